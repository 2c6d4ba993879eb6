#include "app/list.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "case/setting_json.hpp"

namespace atelier {

namespace {

const char* encoding_name(Encoding encoding) {
  switch (encoding) {
    case Encoding::linear:
      return "linear colour";
    case Encoding::srgb:
      return "encoded colour";
    case Encoding::data:
      return "data";
  }
  return "";
}

}  // namespace

std::string list_as_text(const StepDescription& description) {
  std::string text = fmt::format("{}: {}\n\nScenes (--scene)\n", description.name, description.title);
  for (const std::string& scene : description.scenes) text += fmt::format("  {}\n", scene);
  if (description.imports) text += "  or a .gltf, .glb or .obj file\n";
  text += "\nSettings (--set NAME=VALUE)\n";
  for (const SettingSpec& spec : description.settings)
    text += fmt::format("  {:<24} {} (default {})\n  {:<24}   {}\n", spec.name, allowed_values(spec),
                        setting_text(spec.fallback), "", spec.help);
  text += "\nOutputs (--output)\n";
  for (const OutputSpec& output : description.outputs)
    text += fmt::format("  {:<24} {}; {}\n", output.name, output.help, encoding_name(output.encoding));
  if (!description.probes.empty()) text += "\nProbes (functions that cases call)\n";
  for (const auto& [name, probe] : description.probes) text += fmt::format("  {}\n", name);
  return text;
}

std::string list_as_json(const StepDescription& description) {
  nlohmann::json json = {{"name", description.name}, {"title", description.title}, {"scenes", description.scenes}};
  json["settings"] = nlohmann::json::array();
  for (const SettingSpec& spec : description.settings) {
    nlohmann::json setting = {{"name", spec.name},
                              {"default", setting_to_json(spec.fallback)},
                              {"allowed", allowed_values(spec)},
                              {"help", spec.help}};
    if (!spec.choices.empty()) setting["choices"] = spec.choices;
    if (spec.high > spec.low) setting["range"] = {spec.low, spec.high};
    json["settings"].push_back(setting);
  }
  json["outputs"] = nlohmann::json::array();
  for (const OutputSpec& output : description.outputs)
    json["outputs"].push_back({{"name", output.name},
                               {"encoding", encoding_name(output.encoding)},
                               {"help", output.help},
                               {"stage", to_string(output.stage)}});
  json["probes"] = nlohmann::json::array();
  for (const auto& [name, probe] : description.probes) json["probes"].push_back(name);
  return json.dump(2) + "\n";
}

}  // namespace atelier
