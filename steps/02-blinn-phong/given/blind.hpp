// A blind in front of every light, as a feature of the renderer: an occluder without shadow maps. Given.
#pragma once

#include "02-blinn-phong/given/lit_surface.hpp"
#include "render/feature.hpp"

namespace atelier {

/// Slats in a horizontal plane, parallel to z. Each transmits one half of the light; between slats all light passes.
/// Metres.
struct BlindShape {
  double below = 0.5;   ///< the plane's distance below a point or spot light
  double height = 4;    ///< the plane's y for a directional light
  double period = 0.4;  ///< spacing of the slats along x, the first in the middle of 0 .. period; half of it is slat
  double ramp = 0.04;   ///< across each edge of a slat the transmission grows from 1/2 to 1 as 3t^2 - 2t^3
};
inline constexpr BlindShape blind_shape;

/// "light.blind": whether there is a blind in front of every light.
SettingSpec blind_setting();

/// The fraction of each light that passes its blind, at nodes that receive shadows: 1/2 to 1; 1 if the ray to the light
/// does not cross the plane. Its shader reads LitSurface's light uniforms.
class Blind : public Feature {
 public:
  /// `lights` are a LitSurface's, which outlives this.
  explicit Blind(const DrawnLights& lights) : lights_(lights) {}
  void configure(const Settings& settings) override;
  Need need(const Scene& scene, const View& view, const Node& node) const override;
  std::map<Slot, SlotCode> slots() const override;
  void bind_view(Binder& binder, const Scene& scene, const Viewpoint& viewpoint) override;

 private:
  const DrawnLights& lights_;
  bool enabled_ = false;
};

}  // namespace atelier
