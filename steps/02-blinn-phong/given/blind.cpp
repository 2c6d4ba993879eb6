#include "02-blinn-phong/given/blind.hpp"

namespace atelier {

SettingSpec blind_setting() {
  return {.name = "light.blind",
          .fallback = false,
          .help = "hang a blind in front of every light: its slats let half of the light through, in stripes"};
}

void Blind::configure(const Settings& settings) {
  enabled_ = settings.flag("light.blind");
}

Need Blind::need(const Scene&, const View&, const Node& node) const {
  const bool lit = !lights_.points.empty() || !lights_.spots.empty() || !lights_.directional.empty();
  return {.wanted = enabled_ && lit && node.receives_shadow};
}

std::map<Slot, SlotCode> Blind::slots() const {
  const std::string file = "02-blinn-phong/given/blind.glsl";
  return {{Slot::visible_from_point, {file, "point_light_through_blind"}},
          {Slot::visible_from_spot, {file, "spot_light_through_blind"}},
          {Slot::visible_from_directional, {file, "directional_light_through_blind"}}};
}

void Blind::bind_view(Binder& binder, const Scene&, const Viewpoint&) {
  binder.set("u_blind_below", float(blind_shape.below));
  binder.set("u_blind_height", float(blind_shape.height));
  binder.set("u_blind_period", float(blind_shape.period));
  binder.set("u_blind_ramp", float(blind_shape.ramp));
}

}  // namespace atelier
