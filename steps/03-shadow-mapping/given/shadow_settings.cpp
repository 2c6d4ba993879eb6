#include "03-shadow-mapping/given/shadow_settings.hpp"

#include <cmath>

namespace atelier {

OutputSpec shadow_factor_output() {
  return {"shadow_factor", Encoding::data, "the fraction of one light that arrives: 1 lit, 0 in shadow"};
}

std::vector<SettingSpec> shadow_setting_specs() {
  return {
      {.name = "shadow.resolution", .fallback = 1024, .low = 1, .high = 8192, .help = "texels along a side of a map"},
      {.name = "shadow.format",
       .fallback = std::string("24"),
       .choices = {"16", "24", "32f"},
       .help = "how depth is stored in a map"},
      {.name = "shadow.bias",
       .fallback = std::string("normal"),
       .choices = {"none", "constant", "slope", "normal", "plane", "front-faces"},
       .help = "what keeps a surface from casting a shadow on itself"},
      {.name = "shadow.bias_size",
       .fallback = 1.0,
       .low = -16,
       .high = 64,
       .help = "size of the bias: in texels, for a filter of one texel; wider filters get proportionally more"},
      {.name = "shadow.filter",
       .fallback = std::string("nearest"),
       .choices = {"nearest", "bilinear"},
       .help = "how one comparison is made: with the nearest texel, or with the four nearest, interpolated"},
      {.name = "shadow.pcf", .fallback = 1, .low = 1, .high = 15, .help = "comparisons along a side of the filter"},
      {.name = "shadow.soft",
       .fallback = std::string("pcf"),
       .choices = {"pcf", "pcss"},
       .help = "a filter of fixed width (pcf), or one as wide as the penumbra (pcss, which compares with nearest "
               "texels only)"},
      {.name = "shadow.samples",
       .fallback = 16,
       .low = 1,
       .high = 1024,
       .help = "of pcss: number of texels read to find blockers, and number of comparisons; on a grid the next smaller "
               "square number"},
      {.name = "shadow.pattern",
       .fallback = std::string("grid"),
       .choices = {"grid", "random"},
       .help = "of pcss: how samples are placed"},
      {.name = "light.width",
       .fallback = 0.0,
       .low = 0,
       .high = 10,
       .help = "size of the light sources: side of a spot light in metres, tangent of the angle of a directional "
               "light; 0: points"},
      {.name = "shadow.fit",
       .fallback = std::string("scene"),
       .choices = {"fixed", "scene", "casters", "visible"},
       .help = "what a map covers: fixed, shadow.reach metres; scene, all casters and receivers; casters; visible, "
               "casters and receivers that matter to this picture"},
      {.name = "shadow.reach",
       .fallback = 10.0,
       .low = 1e-3,
       .high = 1e6,
       .help = "of shadow.fit = fixed: radius around the world's origin that a map covers, m"},
      {.name = "shadow.update",
       .fallback = std::string("when-moved"),
       .choices = {"always", "when-moved"},
       .help = "when maps are drawn: for every frame, or only after something in them has changed"},
      {.name = "shadow.light",
       .fallback = 0,
       .low = 0,
       .high = 63,
       .help = "the light that the outputs shadow_map, shadow_coordinate and shadow_factor show: its index in the "
               "scene, from 0"},
  };
}

namespace {

using Bias = ShadowSettings::Bias;
using Fit = ShadowSettings::Fit;

Bias bias_named(const std::string& name) {
  return name == "none"       ? Bias::none
         : name == "constant" ? Bias::constant
         : name == "slope"    ? Bias::slope
         : name == "normal"   ? Bias::normal_offset
         : name == "plane"    ? Bias::plane
                              : Bias::front_faces;
}

Fit fit_named(const std::string& name) {
  return name == "fixed" ? Fit::fixed : name == "scene" ? Fit::scene : name == "casters" ? Fit::casters : Fit::visible;
}

GLenum format_named(const std::string& name) {
  return GLenum(name == "16" ? GL_DEPTH_COMPONENT16 : name == "24" ? GL_DEPTH_COMPONENT24 : GL_DEPTH_COMPONENT32F);
}

}  // namespace

ShadowSettings shadow_settings(const Settings& settings) {
  ShadowSettings s{.resolution = settings.integer("shadow.resolution"),
                   .format = format_named(settings.choice("shadow.format")),
                   .bias = bias_named(settings.choice("shadow.bias")),
                   .bias_size = float(settings.real("shadow.bias_size")),
                   .pcf = settings.integer("shadow.pcf"),
                   .pcss = settings.choice("shadow.soft") == "pcss",
                   .samples = settings.integer("shadow.samples"),
                   .random = settings.choice("shadow.pattern") == "random",
                   .light_width = settings.real("light.width"),
                   .fit = fit_named(settings.choice("shadow.fit")),
                   .reach = float(settings.real("shadow.reach")),
                   .keep = settings.choice("shadow.update") == "when-moved",
                   .shown_light = settings.integer("shadow.light")};
  s.bilinear = settings.choice("shadow.filter") == "bilinear" && !s.pcss;
  if (!s.random) s.samples = int(std::sqrt(s.samples + 0.5)) * int(std::sqrt(s.samples + 0.5));
  return s;
}

bool shows_shadows_alone(const View& view) {
  return view.output == "shadow_factor" || view.output == "shadow_coordinate";
}

bool shows_shadows(const View& view) {
  return view.output == "colour" || view.output == "shadow_map" || shows_shadows_alone(view);
}

float texels_moved(const ShadowSettings& s) {
  // Step 04 has no receiver plane bias.
  const bool along_normal = s.bias == Bias::normal_offset || s.bias == Bias::plane;
  return along_normal ? std::abs(s.bias_size) * float(s.pcf + (s.bilinear ? 1 : 0)) : 0.0f;
}

int lookups_in_a_map(const ShadowSettings& s) {
  return s.pcss ? 2 * s.samples : s.pcf * s.pcf * (s.bilinear ? 4 : 1);  // pcss: blockers, then comparisons
}

Defines filter_structure(const ShadowSettings& s) {
  Defines d;
  d["BIAS"] = std::to_string(s.culls_front_faces() ? 0 : int(s.bias));
  d["PCF"] = std::to_string(s.pcf);
  if (s.bilinear) d["COMPARE"] = "1";
  if (s.pcss) d["PCSS"] = "1", d["SAMPLES"] = std::to_string(s.samples);
  if (s.pcss && s.random) d["RANDOM"] = "1";
  return d;
}

void bind_bias(Binder& binder, const ShadowSettings& s) {
  binder.set("u_bias", s.bias_size);
  // Matrix products have an error of about ten units in the last place of a float near 1, in any format.
  binder.set("u_depth_epsilon", 1e-6f + (s.format == GL_DEPTH_COMPONENT16 ? 1.0f / 65535 : 0.0f));
}

std::vector<DrawConstant> bias_constants() {
  return {{"float", "u_bias"}, {"float", "u_depth_epsilon"}};
}

}  // namespace atelier
