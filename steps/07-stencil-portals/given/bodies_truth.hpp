// Ground truth of bodies that stand in an opening, in double precision, without the student's functions. Given.
#pragma once

#include "scene/scene.hpp"

namespace atelier {

/// Splits every travelling body whose box meets the opening of a portal, as split_bodies does.
void split_bodies_exactly(Scene& scene);

}  // namespace atelier
