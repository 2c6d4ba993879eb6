#include "07-stencil-portals/given/scenes_through.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "07-stencil-portals/given/scene_parts.hpp"
#include "scene/builder.hpp"
#include "scene/shapes.hpp"

namespace atelier {

namespace {

/// Metres between two rooms.
constexpr double far_away = 40;

void add_post(Scene& scene, int material, const glm::dvec3& foot, float height) {
  add_object(scene, make_box({.size = {0.16f, height, 0.16f}}), material,
             {.name = "post", .translation = foot + glm::dvec3(0, height / 2, 0), .rotation_angle = degrees(20)});
}

}  // namespace

Scene make_lamp_scene() {
  Scene scene{.name = "lamp"};
  scene.ambient = glm::vec3(0.04f);
  const int warm = add_material(scene, {.name = "warm walls", .diffuse = {0.75f, 0.55f, 0.4f}});
  const int grey = add_material(scene, {.name = "grey walls", .diffuse = {0.55f, 0.58f, 0.62f}});
  const int tiles = checkered(scene, "tiles", {0.7f, 0.65f, 0.55f, 1}, {0.4f, 0.32f, 0.26f, 1});
  const int slate = checkered(scene, "slate", {0.6f, 0.63f, 0.66f, 1}, {0.35f, 0.38f, 0.42f, 1});
  const int copper = add_material(scene, metal("copper", copper_reflectance, 60));
  const int white = add_material(scene, plastic("white", glm::vec3(0.8f), 60));
  const Look look = add_look(scene, {0.35f, 0.25f, 0.15f});
  add_room(scene, 0, 0, {7, 3.5f, 7}, warm, tiles);
  add_room(scene, far_away, 0, {7, 3.5f, 8}, grey, slate);
  const int here = add_door(scene, quarter_turned("door here", {0, 1.25, -2}, 0), look);
  const int there = add_door(scene, quarter_turned("door there", {far_away, 1.25, -2.5}, 0), look);
  join(scene, here, there, {0.02f, 0.03f, 0.05f});
  const int glass =
      add_door(scene, {.name = "mirror", .translation = {far_away + 2.4, 1.0, 1.2}, .rotation_angle = degrees(-115)},
               look, 1.4f, 1.6f);
  scene.portals.push_back({.node = glass, .colour = {0.4f, 0.4f, 0.45f}});
  add_post(scene, copper, {0.35, 0, -0.9}, 1.5f);
  add_post(scene, white, {far_away - 0.3, 0, -0.6}, 0.9f);
  add_object(scene, make_sphere({.radius = 0.35f}), copper,
             {.name = "ball", .translation = {far_away - 1.4, 0.35, 0.9}});
  add_light(scene, {.name = "lamp", .position = {0.7, 2.2, 0.9}, .colour = {7, 5.8f, 4.2f}});
  add_light(scene, {.type = LightType::spot,
                    .name = "torch",
                    .position = {far_away + 0.4, 2.6, 0.2},
                    .direction = {2.0f, -1.5f, 1.0f},
                    .colour = {4, 5, 7},
                    .inner_angle = 0.3f,
                    .outer_angle = 0.42f});
  scene.camera = {.eye = {far_away - 1.8, 2.3, 3.6},
                  .target = {far_away + 0.6, 0.6, -0.4},
                  .fov_y = degrees(62),
                  .near = 0.1f,
                  .far = 60};
  return scene;
}

Scene make_astride_scene(double way) {
  Scene scene{.name = "astride"};
  scene.ambient = glm::vec3(0.08f);
  const int warm = add_material(scene, {.name = "warm walls", .diffuse = {0.75f, 0.55f, 0.4f}});
  const int cool = add_material(scene, {.name = "cool walls", .diffuse = {0.4f, 0.55f, 0.75f}});
  const int tiles = checkered(scene, "tiles", {0.7f, 0.65f, 0.55f, 1}, {0.4f, 0.32f, 0.26f, 1});
  const int slate = checkered(scene, "slate", {0.5f, 0.55f, 0.6f, 1}, {0.22f, 0.25f, 0.3f, 1});
  const int red = add_material(scene, plastic("red", {0.75f, 0.12f, 0.08f}, 60));
  const Look look = add_look(scene, {0.35f, 0.25f, 0.15f});
  add_room(scene, -3, 0, {6, 3.5f, 8}, warm, tiles);
  add_room(scene, far_away + 3.25, 0, {6, 3.5f, 8}, cool, slate);
  const int here = add_door(scene, quarter_turned("door here", {-2, 1.25, -1.5}, 0), look);
  const int there = add_door(scene, quarter_turned("door there", {far_away + 2.5, 1.25, -1.5}, 0), look);
  join(scene, here, there, {0.02f, 0.03f, 0.05f});
  add_traveller(scene, here, there, make_box({.size = {0.5f, 0.7f, 1.4f}}), red,
                {.name = "body",
                 .translation = {0.1, -0.35, 1.4 - 2.8 * way},
                 .rotation_axis = {0.2f, 1, 0.1f},
                 .rotation_angle = degrees(35)});
  add_light(scene, {.name = "lamp here", .position = {-2.9, 2.8, 0.8}, .colour = {6, 5.2f, 4.2f}});
  add_light(scene, {.name = "lamp there", .position = {far_away + 3.6, 2.8, 0.6}, .colour = {3.6f, 4.6f, 6}});
  scene.camera = {.eye = {-0.9, 2.0, 3.4}, .target = {-1.7, 0.9, -1.5}, .fov_y = degrees(58), .near = 0.1f, .far = 60};
  return scene;
}

namespace {

/// Of a particle, in the frame of the door that it goes through. `s`: from 0 (at the rim) over 1/2 (in the plane) to 1.
struct Flight {
  glm::dvec3 position;
  double size = 0;  ///< 0..1
};

double fraction(double x) {
  return x - std::floor(x);
}

Flight flight_of(double start_angle, double inner_radius, double s) {
  constexpr double pi = std::numbers::pi;
  const double u = 2 * s - 1;  // -1..1
  const double angle = start_angle + 2.6 * u, radius = inner_radius + (1.1 - inner_radius) * u * u;
  return {
      {radius * std::cos(angle) * door_width / 2, radius * std::sin(angle) * door_height / 2, -0.55 * std::sin(pi * u)},
      1 - std::pow(u, 6)};
}

}  // namespace

Scene make_swirl_scene(int particles, double time) {
  Scene scene{.name = "swirl"};
  scene.ambient = {0.05f, 0.055f, 0.08f};
  scene.background = {0.02f, 0.025f, 0.05f};
  const int ground = checkered(scene, "ground", {0.3f, 0.3f, 0.34f, 1}, {0.16f, 0.16f, 0.2f, 1});
  const int copper = add_material(scene, metal("copper", copper_reflectance, 60));
  const Look look = add_look(scene, {0.35f, 0.28f, 0.2f});
  std::array<int, 3> glows{};
  const std::array<glm::vec3, 3> colours{glm::vec3(1, 0.55f, 0.12f), glm::vec3(0.95f, 0.25f, 0.1f),
                                         glm::vec3(0.3f, 0.6f, 1)};
  for (std::size_t i = 0; i < glows.size(); ++i)
    glows[i] = add_material(scene, {.name = "glow", .diffuse = glm::vec3(0), .emission = colours[i]});
  add_object(scene, make_plane({.width = 14, .depth = 10, .repeat = {7, 5}}), ground, {.name = "ground"});
  const int left =
      add_door(scene, {.name = "left door", .translation = {-1.4, 1.25, 0}, .rotation_angle = degrees(24)}, look);
  const int right =
      add_door(scene, {.name = "right door", .translation = {1.4, 1.25, -0.3}, .rotation_angle = degrees(-32)}, look);
  join(scene, left, right, {0.05f, 0.03f, 0.02f});
  add_object(scene, make_teapot({.height = 0.6f}), copper, {.name = "teapot", .translation = {0.1, 0, 1.3}});
  const Mesh spark = make_icosphere({.radius = 0.032f, .subdivisions = 1});
  for (int i = 0; i < particles; ++i) {
    // The R3 sequence (M. Roberts, "The unreasonable effectiveness of quasirandom sequences", 2018): even without
    // random numbers.
    const glm::dvec3 even = double(i + 1) * glm::dvec3(0.8191725133961645, 0.6710436067037893, 0.5497004779019703);
    const Flight flight =
        flight_of(2 * std::numbers::pi * fraction(even.x), 0.1 + 0.75 * fraction(even.y), fraction(time + even.z));
    const bool from_left = i % 2 == 0;
    add_traveller(scene, from_left ? left : right, from_left ? right : left, spark, glows[std::size_t(i) % 3],
                  {.name = "particle",
                   .translation = flight.position,
                   .scale = glm::vec3(float(std::max(flight.size, 0.01))),
                   .casts_shadow = false});
  }
  add_light(scene, {.position = {-0.5, 3.2, 3}, .colour = {3.2f, 3.4f, 4}, .casts_shadow = false});
  scene.camera = {.eye = {0.1, 1.55, 4.6}, .target = {0, 1.1, 0}, .fov_y = degrees(48), .near = 0.1f, .far = 60};
  return scene;
}

}  // namespace atelier
