// What drawing has cost, in numbers that are the same on every machine.
#pragma once

#include <cstdint>
#include <string>

namespace atelier {

/// What was asked of OpenGL since Gl::restart_counts(): what --stats prints, and what 'only what the scene requires' is
/// tested by. A count of draws is a fact about the program; a time is one about the machine too.
struct GlCounts {
  /// Framebuffers drawn into, cleared or blitted to, anew after each binding or change of attachment. To bring several
  /// samples a pixel into a texture is one.
  std::int64_t passes = 0;
  std::int64_t clears = 0;     ///< glClear* calls
  std::int64_t draws = 0;      ///< glDraw* calls
  std::int64_t triangles = 0;  ///< asked for by them
  std::int64_t vertices = 0;   ///< corners asked for by them; a vertex that three triangles share counts three times

  std::int64_t variants = 0;          ///< different shader programs drawn with
  std::int64_t program_switches = 0;  ///< glUseProgram calls that chose another program than the one before
  std::int64_t programs_linked = 0;   ///< shader programs built
  std::int64_t attributes = 0;        ///< different vertex attributes that the programs drawn with read
  std::int64_t texture_sources = 0;   ///< different textures that the programs drawn with look up

  std::int64_t target_bytes = 0;     ///< of all attachments of the framebuffers that `passes` counts
  std::int64_t texture_bytes = 0;    ///< that the textures hold now, all levels and layers, without targets
  std::int64_t allocated_bytes = 0;  ///< asked for by glTexImage* and glRenderbufferStorage*: 0 in a frame at rest
};

/// A part of a frame that was given a name (gl/debug.hpp), with what was asked for in it and in the groups inside it.
struct GlGroup {
  int depth = 0;  ///< how many groups it lies in
  std::string name;
  std::int64_t passes = 0;  ///< begun in it: none where it draws on in a pass that was begun before
  std::int64_t draws = 0, triangles = 0;
  bool operator==(const GlGroup&) const = default;
};

}  // namespace atelier
