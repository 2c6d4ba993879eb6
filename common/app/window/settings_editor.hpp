// The settings of a step as controls of Dear ImGui, each made from its specification alone.
#pragma once

#include "app/window/viewer.hpp"

namespace atelier {

/// A list to choose from in the ImGui window at hand; returns the name that was chosen now, or an empty string.
std::string edit_choice(const char* label, const std::string& current, const std::vector<std::string>& choices);

/// A control a setting, grouped by what stands before the dot of its name ("shadow.resolution"); help as tooltips; a
/// button that takes all of them back to their defaults.
void edit_settings(Viewer& viewer);

}  // namespace atelier
