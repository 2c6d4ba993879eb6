// Dear ImGui controls for the settings of a step, generated from their specifications.
#pragma once

#include "app/window/viewer.hpp"

namespace atelier {

/// A combo box in the current ImGui window; returns the newly chosen name, or an empty string.
std::string edit_choice(const char* label, const std::string& current, const std::vector<std::string>& choices);

/// A control per setting, grouped by the part of its name before the dot ("shadow.resolution"), with help as tooltips;
/// and a button that resets all to their defaults.
void edit_settings(Viewer& viewer);

}  // namespace atelier
