// Light that shines through portals, and that mirrors reflect: images of lights behind the exits, with the student's
// functions. Given.
#pragma once

#include "02-blinn-phong/given/lit_surface.hpp"

namespace atelier {

std::vector<SettingSpec> portal_light_settings();

class PortalLights : public Feature {
 public:
  explicit PortalLights(const DrawnLights& lights) : lights_(lights) {}  ///< which must outlive this

  void configure(const Settings& settings) override;
  void add_lights(const Scene& scene, std::vector<Light>& lights) const override;
  Need need(const Scene& scene, const View& view, const Node& node) const override;
  std::map<Slot, SlotCode> slots() const override;
  void bind_view(Binder& binder, const Scene& scene, const Viewpoint& viewpoint) override;

 private:
  std::vector<int> images() const;

  const DrawnLights& lights_;
  bool wanted_ = false, cull_ = true, normalised_ = false;
};

}  // namespace atelier
