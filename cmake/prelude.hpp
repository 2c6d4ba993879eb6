// Included before every student's file, precompiled: what the contracts include anyway. No include guard: nothing
// else includes it, and GCC warns of one in a file that it precompiles.

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
