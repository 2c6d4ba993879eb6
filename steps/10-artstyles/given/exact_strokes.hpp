// The functions of strokes again, slowly, pixel by pixel: their ground truth. Given.
#pragma once

#include "10-artstyles/given/painter.hpp"

namespace atelier {

StrokeFunctions exact_strokes();

}  // namespace atelier
