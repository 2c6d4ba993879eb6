#include "01-transforms/given/truth.hpp"

#include <cmath>

#include "01-transforms/given/scenes.hpp"
#include "base/error.hpp"

namespace atelier {

namespace {

/// preview.glsl in double precision.
glm::dvec3 preview(const oracle::World& world, const oracle::SurfacePoint& point, const glm::dvec3& eye) {
  const glm::dvec2 cell = glm::floor(point.texcoord * 8.0);
  const double sum = cell.x + cell.y, checker = sum - 2 * std::floor(sum / 2) < 0.5 ? 1 : 0.72;
  const glm::dvec3 to_eye = eye - point.position;
  const double facing = to_eye == glm::dvec3(0) ? 0 : glm::dot(point.normal, glm::normalize(to_eye));
  return glm::dvec3(world.scene().materials[std::size_t(point.material)].diffuse) *
         (checker * (0.15 + 0.85 * std::max(facing, 0.0)));
}

std::vector<oracle::Shape> round_hall() {
  const double radius = hall_radius, height = hall_height;
  const oracle::Rectangle floor{{0, 0, 0}, {radius, 0, 0}, {0, 0, -radius}},
      ceiling{{0, height, 0}, {radius, 0, 0}, {0, 0, radius}};
  return {{.surface = oracle::CylinderWall{.radius = radius, .height = height, .inside = true}, .material = 0},
          {.surface = floor, .material = 1},
          {.surface = ceiling, .material = 2}};
}

/// The triangle is given in clip space: an orthographic box of two metres, scaled to the picture's aspect ratio.
SceneTruth triangle_in_clip_space(const TruthRequest& request) {
  const CaseCamera& camera = request.camera;
  if (request.output != "colour" || camera.eye || camera.target || camera.up || camera.fov_y_degrees || camera.near ||
      camera.far)
    throw Error("scene 'triangle' has the output colour alone, and no camera");
  SceneTruth truth{.scene = {.name = "triangle", .background = triangle_background}};
  Mesh mesh{.name = "triangle", .indices = {0, 1, 2}};
  for (const glm::vec3& corner : triangle_corners)
    mesh.vertices.push_back({corner * glm::vec3(float(request.size.x) / float(request.size.y), 1, 1)});
  truth.scene.meshes = {mesh};
  truth.scene.materials = {{.name = "flat", .two_sided = true}};
  truth.scene.nodes = {{.name = "triangle", .mesh = 0}};
  truth.scene.camera = {
      .eye = {0, 0, 1}, .target = {0, 0, 0}, .projection = Projection::orthographic, .height = 2, .near = 0, .far = 2};
  truth.shading.surface = [](const oracle::World&, const oracle::SurfacePoint&, const glm::dvec3&) {
    return glm::dvec3(triangle_colour);
  };
  return truth;
}

}  // namespace

SceneTruth transform_truth(const TruthRequest& request, const Settings& settings, std::optional<Scene> model) {
  if (!model && request.scene == "triangle") return triangle_in_clip_space(request);
  SceneTruth truth;
  if (model) {
    truth.scene = std::move(*model);
  } else if (request.scene == "hall") {
    truth.scene = empty_hall();
    truth.shapes = round_hall();
  } else {
    truth.scene = make_scene(transform_scenes(), request.scene, settings);
  }
  truth.shading.surface = preview;
  return truth;
}

}  // namespace atelier
