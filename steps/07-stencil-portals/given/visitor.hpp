// A visitor who walks through portals, with the student's functions. Given.
#pragma once

#include "case/settings.hpp"
#include "scene/scene.hpp"

namespace atelier {

/// "visitor.way".
std::vector<SettingSpec> visitor_settings();

/// The camera after its visitor has gone this fraction of the scene's walk (walk_of), in steps of 1/64 of it. The
/// rules: portals carry the visitor on, from their front, and from behind if they are two-sided. Walls and mirrors
/// neither stop nor carry anybody. Who ends exactly on the plane of an opening has not gone through it. Two openings on
/// the walk are more than a step apart.
Camera visit(const Scene& scene, const Camera& camera, const Settings& settings);

}  // namespace atelier
