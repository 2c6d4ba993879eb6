// Dithering as a pass of the chain: which method runs where, its textures and uniforms. Given.
#pragma once

#include <vector>

#include "09-dithering/dithering.hpp"
#include "app/step_program.hpp"
#include "case/settings.hpp"
#include "gl/objects.hpp"
#include "render/feature.hpp"

namespace atelier {

std::vector<SettingSpec> dither_settings();

/// The picture after each pass, with those of step 08.
std::vector<OutputSpec> dither_outputs();

class DitherPass : public Feature {
 public:
  void configure(const Settings& settings) override;
  void prepare(Gl& gl, const Scene& scene) override;
  std::vector<ChainPass> passes(const Scene& scene, const View& view) const override;
  Need need(const Scene&, const View&, const Node&) const override { return {}; }  // no code in surfaces

 private:
  ChainPass shader_pass(const View& view) const;
  ChainPass grey_pass() const;
  ChainPass cpu_pass() const;
  ChainPass line_pass(const View& view) const;
  void diffuse(ByteImage& picture) const;
  void bind_camera(Binder& binder, const View& view) const;
  bool diffuses() const { return method_ == "floyd-steinberg" || method_ == "atkinson"; }

  std::string method_, held_, lines_;
  dithering::Diffusion diffusion_;
  int matrix_size_ = 8, threads_ = 1;
  float cell_ = 1;  ///< pixels
  bool linear_ = false, grey_ = false, fast_ = false;
  std::vector<int> matrix_;  ///< Bayer's
  GlTexture ranks_;
  int side_ = 1;  ///< of the ranks' square
};

}  // namespace atelier
