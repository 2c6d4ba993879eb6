// A step program, asked for pictures, for their truth and for what they cost. It is a process of its own, and what it
// writes is read as the judge reads it: nothing of a step is ever linked here.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "case/implementations.hpp"
#include "image/colour.hpp"

namespace atelier::measure {

struct Program {
  std::filesystem::path file;  ///< BIN/NN-name
  Implementations implementations;
  std::string context;                 ///< "osmesa", "egl", "window"; empty: what the program takes by itself
  std::filesystem::path shader_cache;  ///< the driver's; empty: none
};

/// What --list --json says of it.
struct Listing {
  std::vector<SettingSpec> settings;
  std::map<std::string, Encoding> outputs;
  std::vector<std::string> output_names() const;
};
Listing list_of(const Program& program);

/// Wall time of a frame, from the first call to OpenGL to the end of glFinish, in seconds.
struct FrameTimes {
  int count = 0;
  double median = 0, least = 0, most = 0;
};

/// What a picture costs: what was counted while it was drawn, by name, and its times where it was repeated.
struct Cost {
  std::map<std::string, double> counts;
  std::optional<FrameTimes> times;
};

struct Drawn {
  Image picture;
  Cost cost;
};

/// Draws each case; with `repeats` above 0 so often more, to time it. The driver draws in the calling thread alone,
/// with its shaders optimised as they are for everybody (the judge does without, since that is faster for a single
/// frame). Throws Error with the program's own sentence where it refuses a case, and where an answer cannot be read.
std::vector<Drawn> draw(const Program& program, const std::vector<Case>& cases, int repeats = 0);

/// The truth of each case, by n x n rays a pixel.
std::vector<Image> trace(const Program& program, const std::vector<Case>& cases, int samples = 1);

}  // namespace atelier::measure
