// FLIP is computed in tiles. In a tile, each row of both pictures is converted to opponent colours and filtered along x
// once, then kept in a ring buffer with as many rows as the widest filter is high. When the ring around a row is
// complete, it is filtered along y, and the two pictures are compared there. A tile's rings fit in the L2 cache, only
// the result has the size of the pictures, and tiles run on any number of threads.
#include "image/flip.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <future>
#include <vector>

#include "base/error.hpp"
#include "image/fast_math.hpp"
#include "image/flip_filters.hpp"

namespace atelier {
namespace {

using flip_detail::ContrastFilters;
using flip_detail::FeatureFilters;
using flip_detail::Filter;

constexpr int tile_width = 480, tile_height = 270;  // a tile's two rings: 0.6 MB at the default pixels per degree
constexpr double pooling_power = 0.7, knee = 0.4, knee_value = 0.95;  // q_c, p_c, p_t in the paper

/// Everything that depends only on the options.
struct Plan {
  ContrastFilters contrast;
  FeatureFilters feature;
  int radius = 0;     // of the widest filter
  float largest = 0;  // c_max: the pooled colour distance of green and blue, the largest of all
};

/// The Hunt effect: dark colours look less colourful.
Lab hunt(const Lab& lab) {
  return {lab.l, 0.01 * lab.l * lab.a, 0.01 * lab.l * lab.b};
}

Plan make_plan(double pixels_per_degree) {
  Plan plan{flip_detail::contrast_filters(pixels_per_degree), flip_detail::feature_filters(pixels_per_degree)};
  for (const Filter* filter :
       {&plan.contrast.luminance, &plan.contrast.red_green, &plan.contrast.blue_yellow[0],
        &plan.contrast.blue_yellow[1], &plan.feature.smooth, &plan.feature.edge, &plan.feature.point})
    plan.radius = std::max(plan.radius, filter->radius());
  const Lab green = hunt(xyz_to_lab(linear_to_xyz({0, 1, 0}))), blue = hunt(xyz_to_lab(linear_to_xyz({0, 0, 1})));
  const double distance = std::abs(green.l - blue.l) + std::hypot(green.a - blue.a, green.b - blue.b);
  plan.largest = float(std::pow(distance, pooling_power));
  return plan;
}

/// A tile's pixels: x0 <= x < x1, y0 <= y < y1.
struct Tile {
  int x0, y0, x1, y1;
  int width() const { return x1 - x0; }
};

/// The planes after filtering along x, one ring of rows each.
enum Plane { luminance, red_green, blue_wide, blue_narrow, smooth, edge, point, plane_count };

/// A row as a viewer sees it, filtered along x and y.
struct SeenRow {
  explicit SeenRow(int width) : l(width), a(width), b(width), edge(width), point(width) {}
  std::vector<float> l, a, b;      // Hunt-adjusted L*a*b*
  std::vector<float> edge, point;  // strength of each feature, 0..1
};

// XYZ relative to white: white is (1, 1, 1), and every row of the matrix adds up to 1.
struct RelativeMatrices {
  float to[3][3], from[3][3];
};
constexpr RelativeMatrices relative = [] {
  RelativeMatrices r{};
  const double white[3] = {white_d65.x, white_d65.y, white_d65.z};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      r.to[i][j] = float(linear_to_xyz_matrix.m[i][j] / white[i]);
      r.from[i][j] = float(xyz_to_linear_matrix.m[i][j] * white[j]);
    }
  return r;
}();

/// One picture's rows in a tile.
class Stream {
 public:
  Stream(const Image& image, const Plan& plan, const Tile& tile, bool encoded)
      : image_(image),
        plan_(plan),
        tile_(tile),
        encoded_(encoded),
        height_(2 * plan.radius + 1),
        padded_(tile.width() + 2 * plan.radius),
        source_(std::size_t(padded_) * 3),
        linear_(source_.size()),
        taps_(std::size_t(height_)),
        scratch_(std::size_t(tile.width())),
        ring_(std::size_t(plane_count) * height_ * tile.width()),
        seen_(tile.width()) {}

  /// Filters row `y` of the picture along x and overwrites the oldest row.
  void push(int y) {
    load(y);
    const float* row = source_.data();
    along_x(plan_.contrast.luminance, row, slot(luminance, y));
    along_x(plan_.feature.smooth, row, slot(smooth, y));
    along_x(plan_.feature.edge, row, slot(edge, y));
    along_x(plan_.feature.point, row, slot(point, y));
    along_x(plan_.contrast.red_green, row + padded_, slot(red_green, y));
    along_x(plan_.contrast.blue_yellow[0], row + 2 * padded_, slot(blue_wide, y));
    along_x(plan_.contrast.blue_yellow[1], row + 2 * padded_, slot(blue_narrow, y));
  }

  /// Row `y` as seen; rows y - radius .. y + radius (those that exist) must have been pushed.
  const SeenRow& look(int y) {
    see_features(y);
    see_colour(y);
    return seen_;
  }

 private:
  float* slot(int plane, int y) {
    return ring_.data() + (std::size_t(plane) * height_ + std::size_t(y % height_)) * tile_.width();
  }

  /// Row `y` as opponent colours Y, Cx, Cz, with a margin of the filters' radius, where the border pixels repeat.
  void load(int y) {
    const Rgba* row = &image_.at(0, y);
    float* __restrict rgb = linear_.data();
    for (int i = 0; i < padded_; ++i) {
      const Rgba& pixel = row[std::clamp(tile_.x0 - plan_.radius + i, 0, image_.width() - 1)];
      rgb[i] = pixel.r, rgb[padded_ + i] = pixel.g, rgb[2 * padded_ + i] = pixel.b;
    }
    for (int i = 0; i < 3 * padded_; ++i) rgb[i] = fast::clamp01(rgb[i]);
    if (encoded_)
      for (int i = 0; i < 3 * padded_; ++i) rgb[i] = fast::srgb_decode(rgb[i]);

    const auto& m = relative.to;
    float* __restrict out = source_.data();
    for (int i = 0; i < padded_; ++i) {
      const float r = rgb[i], g = rgb[padded_ + i], b = rgb[2 * padded_ + i];
      const float x = m[0][0] * r + m[0][1] * g + m[0][2] * b, luma = m[1][0] * r + m[1][1] * g + m[1][2] * b,
                  z = m[2][0] * r + m[2][1] * g + m[2][2] * b;
      out[i] = luma;  // relative luminance; the paper's Y is 116 luma - 16, which is undone in both of its uses
      out[padded_ + i] = x - luma;
      out[2 * padded_ + i] = luma - z;
    }
  }

  void along_x(const Filter& filter, const float* padded_row, float* out) {
    const int first = plan_.radius - filter.radius();
    for (int k = 0; k <= 2 * filter.radius(); ++k) taps_[std::size_t(k)] = padded_row + first + k;
    flip_detail::apply(filter, taps_.data(), tile_.width(), out);
  }

  void along_y(const Filter& filter, Plane plane, int y, float* out) {
    for (int k = 0; k <= 2 * filter.radius(); ++k)
      taps_[std::size_t(k)] = slot(plane, std::clamp(y - filter.radius() + k, 0, image_.height() - 1));
    flip_detail::apply(filter, taps_.data(), tile_.width(), out);
  }

  /// The lengths of the gradient and of the second derivatives.
  void see_features(int y) {
    const int n = tile_.width();
    const auto strength = [&](const Filter& derivative, Plane derived, std::vector<float>& result) {
      along_y(plan_.feature.smooth, derived, y, scratch_.data());
      along_y(derivative, smooth, y, result.data());
      const float* __restrict across = scratch_.data();
      float* __restrict along = result.data();
      for (int i = 0; i < n; ++i) along[i] = std::sqrt(across[i] * across[i] + along[i] * along[i]);
    };
    strength(plan_.feature.edge, edge, seen_.edge);
    strength(plan_.feature.point, point, seen_.point);
  }

  /// The blurred colour, clamped to the displayable range, as Hunt-adjusted L*a*b*.
  void see_colour(int y) {
    along_y(plan_.contrast.luminance, luminance, y, seen_.l.data());
    along_y(plan_.contrast.red_green, red_green, y, seen_.a.data());
    along_y(plan_.contrast.blue_yellow[0], blue_wide, y, seen_.b.data());
    along_y(plan_.contrast.blue_yellow[1], blue_narrow, y, scratch_.data());
    float* __restrict l = seen_.l.data(), * __restrict a = seen_.a.data(), * __restrict b = seen_.b.data();
    const float* __restrict narrow = scratch_.data();
    constexpr auto& from = relative.from;
    constexpr auto& to = relative.to;
    const auto curve = [](float t) {  // xyz_to_lab's
      constexpr float corner = 6.0f / 29, slope = 1 / (3 * corner * corner), offset = 4.0f / 29;
      const float root = fast::cbrt(t < 1e-6f ? 1e-6f : t), line = slope * t + offset;
      return t > corner * corner * corner ? root : line;
    };
    for (int i = 0, n = tile_.width(); i < n; ++i) {
      const float luma = l[i], x = luma + a[i], z = luma - (b[i] + narrow[i]);
      const float red = fast::clamp01(from[0][0] * x + from[0][1] * luma + from[0][2] * z),
                  green = fast::clamp01(from[1][0] * x + from[1][1] * luma + from[1][2] * z),
                  blue = fast::clamp01(from[2][0] * x + from[2][1] * luma + from[2][2] * z);
      const float fx = curve(to[0][0] * red + to[0][1] * green + to[0][2] * blue),
                  fy = curve(to[1][0] * red + to[1][1] * green + to[1][2] * blue),
                  fz = curve(to[2][0] * red + to[2][1] * green + to[2][2] * blue);
      const float lightness = 116 * fy - 16;
      l[i] = lightness;
      a[i] = 5 * lightness * (fx - fy);  // 500 of L*a*b*, 0.01 of Hunt
      b[i] = 2 * lightness * (fy - fz);
    }
  }

  const Image& image_;
  const Plan& plan_;
  Tile tile_;
  bool encoded_;
  int height_, padded_;                 // rows of a ring; pixels of a row with its margins
  std::vector<float> source_, linear_;  // one row, three planes
  std::vector<const float*> taps_;
  std::vector<float> scratch_, ring_;
  SeenRow seen_;
};

/// The error in each pixel of a row.
void compare_row(const SeenRow& reference, const SeenRow& test, float largest, float* __restrict error, int count) {
  const float bend = float(knee) * largest, below = float(knee_value) / bend,
              above = float(1 - knee_value) / (largest - bend);
  for (int i = 0; i < count; ++i) {
    // Colour: city-block distance in lightness plus Euclidean distance in a and b (HyAB), compressed, and mapped to
    // 0..1 piecewise.
    const float dl = reference.l[i] - test.l[i], da = reference.a[i] - test.a[i], db = reference.b[i] - test.b[i];
    const float distance = std::abs(dl) + std::sqrt(da * da + db * db);
    const float pooled = fast::pow(distance < 1e-12f ? 1e-12f : distance, float(pooling_power));
    const float colour = pooled < bend ? pooled * below : float(knee_value) + (pooled - bend) * above;
    // Features: the larger change of the two kinds.
    const float edge_change = std::abs(reference.edge[i] - test.edge[i]),
                point_change = std::abs(reference.point[i] - test.point[i]);
    const float change = edge_change > point_change ? edge_change : point_change;
    const float feature = std::sqrt(change * 0.70710678f);
    // Together: a feature that appears pulls the colour error towards one.
    const float together = fast::pow(colour < 1e-12f ? 1e-12f : colour, 1 - feature);
    error[i] = distance > 0 ? together : 0;
  }
}

/// Compares one tile, writes its errors and returns their sum.
double compare_tile(const Image& reference, const Image& test, const Plan& plan, bool encoded, const Tile& tile,
                    Image& map) {
  Stream streams[] = {{reference, plan, tile, encoded}, {test, plan, tile, encoded}};
  std::vector<float> error(std::size_t(tile.width()));
  double sum = 0;
  int next = std::max(tile.y0 - plan.radius, 0);
  for (int y = tile.y0; y < tile.y1; ++y) {
    for (const int last = std::min(y + plan.radius, map.height() - 1); next <= last; ++next)
      for (Stream& stream : streams) stream.push(next);
    compare_row(streams[0].look(y), streams[1].look(y), plan.largest, error.data(), tile.width());
    for (int i = 0; i < tile.width(); ++i) {
      map.at(tile.x0 + i, y) = {error[i], error[i], error[i], 1};
      sum += error[i];
    }
  }
  return sum;
}

void check(const Image& reference, const Image& test, const FlipOptions& options) {
  if (reference.empty() || !reference.same_size(test))
    throw Error(fmt::format("FLIP compares two pictures of the same size, not {} x {} and {} x {} pixels.",
                            reference.width(), reference.height(), test.width(), test.height()));
  if (options.encoding == Encoding::data) throw Error("FLIP compares colours: the encoding must be linear or sRGB.");
  if (!(options.pixels_per_degree >= 1 && options.pixels_per_degree <= 200))
    throw Error(fmt::format("FLIP cannot use {} pixels per degree: 1 to 200 are allowed.", options.pixels_per_degree));
  if (options.threads < 1 || options.threads > 64)
    throw Error(fmt::format("FLIP cannot run on {} threads: 1 to 64 are allowed.", options.threads));
}

}  // namespace

Flip flip(const Image& reference, const Image& test, const FlipOptions& options) {
  check(reference, test, options);
  const Plan plan = make_plan(options.pixels_per_degree);
  Flip result{Image(reference.width(), reference.height())};
  std::vector<Tile> tiles;
  for (int y = 0; y < reference.height(); y += tile_height)
    for (int x = 0; x < reference.width(); x += tile_width)
      tiles.push_back(
          {x, y, std::min(x + tile_width, reference.width()), std::min(y + tile_height, reference.height())});

  // Each tile stores its own sum, so that they are always added in the same order.
  std::vector<double> sums(tiles.size());
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i; (i = next++) < tiles.size();)
      sums[i] = compare_tile(reference, test, plan, options.encoding == Encoding::srgb, tiles[i], result.map);
  };
  // A future passes on a thread's exception (out of memory), and its destructor waits for the thread.
  std::vector<std::future<void>> helpers;
  for (int i = 1; i < options.threads; ++i) helpers.push_back(std::async(std::launch::async, work));
  work();
  for (auto& helper : helpers) helper.get();
  for (double sum : sums) result.mean += sum;
  result.mean /= double(reference.width()) * reference.height();
  return result;
}

}  // namespace atelier
