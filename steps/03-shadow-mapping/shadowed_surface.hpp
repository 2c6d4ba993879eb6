// Shadow maps, as a feature of the renderer: which lights get one, what it is fitted to, and when it is drawn. Given.
#pragma once

#include <functional>
#include <span>
#include <string>

#include "02-blinn-phong/lit_surface.hpp"
#include "03-shadow-mapping/map_picture.hpp"
#include "03-shadow-mapping/shadow_fit.hpp"
#include "03-shadow-mapping/shadow_mapping.hpp"
#include "render/feature.hpp"

namespace atelier {

/// The settings of this step that belong to shadows (not to the scene).
std::vector<SettingSpec> shadow_settings();

/// The numbers of these lights (of a map, of a cube) as the shader lists them: "0, -1, 1".
std::string glsl_list(std::span<const int> lights, const std::function<int(int)>& number);

class ShadowedSurface : public Feature {
 public:
  /// `lit` says which lights shine, under which numbers; it must outlive this.
  explicit ShadowedSurface(const LitSurface& lit);

  void configure(const Settings& settings) override;
  void prepare(Gl& gl, const Scene& scene) override;
  void moved(const Scene& scene) override;
  void draw_before(Gl& gl, const Scene& scene, const Viewpoint& viewpoint, NodePainter& painter) override;
  bool draw_instead(Gl& gl, const View& view, const Target& target) override;
  Need need(const Scene& scene, const View& view, const Node& node) const override;
  std::map<Slot, SlotCode> slots() const override;
  std::map<std::string, std::string> outputs() const override;
  void bind_view(Binder& binder, const Scene& scene, const Viewpoint& viewpoint) override;
  void count(SceneCounts& counts) const override;

 protected:
  // What a later step that has other maps beside these builds on.

  /// The frustum in which a point light's casters fit, where there is one: then a map serves it too.
  virtual std::optional<shadow_mapping::LightFrustum> fit_point(const Light&, const glm::vec3& /*position*/,
                                                                std::span<const NodePainter::Item> /*casters*/) const {
    return {};
  }
  /// What shaders that look shadows up must know: filter, bias, how many maps. For surfaces that receive shadows.
  Defines structure(bool receives) const;
  /// Whether shadows are to be seen in an output: normals and depths need no map.
  bool shows_shadows(const View& view) const;
  /// What maps are looked up for in this frame, where that bounds what must be drawn of them: where they are drawn for
  /// every frame, by filters whose reach is known. None where all of a map may matter.
  const std::optional<Pieces>& looked_up() const { return looked_up_; }
  /// How many texels the bias moves a point along its normal; what moves it towards the light leaves it where it is in
  /// the map.
  float texels_moved() const;
  int pcf() const { return pcf_; }
  /// Texels that the filter reads of one map for each point, in the last frame; 0 where nothing is looked up in it.
  int lookups_in_a_map() const;
  bool has_map(int light) const { return map_of(light) >= 0; }  ///< a light of the scene, after draw_before
  const LitSurface& lit() const { return lit_; }
  GLenum format() const { return format_; }
  bool compares() const { return bilinear_; }
  bool culls_front_faces() const { return bias_ == Bias::front_faces; }
  bool keeps_maps() const { return keep_; }
  int shown_light() const { return shown_light_; }

 private:
  enum class Bias { none, constant, slope, normal_offset, plane, front_faces };
  enum class Fit { fixed, scene, casters, visible };
  /// A light with a map.
  struct Mapped {
    int light = 0;  ///< index into Scene::lights
    shadow_mapping::LightFrustum frustum;
    glm::mat4 view{1.0f}, projection{1.0f};
    glm::mat4 world_to_map() const { return shadow_mapping::bias_matrix() * projection * view; }
    std::vector<int> casters;  ///< items of the painter that stand in it
    bool drawn = false;        ///< whether the layer holds what these casters look like from there
  };

  struct Extents;
  void find_maps(const Scene& scene, const Viewpoint& viewpoint, const NodePainter& painter);
  std::optional<Mapped> map_for(const Scene& scene, int light, const Viewpoint& viewpoint, const NodePainter& painter,
                                const Extents& extents) const;
  std::optional<shadow_mapping::LightFrustum> fit_to_spot(const Light& light, const glm::vec3& position,
                                                          const Extents& extents) const;
  shadow_mapping::Sphere covered(const Extents& extents) const;
  std::optional<shadow_mapping::LightFrustum> fit_to_sun(const Light& light, const Extents& extents) const;
  void make_room(Gl& gl);
  void draw_map(Gl& gl, int layer, NodePainter& painter);
  glm::ivec4 texels_looked_up(const Mapped& map) const;
  int map_of(int light) const;
  bool parallel_light_stays_parallel() const;
  bool has_room() const { return texture_ && framebuffer_; }  ///< false where make_shadow_maps is not written yet

  const LitSurface& lit_;
  int resolution_ = 1024, pcf_ = 1, samples_ = 16, shown_light_ = 0;
  GLenum format_ = GL_DEPTH_COMPONENT24;
  Bias bias_ = Bias::normal_offset;
  Fit fit_ = Fit::scene;
  float bias_size_ = 1, reach_ = 10;
  double light_width_ = 0;
  bool bilinear_ = false, pcss_ = false, random_ = false, keep_ = true;

  std::vector<Mapped> maps_;  ///< layer by layer
  bool shown_ = false;        ///< whether the last frame's shaders read the maps
  std::optional<Pieces> looked_up_;
  bool found_ = false;  ///< whether maps_ is right for scene and settings
  shadow_mapping::ShadowMaps names_;
  GlTexture texture_;
  GlFramebuffer framebuffer_;
  struct Room {
    int resolution = 0, layers = 0;
    GLenum format = 0;
    bool compare = false;
    bool operator==(const Room&) const = default;
  } room_;  ///< what `texture_` was made as
  MapPicture showing_;
};

}  // namespace atelier
