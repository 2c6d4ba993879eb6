#include "case/output.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "base/error.hpp"

namespace atelier {
namespace {

constexpr std::array<std::pair<Stage, std::string_view>, 7> stages = {{{Stage::surface, "surface"},
                                                                       {Stage::light, "light"},
                                                                       {Stage::pass, "pass"},
                                                                       {Stage::colour, "colour"},
                                                                       {Stage::after_colour, "after_colour"},
                                                                       {Stage::aside, "aside"},
                                                                       {Stage::other_view, "other_view"}}};

}  // namespace

std::string to_string(Stage stage) {
  return std::string(stages[std::size_t(stage)].second);
}

Stage stage_named(std::string_view name) {
  std::string known;
  for (const auto& [stage, own_name] : stages) {
    if (own_name == name) return stage;
    known += fmt::format("{}{}", known.empty() ? "" : ", ", own_name);
  }
  throw Error(fmt::format("stage '{}': it is one of {}", name, known));
}

}  // namespace atelier
