#include "05-normal-mapping/given/truth.hpp"

#include "02-blinn-phong/given/truth.hpp"
#include "05-normal-mapping/given/scenes.hpp"
#include "app/picture.hpp"
#include "oracle/frame.hpp"

namespace atelier {

namespace {

/// The normal map of a height map in double precision, stored as floats: central differences, as the contract of
/// normals_from_heights says.
Image map_of_heights(const Texture& texture, double depth) {
  const Image& heights = texture.pixels;
  const int width = heights.width(), height = heights.height();
  const auto inside = [&](int i, int count) {
    if (texture.wrap == Wrap::repeat) return ((i % count) + count) % count;
    return i < 0 ? 0 : i >= count ? count - 1 : i;
  };
  const auto rise = [&](int x0, int y0, int x1, int y1) {
    return depth * (double(heights.at(inside(x1, width), inside(y1, height)).r) -
                    double(heights.at(inside(x0, width), inside(y0, height)).r));
  };
  Image normals(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const glm::dvec2 slope(rise(x - 1, y, x + 1, y) * width / 2, rise(x, y + 1, x, y - 1) * height / 2);
      const glm::dvec3 stored = glm::normalize(glm::dvec3(-slope, 1)) * 0.5 + 0.5;
      normals.at(x, y) = {float(stored.x), float(stored.y), float(stored.z), 1};
    }
  return normals;
}

/// Gives every material with a height texture the normal map of its heights, and takes all others away.
void use_heights(Scene& scene, double depth) {
  for (Material& material : scene.materials) {
    material.normal_texture.reset();
    if (!material.height_texture || depth == 0) continue;
    Texture map = scene.textures[std::size_t(*material.height_texture)];
    map.pixels = map_of_heights(map, depth);
    material.normal_texture = int(scene.textures.size());
    scene.textures.push_back(std::move(map));
  }
}

/// Normals as the camera sees them: along its right, its up, and towards it.
oracle::SurfaceColour in_view_of(const Camera& camera) {
  const oracle::ViewFrame frame = oracle::view_frame(camera.target - camera.eye, glm::dvec3(camera.up));
  return [frame](const oracle::World&, const oracle::SurfacePoint& point, const glm::dvec3&) {
    if (point.normal == glm::dvec3(0)) return glm::dvec3(0.5, 0.5, 1);
    return glm::dvec3(glm::dot(frame.right, point.normal), glm::dot(frame.up, point.normal),
                      -glm::dot(frame.ahead, point.normal)) *
               0.5 +
           0.5;
  };
}

}  // namespace

SceneTruth normal_mapping_truth(const TruthRequest& request, const Settings& settings, std::optional<Scene> model) {
  if (!model) model = make_scene(normal_mapping_scenes(), request.scene, settings);
  SceneTruth truth = blinn_phong_truth(request, settings, std::move(model));
  truth.shading.normal_maps = settings.flag("normal.maps");
  if (settings.choice("normal.source") == "heights") use_heights(truth.scene, settings.real("normal.depth"));
  if (request.output == "recorded_normal") {
    truth.output = "colour";
    truth.scene.background = glm::vec3(0);
    truth.shading.surface = in_view_of(apply(request.camera, truth.scene.camera));
  }
  return truth;
}

}  // namespace atelier
