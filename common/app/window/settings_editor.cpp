#include "app/window/settings_editor.hpp"

#include <fmt/core.h>
#include <imgui.h>

#include <optional>

#include "app/window/colour_codes.hpp"

namespace atelier {
namespace {

const char* group_end(const std::string& name) {
  const auto dot = name.find('.');
  return name.c_str() + (dot == std::string::npos ? 0 : dot);
}

std::string group_of(const std::string& name) {
  return {name.c_str(), group_end(name)};
}
std::string own_name(const std::string& name) {
  return *group_end(name) == '.' ? group_end(name) + 1 : name;
}

/// Logarithmic for a range over several powers of ten.
ImGuiSliderFlags scale_of(const SettingSpec& spec) {
  const bool wide = spec.low > 0 ? spec.high / spec.low >= 100 : spec.high - spec.low >= 1000;
  return ImGuiSliderFlags_AlwaysClamp | (wide ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None);
}

/// As many digits as a slider over this range can resolve.
const char* digits_of(const SettingSpec& spec) {
  const double span = spec.high - spec.low;
  return span >= 1000 ? "%.1f" : span >= 10 ? "%.2f" : span >= 0.1 ? "%.3f" : "%.3g";
}

/// One control, by the type of the value; returns the new value if the user has changed it.
struct Control {
  const SettingSpec& spec;
  const char* label;
  std::optional<SettingValue> operator()(bool value) const {
    if (!ImGui::Checkbox(label, &value)) return {};
    return SettingValue(value);
  }
  std::optional<SettingValue> operator()(int value) const {
    if (!ImGui::SliderInt(label, &value, int(spec.low), int(spec.high), "%d", scale_of(spec))) return {};
    return SettingValue(value);
  }
  std::optional<SettingValue> operator()(double value) const {
    if (!ImGui::SliderScalar(label, ImGuiDataType_Double, &value, &spec.low, &spec.high, digits_of(spec),
                             scale_of(spec)))
      return {};
    return SettingValue(value);
  }
  std::optional<SettingValue> operator()(const std::string& value) const {
    const std::string chosen = edit_choice(label, value, spec.choices);
    if (chosen.empty()) return {};
    return SettingValue(chosen);
  }
  std::optional<SettingValue> operator()(const Colour& value) const {
    const bool beyond_screens = spec.low < 0 || spec.high > 1;
    glm::vec3 shown = glm::vec3(codes_of(value)) / 255.0f;
    if (!ImGui::ColorEdit3(label, &shown.x,
                           ImGuiColorEditFlags_Uint8 | ImGuiColorEditFlags_NoTooltip |
                               (beyond_screens ? ImGuiColorEditFlags_HDR : ImGuiColorEditFlags_None)))
      return {};
    return SettingValue(with_codes(spec, value, glm::ivec3(glm::round(shown * 255.0f))));
  }
};

void explain(const SettingSpec& spec) {
  if (!ImGui::IsItemHovered()) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(ImGui::GetFontSize() * 28);
  ImGui::TextUnformatted(spec.help.c_str());
  ImGui::TextDisabled("--set %s=%s\n%s", spec.name.c_str(), setting_text(spec.fallback).c_str(),
                      allowed_values(spec).c_str());
  if (std::holds_alternative<Colour>(spec.fallback)) ImGui::TextDisabled("shown here as 8-bit sRGB codes");
  if (spec.high > spec.low) ImGui::TextDisabled("Ctrl+click to type a number");
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

void edit(Viewer& viewer, const SettingSpec& spec) {
  const SettingValue value = viewer.settings().value(spec.name);
  const std::string label = own_name(spec.name) + "##" + spec.name;
  const bool changed = value != spec.fallback;
  if (changed) ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_PlotHistogram));
  const auto edited = std::visit(Control{spec, label.c_str()}, value);
  if (changed) ImGui::PopStyleColor();
  explain(spec);
  if (edited && *edited != value) viewer.set(spec.name, *edited);
}

}  // namespace

std::string edit_choice(const char* label, const std::string& current, const std::vector<std::string>& choices) {
  std::string chosen;
  if (!ImGui::BeginCombo(label, current.c_str())) return chosen;
  for (const std::string& choice : choices) {
    if (ImGui::Selectable(choice.c_str(), choice == current) && choice != current) chosen = choice;
    if (choice == current) ImGui::SetItemDefaultFocus();
  }
  ImGui::EndCombo();
  return chosen;
}

void edit_settings(Viewer& viewer) {
  const std::vector<SettingSpec> specs = viewer.settings().specs();  // a copy, since an edit changes the viewer's
  std::string group = "\n";                                          // differs from any group name
  bool open = false;
  for (const SettingSpec& spec : specs) {
    if (group_of(spec.name) != group) {
      group = group_of(spec.name);
      open = ImGui::CollapsingHeader(group.empty() ? "settings" : group.c_str(), ImGuiTreeNodeFlags_DefaultOpen);
    }
    if (open) edit(viewer, spec);
  }
  if (!specs.empty() && ImGui::Button("Reset settings", ImVec2(-1, 0))) viewer.reset_settings();
}

}  // namespace atelier
