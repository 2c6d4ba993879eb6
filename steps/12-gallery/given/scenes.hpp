// The scenes of step 12. Given.
#pragma once

#include <string>

#include "12-gallery/given/plan.hpp"
#include "app/scene_table.hpp"

namespace atelier {

/// "hall.segments", "gallery.room", "gallery.portals".
std::vector<SettingSpec> gallery_scene_settings();

const SceneTable& gallery_scenes();

/// The same scene with this hall.
Scene gallery_with(const HallParts& hall, const Settings& settings);

/// The name of a painting's node, of its material, and of its three textures. The bedroom's door is number
/// paintings_in_hall.
std::string painting_name(int painting);

}  // namespace atelier
