// How far a picture is from its truth, as one number: what trades against time and memory. Never a verdict on a picture
// by itself (image/compare.hpp is), since no single number tells a right picture from a wrong one.
#pragma once

#include <array>
#include <string>

#include "image/colour.hpp"
#include "image/image.hpp"

namespace atelier {

enum class ErrorMetric { rmse, flip, misclassified, distance, degrees, displacement, acne, leak, wrong, mean };
inline constexpr std::array error_metrics{ErrorMetric::rmse,     ErrorMetric::flip,    ErrorMetric::misclassified,
                                          ErrorMetric::distance, ErrorMetric::degrees, ErrorMetric::displacement,
                                          ErrorMetric::acne,     ErrorMetric::leak,    ErrorMetric::wrong,
                                          ErrorMetric::mean};
std::string to_string(ErrorMetric metric);  ///< "rmse": the enumerator's own name

/// By metric; a and b are two pixels' three numbers, and opacity is not looked at:
/// - rmse: the root of the mean of (a - b)^2 over all channels of all pixels, in the output's unit.
/// - distance: the root of the mean of |a - b|^2 over all pixels: metres, where the output is a position.
/// - misclassified: the share of pixels, 0..1, of which a channel is off by more than 3/255 once encoded for a screen:
///   the difference that processors of different makers have in a right picture.
/// - flip: the mean of LDR-FLIP (image/flip.hpp), 0..1. Throws Error where `encoding` is data.
/// - degrees: the root of the mean of the squared angles between directions that are coded as n/2 + 1/2.
/// - displacement: how far the picture has moved, in pixels: the median of |a - b| / |gradient of b|, over the pixels
///   round which b is nearly linear. Where colour travels with what is seen, this is the length of the normal flow
///   (B. K. P. Horn and B. G. Schunck: Determining Optical Flow, Artificial Intelligence 17, 1981); the median passes
///   over what has come into sight. 0 where there is no gradient.
/// Of pictures whose red channel says how much of a light is seen, 0 in shadow to 1 lit, all shares of pixels, 0..1:
/// - acne: darker than the truth by more than 1/2: shadow where there is none.
/// - leak: brighter than the truth by more than 1/2: light where there is none.
/// - wrong: nearer to 0 where the truth is nearer to 1, or the reverse (1/2 counts as lit). Where all pixels are 0 or 1
///   this is acne + leak; in a penumbra it is a matter of where the edge lies, however blurred.
/// And of a picture alone:
/// - mean: the mean of all channels of `picture`; `truth` is not looked at.
/// Throws Error where sizes differ, or where a pixel of either is not finite: an error of NaN would say nothing.
double error_of(const Image& picture, const Image& truth, ErrorMetric metric, Encoding encoding = Encoding::linear);

}  // namespace atelier
