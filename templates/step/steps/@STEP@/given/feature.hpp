// Fog as a feature of the renderer. Given.
#pragma once

#include "render/feature.hpp"

namespace atelier {

/// "@NAME@.half_distance", "@NAME@.pieces".
std::vector<SettingSpec> @NAME@_settings();

/// The colour of the fog, linear; also the background.
inline constexpr glm::vec3 @NAME@_air{0.5f, 0.62f, 0.75f};

/// Changes only the output "colour". At density 0 the shader has no code for it.
class @TYPE@Feature : public Feature {
 public:
  void configure(const Settings& settings) override;
  std::optional<glm::vec3> background(const Scene& scene, const View& view) const override;
  Need need(const Scene& scene, const View& view, const Node& node) const override;
  std::map<Slot, SlotCode> slots() const override;
  void bind_view(Binder& binder, const Scene& scene, const Viewpoint& viewpoint) override;

 private:
  bool clear_ = false;
  float density_ = 0;  ///< 1/m
  int pieces_ = 0;
};

}  // namespace atelier
