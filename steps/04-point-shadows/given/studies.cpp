#include "04-point-shadows/given/studies.hpp"

#include <cmath>
#include <numbers>

#include "04-point-shadows/given/walls.hpp"
#include "scene/builder.hpp"
#include "scene/shapes.hpp"

namespace atelier {

namespace {

constexpr double radians_per_degree = std::numbers::pi / 180;

/// A round shadow of `dots`: its offset from the picture's centre and its size, degrees.
struct Dot {
  double aside, up, radius;
};

constexpr int dots_a_side = 6;

/// Rows of dots, with offsets and sizes from the fractional parts of multiples of the golden ratio and sqrt(2), so that
/// no two have the same position relative to the texel grid, and none touch.
Dot dot(int index) {
  const auto fraction = [](double x) { return x - std::floor(x); };
  constexpr double spacing = 3.6;
  const double column = index % dots_a_side - (dots_a_side - 1) / 2.0,
               row = index / dots_a_side - (dots_a_side - 1) / 2.0;
  const double a = fraction(index * std::numbers::phi), b = fraction(index * std::numbers::sqrt2);
  return {.aside = spacing * column + 0.6 * (a - 0.5), .up = spacing * row + 0.6 * (b - 0.5), .radius = 1 + 0.4 * a};
}

/// The unit vector towards a dot; -z is ahead.
glm::dvec3 towards(const Dot& dot) {
  const double x = std::tan(dot.aside * radians_per_degree), y = std::tan(dot.up * radians_per_degree);
  return glm::normalize(glm::dvec3(x, y, -1));
}

}  // namespace

std::vector<SettingSpec> study_settings() {
  return {{.name = "study.angle",
           .fallback = 0.0,
           .low = 0,
           .high = 90,
           .help = "of the scene 'dots': degrees from the middle of a face of the cube"},
          {.name = "study.towards",
           .fallback = std::string("edge"),
           .choices = {"edge", "corner"},
           .help = "of the scene 'dots': what of the cube lies in that direction"}};
}

Scene dots(const Settings& settings) {
  Scene scene{.name = "dots"};
  const int white = add_material(scene, {.name = "white", .diffuse = glm::vec3(0.8f)});
  const glm::vec3 axis = settings.choice("study.towards") == "edge" ? glm::vec3(0, -1, 0) : glm::vec3(1, -1, 0);
  const float angle = degrees(settings.real("study.angle"));
  const int turned = add_node(scene, {.name = "turned", .rotation_axis = axis, .rotation_angle = angle});
  const int plate = add_mesh(scene, make_plane({.width = 2, .depth = 2}));
  add_node(scene, upright({.name = "plate",
                           .parent = turned,
                           .translation = {0, 0, -3},
                           .mesh = plate,
                           .material = white,
                           .casts_shadow = false},
                          0));
  const int ball = add_mesh(scene, make_icosphere({.radius = 1, .subdivisions = 3}));
  for (int i = 0; i < dots_a_side * dots_a_side; ++i)
    add_node(scene, {.name = "ball",
                     .parent = turned,
                     .translation = towards(dot(i)),
                     .scale = glm::vec3(float(std::sin(dot(i).radius * radians_per_degree))),
                     .mesh = ball,
                     .material = white});
  add_light(scene, {.name = "lamp", .position = {0, 0, 0}, .colour = glm::vec3(7)});
  const glm::dvec3 ahead(world_matrices_exact(scene.nodes)[std::size_t(turned)] * glm::dvec4(0, 0, -1, 0));
  scene.camera = {.eye = {0, 0, 0}, .target = ahead, .fov_y = degrees(24), .near = 2, .far = 4};
  return scene;
}

namespace {

/// The room of bare_walls(); returns the rotated group node, with the point light at its origin. The walls do not
/// touch: at a common edge a texel could store one wall and be compared with the other, which no bias covers.
int add_askew_walls(Scene& scene) {
  scene.ambient = glm::vec3(0.05f);
  const int paint = add_material(scene, {.name = "paint", .diffuse = glm::vec3(0.7f)});
  const int askew = add_node(scene, {.name = "askew", .rotation_axis = {1, 2, 0.5f}, .rotation_angle = degrees(35)});
  add_walls(
      scene,
      {.distance = 3, .side = 5.6, .material = paint, .cast = true, .parent = askew, .middle = {-0.4, 2.4, -0.8}});
  add_light(scene, {.name = "lamp", .position = {0, 0, 0}, .colour = glm::vec3(5)});
  const glm::dmat4 world = world_matrices_exact(scene.nodes)[std::size_t(askew)];
  scene.camera = {.eye = glm::dvec3(world * glm::dvec4(2.2, 4.8, 1.9, 1)),
                  .target = glm::dvec3(world * glm::dvec4(-0.4, 0.6, -0.8, 1)),
                  .fov_y = degrees(95),
                  .near = 0.05f,
                  .far = 20};
  return askew;
}

}  // namespace

Scene bare_walls() {
  Scene scene{.name = "bare-walls"};
  add_askew_walls(scene);
  return scene;
}

Scene boards() {
  Scene scene{.name = "boards"};
  const int askew = add_askew_walls(scene);
  const int wood = add_material(scene, {.name = "wood", .diffuse = {0.6f, 0.4f, 0.2f}});
  const int board = add_mesh(scene, make_box({.size = {1, 0.5f, 0.02f}}));
  struct Board {
    glm::dvec3 at;
    glm::vec3 axis;
    double turn;
  };
  // Four on the floor, y = -0.6, and two on a wall, x = -3.4: each with its base on it.
  for (const Board& b : {Board{{-1.2, -0.35, 0.9}, {0, 1, 0}, 60},
                         {{1.1, -0.35, -1.3}, {0, 1, 0}, -35},
                         {{-0.9, -0.35, -2.1}, {0, 1, 0}, 15},
                         {{0.6, -0.35, 1.2}, {0, 1, 0}, 10},
                         {{-3.15, 0.9, -0.6}, {0, 0, 1}, -90},
                         {{-3.15, 2.0, 0.7}, {0, 0, 1}, -90}})
    add_node(scene, {.name = "board",
                     .parent = askew,
                     .translation = b.at,
                     .rotation_axis = b.axis,
                     .rotation_angle = degrees(b.turn),
                     .mesh = board,
                     .material = wood});
  return scene;
}

}  // namespace atelier
