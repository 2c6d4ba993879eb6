// LDR-FLIP: per pixel, how different two pictures look to a viewer who flips between them.
//
// P. Andersson, J. Nilsson, T. Akenine-Moeller, M. Oskarsson, K. Astroem, M. D. Fairchild: FLIP: A Difference Evaluator
// for Alternating Images. Proc. ACM Comput. Graph. Interact. Tech. 3(2), 2020. In short: blur both pictures as the eye
// does at this distance, take a colour distance that is valid for large differences too, and increase it where edges or
// points appear in one picture only.
#pragma once

#include "image/colour.hpp"
#include "image/image.hpp"

namespace atelier {

struct FlipOptions {
  Encoding encoding = Encoding::srgb;  ///< of both pictures; `data` is an error. Values are clamped to 0..1, NaN to 0
  double pixels_per_degree = 67.0206;  ///< of the visual field, 1..200; a 0.7 m wide 3840-pixel screen seen from 0.7 m
  int threads = 1;                     ///< 1..64; the result does not depend on it
};

struct Flip {
  Image map;        ///< the error in red, green and blue: 0 equal, 1 the largest possible
  double mean = 0;  ///< over all pixels
};

/// Compares `test` with `reference`. Throws Error if the sizes differ, a picture is empty, or an option is out of
/// range. Equal pictures have an error of exactly 0 everywhere.
Flip flip(const Image& reference, const Image& test, const FlipOptions& options = {});

}  // namespace atelier
