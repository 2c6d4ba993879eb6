// What the probes of a map's and of a cube's pass have in common. Given.
#pragma once

#include <string>

#include "app/probe.hpp"

namespace atelier {

/// The formats of depth that a probe's argument `format` counts: 16, 24 and 32 bits.
GLenum depth_format_of(const Arguments& in);

/// Sets all that a depth pass must set to something else.
void set_against_depth_pass(Gl& gl);
/// What is set of it now: viewport, depth test, function, writing and clamping, culling and its face.
Numbers depth_pass_state(Gl& gl);
/// Back to what the next probe expects.
void end_depth_pass(Gl& gl);

/// The text that leaves it to a probe's arguments to declare u_bias and u_depth_epsilon: shadows.glsl declares others
/// in their place.
extern const std::string bias_as_argument;

}  // namespace atelier
