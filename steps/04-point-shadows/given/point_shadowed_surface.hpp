// Cube shadow maps, as a feature of the renderer, beside step 03's maps: which lights have one, and when it is drawn.
// Given.
#pragma once

#include "03-shadow-mapping/given/shadowed_surface.hpp"
#include "04-point-shadows/point_shadows.hpp"

namespace atelier {

/// The settings of this step that belong to cubes. Format, filter, bias and update are step 03's settings.
std::vector<SettingSpec> cube_settings();

class PointShadowedSurface : public Feature {
 public:
  /// `lights` are the active lights, `maps` says which of them already have a map; both must outlive this. Must follow
  /// ShadowedSurface in the list of features.
  PointShadowedSurface(const DrawnLights& lights, const FrameMaps& maps);

  void configure(const Settings& settings) override;
  void prepare(Gl&, const Scene& scene) override { moved(scene); }
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

 private:
  static constexpr int most_cubes = 4;  ///< as in cubes.glsl
  /// A point light with a cube.
  struct Cubed {
    int light = 0;             ///< index into Scene::lights
    glm::vec3 position{0};     ///< in the shaders' world space
    float near = 0, far = 1;   ///< planes of the faces' projections, metres; stored distances are fractions of far
    std::vector<int> casters;  ///< the painter's items that any face sees
    std::array<std::vector<int>, 6> seen;  ///< those that each face sees
    bool drawn = false;
  };
  /// The objects of a cube, kept from frame to frame.
  struct Allocation {
    point_shadows::CubeMap names;
    GlTexture texture;
    GlFramebuffer framebuffer;
    int edge = 0;  ///< the requested edge, texels; `names` is the student's result
    GLenum format = 0;
    bool compare = false;
    bool is_allocated() const { return texture && framebuffer; }  ///< false if make_cube_map is not written yet
  };

  std::optional<Cubed> cube_for(const Scene& scene, int light, const Viewpoint& viewpoint,
                                const ScenePainter& painter) const;
  bool is_sampled(const glm::mat4& face) const;
  void find_cubes(const Scene& scene, const Viewpoint& viewpoint, const ScenePainter& painter);
  bool allocate(Gl& gl, std::size_t cube);
  void draw_cube(Gl& gl, std::size_t cube, ScenePainter& painter);
  int cube_of(int light) const;
  bool any_cube() const;
  Defines structure() const;

  const DrawnLights& lights_;
  const FrameMaps& maps_;
  ShadowSettings settings_;  ///< of step 03: filter, bias, format and update
  int edge_ = 512;           ///< texels
  bool layered_ = true, every_face_ = false;
  std::vector<Cubed> cubes_;
  bool found_ = false;  ///< whether cubes_ is valid for scene and settings
  bool shown_ = false;  ///< whether shaders of the last frame sample the cubes
  Defines structure_;   ///< of surfaces that receive shadows, in the last frame
  std::vector<Allocation> allocations_;
  MapPicture showing_cube_;  ///< six faces side by side
};

}  // namespace atelier
