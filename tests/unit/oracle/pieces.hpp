// Small scenes and cameras for the tests of the oracle.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "oracle/oracle.hpp"
#include "scene/builder.hpp"
#include "scene/shapes.hpp"

namespace atelier::test {

inline constexpr double pi = std::numbers::pi;

/// A scene with one matte white material and no light of any kind.
inline Scene dark_scene(const glm::vec3& diffuse = glm::vec3(1)) {
  Scene scene{.name = "test"};
  scene.ambient = glm::vec3(0);
  scene.materials = {{.name = "matte", .diffuse = diffuse}};
  return scene;
}

/// Looks down on the ground from high above, without perspective: the picture is a map, x to the right, -z up.
inline Camera map_camera(float metres) {
  return {.eye = {0, 100, 0},
          .target = {0, 0, 0},
          .up = {0, 0, -1},
          .projection = Projection::orthographic,
          .height = metres,
          .near = 1,
          .far = 200};
}

/// Where on the map a pixel's middle lies: x and z in metres.
inline glm::dvec2 on_map(int x, int y, int pixels, double metres) {
  return {((x + 0.5) / pixels - 0.5) * metres, ((y + 0.5) / pixels - 0.5) * metres};
}

/// The ground as an exact rectangle, `half` metres to each side.
inline oracle::Shape ground(double half) {
  return {.surface = oracle::Rectangle{.half_u = {half, 0, 0}, .half_v = {0, 0, -half}}};
}

/// A number 0..1 from a running state: the same on every machine (Steele, Lea, Flood, splitmix64).
class Dice {
 public:
  double next() {
    state_ += 0x9e3779b97f4a7c15ull;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return double((z ^ (z >> 31)) >> 11) * 0x1p-53;
  }
  glm::dvec3 in_cube() { return {2 * next() - 1, 2 * next() - 1, 2 * next() - 1}; }

 private:
  std::uint64_t state_ = 1;
};

}  // namespace atelier::test
