#include "image/draw.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "base/error.hpp"
#include "image/colour.hpp"
#include "image/fast_math.hpp"

namespace atelier {
namespace {

Rgba scaled(const Rgba& p, float s) {
  return {p.r * s, p.g * s, p.b * s, p.a * s};
}
Rgba sum(const Rgba& p, const Rgba& q) {
  return {p.r + q.r, p.g + q.g, p.b + q.b, p.a + q.a};
}

void check_sizes(bool same, const char* what) {
  if (!same) throw Error(fmt::format("{} needs two pictures of the same size.", what));
}

/// The source pixels that one target pixel covers along an axis, with their weights; the weights add up to 1.
struct Coverage {
  int first = 0;
  std::vector<float> share;
};

std::vector<Coverage> cover(int source, int target) {
  std::vector<Coverage> result(std::size_t(target), Coverage{});
  const double step = double(source) / target;
  for (int i = 0; i < target; ++i) {
    const double begin = i * step, end = begin + step;
    Coverage& c = result[std::size_t(i)];
    c.first = int(begin);
    for (int k = c.first; k < source && k < end; ++k) {
      const double covered = std::min(end, k + 1.0) - std::max(begin, double(k));
      c.share.push_back(float(std::max(covered, 0.0) / step));
    }
  }
  return result;
}

Image shrink_along_x(const Image& image, int width) {
  const auto coverage = cover(image.width(), width);
  Image result(width, image.height(), {0, 0, 0, 0});
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < width; ++x) {
      const Coverage& c = coverage[std::size_t(x)];
      for (std::size_t k = 0; k < c.share.size(); ++k)
        result.at(x, y) = sum(result.at(x, y), scaled(image.at(c.first + int(k), y), c.share[k]));
    }
  return result;
}

Image shrink_along_y(const Image& image, int height) {
  const auto coverage = cover(image.height(), height);
  Image result(image.width(), height, {0, 0, 0, 0});
  for (int y = 0; y < height; ++y) {
    const Coverage& c = coverage[std::size_t(y)];
    for (std::size_t k = 0; k < c.share.size(); ++k)
      for (int x = 0; x < image.width(); ++x)
        result.at(x, y) = sum(result.at(x, y), scaled(image.at(x, c.first + int(k)), c.share[k]));
  }
  return result;
}

}  // namespace

Box box_around(const Image& image, Position centre, int width, int height) {
  const int w = std::min(width, image.width()), h = std::min(height, image.height());
  return {std::clamp(centre.x - w / 2, 0, image.width() - w), std::clamp(centre.y - h / 2, 0, image.height() - h), w,
          h};
}

Image crop(const Image& image, const Box& box) {
  if (box.width < 1 || box.height < 1 || box.x < 0 || box.y < 0 || box.width > image.width() - box.x ||
      box.height > image.height() - box.y)
    throw Error(fmt::format("A crop of {} x {} pixels at ({}, {}) is not inside a picture of {} x {}.", box.width,
                            box.height, box.x, box.y, image.width(), image.height()));
  Image result(box.width, box.height);
  for (int y = 0; y < box.height; ++y) std::copy_n(&image.at(box.x, box.y + y), box.width, &result.at(0, y));
  return result;
}

Image enlarge(const Image& image, int factor) {
  if (factor < 1 || factor > Image::max_side)
    throw Error(fmt::format("A picture cannot be enlarged {} times: 1 or more.", factor));
  Image result(image.width() * factor, image.height() * factor);
  for (int y = 0; y < result.height(); ++y)
    for (int x = 0; x < result.width(); ++x) result.at(x, y) = image.at(x / factor, y / factor);
  return result;
}

Image shrink_to(const Image& image, int longest) {
  if (longest < 1) throw Error(fmt::format("A picture cannot be made {} pixels long: 1 or more.", longest));
  const int side = std::max(image.width(), image.height());
  if (side <= longest) return image;
  const auto fit = [&](int length) { return std::max(1, int(std::lround(double(length) * longest / side))); };
  return shrink_along_y(shrink_along_x(image, fit(image.width())), fit(image.height()));
}

Image side_by_side(std::span<const Image> images, int gap, Rgba background) {
  if (images.empty() || gap < 0) throw Error("Side by side needs at least one picture and a gap of 0 pixels or more.");
  long width = long(gap) * long(images.size() - 1);
  int height = 0;
  for (const Image& image : images) {
    if (image.empty()) throw Error("An empty picture cannot be placed side by side with others.");
    width += image.width();
    height = std::max(height, image.height());
  }
  Image result(int(std::min<long>(width, Image::max_side + 1)), height, background);
  int left = 0;
  for (const Image& image : images) {
    for (int y = 0; y < image.height(); ++y) std::copy_n(&image.at(0, y), image.width(), &result.at(left, y));
    left += image.width() + gap;
  }
  return result;
}

Image signed_difference(const Image& yours, const Image& reference, float gain) {
  check_sizes(yours.same_size(reference), "A difference");
  Image result = yours;
  const auto show = [&](float a, float b) { return fast::clamp01(0.5f + gain * (a - b)); };
  for (std::size_t i = 0; i < result.pixels().size(); ++i) {
    const Rgba &a = yours.pixels()[i], &b = reference.pixels()[i];
    result.pixels()[i] = {show(a.r, b.r), show(a.g, b.g), show(a.b, b.b), 1};
  }
  return result;
}

Rgba heat_colour(float t) {
  // Encoded colours in about equal steps of lightness L*.
  static constexpr Rgba stops[] = {{0.00f, 0.00f, 0.02f, 1}, {0.15f, 0.06f, 0.35f, 1}, {0.40f, 0.08f, 0.50f, 1},
                                   {0.66f, 0.16f, 0.46f, 1}, {0.88f, 0.30f, 0.35f, 1}, {0.97f, 0.52f, 0.30f, 1},
                                   {0.99f, 0.75f, 0.46f, 1}, {0.99f, 0.97f, 0.76f, 1}};
  constexpr int last = int(std::size(stops)) - 1;
  const float place = fast::clamp01(t) * last;
  const int below = std::min(int(place), last - 1);
  const float f = place - float(below);
  Rgba colour = sum(scaled(stops[below], 1 - f), scaled(stops[below + 1], f));
  colour.a = 1;
  return colour;
}

Image heat_map(const Image& errors, float full) {
  if (!(full > 0)) throw Error(fmt::format("A heat map cannot end at {}: it is above 0.", full));
  Image result = errors;
  for (Rgba& pixel : result.pixels()) pixel = heat_colour(pixel.r / full);
  return result;
}

Image overlay(const Image& image, const Mask& mask, Rgba colour) {
  check_sizes(image.width() == mask.width() && image.height() == mask.height(), "An overlay");
  Image result = image;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const float grey = 0.15f + 0.35f * fast::clamp01(luminance(image.at(x, y)));
      result.at(x, y) = mask.at(x, y) ? colour : Rgba{grey, grey, grey, 1};
    }
  return result;
}

}  // namespace atelier
