// Bodies that stand in an opening, with the student's functions. Given.
#pragma once

#include "scene/scene.hpp"

namespace atelier {

/// Draws every travelling body (Node::travels) that stands in the opening of a portal on both sides: it ends at the
/// entry's plane, and a copy at the exit, carried through and ending there, continues it. Adds the copies' nodes.
void split_bodies(Scene& scene);

}  // namespace atelier
