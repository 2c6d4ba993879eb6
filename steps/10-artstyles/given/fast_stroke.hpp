// paint_stroke again, several pixels at a time. Given.
#pragma once

#include "10-artstyles/artstyles.hpp"

namespace atelier {

/// What the contract of paint_stroke says, bit by bit.
void paint_stroke_fast(artstyles::Picture& canvas, const artstyles::Stroke& stroke, artstyles::Rows rows,
                       std::span<const int> regions);

}  // namespace atelier
