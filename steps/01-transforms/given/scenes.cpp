#include "01-transforms/given/scenes.hpp"

#include <glm/gtc/constants.hpp>

#include "01-transforms/transforms.hpp"
#include "scene/builder.hpp"
#include "scene/builtin.hpp"
#include "scene/round_enough.hpp"
#include "scene/shapes.hpp"

namespace atelier {

namespace {

int matte(Scene& scene, const std::string& name, const glm::vec3& colour, bool two_sided = false) {
  return add_material(scene, {.name = name, .diffuse = colour, .two_sided = two_sided});
}

/// Low-poly solids, stretched, flattened and mirrored: the hard cases for normals.
Scene stretched() {
  Scene scene{.name = "stretched"};
  scene.background = {0.05f, 0.06f, 0.08f};
  const int clay = matte(scene, "clay", {0.8f, 0.45f, 0.3f}), slate = matte(scene, "slate", {0.35f, 0.5f, 0.7f}),
            moss = matte(scene, "moss", {0.45f, 0.65f, 0.3f}, true);
  const int ball = add_mesh(scene, make_icosphere({.radius = 0.8f, .subdivisions = 1}));
  const int teapot = add_mesh(scene, make_teapot({.height = 1.1f, .subdivisions = 6}));
  add_node(scene, {.name = "plain", .translation = {-3, 0.2, 0}, .mesh = ball, .material = clay});
  add_node(scene, {.name = "stretched",
                   .translation = {-1, 0.2, 0},
                   .rotation_axis = {0, 0, 1},
                   .rotation_angle = 0.5f,
                   .scale = {0.45f, 1.6f, 0.8f},
                   .mesh = ball,
                   .material = slate});
  add_node(scene,
           {.name = "mirrored", .translation = {1.2, -0.6, 0}, .scale = {-1, 1, 1}, .mesh = teapot, .material = clay});
  add_node(scene, {.name = "flattened",
                   .translation = {3, 0.2, 0},
                   .rotation_axis = {0, 1, 0},
                   .rotation_angle = 0.6f,
                   .scale = {1, 1, 0},
                   .mesh = ball,
                   .material = moss});
  scene.camera = {.eye = {0, 1.6, 11}, .target = {0, 0.1, 0}, .fov_y = degrees(40), .near = 0.5f, .far = 50};
  return scene;
}

/// The number of pieces: hall.segments, or, if hall.fit is set, the least number with a sagitta of at most half a pixel
/// in a picture of that height from the scene's own camera. Computed for the point of the wall nearest to that camera,
/// seen head-on, whether or not it is in the picture. --eye has no effect: a camera nearer to the wall may see an error
/// of more than half a pixel.
int hall_segments(const Settings& settings, const Camera& camera) {
  const int height = settings.integer("hall.fit");
  if (height == 0) return settings.integer("hall.segments");
  const double nearest = double(hall_radius) - std::hypot(camera.eye.x, camera.eye.z);
  return segments_for({.radius = hall_radius, .distance = nearest, .fov_y = camera.fov_y, .height = height});
}

/// The cylindrical hall from step 01's own wall, with square floor and ceiling whose corners the wall hides.
Scene hall(const Settings& settings) {
  const float radius = hall_radius, height = hall_height;
  Scene scene = empty_hall();
  const int segments = hall_segments(settings, scene.camera);
  add_object(scene, transforms::cylinder_wall(radius, height, segments), 0, {.name = "wall"});
  add_object(scene, transforms::rectangle({0, 0, 0}, {radius, 0, 0}, {0, 0, -radius}), 1, {.name = "floor"});
  add_object(scene, transforms::rectangle({0, height, 0}, {radius, 0, 0}, {0, 0, radius}), 2, {.name = "ceiling"});
  return scene;
}

/// A hundred boxes, each on the corner of the previous one: a single wrong product destroys the spiral.
/// Every child is listed before its parent.
Scene spiral() {
  Scene scene{.name = "spiral"};
  scene.background = {0.04f, 0.05f, 0.07f};
  const int box = add_mesh(scene, make_box({.size = glm::vec3(0.9f, 0.3f, 0.9f)}));
  const int amber = matte(scene, "amber", {0.9f, 0.6f, 0.2f}), teal = matte(scene, "teal", {0.2f, 0.55f, 0.6f});
  const int count = 100;
  for (int i = 0; i < count; ++i) {
    const bool root = i + 1 == count;
    Node node{.name = "step",
              .parent = root ? -1 : i + 1,
              .translation = {0.42, 0.24, 0},
              .rotation_axis = {0, 1, 0},
              .rotation_angle = degrees(17),
              .scale = glm::vec3(0.985f),
              .mesh = box,
              .material = i % 2 ? amber : teal};
    if (root) node.translation = {0, 0, 0}, node.scale = glm::vec3(1);
    add_node(scene, node);
  }
  scene.camera = {.eye = {4.2, 9.5, 7.5}, .target = {0, 4.6, -1.2}, .fov_y = degrees(50), .near = 0.5f, .far = 60};
  return scene;
}

/// Pairs of slats with a tiny gap, far behind a near plane that is very near: tests depth precision.
Scene slats() {
  Scene scene{.name = "slats"};
  scene.background = {0.02f, 0.02f, 0.03f};
  const int red = matte(scene, "red", {0.85f, 0.2f, 0.15f}, true),
            blue = matte(scene, "blue", {0.15f, 0.3f, 0.85f}, true);
  for (int i = 0; i < 8; ++i) {
    // In each row blue is in front of red by a ten-thousandth of its distance.
    const float distance = 20.0f * std::pow(2.2f, float(i)), size = distance * 0.055f,
                y = distance * (0.36f - 0.1f * float(i));
    const Mesh wide = make_box({.size = {size * 14, size, size * 1e-3f}}),
               narrow = make_box({.size = {size * 7, size, size * 1e-3f}});
    add_object(scene, wide, red, {.name = "behind", .translation = {0, y, -distance}});
    add_object(scene, narrow, blue, {.name = "before", .translation = {distance * 0.13f, y, -distance * (1 - 1e-4f)}});
  }
  scene.camera = {.eye = {0, 0, 0}, .target = {0, 0, -1}, .fov_y = degrees(50), .near = 0.01f, .far = 10000};
  return scene;
}

/// 1024 pairs of squares, each pair in its own tile, which both squares fill: red, and blue in front of it by a
/// hundred-thousandth of its distance. Distances are logarithmically spaced from the near plane, lower left, to the far
/// plane, upper right. Red is drawn first, so a pair with equal depths stays red: red pixels are in the wrong order.
Scene depth_pairs(const Settings& settings) {
  Scene scene{.name = "depth-pairs"};
  constexpr int tiles = 32;  // per side; if the picture's size is a multiple of 32, no pixel centre is on an edge
  const double near = settings.real("pairs.near"), far = 1e4, gap = 1e-5;
  Mesh behind{.name = "behind"}, before{.name = "before"};
  const auto add = [&](Mesh& mesh, int tile, double distance) {
    const double x = tile % tiles - tiles / 2, y = tile / tiles - tiles / 2, side = distance / (tiles / 2);
    const std::uint32_t first = std::uint32_t(mesh.vertices.size());
    for (const auto& [right, up] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
      mesh.vertices.push_back(
          {{float((x + right) * side), float((y + up) * side), float(-distance)}, {0, 0, 1}, {0, 0}});
    for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(first + corner);
  };
  for (int tile = 0; tile < tiles * tiles; ++tile) {
    const double distance = near * std::pow(far / near, (tile + 0.5) / (tiles * tiles));
    add(behind, tile, distance * (1 + gap));
    add(before, tile, distance);
  }
  add_object(scene, behind, matte(scene, "red", {0.85f, 0.2f, 0.15f}), {.name = "behind"});
  add_object(scene, before, matte(scene, "blue", {0.15f, 0.3f, 0.85f}), {.name = "before"});
  scene.camera = {.eye = {0, 0, 0}, .target = {0, 0, -1}, .fov_y = degrees(90), .near = float(near), .far = float(far)};
  return scene;
}

/// A still life, moved away from the world's origin by the setting world.offset.
Scene far_away(const Settings& settings) {
  Scene scene = make_builtin_scene("primitives");
  const glm::dvec3 offset = settings.real("world.offset") * glm::dvec3(1, 0.25, -0.5);
  for (Node& node : scene.nodes)
    if (node.parent < 0) node.translation += offset;
  for (Light& light : scene.lights) light.position += offset;
  scene.camera.eye += offset;
  scene.camera.target += offset;
  return scene;
}

/// The robot in orthographic projection: parallel lines stay parallel.
Scene plan() {
  Scene scene = make_builtin_scene("robot");
  const Box3 box = bounds(scene);
  const glm::dvec3 centre = (box.low + box.high) / 2.0;
  scene.camera = {.eye = centre + glm::dvec3(8, 6, 8),
                  .target = centre,
                  .projection = Projection::orthographic,
                  .height = float(1.3 * (box.high.y - box.low.y)),
                  .near = -20,
                  .far = 40};
  return scene;
}

}  // namespace

std::vector<SettingSpec> transform_scene_settings() {
  return {
      {.name = "hall.segments", .fallback = 64, .low = 3, .high = 4096, .help = "flat pieces of the hall's round wall"},
      {.name = "hall.fit",
       .fallback = 0,
       .low = 0,
       .high = 16384,
       .help = "height of the picture in pixels: the wall gets the fewest pieces whose error is at most half a pixel "
               "from the scene's own camera (at its distance from the nearest wall, seen head-on; --eye has no "
               "effect); 0: hall.segments pieces"},
      {.name = "world.offset",
       .fallback = 0.0,
       .low = 0,
       .high = 1e7,
       .help = "distance of the scene 'far' from the world's origin, metres"},
      {.name = "pairs.near",
       .fallback = 0.1,
       .low = 1e-4,
       .high = 1e3,
       .help = "distance of the near plane of the scene 'depth-pairs', metres; the far plane is at 10 km"},
  };
}

Scene empty_hall() {
  Scene scene{.name = "hall"};
  matte(scene, "plaster", {0.75f, 0.7f, 0.62f});
  matte(scene, "boards", {0.5f, 0.33f, 0.2f});
  matte(scene, "white", {0.8f, 0.8f, 0.8f});
  scene.camera = {.eye = {-3.5, 1.7, 2}, .target = {4, 1.9, -2.5}, .fov_y = degrees(75), .near = 0.1f, .far = 40};
  return scene;
}

const SceneTable& transform_scenes() {
  static const SceneTable scenes = {
      builtin_scene("robot"),
      {"triangle", [](const Settings&) { return Scene{.name = "triangle"}; }},
      builtin_scene("teapot"),
      {"stretched", [](const Settings&) { return stretched(); }},
      {"hall", hall},
      {"spiral", [](const Settings&) { return spiral(); }},
      {"slats", [](const Settings&) { return slats(); }},
      {"far", far_away},
      {"plan", [](const Settings&) { return plan(); }},
      {"depth-pairs", depth_pairs},
      builtin_scene("primitives"),
      builtin_scene("materials"),
      builtin_scene("room"),
  };
  return scenes;
}

}  // namespace atelier
