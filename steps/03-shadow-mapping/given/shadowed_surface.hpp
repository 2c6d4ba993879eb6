// Shadow maps, as a feature of the renderer: which lights have one, its frustum, and when it is drawn. Given.
#pragma once

#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>

#include "02-blinn-phong/given/lit_surface.hpp"
#include "03-shadow-mapping/given/light_image.hpp"
#include "03-shadow-mapping/given/map_picture.hpp"
#include "03-shadow-mapping/given/shadow_fit.hpp"
#include "03-shadow-mapping/given/shadow_settings.hpp"
#include "03-shadow-mapping/shadow_mapping.hpp"
#include "render/feature.hpp"

namespace atelier {

/// "shadow map of light 0 (sun)": for debug groups and labels.
std::string name_of(const DrawnLights& lights, int light, std::string_view what);

/// By index of a point light: a frustum that contains all of its casters, so that one map is enough.
using PointFrusta = std::map<int, shadow_mapping::LightFrustum>;

/// A light with a map.
struct MappedLight {
  int light = 0;  ///< its index in DrawnLights::all
  shadow_mapping::LightFrustum frustum;
  glm::mat4 view{1.0f}, projection{1.0f};
  glm::mat4 world_to_map() const { return shadow_mapping::bias_matrix() * projection * view; }
  std::vector<int> casters;  ///< the painter's items in its frustum
  /// Of the image of a light: the casters before the entry, which are seen through the opening.
  std::vector<int> carried;
  std::optional<MovedPassage> passage;
  bool drawn = false;  ///< whether the layer is up to date
};

/// The maps of a frame, for other features.
struct FrameMaps {
  std::vector<MappedLight> maps;  ///< layer by layer
  /// The visible receivers of this frame, if they limit the part of a map to draw: if maps are drawn for every frame
  /// and the filter width is known. None if the whole map may be sampled.
  std::optional<Pieces> visible_receivers;
  int layer_of(int light) const;  ///< -1: it has no map
};

class ShadowedSurface : public Feature {
 public:
  /// `lights` are the active lights, `points` the point lights that can use a map; both must outlive this.
  ShadowedSurface(const DrawnLights& lights, const PointFrusta& points);

  void configure(const Settings& settings) override;
  void prepare(Gl& gl, const Scene& scene) override;
  void moved(const Scene& scene) override;
  void draw_views(Gl&, const Scene&, const Viewpoint&, ScenePainter&) override { shown_ = false; }
  void draw_before(Gl& gl, const Scene& scene, const Viewpoint& viewpoint, ScenePainter& painter) override;
  bool may_draw_instead(const View& view) const override { return view.output == "shadow_map"; }
  bool draw_instead(Gl& gl, const View& view, const Target& target) override;
  Need need(const Scene& scene, const View& view, const Node& node) const override;
  std::map<Slot, SlotCode> slots() const override;
  std::map<std::string, std::string> outputs() const override;
  std::vector<DrawConstant> draw_constants() const override;
  void bind_view(Binder& binder, const Scene& scene, const Viewpoint& viewpoint) override;
  void count(SceneCounts& counts) const override;

  const FrameMaps& maps() const { return frame_; }  ///< of the last drawn view; valid as long as this object

 private:
  struct Extents;
  void find_maps(const Scene& scene, const Viewpoint& viewpoint, const ScenePainter& painter);
  std::optional<MappedLight> map_for(const Scene& scene, int light, const Viewpoint& viewpoint,
                                     const ScenePainter& painter, const Extents& extents) const;
  std::optional<shadow_mapping::LightFrustum> frustum_of(int light, const glm::vec3& position,
                                                         const Extents& extents) const;
  std::optional<shadow_mapping::LightFrustum> fit_to_spot(const Light& light, const glm::vec3& position,
                                                          const Extents& extents) const;
  shadow_mapping::Sphere covered(const Extents& extents) const;
  std::optional<shadow_mapping::LightFrustum> fit_to_directional(const Light& light, const Extents& extents) const;
  void find_casters(const Scene& scene, const ScenePainter& painter, const Extents& extents, MappedLight& map) const;
  void allocate(Gl& gl);
  void paint_casters(Gl& gl, const MappedLight& map, ScenePainter& painter) const;
  void draw_map(Gl& gl, int layer, ScenePainter& painter);
  glm::ivec4 texels_to_draw(const MappedLight& map) const;
  bool directional_projections_are_affine() const;
  bool is_allocated() const { return texture_ && framebuffer_; }  ///< false if make_shadow_maps is not written yet
  Defines structure() const;

  const DrawnLights& lights_;
  const PointFrusta& points_;
  ShadowSettings settings_;

  FrameMaps frame_;
  bool shown_ = false;  ///< whether shaders of the last frame sample the maps
  bool found_ = false;  ///< whether the frusta are valid for scene and settings
  Defines structure_;   ///< of surfaces that receive shadows, in the last frame
  shadow_mapping::ShadowMaps names_;
  GlTexture texture_;
  GlFramebuffer framebuffer_;
  struct Allocation {
    int resolution = 0, layers = 0;
    GLenum format = 0;
    bool compare = false;
    bool operator==(const Allocation&) const = default;
  } allocation_;  ///< the parameters of `texture_`
  MapPicture showing_;
};

}  // namespace atelier
