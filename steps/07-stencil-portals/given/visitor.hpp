// A visitor who walks through portals, with the student's functions. Given.
#pragma once

#include "case/settings.hpp"
#include "scene/scene.hpp"

namespace atelier {

/// "visitor.way".
std::vector<SettingSpec> visitor_settings();

/// The camera after its visitor has gone this fraction of the scene's walk, in small steps.
Camera visit(const Scene& scene, const Camera& camera, const Settings& settings);

}  // namespace atelier
