// The lit surface, as a feature of the renderer; later steps build on it. Given.
#pragma once

#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "render/feature.hpp"

namespace atelier {

/// "shading": pixel or vertex. A program without it computes lighting per pixel.
SettingSpec shading_setting();

/// The other settings of this step that belong to the surface (not to the scene).
std::vector<SettingSpec> lit_surface_settings();

/// The lights that shaders use, as indices of all lights: light i of u_point_lights is all[points[i]].
struct DrawnLights {
  std::span<const Light> all;  ///< the scene's, and those that features have added
  std::vector<int> points, spots, directional;
  /// The sets of lights that are summed for a point, each on other nodes.
  std::vector<std::vector<int>> together;
  /// By light: the distance of the farthest point that a point light shines on, metres; infinite for others.
  std::vector<double> reach;
  const Light& light(int number) const { return all[std::size_t(number)]; }
};

/// A number for each of these lights, such as the index of its shadow map, as a GLSL list: "0, -1, 1".
std::string glsl_list(std::span<const int> lights, const std::function<int(int)>& number);

class LitSurface : public Feature {
 public:
  void take_lights(std::span<const Light> lights) override { lights_.all = lights; }
  void configure(const Settings& settings) override;
  void prepare(Gl& gl, const Scene& scene) override;
  Need need(const Scene& scene, const View& view, const Node& node) const override;
  std::map<Slot, SlotCode> slots() const override;
  std::map<std::string, std::string> outputs() const override;
  std::vector<DrawConstant> draw_constants() const override;
  void bind_view(Binder& binder, const Scene& scene, const Viewpoint& viewpoint) override;
  void bind_material(Binder& binder, const Scene& scene, const Material& material) override;
  void count(SceneCounts& counts) const override;
  void moved(const Scene& scene) override { choose_lights(scene); }

  const DrawnLights& lights() const { return lights_; }  ///< as long as this object

 private:
  enum class Power { direct, stable, table };
  void choose_lights(const Scene& scene);
  /// `boxes` are those of the nodes, in world space; `kept` are indices into `lights`.
  void choose_for_nodes(const Scene& scene, std::span<const Box3> boxes, const std::vector<Light>& lights,
                        const std::vector<int>& kept);
  void find_reach(std::span<const Box3> boxes);
  bool shines_on(int light, std::size_t node) const;
  std::function<double(double)> lobe() const;  ///< the height of a highlight's lobe, for an exponent
  GLuint power_table_for(float exponent);

  bool per_vertex_ = false, decode_after_filter_ = false, compact_textures_ = false, cull_lights_ = true;
  int normalisation_ = 0, light_limit_ = 64, table_size_ = 256;
  Power power_ = Power::direct;
  std::string filter_ = "scene";

  Gl* gl_ = nullptr;
  DrawnLights lights_;
  int lights_left_out_ = 0;
  std::vector<int> set_of_node_;             ///< index into DrawnLights::together
  std::vector<GlTexture> textures_;          ///< by index in the scene; empty if no material uses it
  std::map<float, GlTexture> power_tables_;  ///< by exponent
};

}  // namespace atelier
