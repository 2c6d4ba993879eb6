// A blind before every light, as a feature of the renderer: something that stands in the way of light long before there
// are shadows. Given.
#pragma once

#include "02-blinn-phong/given/lit_surface.hpp"
#include "render/feature.hpp"

namespace atelier {

/// Slats that lie in a horizontal plane and run along z. Each lets one half of the light through, and what falls
/// between two slats goes on as it is. Metres.
struct BlindShape {
  double below = 0.5;   ///< the plane's distance below a point or spot light
  double height = 4;    ///< the plane's y before a directional light
  double period = 0.4;  ///< from slat to slat along x, the first in the middle of 0 .. period; half of it is slat
  double ramp = 0.04;   ///< across each edge of a slat light grows from 1/2 to 1 as 3t^2 - 2t^3
};
inline constexpr BlindShape blind_shape;

/// "light.blind": off, or a blind before every light.
SettingSpec blind_setting();

/// Says how much of each light passes its blind, at nodes that receive shadows: 1/2 to 1, and 1 where the way to the
/// light does not cross the plane. Its shader reads the lights that LitSurface sends.
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
  bool hung_ = false;
};

}  // namespace atelier
