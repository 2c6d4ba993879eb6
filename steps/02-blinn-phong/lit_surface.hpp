// The lit surface, as a feature of the renderer: what later steps build on. Given.
#pragma once

#include "render/feature.hpp"

namespace atelier {

/// "shading": pixel or vertex. A program that does not list it works out light for every pixel.
SettingSpec shading_setting();

/// The other settings of this step that belong to the surface (not to the scene).
std::vector<SettingSpec> lit_surface_settings();

class LitSurface : public Feature {
 public:
  void configure(const Settings& settings) override;
  void prepare(Gl& gl, const Scene& scene) override;
  Need need(const Scene& scene, const View& view, const Node& node) const override;
  std::map<Slot, SlotCode> slots() const override;
  std::map<std::string, std::string> outputs() const override;
  void bind_view(Binder& binder, const Scene& scene, const Viewpoint& viewpoint) override;
  void bind_material(Binder& binder, const Scene& scene, const Material& material) override;
  void count(SceneCounts& counts) const override;
  void moved(const Scene& scene) override { choose_lights(scene); }

  /// Lights that the shaders add up, as indices into the scene's: light i of u_point_lights is points()[i].
  const std::vector<int>& points() const { return points_; }
  const std::vector<int>& spots() const { return spots_; }
  const std::vector<int>& suns() const { return suns_; }

 private:
  enum class Power { direct, stable, table };
  void choose_lights(const Scene& scene);
  GLuint power_table_for(float exponent);

  bool per_vertex_ = false, decode_after_filter_ = false, compact_textures_ = false, cull_lights_ = true;
  int normalisation_ = 0, light_limit_ = 64, table_size_ = 256;
  Power power_ = Power::direct;
  std::string filter_ = "scene";

  Gl* gl_ = nullptr;
  std::vector<int> points_, spots_, suns_;  ///< lights to draw, as indices into the scene's
  int lights_left_out_ = 0;
  std::vector<GlTexture> textures_;          ///< by index in the scene; empty where no material uses it
  std::map<float, GlTexture> power_tables_;  ///< by exponent
};

}  // namespace atelier
