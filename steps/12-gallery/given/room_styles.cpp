#include "12-gallery/given/room_styles.hpp"

#include <algorithm>
#include <cmath>

#include "02-blinn-phong/given/shaders_alone.hpp"
#include "06-parallax-mapping/given/relief_surface.hpp"
#include "08-post-processing/given/post_chain.hpp"
#include "12-gallery/given/walk.hpp"

namespace atelier {

std::vector<SettingSpec> room_style_settings() {
  return {
      {.name = "gallery.styles", .fallback = true, .help = "whether rooms are seen in their styles"},
      {.name = "style.scale",
       .fallback = 1.0,
       .low = 0.25,
       .high = 4,
       .help = "of brushes and grids of the painterly style"},
      {.name = "style.turns",
       .fallback = 0.25,
       .low = 0,
       .high = 10,
       .help = "periods of the aberration that have passed"},
  };
}

std::vector<OutputSpec> room_style_outputs() {
  std::vector<OutputSpec> outputs = parallax_outputs();
  outputs.push_back({"relief", Encoding::data,
                     "the picture's normal map, as n/2 + 1/2, distorted like the picture if its style is a fish-eye"});
  outputs.push_back({"relief_height", Encoding::data, "the picture's height map, distorted in the same way"});
  return outputs;
}

Settings settings_of(gallery::Style style, const Settings& settings) {
  std::vector<SettingSpec> specs = style_settings();
  for (const auto& more : {dither_settings(), post_settings()}) specs.insert(specs.end(), more.begin(), more.end());
  Settings of(std::move(specs));
  switch (style) {
    case gallery::Style::none:
      break;
    case gallery::Style::floyd_steinberg:
      of.set("dither.method", "floyd-steinberg");
      of.set("dither.levels", 3);
      break;
    case gallery::Style::painterly: {
      of.set("style.first", "painterly");
      const double scale = settings.real("style.scale");
      for (const char* length : {"paint.grid", "paint.smallest", "paint.largest", "paint.reach"}) {
        const int scaled = int(std::lround(scale * of.integer(length)));
        of.set(length, std::max(scaled, std::string_view(length) == "paint.grid" ? 2 : 0));
      }
      of.set("paint.fast", true);
      break;
    }
    case gallery::Style::fisheye:
      of.set("style.first", "fisheye");
      break;
    case gallery::Style::toon:
      of.set("style.first", "toon");
      break;
    case gallery::Style::aberration:
      of.set("style.first", "aberration");
      of.set("aberration.amount", 0.06);
      of.set("aberration.turns", settings.real("style.turns"));
      break;
  }
  return of;
}

void RoomStyles::configure(const Settings& settings) {
  wanted_ = settings.flag("gallery.styles");
  visited_ = shown_ = visited_room(settings);
  for (std::size_t i = 0; i < styles_.size(); ++i) {
    const Settings own = settings_of(gallery::Style(i), settings);
    Style& style = styles_[i];
    style.passes.configure(own);
    style.dither.configure(own);
    style.dithers = own.choice("dither.method") != "none";
    style.behind_lens = own.choice("style.first") == "fisheye";
    style.strength = float(own.real("fisheye.strength"));
    style.power = float(own.real("fisheye.power"));
  }
}

void RoomStyles::prepare(Gl& gl, const Scene& scene) {
  for (Style& style : styles_)
    if (style.dithers) style.dither.prepare(gl, scene);
}

const RoomStyles::Style& RoomStyles::shown_style() const {
  const int style = wanted_ ? int(gallery::style_of(shown_)) : 0;
  return styles_[std::size_t(std::clamp(style, 0, int(styles_.size()) - 1))];
}

ChainPass RoomStyles::height_pass() const {
  ChainPass pass{.name = "relief_height", .reads = {"recorded_height"}, .begins = true};
  pass.code = {"12-gallery/given/height_pass.glsl", "height_pass"};
  pass.structure = no_lights();
  const Style& style = shown_style();
  if (style.behind_lens) pass.structure["BEHIND_LENS"] = "1";
  pass.bind = [&style](Binder& binder) {
    binder.set("u_strength", style.strength);
    binder.set("u_power", style.power);
  };
  return pass;
}

std::vector<ChainPass> RoomStyles::passes(const Scene& scene, const View& view) const {
  if (view.output == "relief_height") return {height_pass()};
  const Style& style = shown_style();
  return style.dithers && view.output != "relief" ? style.dither.passes(scene, view) : style.passes.passes(scene, view);
}

}  // namespace atelier
