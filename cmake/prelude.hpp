// Included before every student's file, precompiled: what the contracts include anyway.
#pragma once

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
