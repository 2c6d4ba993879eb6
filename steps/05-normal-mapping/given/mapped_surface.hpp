// Normal maps as a feature of the renderer. Given.
#pragma once

#include <map>

#include "app/step_program.hpp"
#include "render/feature.hpp"

namespace atelier {

/// "normal.maps", "normal.source", "normal.depth", "normal.tangents", "normal.space", "normal.format",
/// "specular.filtered".
std::vector<SettingSpec> normal_mapping_settings();

/// The output "recorded_normal".
OutputSpec recorded_normal_output();

/// Replaces the normal of surfaces whose material has a normal map. A map that stands for (0, 0, 1) everywhere is left
/// out. Nodes without a map have neither tangents nor shader code for them.
class MappedSurface : public Feature {
 public:
  void configure(const Settings& settings) override;
  std::vector<glm::vec4> tangents(const Scene& scene, int mesh) const override;
  void prepare(Gl& gl, const Scene& scene) override;
  Need need(const Scene& scene, const View& view, const Node& node) const override;
  std::map<Slot, SlotCode> slots() const override;
  std::map<std::string, std::string> outputs() const override;
  void bind_material(Binder& binder, const Scene& scene, const Material& material) override;

 private:
  enum class Format { float32, float16, byte };
  /// The material's texture of normals or heights, whichever are used.
  const TextureIndex& texture_of(const Material& material) const;
  bool is_mapped(const Scene& scene, const Material& material) const;
  GlTexture map_of(Gl& gl, const Texture& texture) const;

  bool enabled_ = true, from_heights_ = false, derivatives_ = false, in_tangent_space_ = false, filtered_ = false;
  float depth_ = 0;  ///< of a height of 1, as a fraction of the texture's side
  Format format_ = Format::float32;
  std::string filter_ = "scene";
  std::map<int, GlTexture> maps_;  ///< by texture of the scene
};

}  // namespace atelier
