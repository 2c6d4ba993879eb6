#include "@STEP@/given/feature.hpp"

#include "@STEP@/@NAME@.hpp"

namespace atelier {

std::vector<SettingSpec> @NAME@_settings() {
  return {
      {.name = "@NAME@.half_distance",
       .fallback = 12.0,
       .low = 0,
       .high = 1e6,
       .help = "metres after which half of the light is left; 0: no fog"},
      {.name = "@NAME@.pieces",
       .fallback = 0,
       .low = 0,
       .high = 4096,
       .help = "number of equal pieces that approximate the exponential; 0: exact"},
  };
}

void @TYPE@Feature::configure(const Settings& settings) {
  const double half_distance = settings.real("@NAME@.half_distance");
  clear_ = half_distance == 0;
  density_ = clear_ ? 0 : @NAME@::density(float(half_distance));
  pieces_ = settings.integer("@NAME@.pieces");
}

std::optional<glm::vec3> @TYPE@Feature::background(const Scene&, const View&) const {
  return clear_ ? std::optional<glm::vec3>() : @NAME@_air;
}

Need @TYPE@Feature::need(const Scene&, const View& view, const Node&) const {
  return {.wanted = !clear_ && view.output == "colour"};
}

std::map<Slot, SlotCode> @TYPE@Feature::slots() const {
  return {{Slot::modify_shaded, {"@STEP@/given/feature.glsl", "@NAME@_shaded"}}};
}

void @TYPE@Feature::bind_view(Binder& binder, const Scene&, const Viewpoint&) {
  binder.set("u_@NAME@_air", @NAME@_air);
  binder.set("u_@NAME@_density", density_);
  binder.set("u_@NAME@_pieces", pieces_);
}

}  // namespace atelier
