#include <cmath>
#include <numbers>

#include "scene/builder.hpp"
#include "scene/builtin_scenes.hpp"
#include "scene/relief.hpp"
#include "scene/shapes.hpp"
#include "scene/textures.hpp"

namespace atelier::builtin {

void hang_lamp(Scene& scene, const glm::dvec3& hook, float cord, const glm::vec3& colour) {
  const int black = add_material(
      scene, {.name = "lamp", .diffuse = glm::vec3(0.04f), .specular = glm::vec3(0.2f), .two_sided = true});
  const int glass = add_material(scene, {.name = "bulb", .diffuse = glm::vec3(0), .emission = colour / 4.0f});
  const int top = add_node(scene, {.name = "lamp", .translation = hook});
  const auto hang = [&](const char* name, Mesh mesh, int material, double height) {
    Node node{.name = name, .parent = top, .translation = {0, height, 0}, .casts_shadow = false};
    add_object(scene, std::move(mesh), material, node);
  };
  hang("cord", make_cylinder({.radius = 0.012f, .height = cord, .segments = 12}), black, -cord);
  Mesh shade = make_cone({.radius = 0.3f, .height = 0.26f});
  shade.indices.resize(3 * 48);  // only the cone's side: a shade has no base
  hang("shade", std::move(shade), black, -cord - 0.2);
  hang("bulb", make_sphere({.radius = 0.075f, .segments = 32, .rings = 16}), glass, -cord - 0.17);
  add_light(scene, {.name = "lamp", .position = hook - glm::dvec3(0, cord + 0.2, 0), .colour = colour});
}

namespace {

/// The size of the room in metres; the origin is in the middle of the floor.
constexpr float room_width = 6, room_depth = 5, room_height = 3;

void add_room_shell(Scene& scene, int floor, int walls, int ceiling) {
  const Mesh boards =
      make_plane({.width = room_width, .depth = room_depth, .repeat = {2, 2}, .columns = 12, .rows = 10});
  add_object(scene, boards, floor, {.name = "floor"});
  add_object(scene, make_plane({.width = room_width, .depth = room_depth, .columns = 12, .rows = 10}), ceiling,
             {.name = "ceiling",
              .translation = {0, room_height, 0},
              .rotation_axis = {1, 0, 0},
              .rotation_angle = degrees(180)});
  for (int side = 0; side < 4; ++side) {  // the back wall, then rotated by quarter turns
    const bool long_wall = side % 2 == 0;
    const double away = (long_wall ? room_depth : room_width) / 2, yaw = side * std::numbers::pi / 2;
    const Mesh wall =
        make_plane({.width = long_wall ? room_width : room_depth, .depth = room_height, .columns = 12, .rows = 6});
    const glm::dvec3 middle(-away * std::sin(yaw), room_height / 2, -away * std::cos(yaw));
    add_object(scene, wall, walls, upright({.name = "wall", .translation = middle}, yaw));
  }
}

/// A canvas on a wall, in a frame of 6 cm. `yaw` turns the wall's normal from +z, counter-clockwise from above.
void hang_picture(Scene& scene, int frame, const char* name, Image pixels, const glm::vec2& size,
                  const glm::dvec3& place, double yaw) {
  constexpr float border = 0.06f, thickness = 0.06f;
  const Node centre{.name = name, .translation = place, .rotation_angle = float(yaw)};
  add_object(scene, make_box({.size = {size.x + 2 * border, size.y + 2 * border, thickness}}), frame, centre);
  const int canvas = add_material(
      scene,
      {.name = name, .diffuse = glm::vec3(0.95f), .diffuse_texture = add_texture(scene, name, std::move(pixels))});
  Node front = centre;
  front.translation += (thickness / 2 + 0.005) * glm::dvec3(std::sin(yaw), 0, std::cos(yaw));
  add_object(scene, make_plane({.width = size.x, .depth = size.y}), canvas, upright(front, yaw));
}

void add_round_table(Scene& scene, int top, int leg, const glm::dvec3& place) {
  const int table = add_node(scene, {.name = "table", .translation = place});
  const auto part = [&](const char* name, Mesh mesh, int material, double height) {
    add_object(scene, std::move(mesh), material, {.name = name, .parent = table, .translation = {0, height, 0}});
  };
  part("table top", make_cylinder({.radius = 0.8f, .height = 0.05f, .segments = 64}), top, 0.72);
  part("table leg", make_cylinder({.radius = 0.06f, .height = 0.72f, .segments = 32}), leg, 0);
  part("table foot", make_cone({.radius = 0.4f, .height = 0.12f, .segments = 64}), leg, 0);
  const int glaze = add_material(scene, plastic("glaze", {0.1f, 0.25f, 0.6f}, 100));
  part("teapot", make_teapot({.height = 0.34f}), glaze, 0.77);
}

}  // namespace

Scene room() {
  Scene scene;
  const int boards = add_texture(scene, "boards", make_wood({.size = 256, .boards = 6}));
  const int floor = add_material(scene, {.name = "floor",
                                         .diffuse = glm::vec3(0.85f),
                                         .specular = glm::vec3(0.1f),
                                         .exponent = 30,
                                         .diffuse_texture = boards});
  const int paint = add_material(scene, {.name = "paint", .diffuse = {0.5f, 0.58f, 0.55f}});
  const int white = add_material(scene, {.name = "white", .diffuse = glm::vec3(0.7f)});
  const int dark = add_material(scene, plastic("frame", {0.09f, 0.05f, 0.02f}, 40));
  add_room_shell(scene, floor, paint, white);

  constexpr double quarter = std::numbers::pi / 2;
  hang_picture(scene, dark, "grid", make_uv_grid(), {1.1f, 1.1f}, {0, 1.75, -2.5}, 0);
  hang_picture(scene, dark, "dots", make_dots(), {0.8f, 0.8f}, {-1.8, 1.7, -2.5}, 0);
  hang_picture(scene, dark, "marble", make_marble({.size = 256}), {0.8f, 0.8f}, {1.8, 1.7, -2.5}, 0);
  hang_picture(scene, dark, "bricks", make_bricks({.size = 256}).colour, {1.4f, 0.9f}, {-3, 1.7, -0.6}, quarter);
  hang_picture(scene, dark, "squares", make_checker(), {0.9f, 0.9f}, {3, 1.7, -0.6}, -quarter);
  add_round_table(scene, white, dark, {0.75, 0, -0.5});

  hang_lamp(scene, {0.75, room_height, -0.5}, 0.6f, {2.5f, 2.2f, 1.8f});
  add_light(scene,
            {.name = "entrance", .position = {-0.5, 2.3, 2.3}, .colour = {3.2f, 3.3f, 3.5f}, .casts_shadow = false});
  scene.ambient = glm::vec3(0.12f);
  scene.camera = {.eye = {0, 1.6, 2.45}, .target = {0, 1.4, -1}, .fov_y = degrees(64), .near = 0.1f, .far = 20};
  return scene;
}

Scene hall() {
  Scene scene;
  constexpr float radius = 6, height = 4.5f;
  const Relief bricks = make_bricks({.size = 256});
  const int brick = add_material(scene, {.name = "bricks",
                                         .diffuse = glm::vec3(0.95f),
                                         .diffuse_texture = add_texture(scene, "bricks", bricks.colour),
                                         .normal_texture = add_texture(scene, "brick normals", bricks.normal),
                                         .height_texture = add_texture(scene, "brick heights", bricks.height)});
  const int squares = add_texture(
      scene, "squares", make_checker({.squares = 2, .first = {0.5f, 0.48f, 0.44f}, .second = {0.1f, 0.1f, 0.11f}}));
  const int tiles = add_material(scene, {.name = "tiles",
                                         .diffuse = glm::vec3(0.9f),
                                         .specular = glm::vec3(0.1f),
                                         .exponent = 60,
                                         .diffuse_texture = squares});
  const int plaster = add_material(scene, {.name = "plaster", .diffuse = {0.6f, 0.57f, 0.5f}});
  const int stone = add_material(scene, {.name = "marble",
                                         .diffuse = glm::vec3(0.8f),
                                         .specular = glm::vec3(0.2f),
                                         .exponent = 80,
                                         .diffuse_texture = add_texture(scene, "marble", make_marble({.size = 256}))});

  // Floor and ceiling are squares; the wall hides their corners.
  add_object(
      scene,
      make_cylinder_wall({.radius = radius, .height = height, .segments = 96, .side = Side::inside, .repeat = {12, 2}}),
      brick, {.name = "wall"});
  const Mesh square =
      make_plane({.width = 2 * radius, .depth = 2 * radius, .repeat = {12, 12}, .columns = 24, .rows = 24});
  add_object(scene, square, tiles, {.name = "floor"});
  add_object(
      scene, square, plaster,
      {.name = "ceiling", .translation = {0, height, 0}, .rotation_axis = {1, 0, 0}, .rotation_angle = degrees(180)});

  const int column = add_mesh(scene, make_cylinder({.radius = 0.28f, .height = height, .segments = 48}));
  for (int i = 0; i < 8; ++i) {
    const double turn = std::numbers::pi * (i + 0.5) / 4;
    add_node(scene, {.name = "column",
                     .translation = {4.6 * std::cos(turn), 0, 4.6 * std::sin(turn)},
                     .mesh = column,
                     .material = stone});
  }
  const auto exhibit = [&](const char* name, Mesh mesh, const Material& material, const glm::dvec3& place, Node pose) {
    pose.name = name;
    pose.parent = add_object(scene, make_cylinder({.radius = 0.5f, .height = 0.9f}), stone,
                             {.name = "pedestal", .translation = place});
    add_object(scene, std::move(mesh), add_material(scene, material), pose);
  };
  exhibit("sphere", make_sphere({.radius = 0.42f}), metal("gold", gold_reflectance, 60), {-1.8, 0, -0.5},
          {.translation = {0, 1.32, 0}});
  exhibit("teapot", make_teapot({.height = 0.7f}), metal("copper", copper_reflectance, 50), {0, 0, -1.2},
          {.translation = {0, 0.9, 0}, .rotation_angle = degrees(-15)});
  exhibit("torus", make_torus({.ring_radius = 0.34f, .tube_radius = 0.13f}), plastic("jade", {0.06f, 0.35f, 0.16f}, 90),
          {1.8, 0, -0.5}, {.translation = {0, 1.37, 0}, .rotation_axis = {1, 0, 0}, .rotation_angle = degrees(78)});
  hang_lamp(scene, {-1.6, height, 1.4}, 0.8f, {9, 8, 6.4f});
  hang_lamp(scene, {1.8, height, 0.8}, 0.8f, {9, 8, 6.4f});
  scene.ambient = glm::vec3(0.07f);
  scene.camera = {.eye = {0, 1.9, 5.2}, .target = {0, 1.5, -1}, .fov_y = degrees(58), .near = 0.1f, .far = 30};
  return scene;
}

}  // namespace atelier::builtin
