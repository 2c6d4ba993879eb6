// Reliefs by parallax mapping, as a feature of the renderer. Given.
#pragma once

#include <map>

#include "app/step_program.hpp"
#include "render/feature.hpp"

namespace atelier {

/// "parallax.method", "parallax.depth", "parallax.layers" ...
std::vector<SettingSpec> parallax_settings();

/// The output "recorded_height".
std::vector<OutputSpec> parallax_outputs();

/// "recorded.nearest" and "recorded.farthest", metres. Throws Error unless the first is smaller, rounded to floats.
glm::dvec2 recorded_range(const Settings& settings);

/// Moves the texture coordinate of surfaces whose material has a height texture to where the ray from the eye meets the
/// relief, and with it the position, so that lights find the point there. Left out: reliefs of depth 0, and height
/// textures that are 1 everywhere. Must be listed before what reads texture coordinates, and lights.
class ReliefSurface : public Feature {
 public:
  void configure(const Settings& settings) override;
  std::vector<glm::vec4> tangents(const Scene& scene, int mesh) const override;
  void prepare(Gl& gl, const Scene& scene) override;
  Need need(const Scene& scene, const View& view, const Node& node) const override;
  std::map<Slot, SlotCode> slots() const override;
  std::map<std::string, std::string> outputs() const override;
  std::vector<DrawConstant> draw_constants() const override;
  void bind_view(Binder& binder, const Scene& scene, const Viewpoint& viewpoint) override;
  void bind_material(Binder& binder, const Scene& scene, const Material& material) override;
  void count(SceneCounts& counts) const override;

 private:
  enum class Method { none, offset, steep, occlusion, relief };
  bool has_relief(const Scene& scene, const Material& material) const;
  glm::vec4 edges_of(const Scene& scene) const;

  Method method_ = Method::occlusion;
  float depth_ = 0;
  int layers_ = 1, bisections_ = 0, shadow_samples_ = 0;
  bool adaptive_ = false, mean_ = false, discard_ = false, write_depth_ = false, silhouette_ = false,
       derivatives_ = false;
  std::string filter_ = "scene";
  glm::vec2 recorded_{0, 1};          ///< metres: nearest and farthest of "recorded_height"
  std::map<int, GlTexture> heights_;  ///< by texture of the scene
  glm::vec4 edges_{0, 0, 1, 1};       ///< the lowest and the highest texture coordinate of surfaces with a relief
};

}  // namespace atelier
