// The chain of passes, as a feature of the renderer: which passes run, their shaders, uniforms and textures. Given.
#pragma once

#include <vector>

#include "08-post-processing/given/looks.hpp"
#include "08-post-processing/post_processing.hpp"
#include "app/step_program.hpp"
#include "case/settings.hpp"
#include "gl/objects.hpp"
#include "render/feature.hpp"

namespace atelier {

/// The student's functions that run a chain, for the renderer.
ChainFunctions chain_functions();

std::vector<SettingSpec> post_settings();

/// The picture after each pass.
std::vector<OutputSpec> post_outputs();

class PostChain : public Feature {
 public:
  void configure(const Settings& settings) override;
  void prepare(Gl& gl, const Scene& scene) override;
  std::vector<ChainPass> passes(const Scene& scene, const View& view) const override;
  Need need(const Scene& scene, const View& view, const Node& node) const override;
  std::map<Slot, SlotCode> slots() const override;

 private:
  std::vector<ChainPass> passes_of(post_processing::Pass pass) const;
  ChainPass shader_pass(const char* name, const char* function) const;
  ChainPass blur_pass(const char* name, const char* function) const;
  ChainPass bloom_pass() const;
  ChainPass fetching_pass() const;
  ChainPass fused(std::span<const post_processing::Pass> wanted) const;
  void bind(Binder& binder, post_processing::Pass pass) const;

  post_processing::Look look_;
  float threshold_ = 1, sigma_ = 6, white_ = 4;
  std::string table_name_;
  int table_points_ = 9;  ///< along each axis
  bool tetrahedral_ = false, fuses_ = false, dithers_ = false;
  int fetches_ = 0;
  bool frame_has_8_bits_ = false, chain_has_8_bits_ = false;
  std::vector<float> weights_;
  post_processing::ColourTable table_;
  GlTexture table_texture_, overlay_texture_;
};

}  // namespace atelier
