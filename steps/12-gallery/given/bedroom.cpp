#include "12-gallery/given/bedroom.hpp"

#include "12-gallery/given/plan.hpp"
#include "scene/builder.hpp"
#include "scene/shapes.hpp"
#include "scene/textures.hpp"

namespace atelier {

namespace {

/// Places boxes in one piece of furniture, whose origin stands on the floor.
class Furniture {
 public:
  Furniture(Scene& scene, const char* name, const glm::dvec3& place, double turn)
      : scene_(scene),
        name_(name),
        node_(add_node(scene, {.name = name,
                               .translation = bedroom_centre + place,
                               .rotation_axis = {0, 1, 0},
                               .rotation_angle = degrees(turn)})) {}

  /// A box of this size, the middle of whose lower side is at `place`.
  void box(int material, const glm::vec3& size, const glm::dvec3& place) {
    add_object(scene_, make_box({.size = size}), material,
               {.name = name_, .parent = node_, .translation = place + glm::dvec3(0, size.y / 2, 0)});
  }

  /// Four legs at the corners of a rectangle.
  void legs(int material, double width, double depth, float height, float thickness) {
    for (const double x : {-0.5, 0.5})
      for (const double z : {-0.5, 0.5}) box(material, {thickness, height, thickness}, {x * width, 0, z * depth});
  }

 private:
  Scene& scene_;
  const char* name_;
  int node_;
};

void add_bed(Scene& scene, int wood, int sheet, int blanket) {
  Furniture bed(scene, "bed", {1.45, 0, -1.1}, 0);
  bed.legs(wood, 1.5, 2.9, 0.35f, 0.1f);
  bed.box(wood, {1.6f, 0.16f, 3}, {0, 0.3, 0});
  bed.box(wood, {1.6f, 0.95f, 0.1f}, {0, 0.3, -1.5});
  bed.box(wood, {1.6f, 0.62f, 0.1f}, {0, 0.3, 1.5});
  bed.box(sheet, {1.45f, 0.2f, 2.85f}, {0, 0.46, 0});
  bed.box(blanket, {1.5f, 0.08f, 1.75f}, {0, 0.64, 0.5});
  for (const double x : {-0.36, 0.36}) bed.box(sheet, {0.62f, 0.16f, 0.42f}, {x, 0.66, -1.1});
}

void add_chair(Scene& scene, const glm::dvec3& place, double turn, int wood, int straw) {
  Furniture chair(scene, "chair", place, turn);
  chair.legs(wood, 0.42, 0.42, 0.45f, 0.06f);
  chair.box(straw, {0.5f, 0.06f, 0.5f}, {0, 0.45, 0});
  for (const double x : {-0.21, 0.21}) chair.box(wood, {0.06f, 0.55f, 0.06f}, {x, 0.5, -0.21});
  for (const double y : {0.62, 0.82}) chair.box(wood, {0.38f, 0.09f, 0.04f}, {0, y, -0.21});
}

void add_table(Scene& scene, int wood, int jug, int cloth) {
  Furniture table(scene, "table", {-1.75, 0, -2.3}, 0);
  table.legs(wood, 0.75, 0.55, 0.7f, 0.08f);
  table.box(wood, {0.95f, 0.07f, 0.75f}, {0, 0.7, 0});
  table.box(cloth, {0.34f, 0.03f, 0.24f}, {0.2, 0.77, 0.15});
  add_object(scene, make_cylinder({.radius = 0.1f, .height = 0.26f, .segments = 24}), jug,
             {.name = "jug", .translation = bedroom_centre + glm::dvec3(-1.95, 0.77, -2.35)});
}

/// A window with two wings before the far wall.
void add_window(Scene& scene, int wood, int glass) {
  Furniture window(scene, "window", {-0.55, 0, -2.97}, 0);
  constexpr double low = 1.0, height = 1.35;
  for (const double x : {-0.3, 0.3}) {
    window.box(glass, {0.5f, 1.2f, 0.02f}, {x, low + 0.08, 0});
    for (const double row : {0.45, 0.85}) window.box(wood, {0.5f, 0.04f, 0.05f}, {x, low + row, 0});
  }
  for (const double x : {-0.6, 0.0, 0.6}) window.box(wood, {0.1f, float(height), 0.08f}, {x, low, 0});
  for (const double y : {low, low + height - 0.08}) window.box(wood, {1.3f, 0.09f, 0.08f}, {0, y, 0});
}

/// Pictures on the walls: flat boxes in frames.
void add_pictures(Scene& scene, int wood, int sky, int portrait, int meadow) {
  const auto hang = [&](const glm::dvec3& place, double turn, int picture, float width, float height) {
    Furniture frame(scene, "picture", place, turn);
    frame.box(wood, {width + 0.12f, height + 0.12f, 0.05f}, {0, 0, 0});
    frame.box(picture, {width, height, 0.02f}, {0, 0.06, 0.03});
  };
  hang({0.75, 1.75, -2.97}, 0, sky, 0.62f, 0.46f);
  hang({2.46, 1.45, -1.6}, -90, portrait, 0.4f, 0.52f);
  hang({2.46, 1.45, -0.8}, -90, meadow, 0.4f, 0.52f);
  hang({-2.46, 1.5, -1.2}, 90, meadow, 0.5f, 0.6f);
}

}  // namespace

void add_bedroom(Scene& scene) {
  const auto paint = [&](const char* name, const glm::vec3& colour) {
    return add_material(scene, plastic(name, colour, 30));
  };
  const int walls = add_material(scene, {.name = "blue wall", .diffuse = {0.3f, 0.45f, 0.68f}});
  const int boards = add_texture(scene, "boards", make_wood({.size = 256, .boards = 8}));
  const int floor = add_material(scene, {.name = "boards", .diffuse = {0.95f, 0.8f, 0.72f}, .diffuse_texture = boards});
  const int ceiling = add_material(scene, {.name = "plaster", .diffuse = {0.42f, 0.5f, 0.45f}});
  const int wood = paint("orange wood", {0.72f, 0.34f, 0.06f}), straw = paint("straw", {0.75f, 0.6f, 0.2f}),
            sheet = paint("sheet", {0.86f, 0.82f, 0.62f}), blanket = paint("blanket", {0.62f, 0.05f, 0.04f}),
            jug = paint("jug", {0.12f, 0.2f, 0.5f}), cloth = paint("cloth", {0.8f, 0.8f, 0.76f}),
            door = paint("side door", {0.36f, 0.5f, 0.62f}), sky = paint("sky", {0.2f, 0.5f, 0.75f}),
            portrait = paint("portrait", {0.55f, 0.42f, 0.16f}), meadow = paint("meadow", {0.16f, 0.42f, 0.14f});
  const int glass =
      add_material(scene, {.name = "panes", .diffuse = {0.55f, 0.7f, 0.4f}, .emission = {0.3f, 0.36f, 0.2f}});
  const glm::vec3 size(bedroom_size);
  const glm::dvec3 middle = bedroom_centre;
  add_object(scene, make_box({.size = size, .side = Side::inside}), walls,
             {.name = "bedroom", .translation = middle + glm::dvec3(0, size.y / 2, 0)});
  add_object(scene, make_plane({.width = size.x, .depth = size.z, .repeat = {1, 1.25f}}), floor,
             {.name = "boards", .translation = middle + glm::dvec3(0, 1.0 / 512, 0)});
  add_object(scene, make_plane({.width = size.x, .depth = size.z}), ceiling,
             {.name = "ceiling",
              .translation = middle + glm::dvec3(0, size.y - 1.0 / 512, 0),
              .rotation_axis = {1, 0, 0},
              .rotation_angle = degrees(180)});
  add_bed(scene, wood, sheet, blanket);
  add_chair(scene, {-0.75, 0, -1.75}, 25, wood, straw);
  add_chair(scene, {-1.65, 0, 0.9}, 75, wood, straw);
  add_table(scene, wood, jug, cloth);
  add_window(scene, wood, glass);
  add_pictures(scene, wood, sky, portrait, meadow);
  Furniture side_door(scene, "side door", {-2.46, 0, -0.1}, 90);
  side_door.box(door, {0.9f, 2.1f, 0.06f}, {0, 0, 0});
  side_door.box(wood, {0.06f, 0.06f, 0.12f}, {0.35, 1, 0.04});
  add_light(scene, {.name = "lamp of the bedroom",
                    .position = middle + glm::dvec3(0.2, 2.6, 0.6),
                    .colour = {1.7f, 1.62f, 1.4f},
                    .attenuation = {1, 0, 0.1f}});
}

}  // namespace atelier
