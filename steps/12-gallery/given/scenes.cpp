#include "12-gallery/given/scenes.hpp"

#include <fmt/core.h>

#include <array>
#include <cmath>

#include "12-gallery/given/bedroom.hpp"
#include "12-gallery/given/walk.hpp"
#include "base/error.hpp"
#include "scene/builder.hpp"
#include "scene/relief.hpp"
#include "scene/shapes.hpp"
#include "scene/textures.hpp"

namespace atelier {

std::vector<SettingSpec> gallery_scene_settings() {
  return {
      {.name = "hall.segments", .fallback = 64, .low = 6, .high = 4096, .help = "flat sides of the hall's wall"},
      {.name = "gallery.room",
       .fallback = -1,
       .low = -1,
       .high = paintings_in_hall - 1,
       .help = "where the visitor is: in the room behind a painting, 0 to 5, or in the hall, -1"},
      {.name = "gallery.portals",
       .fallback = 0,
       .low = 0,
       .high = paintings_in_hall,
       .help = "how many paintings are portals of step 07, which show a room without its style; the others are "
               "previews"},
  };
}

std::string painting_name(int painting) {
  return painting == paintings_in_hall ? "door" : fmt::format("painting {}", painting);
}

namespace {

/// The rectangle of a painting, in the plane z = 0 of its frame.
Mesh canvas() {
  const auto corner = [](float x, float y) {
    return Vertex{{x * painting_half_size.x, y * painting_half_size.y, 0}, {0, 0, 1}, {(x + 1) / 2, (y + 1) / 2}};
  };
  return {.name = "canvas",
          .vertices = {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)},
          .indices = {0, 1, 2, 0, 2, 3}};
}

/// Four bars around a painting, behind its plane. The carving runs along them: on their ends it has no direction, as
/// the texture coordinates are the same in all corners.
void add_frame(Scene& scene, int parent, int material) {
  constexpr float thick = 0.11f, deep = 0.26f;  // as far as the wall
  const glm::vec2 half(painting_half_size);
  const auto bar = [&](const glm::vec2& size, const glm::dvec2& at) {
    Mesh mesh = make_box({.size = {size, deep}});
    const bool tall = size.y > size.x;
    for (Vertex& vertex : mesh.vertices) {
      const bool end = std::abs(tall ? vertex.normal.y : vertex.normal.x) > 0.5f;
      if (end) vertex.texcoord = glm::vec2(0.25f);
    }
    add_object(scene, std::move(mesh), material,
               {.name = "frame", .parent = parent, .translation = glm::dvec3(at, -deep / 2)});
  };
  const double x = half.x + thick / 2, y = half.y + thick / 2;
  for (const double side : {-1.0, 1.0}) {
    bar({thick, 2 * half.y + 2 * thick}, {side * x, 0});
    bar({2 * half.x, thick}, {0, side * y});
  }
}

/// A painting, which is a plain dark canvas until its preview is recorded.
int add_painting(Scene& scene, int number, const glm::dmat4& frame, int carved) {
  const std::string name = painting_name(number);
  const auto texture = [&](const char* map, const Rgba& value) {
    return add_texture(scene, name + map, Image(2, 2, value), Filter::mipmap, Wrap::clamp_to_edge);
  };
  const int material = add_material(scene, {.name = name,
                                            .diffuse = glm::vec3(0.9f),
                                            .diffuse_texture = texture(" colour", {0.05f, 0.045f, 0.04f}),
                                            .normal_texture = texture(" normal", {0.502f, 0.5f, 1.0f}),
                                            .height_texture = texture(" height", {0.998f, 0.998f, 0.998f})});
  const int place = add_node(scene, {.name = name + " place", .translation = glm::dvec3(frame[3])});
  const int node =
      add_node(scene, {.name = name + " frame", .parent = place, .matrix = glm::mat4(glm::dmat4(glm::dmat3(frame)))});
  const int opening = add_object(scene, canvas(), material,
                                 {.name = name, .parent = node, .casts_shadow = false});  // on its own relief
  add_frame(scene, node, carved);
  return opening;
}

void add_hall(Scene& scene, const HallParts& hall) {
  const int paper = add_texture(
      scene, "wallpaper",
      make_dots(
          {.size = 256, .dots = 8, .radius = 0.2f, .dot = {0.55f, 0.4f, 0.22f}, .ground = {0.62f, 0.56f, 0.46f}}));
  const int marble = add_texture(scene, "marble", make_marble({.size = 256, .bands = 3}));
  const int wall = add_material(scene, {.name = "wallpaper", .diffuse = glm::vec3(1), .diffuse_texture = paper});
  const int floor = add_material(scene, {.name = "marble",
                                         .diffuse = {0.4f, 0.36f, 0.32f},
                                         .specular = glm::vec3(0.2f),
                                         .exponent = 60,
                                         .diffuse_texture = marble});
  const int plaster = add_material(scene, {.name = "plaster", .diffuse = {0.5f, 0.48f, 0.44f}});
  const int stone = add_material(scene, plastic("stone", {0.6f, 0.58f, 0.55f}, 20));
  const int brass = add_material(scene, metal("brass", gold_reflectance, 50));
  const int bulb = add_material(scene, {.name = "bulb", .diffuse = glm::vec3(0.5f), .emission = {1.6f, 1.5f, 1.2f}});
  constexpr float side = 2.1f * float(hall_radius);
  // Floor and ceiling are plain rectangles: the wall hides what stands out.
  add_object(scene, hall.wall, wall, {.name = "wall"});
  add_object(scene, make_plane({.width = side, .depth = side, .repeat = {6, 6}}), floor, {.name = "floor"});
  add_object(scene, make_plane({.width = side, .depth = side}), plaster,
             {.name = "ceiling",
              .translation = {0, hall_height, 0},
              .rotation_axis = {1, 0, 0},
              .rotation_angle = degrees(180)});
  add_object(scene, make_box({.size = {1.8f, 0.42f, 0.5f}}), stone,
             {.name = "bench", .translation = {0.4, 0.21, 0.9}, .rotation_angle = degrees(20)});
  for (const double turn : {30.0, 150.0, 270.0}) {
    const double angle = double(degrees(turn));
    const glm::dvec3 at(3.9 * std::sin(angle), 0, -3.9 * std::cos(angle));
    add_object(scene, make_box({.size = {0.44f, 1, 0.44f}}), stone,
               {.name = "plinth", .translation = at + glm::dvec3(0, 0.5, 0), .rotation_angle = degrees(-turn)});
    add_object(scene, make_teapot({.height = 0.3f, .subdivisions = 6}), brass,
               {.name = "teapot", .translation = at + glm::dvec3(0, 1, 0), .rotation_angle = degrees(90 - turn)});
  }
  const glm::dvec3 lamp(0, 3, 0);
  add_object(scene, make_sphere({.radius = 0.12f, .segments = 24, .rings = 12}), bulb,
             {.name = "bulb", .translation = lamp, .casts_shadow = false, .receives_shadow = false});
  add_object(scene, make_cylinder({.radius = 0.015f, .height = 0.6f, .segments = 12}), brass,
             {.name = "rod", .translation = lamp, .casts_shadow = false});
  add_light(scene,
            {.name = "lamp of the hall", .position = lamp, .colour = {2.1f, 2, 1.8f}, .attenuation = {1, 0, 0.04f}});
}

}  // namespace

Scene gallery_with(const HallParts& hall, const Settings& settings) {
  Scene scene{.name = "gallery"};
  scene.ambient = glm::vec3(0.16f);
  Relief carving = make_relief(64, 0.06f, [](double u, double v) -> ReliefPoint {
    const double wave = std::sin(6.283185307179586 * 4 * u) * std::sin(6.283185307179586 * 2 * v);
    return {glm::dvec3(0.5), 0.5 + 0.5 * wave};
  });
  const int carved =
      add_relief(scene, plastic("carved wood", {0.5f, 0.33f, 0.1f}, 40), std::move(carving), false, Filter::mipmap);
  scene.materials[std::size_t(carved)].height_texture.reset();  // normals alone
  add_hall(scene, hall);
  add_bedroom(scene);
  std::array<int, paintings_in_hall> paintings{};
  for (int i = 0; i < paintings_in_hall; ++i)
    paintings[std::size_t(i)] = add_painting(scene, i, hall.paintings[std::size_t(i)], carved);
  const int door = add_painting(scene, paintings_in_hall, door_frame(), carved);
  const int portals = settings.integer("gallery.portals"), room = visited_room(settings);
  for (int i = 0; i < portals; ++i)
    scene.portals.push_back({.node = paintings[std::size_t(i)], .exit = door, .colour = glm::vec3(0.05f)});
  if (room >= 0 && room < portals)
    scene.portals.push_back({.node = door, .exit = paintings[std::size_t(room)], .colour = glm::vec3(0.05f)});
  if (room < 0)
    scene.camera = {.eye = {0.6, 1.7, 3.4}, .target = {-0.2, 1.5, -4}};
  else
    scene.camera = {.eye = bedroom_centre + glm::dvec3(0.2, 1.7, 2.5),
                    .target = bedroom_centre + glm::dvec3(0, 1.1, -2)};
  scene.camera.fov_y = degrees(62);
  scene.camera.near = 0.05f;
  scene.camera.far = 20;
  return scene;
}

const SceneTable& gallery_scenes() {
  static const SceneTable scenes = {
      {"gallery",
       [](const Settings& settings) {
         return gallery_with(students_hall(settings.integer("hall.segments")), settings);
       }},
  };
  return scenes;
}

}  // namespace atelier
