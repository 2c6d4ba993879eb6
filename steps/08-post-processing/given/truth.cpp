#include "08-post-processing/given/truth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "02-blinn-phong/given/truth.hpp"
#include "08-post-processing/given/cheat_sheet.hpp"
#include "08-post-processing/given/looks.hpp"
#include "08-post-processing/given/scenes.hpp"
#include "image/colour.hpp"

namespace atelier {

double luma_of(const glm::dvec3& c) {
  return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
}

namespace {

glm::dvec3 rgb(const Rgba& p) {
  return {p.r, p.g, p.b};
}

template <class Change>
Image changed(Image image, const Change& change) {
  for (Rgba& p : image.pixels()) {
    const glm::vec3 c(change(rgb(p)));
    p = {c.r, c.g, c.b, p.a};
  }
  return image;
}

// ---- Bloom

Image blurred(const Image& image, double sigma, const glm::ivec2& along) {
  const int last = int(std::ceil(3 * sigma));
  double sum = 0;
  for (int k = -last; k <= last; ++k) sum += std::exp(-k * k / (2 * sigma * sigma));
  Image result(image.width(), image.height());
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      glm::dvec3 mean(0);
      for (int k = -last; k <= last; ++k) {
        const int u = std::clamp(x + k * along.x, 0, image.width() - 1);
        const int v = std::clamp(y + k * along.y, 0, image.height() - 1);
        mean += std::exp(-k * k / (2 * sigma * sigma)) / sum * rgb(image.at(u, v));
      }
      result.at(x, y) = {float(mean.r), float(mean.g), float(mean.b), 1};
    }
  return result;
}

Image bright(const Image& image, double threshold) {
  return changed(image, [&](const glm::dvec3& c) {
    const double excess = luma_of(c) - threshold;
    return excess > 0 ? c * (excess / luma_of(c)) : glm::dvec3(0);
  });
}

Image sum_of(Image image, const Image& glow, double strength) {
  for (std::size_t i = 0; i < image.pixels().size(); ++i) {
    const glm::vec3 c(rgb(image.pixels()[i]) + strength * rgb(glow.pixels()[i]));
    image.pixels()[i] = {c.r, c.g, c.b, image.pixels()[i].a};
  }
  return image;
}

// ---- Tone mapping

double hable(double x) {
  return (x * (0.15 * x + 0.1 * 0.5) + 0.2 * 0.02) / (x * (0.15 * x + 0.5) + 0.2 * 0.3) - 0.02 / 0.3;
}

glm::dvec3 toned(const glm::dvec3& light, const Settings& settings) {
  const glm::dvec3 c = light * std::pow(2.0, settings.real("tone.exposure"));
  const std::string& curve = settings.choice("tone.curve");
  if (curve == "filmic") return glm::dvec3(hable(2 * c.r), hable(2 * c.g), hable(2 * c.b)) / hable(11.2);
  if (curve != "reinhard") return c;
  const double white = settings.real("tone.white"), y = luma_of(c);
  return y > 0 ? c * (y * (1 + y / (white * white)) / (1 + y) / y) : c;
}

// ---- Hue, chroma, luma

/// The corners of the hexagon of hues in their order, from red.
constexpr std::array<std::array<double, 3>, 6> corners = {
    {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}, {1, 0, 1}}};

/// A colour of a hue (0..6) with its least component 0 and its greatest 1.
glm::dvec3 pure(double sixths) {
  const double turned = sixths - 6 * std::floor(sixths / 6);
  const int sector = std::min(int(turned), 5);
  const auto &a = corners[std::size_t(sector)], &b = corners[std::size_t((sector + 1) % 6)];
  return glm::mix(glm::dvec3(a[0], a[1], a[2]), glm::dvec3(b[0], b[1], b[2]), turned - sector);
}

/// 0..6; 0 for greys. The sector is that of the order of the components.
double hue_of(const glm::dvec3& c, double least, double chroma) {
  if (chroma == 0) return 0;
  const glm::dvec3 p = (c - least) / chroma;
  if (p.b == 0) return p.r >= p.g ? p.g : 2 - p.r;
  if (p.r == 0) return p.g >= p.b ? 2 + p.b : 4 - p.g;
  return p.b >= p.r ? 4 + p.r : 6 - p.b;
}

glm::dvec3 adjusted(const glm::dvec3& c, const Settings& settings) {
  const double least = std::min({c.r, c.g, c.b}), chroma = std::max({c.r, c.g, c.b}) - least;
  const double y = luma_of(c) * settings.real("colour.brightness");
  const glm::dvec3 way = pure(hue_of(c, least, chroma) + 6 * settings.real("colour.hue"));
  const glm::dvec3 from_grey = way - luma_of(way);
  double fits = chroma * settings.real("colour.saturation");
  for (int i = 0; i < 3; ++i) {
    const double room = from_grey[i] < 0 ? y : std::max(1 - y, 0.0);
    if (from_grey[i] != 0) fits = std::min(fits, room / std::abs(from_grey[i]));
  }
  return y + fits * from_grey;
}

// ---- Tables

glm::dvec3 grid_point(const std::string& look, const glm::ivec3& at, int size) {
  const glm::dvec3 exact = look_of(look, glm::dvec3(at) / double(size - 1));
  return glm::round(exact * 1e6) / 1e6;  // as the text says it
}

glm::dvec3 looked_up(const glm::dvec3& c, const Settings& settings) {
  const std::string& look = settings.choice("table.look");
  const bool tetrahedral = settings.choice("table.lookup") == "tetrahedral";
  const int size = settings.integer("table.size");
  const auto encode = [](double v) { return srgb_encode(std::clamp(v, 0.0, 1.0)); };
  const glm::dvec3 place = glm::dvec3(encode(c.r), encode(c.g), encode(c.b)) * double(size - 1);
  const glm::ivec3 corner = glm::min(glm::ivec3(place), glm::ivec3(size - 2));
  const glm::dvec3 part = place - glm::dvec3(corner);
  glm::dvec3 found(0);
  if (tetrahedral) {
    // Corner by corner: the weight of each is by how much its fraction exceeds the next smaller one.
    std::array<int, 3> order = {0, 1, 2};
    std::ranges::sort(order, [&](int a, int b) { return part[a] > part[b]; });
    glm::ivec3 at = corner;
    double before = 1;
    for (const int axis : order) {
      found += (before - part[axis]) * grid_point(look, at, size);
      before = part[axis];
      ++at[axis];
    }
    found += before * grid_point(look, at, size);
  } else {
    for (int i = 0; i < 8; ++i) {
      const glm::ivec3 step(i & 1, i >> 1 & 1, i >> 2);
      double weight = 1;
      for (int axis = 0; axis < 3; ++axis) weight *= step[axis] ? part[axis] : 1 - part[axis];
      found += weight * grid_point(look, corner + step, size);
    }
  }
  return {srgb_decode(found.r), srgb_decode(found.g), srgb_decode(found.b)};
}

// ---- The overlay

/// Bilinear, at the centre of a pixel of a picture of this size that the sheet covers.
Rgba sampled(const Image& sheet, const glm::dvec2& place) {
  const glm::dvec2 at = place * glm::dvec2(sheet.width(), sheet.height()) - 0.5;
  const glm::dvec2 low = glm::floor(at), part = at - low;
  glm::dvec4 sum(0);
  for (int i = 0; i < 4; ++i) {
    const glm::ivec2 step(i & 1, i >> 1);
    const int x = std::clamp(int(low.x) + step.x, 0, sheet.width() - 1);
    const int y = std::clamp(int(low.y) + step.y, 0, sheet.height() - 1);
    const Rgba& p = sheet.at(x, y);
    sum += (step.x ? part.x : 1 - part.x) * (step.y ? part.y : 1 - part.y) * glm::dvec4(p.r, p.g, p.b, p.a);
  }
  return {float(sum.r), float(sum.g), float(sum.b), float(sum.a)};
}

Image overlaid(Image image, double amount) {
  const Image sheet = make_cheat_sheet(640, 480);
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const Rgba above = sampled(sheet, {(x + 0.5) / image.width(), (y + 0.5) / image.height()});
      const glm::vec3 c(glm::mix(rgb(image.at(x, y)), rgb(above), double(above.a) * amount));
      image.at(x, y) = {c.r, c.g, c.b, image.at(x, y).a};
    }
  return image;
}

/// The chain, up to an output.
Image developed(Image image, const Settings& settings, const std::string& output) {
  if (const double strength = settings.real("bloom.strength"); strength > 0) {
    Image glow = bright(image, settings.real("bloom.threshold"));
    if (output == "bright") return glow;
    const double sigma = settings.real("bloom.sigma");
    glow = blurred(blurred(glow, sigma, {1, 0}), sigma, {0, 1});
    if (output == "blur") return glow;
    image = sum_of(std::move(image), glow, strength);
  }
  if (output == "bloom") return image;
  image = changed(std::move(image), [&](const glm::dvec3& c) { return toned(c, settings); });
  if (output == "tone") return image;
  if (settings.real("colour.hue") != std::floor(settings.real("colour.hue")) ||
      settings.real("colour.saturation") != 1 || settings.real("colour.brightness") != 1)
    image = changed(std::move(image), [&](const glm::dvec3& c) { return adjusted(c, settings); });
  if (output == "adjust") return image;
  if (settings.choice("table.look") != "none")
    image = changed(std::move(image), [&](const glm::dvec3& c) { return looked_up(c, settings); });
  if (output == "table") return image;
  const double overlay = settings.real("overlay.amount");
  return overlay > 0 ? overlaid(std::move(image), overlay) : image;
}

}  // namespace

SceneTruth post_truth(const TruthRequest& request, const Settings& settings, std::optional<Scene> model) {
  if (!model) model = make_scene(post_scenes(), request.scene, settings);
  SceneTruth truth = blinn_phong_truth(request, settings, std::move(model));
  const std::array outputs = {"colour", "bright", "blur", "bloom", "tone", "adjust", "table"};
  if (std::ranges::count(outputs, request.output) == 0) return truth;
  truth.output = "colour";
  truth.finish = [settings, output = request.output](Image image) {
    return developed(std::move(image), settings, output);
  };
  return truth;
}

}  // namespace atelier
