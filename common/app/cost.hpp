// The cost of drawing a picture: counts that are the same on every machine, and optionally frame times.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gl/counts.hpp"
#include "render/counts.hpp"

namespace atelier {

/// Wall-clock times of frames, each from its first call until OpenGL has finished.
struct FrameTimings {
  int count = 0;
  double median_s = 0, least_s = 0, most_s = 0;  ///< seconds; an even count's median is the mean of the middle two
};

/// Throws Error if there are no times.
FrameTimings timings_of(std::vector<double> seconds);

/// For one frame: the last one if it was drawn repeatedly.
struct DrawingCost {
  GlCounts gl;
  SceneCounts scene;
  std::vector<GlGroup> groups;  ///< in the order in which they began
  std::optional<FrameTimings> frames;
};

/// One line of what --stats prints.
struct CostRow {
  const char* name;  ///< "target_bytes": the member in JSON too
  std::int64_t value;
  const char* meaning;  ///< with the unit: "bytes of the attachments drawn into"
};

/// Every count, in the order of the output; fragments only if they were counted (Painter::count_fragments).
std::vector<CostRow> cost_rows(const DrawingCost& cost);

/// Text tables: name, value and meaning of each count; name, passes, draws, triangles and fragments of each group,
/// indented by its depth.
std::string cost_as_text(const DrawingCost& cost);

/// {"counts": {NAME: whole number, ...}, "groups": [{"depth", "name", "passes", "draws", "triangles", "fragments"},
/// ...], "frames": {"count", "median_s", "least_s", "most_s"}}; "frames" only if frames were timed.
std::string cost_as_json(const DrawingCost& cost);

}  // namespace atelier
