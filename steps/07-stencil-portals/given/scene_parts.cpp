#include "07-stencil-portals/given/scene_parts.hpp"

#include <array>

#include "scene/builder.hpp"
#include "scene/shapes.hpp"
#include "scene/textures.hpp"

namespace atelier {

Node quarter_turned(const char* name, const glm::dvec3& at, int quarters) {
  constexpr std::array<float, 4> cosines{1, 0, -1, 0}, sines{0, 1, 0, -1};
  const float c = cosines[std::size_t(quarters % 4)], s = sines[std::size_t(quarters % 4)];
  return {.name = name,
          .matrix = glm::mat4(c, 0, -s, 0, 0, 1, 0, 0, s, 0, c, 0, float(at.x), float(at.y), float(at.z), 1)};
}

namespace {

/// A rectangle in the plane z = 0, facing +z, around the origin.
Mesh opening_mesh(float width, float height) {
  const auto corner = [&](float x, float y) {
    return Vertex{{x * width, y * height, 0}, {0, 0, 1}, {x + 0.5f, y + 0.5f}};
  };
  return {.name = "opening",
          .vertices = {corner(-0.5f, -0.5f), corner(0.5f, -0.5f), corner(0.5f, 0.5f), corner(-0.5f, 0.5f)},
          .indices = {0, 1, 2, 0, 2, 3}};
}

/// Four bars around an opening, as children of its node; the opening stays free.
void add_bars(Scene& scene, int parent, int material, float width, float height) {
  constexpr float thick = 0.125f;
  const auto bar = [&](float w, float h, float x, float y) {
    Node node{.name = "bar", .parent = parent, .translation = {x, y, 0}};
    add_object(scene, make_box({.size = {w, h, thick}}), material, node);
  };
  const float x = (width + thick) / 2, y = (height + thick) / 2;
  bar(thick, height + 2 * thick, -x, 0);
  bar(thick, height + 2 * thick, x, 0);
  bar(width, thick, 0, y);
  bar(width, thick, 0, -y);
}

}  // namespace

Look add_look(Scene& scene, const glm::vec3& colour, bool two_sided) {
  return {add_material(scene, {.name = "opening", .two_sided = two_sided}),
          add_material(scene, plastic("frame", colour, 40))};
}

int add_door(Scene& scene, Node node, const Look& look, float width, float height) {
  const int door = add_object(scene, opening_mesh(width, height), look.opening, std::move(node));
  add_bars(scene, door, look.frame, width, height);
  return door;
}

void join(Scene& scene, int a, int b, const glm::vec3& colour) {
  scene.portals.push_back({.node = a, .exit = b, .colour = colour});
  scene.portals.push_back({.node = b, .exit = a, .colour = colour});
}

void add_room(Scene& scene, double x, double z, const glm::vec3& size, int walls, int floor) {
  add_object(scene, make_box({.size = size, .side = Side::inside}), walls,
             {.name = "room", .translation = {x, size.y / 2, z}});
  add_object(scene, make_plane({.width = size.x, .depth = size.z, .repeat = {size.x / 2, size.z / 2}}), floor,
             {.name = "floor", .translation = {x, 1.0 / 1024, z}});
}

int checkered(Scene& scene, const char* name, const Rgba& first, const Rgba& second) {
  const int texture = add_texture(
      scene, name, make_checker({.size = 64, .squares = 2, .first = first, .second = second}), Filter::linear);
  return add_material(scene, {.name = name, .diffuse_texture = texture});
}

void add_lamp(Scene& scene, const glm::dvec3& at, const glm::vec3& colour) {
  add_light(scene, {.type = LightType::point, .position = at, .colour = colour, .casts_shadow = false});
}

int add_traveller(Scene& scene, int entry, int exit, Mesh mesh, int material, Node node) {
  node.parent = entry;
  node.travels = true;
  if (node.translation.z < 0)  // it has gone through
    node.parent = add_node(
        scene,
        {.name = "way out", .parent = exit, .matrix = glm::mat4(-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1)});
  return add_object(scene, std::move(mesh), material, node);
}

}  // namespace atelier
