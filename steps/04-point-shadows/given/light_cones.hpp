// Point lights whose casters fit into a cone: they use one map of step 03 instead of a cube. Given.
#pragma once

#include "03-shadow-mapping/given/shadowed_surface.hpp"

namespace atelier {

/// Finds the cones. Must precede ShadowedSurface, which draws their maps, in the list of features.
class LightCones : public Feature {
 public:
  explicit LightCones(const DrawnLights& lights) : lights_(lights) {}  ///< which must outlive this

  void configure(const Settings& settings) override;
  void prepare(Gl&, const Scene& scene) override { moved(scene); }
  void moved(const Scene&) override { found_ = false; }
  void draw_before(Gl& gl, const Scene& scene, const Viewpoint& viewpoint, ScenePainter& painter) override;
  Need need(const Scene&, const View&, const Node&) const override { return {}; }

  const PointFrusta& frusta() const { return frusta_; }  ///< valid as long as this object

 private:
  const DrawnLights& lights_;
  bool wanted_ = true, keep_ = true;
  bool found_ = false;  ///< whether frusta_ is valid for scene and settings
  PointFrusta frusta_;
};

}  // namespace atelier
