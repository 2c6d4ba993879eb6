// The settings of shadow maps. Given.
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
  bool bilinear = false;   ///< the four nearest texels are compared and the results interpolated
  int pcf = 1;             ///< comparisons along a side of the filter
  bool pcss = false;       ///< instead of pcf: a filter as wide as the penumbra
  int samples = 16;        ///< of pcss
  bool random = false;     ///< whether these are random, or on a grid
  double light_width = 0;  ///< of the light sources: metres; tangent of an angle for directional lights
  Fit fit = Fit::scene;
  float reach = 10;     ///< metres, of Fit::fixed
  bool keep = true;     ///< maps are drawn only when their content has changed; otherwise for every frame
  int shown_light = 0;  ///< the light of the shadow outputs

  bool culls_front_faces() const { return bias == Bias::front_faces; }
};
ShadowSettings shadow_settings(const Settings& settings);

/// Whether an output shows shadows: normals and depths need no map.
bool shows_shadows(const View& view);
/// Whether an output shows only shadow data at surface points: factor or coordinate.
bool shows_shadows_alone(const View& view);

/// How many texels the bias moves a point along its normal. Moving it towards the light does not move it in the map.
float texels_moved(const ShadowSettings& settings);

/// Texels that the filter reads per point in one map.
int lookups_in_a_map(const ShadowSettings& settings);

/// The shader's #defines of bias and filter.
Defines filter_structure(const ShadowSettings& settings);
/// The uniforms of shadows.glsl that do not belong to a light: sets them, and lists them as draw constants.
void bind_bias(Binder& binder, const ShadowSettings& settings);
std::vector<DrawConstant> bias_constants();

}  // namespace atelier
