// Runs a step program to get pictures, their ground truth and their cost. It runs as a separate process, and its files
// are read as the judge reads them.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "case/implementations.hpp"
#include "case/output.hpp"
#include "image/image.hpp"

namespace atelier::measure {

struct Program {
  std::filesystem::path file;  ///< BIN/NN-name
  Implementations implementations;
  std::string context;                 ///< "osmesa", "egl", "window"; empty: the program's default
  std::filesystem::path shader_cache;  ///< the driver's; empty: none
};

/// The program's settings and outputs, from --list --json.
struct Listing {
  std::vector<SettingSpec> settings;
  std::vector<OutputSpec> outputs;
  std::vector<std::string> output_names() const;
  Encoding encoding_of(const std::string& output) const;  ///< data for an output that it does not have
};
/// Throws Error with the program's message if it fails.
Listing list_of(const Program& program);

/// Wall-clock time of a frame, from the first OpenGL call to the end of glFinish, in seconds.
struct FrameTimes {
  int count = 0;
  double median = 0, least = 0, most = 0;
};

/// The cost of a picture: counts by name, and frame times if it was drawn repeatedly.
struct Cost {
  std::map<std::string, double> counts;
  std::optional<FrameTimes> times;
};

/// Throws Error with `where` and a suggestion if there is no such count.
double count_of(const Cost& cost, const std::string& name, const std::string& where);

struct Drawn {
  Image picture;
  Cost cost;
};

/// Draws each case, and then `repeats` times more for timing. The driver uses the calling thread only and optimises its
/// shaders (the judge turns that off, which is faster for a single frame). Throws Error with the program's message if
/// it refuses a case, and if an answer cannot be read.
std::vector<Drawn> draw(const Program& program, const std::vector<Case>& cases, int repeats = 0);

/// The ground truth of each case, with samples x samples rays per pixel.
std::vector<Image> trace(const Program& program, const std::vector<Case>& cases, int samples = 1);

}  // namespace atelier::measure
