#include "app/cost.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/printable.hpp"

namespace atelier {
namespace {

/// A group's name made printable, since it may contain text from a scene file.
std::string shown_name(const GlGroup& group, std::size_t longest) {
  return shorten(printable(group.name), longest);
}

/// Bytes: with this limit 256 groups, the most that are listed, fit into the 64 KiB of a .stats file
/// (case/exchange.hpp).
constexpr std::size_t longest_in_json = 48;

std::string groups_as_text(const std::vector<GlGroup>& groups) {
  if (groups.empty()) return {};
  constexpr int name_columns = 53;
  constexpr std::size_t deepest = 16, longest = name_columns - deepest;
  std::string text = fmt::format("\n{:<{}} {:>7} {:>7} {:>12} {:>12}\n", "group", name_columns, "passes", "draws",
                                 "triangles", "fragments");
  for (const GlGroup& group : groups) {
    const std::string indent(std::min(2 * std::size_t(group.depth), deepest), ' ');
    text += fmt::format("{:<{}} {:>7} {:>7} {:>12} {:>12}\n", indent + shown_name(group, longest), name_columns,
                        group.passes, group.draws, group.triangles, group.fragments);
  }
  return text;
}

}  // namespace

FrameTimings timings_of(std::vector<double> seconds) {
  if (seconds.empty()) throw Error("no frame was timed, so there is no median");
  std::sort(seconds.begin(), seconds.end());
  const std::size_t count = seconds.size();
  return {.count = int(count),
          .median_s = (seconds[(count - 1) / 2] + seconds[count / 2]) / 2,
          .least_s = seconds.front(),
          .most_s = seconds.back()};
}

std::vector<CostRow> cost_rows(const DrawingCost& cost) {
  const GlCounts& gl = cost.gl;
  const SceneCounts& scene = cost.scene;
  std::vector<CostRow> rows = {
      {"passes", gl.passes, "targets drawn into, cleared or resolved into"},
      {"clears", gl.clears, "of a target"},
      {"draws", gl.draws, "glDraw* calls"},
      {"triangles", gl.triangles, "drawn by these calls"},
      {"vertices", gl.vertices, "vertices drawn by these calls; a shared one counts each time"},
      {"attributes", gl.attributes, "vertex attributes that the shaders read: position, normal ..."},
      {"variants", gl.variants, "different shader programs drawn with"},
      {"program_switches", gl.program_switches, "changes of the current program"},
      {"programs_linked", gl.programs_linked, "linked in this frame; 0 if an earlier frame has linked them"},
      {"texture_sources", gl.texture_sources, "textures that the shaders sample"},
      {"texture_bytes", gl.texture_bytes, "bytes of all textures, all levels, without targets"},
      {"target_bytes", gl.target_bytes, "bytes of the targets drawn into: colour, depth ..."},
      {"allocated_bytes", gl.allocated_bytes, "bytes allocated in this frame"},
      {"views", scene.views, "views in which surfaces are drawn, those inside others among them"},
      {"view_pixels", scene.view_pixels, "pixels of their rectangles: the target, or the scissor in it"},
      {"nodes", scene.nodes, "nodes with a mesh, in all views together"},
      {"nodes_culled", scene.nodes_culled, "of those, skipped because they are outside the view"},
      {"skies", scene.skies, "draws of the sky, one for each view of colour"},
      {"matrices", scene.matrices, "world and normal matrices computed in this frame"},
      {"lights", scene.lights, "lights summed by the shaders for each point"},
      {"lookups", scene.lookups, "texels of shadow and height maps read by the shaders for each point"},
      {"lights_culled", scene.lights_culled, "lights of the scene, skipped because they are too weak to be visible"},
  };
  if (gl.fragments)
    rows.push_back(
        {"fragments", *gl.fragments, "fragments that passed all tests, or samples of a multisampled target"});
  return rows;
}

std::string cost_as_text(const DrawingCost& cost) {
  std::string text;
  for (const CostRow& row : cost_rows(cost))
    text += fmt::format("{:<17} {:>12}  {}\n", row.name, row.value, row.meaning);
  if (const auto& frames = cost.frames)
    text += fmt::format("{:<17} {:>12.3f}  milliseconds, median of {} frames: {:.3f} to {:.3f}\n", "frame",
                        frames->median_s * 1e3, frames->count, frames->least_s * 1e3, frames->most_s * 1e3);
  return text + groups_as_text(cost.groups);
}

std::string cost_as_json(const DrawingCost& cost) {
  nlohmann::ordered_json json;
  for (const CostRow& row : cost_rows(cost)) json["counts"][row.name] = row.value;
  json["groups"] = nlohmann::ordered_json::array();
  for (const GlGroup& group : cost.groups)
    json["groups"].push_back({{"depth", group.depth},
                              {"name", shown_name(group, longest_in_json)},
                              {"passes", group.passes},
                              {"draws", group.draws},
                              {"triangles", group.triangles},
                              {"fragments", group.fragments}});
  if (const auto& frames = cost.frames)
    json["frames"] = {{"count", frames->count},
                      {"median_s", frames->median_s},
                      {"least_s", frames->least_s},
                      {"most_s", frames->most_s}};
  return json.dump(2) + "\n";
}

}  // namespace atelier
