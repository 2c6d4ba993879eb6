#include "02-blinn-phong/given/studies.hpp"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "scene/builder.hpp"
#include "scene/shapes.hpp"

namespace atelier {

namespace {

constexpr double pi = std::numbers::pi;

/// The Legendre polynomial of degree `n` at x, and its derivative, by Bonnet's recurrence.
std::pair<double, double> legendre(int n, double x) {
  double before = 1, value = x;
  for (int k = 2; k <= n; ++k) before = std::exchange(value, ((2 * k - 1) * x * value - (k - 1) * before) / k);
  return {value, n * (x * value - before) / (x * x - 1)};
}

/// A node and its weight for the integral from -1 to 1.
struct Node1D {
  double x, weight;
};

/// The Gauss-Legendre rule with `count` nodes: the roots of the polynomial, by Newton's method from Chebyshev's guess.
std::vector<Node1D> gauss_legendre(int count) {
  std::vector<Node1D> nodes;
  for (int i = 0; i < count; ++i) {
    double x = std::cos(pi * (i + 0.75) / (count + 0.5));
    for (int step = 0; step < 8; ++step) {
      const auto [value, slope] = legendre(count, x);
      x -= value / slope;
    }
    const double slope = legendre(count, x).second;
    nodes.push_back({x, 2 / ((1 - x * x) * slope * slope)});
  }
  return nodes;
}

/// Straight down from `height` metres above the origin.
Camera from_above(double height, float fov_y) {
  return {.eye = {0, height, 0},
          .target = {0, 0, 0},
          .up = {0, 0, -1},
          .fov_y = fov_y,
          .near = float(height / 2),
          .far = float(height * 2)};
}

Scene dark(const char* name) {
  Scene scene{.name = name};
  scene.ambient = glm::vec3(0);
  return scene;
}

}  // namespace

Scene furnace() {
  Scene scene = dark("furnace");
  const int mirror = add_material(scene, {.name = "mirror", .diffuse = glm::vec3(0), .specular = glm::vec3(1)});
  add_object(scene, make_plane({.width = 0.1f, .depth = 0.1f}), mirror, {.name = "plate"});
  const double low = std::numbers::sqrt2 / 2, high = 1;
  int place = 0;
  for (const auto& [x, weight] : gauss_legendre(64)) {
    const double u = low + (high - low) * (x + 1) / 2, du = weight * (high - low) / 2;
    const double theta = 2 * std::acos(u), around = 2.399963 * place++;  // the golden angle; any angle works
    add_light(scene, {.type = LightType::directional,
                      .direction = -glm::vec3(std::sin(theta) * std::cos(around), std::cos(theta),
                                              std::sin(theta) * std::sin(around)),
                      .colour = glm::vec3(float(8 * u * du))});
  }
  // Far enough away that the view direction is nearly the same in all pixels.
  scene.camera = from_above(10, 1e-3f);
  return scene;
}

Scene highlight(float exponent) {
  Scene scene = dark("highlight");
  const int gloss =
      add_material(scene, {.name = "gloss", .diffuse = glm::vec3(0), .specular = glm::vec3(1), .exponent = exponent});
  // cos(angle)^n = 1/2 at the half vector's angle, which is half of the view angle.
  const double widest = 70 * pi / 180, half_maximum = 2 * std::acos(std::pow(0.5, 1 / double(exponent)));
  const double tilt = half_maximum < widest ? half_maximum : widest;
  const float side = float(4 * std::tan(tilt));
  add_object(scene, make_plane({.width = side, .depth = side}), gloss, {.name = "plate"});
  add_light(scene, {.type = LightType::directional, .direction = {0, -1, 0}, .colour = glm::vec3(1)});
  scene.camera = from_above(1, float(2 * tilt));
  return scene;
}

Scene plate(const Settings& settings) {
  Scene scene = dark("plate");
  const int cells = settings.integer("plate.cells");
  const int gloss = add_material(scene, plastic("gloss", {0.2f, 0.45f, 0.6f}, 8));
  add_object(scene, make_plane({.width = 4, .depth = 4, .columns = cells, .rows = cells}), gloss, {.name = "plate"});
  add_light(scene, {.type = LightType::point, .position = {0.3, 1, 0.2}, .colour = glm::vec3(0.8f)});
  scene.camera = from_above(4, degrees(50));
  return scene;
}

}  // namespace atelier
