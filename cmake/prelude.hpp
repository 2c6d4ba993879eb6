// The precompiled header that is included before every student's file; the contracts include these headers anyway. No
// include guard: nothing else includes it, and GCC warns of `#pragma once` in a precompiled file.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "render/transforms.hpp"
#include "scene/scene.hpp"
