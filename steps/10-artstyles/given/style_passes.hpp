// The styles as passes of the chain, and the cube of six views for the lens. Given.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "10-artstyles/given/painter.hpp"
#include "app/step_program.hpp"
#include "case/settings.hpp"
#include "render/feature.hpp"

namespace atelier {

std::vector<SettingSpec> style_settings();

/// The picture after each style, and what the styles are made of; with those of step 08.
std::vector<OutputSpec> style_outputs();

Painting painting_of(const Settings& settings);

enum class Style { none, painterly, toon, fisheye, aberration };
using Styles = std::array<Style, 2>;  ///< in their order
Styles styles_of(const Settings& settings);

/// Whether the picture begins with a lens that sees six views: the first style, if it is a fish-eye from a cube.
bool begins_with_cube(const Settings& settings);

/// The axes of view space in the world: right, up, and backwards.
glm::dmat3 view_axes(const Camera& camera);

/// The six views around the eye, and the pass that begins the picture with them.
class CubeOfViews : public Feature {
 public:
  void configure(const Settings& settings) override;
  void draw_views(Gl& gl, const Scene& scene, const Viewpoint& viewpoint, ScenePainter& painter) override;
  std::vector<ChainPass> passes(const Scene& scene, const View& view) const override;
  Need need(const Scene&, const View&, const Node&) const override { return {}; }  // no code in surfaces

 private:
  bool wanted_ = false, all_faces_ = false;
  double half_angle_ = 1;  ///< radians
  int edge_ = 256;
  std::shared_ptr<const CubeTarget> cube_;
};

class StylePasses : public Feature {
 public:
  void configure(const Settings& settings) override;
  std::vector<ChainPass> passes(const Scene& scene, const View& view) const override;
  Need need(const Scene&, const View&, const Node&) const override { return {}; }  // no code in surfaces

 private:
  ChainPass shader_pass(const char* name, const char* function, const View& view) const;
  void read_surfaces(ChainPass& pass, const View& view, bool behind_lens) const;
  ChainPass toon_pass(const char* name, const View& view, bool behind_lens) const;
  ChainPass painterly_pass(const char* name) const;
  ChainPass style_pass(std::size_t i, const char* name, const View& view) const;
  ChainPass relief_pass(const View& view) const;

  Styles styles_{};
  bool cube_ = false, equidistant_ = false, restored_ = false, colour_edges_ = false, surface_edges_ = false,
       fast_ = false;
  float low_ = 0, high_ = 1, half_angle_ = 1, strength_ = 0, power_ = 2, amount_ = 0, turns_ = 0;
  Painting painting_;
};

}  // namespace atelier
