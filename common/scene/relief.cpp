#include "scene/relief.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "scene/noise.hpp"
#include "scene/texture_detail.hpp"

namespace atelier {

using texture_detail::ramp;
using texture_detail::require;

namespace {

struct Stroke {
  glm::dvec2 from, to;
};

double distance_to(const Stroke& stroke, const glm::dvec2& p) {
  const glm::dvec2 along = stroke.to - stroke.from;
  const double t = std::clamp(glm::dot(p - stroke.from, along) / glm::dot(along, along), 0.0, 1.0);
  return glm::length(p - stroke.from - t * along);
}

/// The strokes of a capital letter in a box of width 0.6 and height 1.
std::vector<Stroke> strokes_of(char letter) {
  const glm::dvec2 low_left(0, 0), low_right(0.6, 0), high_left(0, 1), high_right(0.6, 1), middle(0, 0.52);
  switch (letter) {
    case 'A':
      return {{low_left, {0.3, 1}}, {{0.3, 1}, low_right}, {{0.12, 0.38}, {0.48, 0.38}}};
    case 'T':
      return {{high_left, high_right}, {{0.3, 1}, {0.3, 0}}};
    case 'E':
      return {{low_left, high_left}, {high_left, high_right}, {middle, {0.48, 0.52}}, {low_left, low_right}};
    case 'L':
      return {{high_left, low_left}, {low_left, low_right}};
    case 'I':
      return {{{0.3, 1}, {0.3, 0}}};
    default:  // R
      return {{low_left, high_left},        {high_left, {0.42, 1}},       {{0.42, 1}, {0.58, 0.86}},
              {{0.58, 0.86}, {0.58, 0.66}}, {{0.58, 0.66}, {0.42, 0.52}}, {{0.42, 0.52}, middle},
              {{0.3, 0.52}, low_right}};
  }
}

/// The strokes of the word, centred in the square.
std::vector<Stroke> inscription() {
  const std::string_view word = "ATELIER";
  constexpr double letter_height = 0.15, advance = 0.8 * letter_height;
  const glm::dvec2 origin(0.5 - advance * (double(word.size()) - 0.25) / 2, 0.5 - letter_height / 2);
  std::vector<Stroke> strokes;
  for (std::size_t i = 0; i < word.size(); ++i)
    for (const Stroke& stroke : strokes_of(word[i])) {
      const glm::dvec2 corner = origin + glm::dvec2(advance * double(i), 0);
      strokes.push_back({corner + letter_height * stroke.from, corner + letter_height * stroke.to});
    }
  return strokes;
}

}  // namespace

Image normals_of_heights(const Image& heights, double depth, Wrap wrap) {
  const int width = heights.width(), height = heights.height();
  const auto inside = [&](int i, int count) {
    return wrap == Wrap::repeat ? (i + count) % count : std::clamp(i, 0, count - 1);
  };
  const auto h = [&](int x, int y) { return double(heights.at(inside(x, width), inside(y, height)).r) * depth; };
  Image normals(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double slope_u = (h(x + 1, y) - h(x - 1, y)) * width / 2;
      const double slope_v = (h(x, y - 1) - h(x, y + 1)) * height / 2;  // v runs up, rows run down
      const glm::dvec3 normal = glm::normalize(glm::dvec3(-slope_u, -slope_v, 1)) * 0.5 + 0.5;
      normals.at(x, y) = {float(normal.x), float(normal.y), float(normal.z), 1};
    }
  return normals;
}

Relief make_relief(int size, double depth, const std::function<ReliefPoint(double u, double v)>& point) {
  require("relief", "size", size, 1, 8192);
  Relief relief{Image(size, size), Image(size, size), {}};
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const ReliefPoint here = point((x + 0.5) / size, 1 - (y + 0.5) / size);
      relief.colour.at(x, y) = {float(here.colour.r), float(here.colour.g), float(here.colour.b), 1};
      const float height = float(here.height);
      relief.height.at(x, y) = {height, height, height, 1};
    }
  relief.normal = normals_of_heights(relief.height, depth, Wrap::repeat);
  return relief;
}

Relief make_tiles(const TileShape& shape) {
  require("tiles", "tiles", shape.tiles, 1, 64);
  require("tiles", "joint", shape.joint, 0, 0.4);
  require("tiles", "depth", shape.depth, 0, 0.2);
  return make_relief(shape.size, shape.depth, [&](double u, double v) -> ReliefPoint {
    const double x = u * shape.tiles, y = v * shape.tiles;
    const auto column = std::int64_t(x), row = std::int64_t(y);
    const double in_x = x - double(column), in_y = y - double(row);
    const double edge = std::min(std::min(in_x, 1 - in_x), std::min(in_y, 1 - in_y)) - shape.joint / 2;
    const double tile = ramp(0, 0.1, edge);  // 0 in the joint, 1 on the tile's face
    const double grain = fractal_noise(shape.seed, {64 * u, 64 * v}, {64, 64}, 2);
    const auto tilt = [&](std::uint64_t axis) { return hash01(shape.seed + axis, column, row) - 0.5; };
    const double face = 0.85 + 0.2 * (tilt(1) * (in_x - 0.5) + tilt(2) * (in_y - 0.5));
    const double tone = hash01(shape.seed + 3, column, row);
    const glm::dvec3 glaze = glm::mix(glm::dvec3(0.05, 0.17, 0.24), glm::dvec3(0.10, 0.28, 0.30), tone);
    return {glm::mix(glm::dvec3(0.36, 0.34, 0.3) * (0.8 + 0.4 * grain), glaze, tile),
            glm::mix(0.15 * grain, face, tile)};
  });
}

glm::dvec3 dimples_at(const DimpleShape& shape, double u, double v) {
  const glm::dvec2 cell(u * shape.dimples, v * shape.dimples);
  const glm::dvec2 from_centre = cell - glm::floor(cell) - 0.5;
  const double radius = shape.radius, share = glm::dot(from_centre, from_centre) / (radius * radius);
  if (share >= 1) return {1, 0, 0};
  const double rest = 1 - share;
  const glm::dvec2 slope = 6 * rest * rest / (radius * radius) * from_centre * double(shape.dimples);
  return {1 - rest * rest * rest, slope};
}

Relief make_dimples(const DimpleShape& shape) {
  require("dimples", "dimples", shape.dimples, 1, 64);
  require("dimples", "radius", shape.radius, 0.01, 0.5);
  require("dimples", "depth", shape.depth, 0, 0.2);
  return make_relief(shape.size, shape.depth, [&](double u, double v) -> ReliefPoint {
    return {glm::dvec3(shape.colour), dimples_at(shape, u, v).x};
  });
}

Relief make_inscription(const InscriptionShape& shape) {
  require("inscription", "stroke", shape.stroke, 0.005, 0.05);
  require("inscription", "depth", shape.depth, 0, 0.2);
  const std::vector<Stroke> strokes = inscription();
  return make_relief(shape.size, shape.depth, [&](double u, double v) -> ReliefPoint {
    double nearest = 1;
    for (const Stroke& stroke : strokes) nearest = std::min(nearest, distance_to(stroke, {u, v}));
    const double carved = 1 - ramp(0.25 * shape.stroke, 0.75 * shape.stroke, nearest);
    const double grain = fractal_noise(shape.seed, {48 * u, 48 * v}, {48, 48}, 3);
    const double cloud = fractal_noise(shape.seed + 9, {4 * u, 4 * v}, {4, 4}, 4);
    const glm::dvec3 stone = glm::mix(glm::dvec3(0.5, 0.46, 0.38), glm::dvec3(0.62, 0.58, 0.5), cloud);
    return {stone * (1 - 0.35 * carved) * (0.9 + 0.2 * grain), (0.94 + 0.06 * grain) * (1 - 0.9 * carved)};
  });
}

}  // namespace atelier
