// The style of each room, as passes of the chain. Given.
#pragma once

#include <array>

#include "09-dithering/given/dither_pass.hpp"
#include "10-artstyles/given/style_passes.hpp"
#include "12-gallery/gallery.hpp"
#include "12-gallery/given/plan.hpp"
#include "case/settings.hpp"
#include "render/feature.hpp"

namespace atelier {

/// "gallery.styles", "style.scale", "style.turns".
std::vector<SettingSpec> room_style_settings();

/// Those of step 06, and "relief" and "relief_height": the normal map and the height map of a room's picture.
std::vector<OutputSpec> room_style_outputs();

/// The settings of steps 09 and 10 with which a style is drawn.
Settings settings_of(gallery::Style style, const Settings& settings);

/// Gives a view the style of the room that it shows.
class RoomStyles : public Feature {
 public:
  void configure(const Settings& settings) override;
  void prepare(Gl& gl, const Scene& scene) override;
  std::vector<ChainPass> passes(const Scene& scene, const View& view) const override;
  Need need(const Scene&, const View&, const Node&) const override { return {}; }  // no code in surfaces

  /// Sets the place that the next views show: a room, or gallery::hall.
  void show(int room) { shown_ = room; }
  int visited() const { return visited_; }  ///< where the visitor is

 private:
  struct Style {
    StylePasses passes;
    DitherPass dither;
    bool dithers = false, behind_lens = false;
    float strength = 0, power = 2;
  };
  const Style& shown_style() const;
  ChainPass height_pass() const;

  std::array<Style, 6> styles_;  ///< by gallery::Style
  bool wanted_ = true;
  int visited_ = gallery::hall, shown_ = gallery::hall;
};

}  // namespace atelier
