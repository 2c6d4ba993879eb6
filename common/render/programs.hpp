// Shader programs: built on first use, cached, and rebuilt when their files change.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "case/implementations.hpp"
#include "gl/shader.hpp"
#include "render/chain.hpp"
#include "render/scene_painter.hpp"
#include "render/surface_shader.hpp"

namespace atelier {

struct Program {
  GlProgram program;
  Uniforms uniforms;
  std::map<std::filesystem::path, std::filesystem::file_time_type> files;  ///< when each was last changed
};

/// The cache key of a chain pass's program.
struct ChainKey {
  SlotCode code;
  std::vector<std::string> reads;
  Defines structure;
  std::string full_screen_glsl;  ///< ChainFunctions::glsl
  bool operator<(const ChainKey& other) const;
};

class Programs {
 public:
  /// Shaders are searched in `implementations`, then among the renderer's own. `transforms_glsl` is the include behind
  /// TransformFunctions::glsl.
  Programs(Gl& gl, Implementations implementations, std::string transforms_glsl);

  /// A program and its cache key, whose addresses stay valid. The functions throw ShaderError with source file and
  /// line.
  struct Surface {
    const SurfaceKey& key;
    Program& program;
  };
  Surface surface(const SurfaceKey& key);
  Program& pass(const PassSources& pass);
  Program& chain_pass(const ChainKey& key);

  struct Reloaded {
    bool passes = false;  ///< a program that a feature draws with
    std::string words;    ///< the driver's log if it rejected one: the old program stays
  };
  /// Rebuilds every program with a changed file.
  Reloaded reload_changed();

 private:
  std::filesystem::path find(const std::string& name) const;
  Program build(const SurfaceKey& key) const;
  Program build(const PassSources& pass) const;
  Program build(const ChainKey& key) const;
  template <class Key>
  typename std::map<Key, Program>::iterator kept(std::map<Key, Program>& programs, const Key& key) const;
  template <class Key>
  bool reload_changed(std::map<Key, Program>& programs, std::string& words) const;

  Gl& gl_;
  Implementations implementations_;
  std::string transforms_glsl_;
  int varyings_;  ///< the driver's limit of varying components
  std::map<SurfaceKey, Program> surfaces_;
  std::map<PassSources, Program> passes_;
  std::map<ChainKey, Program> chain_;
};

}  // namespace atelier
