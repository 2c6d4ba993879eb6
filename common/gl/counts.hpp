// The cost of drawing, in counts that are the same on every machine.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace atelier {

/// Counts of OpenGL work since Gl::restart_counts(). --stats prints them, and the tests of "unused features cost
/// nothing" compare them.
struct GlCounts {
  /// Framebuffers drawn into, cleared or blitted to; one more after another one was bound, or an attachment
  /// changed. A resolve
  /// of multisampling counts as one.
  std::int64_t passes = 0;
  std::int64_t clears = 0;     ///< glClear* calls
  std::int64_t draws = 0;      ///< glDraw* calls
  std::int64_t triangles = 0;  ///< drawn by them
  std::int64_t vertices = 0;   ///< vertices drawn by them; a vertex that three triangles share counts three times
  /// Samples that passed all tests: one for each fragment, or up to one for each sample of a multisampled target. Only
  /// if Gl::count_fragments() asked for it.
  std::optional<std::int64_t> fragments;

  std::int64_t variants = 0;          ///< different shader programs drawn with
  std::int64_t program_switches = 0;  ///< glUseProgram calls that changed the program
  std::int64_t programs_linked = 0;   ///< shader programs linked
  std::int64_t attributes = 0;        ///< different vertex attributes that the used programs read
  std::int64_t texture_sources = 0;   ///< different textures that the used programs sample

  std::int64_t target_bytes = 0;     ///< of all attachments of the framebuffers in `passes`
  std::int64_t texture_bytes = 0;    ///< of all textures now, all levels and layers, without targets
  std::int64_t allocated_bytes = 0;  ///< allocated by glTexImage* and glRenderbufferStorage*; 0 in a steady-state frame
};

/// A named part of a frame (gl/debug.hpp), with the counts of it and of the groups inside it.
struct GlGroup {
  int depth = 0;  ///< how many groups enclose it
  std::string name;
  std::int64_t passes = 0;  ///< begun in it: 0 if it only continues an earlier pass
  std::int64_t draws = 0, triangles = 0;
  std::int64_t fragments = 0;  ///< 0 unless they are counted
  bool operator==(const GlGroup&) const = default;
};

}  // namespace atelier
