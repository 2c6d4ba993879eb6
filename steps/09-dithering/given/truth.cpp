#include "09-dithering/given/truth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>
#include <vector>

#include "03-shadow-mapping/given/truth.hpp"
#include "08-post-processing/given/truth.hpp"
#include "09-dithering/given/exact_diffusion.hpp"
#include "09-dithering/given/scenes.hpp"
#include "app/picture.hpp"
#include "base/error.hpp"
#include "image/colour.hpp"

namespace atelier {

namespace {

glm::dvec3 rgb(const Rgba& p) {
  return {p.r, p.g, p.b};
}

// ---- The pattern

/// Bayer's rank of a cell by its bits: from the coarsest bit of the rank to the finest, the coordinates' bits from the
/// least significant one; in each pair first whether x and y differ, then y's.
int bayer_rank(glm::ivec2 cell, int size) {
  int rank = 0;
  for (int bit = 1; bit < size; bit *= 2) {
    const int x = (cell.x & bit) != 0, y = (cell.y & bit) != 0;
    rank = 4 * rank + 2 * (x ^ y) + y;
  }
  return rank;
}

int wrapped(double place, int size) {
  return int(std::floor(place) - size * std::floor(std::floor(place) / size));
}

/// The threshold in a cell of the repeated matrix.
double threshold_in(const glm::dvec2& place, int size) {
  return (bayer_rank({wrapped(place.x, size), wrapped(place.y, size)}, size) + 0.5) / (size * size);
}

/// Where a pattern that is held by the sphere or the world is seen.
struct Eye {
  glm::dvec3 place;
  glm::dmat3 to_world;
  double half_height;  ///< of the picture at a distance of 1
  glm::ivec2 size;

  double cell = 1;  ///< pixels

  double cell_angle() const { return cell * 2 * half_height / size.y; }
  glm::dvec3 direction(int x, int y) const {
    const glm::dvec2 ndc((2 * x + 1.0) / size.x - 1, 1 - (2 * y + 1.0) / size.y);
    return to_world * glm::dvec3(ndc * half_height * glm::dvec2(double(size.x) / size.y, 1), -1);
  }
};

/// In cells, on the face of a cube.
glm::dvec2 place_on_sphere(const glm::dvec3& d, double cell_angle) {
  int axis = 0;
  for (int i = 1; i < 3; ++i)
    if (std::abs(d[i]) > std::abs(d[axis])) axis = i;
  const double cells = std::round(std::numbers::pi / 2 / cell_angle);
  const auto across = [&](int i) {
    return (std::atan2(d[i], std::abs(d[axis])) / (std::numbers::pi / 4) + 1) / 2 * cells;
  };
  return {across((axis + 1) % 3), across((axis + 2) % 3)};
}

/// The share of pairs of even thresholds whose mean, weighted by `part`, is below `mean`: the area of the unit square
/// below a line.
double share_below(double mean, double part) {
  const auto square = [](double v) { return v > 0 ? v * v : 0; };
  const double p = part, q = 1 - part;
  if (p == 0 || q == 0) return mean;
  return (square(mean) - square(mean - p) - square(mean - q) + square(mean - 1)) / (2 * p * q);
}

double threshold_in_world(const glm::dvec3& position, const glm::dvec3& normal, const Eye& eye, int size) {
  const double octaves = std::log2(glm::length(position - eye.place) * eye.cell_angle()), whole = std::floor(octaves);
  int axis = 0;
  for (int i = 1; i < 3; ++i)
    if (std::abs(normal[i]) > std::abs(normal[axis])) axis = i;
  const glm::dvec2 place = glm::dvec2(position[(axis + 1) % 3], position[(axis + 2) % 3]) / std::exp2(whole + 1);
  const double part = octaves - whole;
  const double a = threshold_in(place, size), b = threshold_in(glm::floor(0.5 * place) + glm::dvec2(23, 41), size);
  return share_below((1 - part) * a + part * b, part);
}

// ---- Levels

struct Levels {
  int count;
  bool linear;

  double value_of(double light) const {
    const double v = std::clamp(light, 0.0, 1.0);
    return linear ? v : srgb_encode(v);
  }
  double light_of(int level) const {
    const double v = double(level) / (count - 1);
    return linear ? v : srgb_decode(v);
  }
  int at_threshold(double value, double threshold) const {
    const double steps = value * (count - 1), below = std::floor(steps);
    return int(below) + (steps - below > threshold);
  }
};

// ---- Pictures

/// Where nothing is seen, normals and positions are 0.
bool is_surface(const Rgba& normal_code) {
  return rgb(normal_code) != glm::dvec3(0);
}

struct Geometry {
  Image positions, normals;

  glm::dvec3 normal(int x, int y) const { return glm::normalize(2.0 * rgb(normals.at(x, y)) - 1.0); }
  glm::dvec3 position(int x, int y) const { return rgb(positions.at(x, y)); }
};

bool line_between(const Geometry& g, const Eye& eye, glm::ivec2 a, glm::ivec2 b) {
  const bool first = is_surface(g.normals.at(a.x, a.y)), second = is_surface(g.normals.at(b.x, b.y));
  if (!first || !second) return first != second;
  const glm::dvec3 p = g.position(a.x, a.y), q = g.position(b.x, b.y), m = g.normal(a.x, a.y), n = g.normal(b.x, b.y);
  const double near = std::min(glm::length(p - eye.place), glm::length(q - eye.place));
  const bool apart = std::abs(glm::dot(m, q - p)) > 0.01 * near && std::abs(glm::dot(n, q - p)) > 0.01 * near;
  return apart || glm::dot(m, n) < std::sqrt(0.75);
}

Image with_lines(Image image, const Geometry& g, const Eye& eye, float grey) {
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const bool right = x + 1 < image.width() && line_between(g, eye, {x, y}, {x + 1, y});
      const bool above = y > 0 && line_between(g, eye, {x, y}, {x, y - 1});
      if (right || above) image.at(x, y) = {grey, grey, grey, image.at(x, y).a};
    }
  return image;
}

void make_grey(Image& image) {
  for (Rgba& p : image.pixels()) {
    const float grey = float(luma_of(rgb(p)));
    p = {grey, grey, grey, p.a};
  }
}

Image with_diffused_errors(Image image, const Levels& levels, const Settings& settings) {
  for (int channel = 0; channel < 3; ++channel) {
    const auto component = [&](Rgba& p) -> float& { return channel == 0 ? p.r : channel == 1 ? p.g : p.b; };
    std::vector<double> values;
    for (Rgba& p : image.pixels()) {
      const double code = srgb_code(component(p)) / 255.0;
      values.push_back(levels.linear ? srgb_decode(code) : code);
    }
    const std::vector<int> chosen =
        exactly_diffused(values, image.width(), levels.count, settings.choice("dither.method") == "atkinson",
                         settings.flag("dither.serpentine"));
    for (std::size_t i = 0; i < chosen.size(); ++i)
      component(image.pixels()[i]) =
          float(srgb_decode(srgb_code(float(levels.light_of(chosen[i]))) / 255.0));  // stored in 8 bits
  }
  return image;
}

Image at_thresholds(Image image, const Levels& levels, const Eye& eye, const Geometry& g, const Settings& settings) {
  const std::string& held = settings.choice("dither.held");
  const int size = std::stoi(settings.choice("dither.matrix"));
  const auto threshold = [&](int x, int y) {
    if (settings.choice("dither.method") == "rounded") return 0.5;
    if (held == "screen") return threshold_in({x, y}, size);
    if (held == "world" && is_surface(g.normals.at(x, y)))
      return threshold_in_world(g.position(x, y), g.normal(x, y), eye, size);
    return threshold_in(place_on_sphere(eye.direction(x, y), eye.cell_angle()), size);
  };
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      Rgba& p = image.at(x, y);
      const double t = threshold(x, y);
      const auto changed = [&](float light) {
        return float(levels.light_of(levels.at_threshold(levels.value_of(light), t)));
      };
      p = {changed(p.r), changed(p.g), changed(p.b), p.a};
    }
  return image;
}

Image dithered(Image image, const Eye& eye, const Geometry& g, const Settings& settings, bool lines_too) {
  const std::string &method = settings.choice("dither.method"), &lines = settings.choice("dither.lines");
  const Levels levels{settings.integer("dither.levels"), settings.choice("dither.space") == "linear"};
  if (settings.flag("dither.grey")) make_grey(image);
  if (method == "blue-noise") throw Error("dither.method=blue-noise has no ground truth: its pattern is your own");
  if (method == "floyd-steinberg" || method == "atkinson")
    image = with_diffused_errors(std::move(image), levels, settings);
  else if (method != "none")
    image = at_thresholds(std::move(image), levels, eye, g, settings);
  return lines == "none" || !lines_too ? image : with_lines(std::move(image), g, eye, lines == "white" ? 1.0f : 0.0f);
}

}  // namespace

SceneTruth dither_truth(const TruthRequest& request, const Settings& settings, std::optional<Scene> model) {
  if (!model) model = make_scene(dither_scenes(), request.scene, settings);
  TruthRequest before_dithering = request;
  if (request.output == "dither" || request.output == "seen") before_dithering.output = "colour";
  SceneTruth truth = post_truth(before_dithering, settings, std::move(model));
  use_shadows_without_cubes(truth, settings);
  return in_few_levels(std::move(truth), request, settings);
}

SceneTruth in_few_levels(SceneTruth truth, const TruthRequest& request, const Settings& settings) {
  const bool without_lines = request.output == "dither";
  if (request.output != "colour" && !without_lines) return truth;
  const Camera camera = truth.camera.value_or(apply(request.camera, truth.scene.camera));
  const Eye eye{.place = camera.eye,
                .to_world = glm::dmat3(glm::inverse(glm::lookAt(camera.eye, camera.target, glm::dvec3(camera.up)))),
                .half_height = std::tan(double(camera.fov_y) / 2),
                .size = request.size,
                .cell = settings.real("dither.cell")};
  SceneTruth geometry = truth;
  geometry.finish = nullptr;
  geometry.output.clear();
  const auto trace = [=](const char* output) {
    TruthRequest wanted = request;
    wanted.output = output;
    wanted.samples = 1;
    return trace_scene(geometry, wanted, {}, settings);
  };
  const bool needs_geometry = settings.choice("dither.lines") != "none" || settings.choice("dither.held") == "world";
  truth.finish = [=, before = truth.finish](Image image) {
    if (before) image = before(std::move(image));
    const Geometry g = needs_geometry ? Geometry{trace("position"), trace("normal")} : Geometry{};
    return dithered(std::move(image), eye, g, settings, !without_lines);
  };
  return truth;
}

}  // namespace atelier
