// The settings of shadow maps, as a program reads them. Given.
#pragma once

#include <vector>

#include "app/step_program.hpp"
#include "render/feature.hpp"

namespace atelier {

/// The settings of this step that belong to shadows (not to the scene).
std::vector<SettingSpec> shadow_setting_specs();

/// The output "shadow_factor", of every step that has shadows.
OutputSpec shadow_factor_output();

struct ShadowSettings {
  enum class Bias { none, constant, slope, normal_offset, plane, front_faces };
  enum class Fit { fixed, scene, casters, visible };
  int resolution = 1024;  ///< texels along a side of a map
  GLenum format = GL_DEPTH_COMPONENT24;
  Bias bias = Bias::normal_offset;
  float bias_size = 1;     ///< texels, times the width of the filter
  bool bilinear = false;   ///< the four nearest texels are compared and the answers mixed
  int pcf = 1;             ///< comparisons along a side of the filter
  bool pcss = false;       ///< in place of pcf: a filter as wide as the penumbra
  int samples = 16;        ///< of pcss
  bool random = false;     ///< whether these lie at random, or on a grid
  double light_width = 0;  ///< of the lights themselves: metres; the tangent of an angle for directional lights
  Fit fit = Fit::scene;
  float reach = 10;     ///< metres, of Fit::fixed
  bool keep = true;     ///< maps are drawn when what they show has changed; otherwise for every frame
  int shown_light = 0;  ///< whose shadow the outputs of shadows show

  bool culls_front_faces() const { return bias == Bias::front_faces; }
};
ShadowSettings shadow_settings(const Settings& settings);

/// Whether shadows are to be seen in an output: normals and depths need no map.
bool shows_shadows(const View& view);
/// Whether an output shows something of shadows alone, for each point of a surface: factor or coordinate.
bool shows_shadows_alone(const View& view);

/// How many texels the bias moves a point along its normal; what moves it towards the light leaves it where it is in
/// the map.
float texels_moved(const ShadowSettings& settings);

/// Texels that the filter reads of one map for each point.
int lookups_in_a_map(const ShadowSettings& settings);

/// What shaders must know to look up: #defines of bias and filter.
Defines filter_structure(const ShadowSettings& settings);
/// The uniforms of shadows.glsl that belong to no light: their values, and that they are constant over a draw.
void bind_bias(Binder& binder, const ShadowSettings& settings);
std::vector<DrawConstant> bias_constants();

}  // namespace atelier
