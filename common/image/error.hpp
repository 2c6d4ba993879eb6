// The error of a picture against its truth as one number, for trade-offs with time and memory. Not used for verdicts
// (image/compare.hpp is), since no single number separates right pictures from wrong ones.
#pragma once

#include <array>
#include <string>

#include "image/colour.hpp"
#include "image/image.hpp"

namespace atelier {

enum class ErrorMetric {
  rmse,
  flip,
  misclassified,
  distance,
  degrees,
  displacement,
  acne,
  leak,
  wrong,
  blurred_codes,
  blurred_light,
  mean
};
inline constexpr std::array error_metrics{
    ErrorMetric::rmse,          ErrorMetric::flip,          ErrorMetric::misclassified, ErrorMetric::distance,
    ErrorMetric::degrees,       ErrorMetric::displacement,  ErrorMetric::acne,          ErrorMetric::leak,
    ErrorMetric::wrong,         ErrorMetric::blurred_codes, ErrorMetric::blurred_light, ErrorMetric::mean};
std::string to_string(ErrorMetric metric);  ///< "rmse": the enumerator's own name

/// By metric; a and b are the three numbers of two pixels; opacity is ignored:
/// - rmse: the root of the mean of (a - b)^2 over all channels of all pixels, in the output's unit.
/// - distance: the root of the mean of |a - b|^2 over all pixels: metres, where the output is a position.
/// - misclassified: the fraction of pixels, 0..1, with a channel that differs by more than 3/255 after sRGB encoding:
///   CPUs of different vendors differ by as much in a right picture.
/// - flip: the mean of LDR-FLIP (image/flip.hpp), 0..1. Throws Error if `encoding` is data.
/// - degrees: the root of the mean of the squared angles between directions that are coded as n/2 + 1/2.
/// - displacement: how far the picture has moved, in pixels: the median of |a - b| / |gradient of b|, over the pixels
///   around which b is nearly linear. If colours move with the surfaces, this is the length of the normal flow (B. K.
///   P. Horn and B. G. Schunck: Determining Optical Flow, Artificial Intelligence 17, 1981); the median ignores what
///   has become visible. 0 if there is no gradient.
/// - blurred_light: rmse of both pictures after a Gaussian blur of 2 pixels, as an eye sees them that is too far away for
///   single pixels. The blur of a border pixel is that of the pixels inside. For linear colours; others as they are.
/// - blurred_codes: the same of sRGB-encoded colours, 0..1. Throws Error if `encoding` is data.
/// For pictures whose red channel is the visible fraction of a light, 0 in shadow to 1 lit; all are fractions of
/// pixels, 0..1:
/// - acne: darker than the truth by more than 1/2: a false shadow.
/// - leak: brighter than the truth by more than 1/2: a missing shadow.
/// - wrong: nearer to 0 though the truth is nearer to 1, or the reverse (1/2 counts as lit). If all pixels are 0 or 1
///   this is acne + leak; in a penumbra it measures where the edge lies, however blurred.
/// For one picture alone:
/// - mean: the mean of all channels of `picture`; `truth` is ignored.
/// Throws Error if sizes differ or a pixel of either is not finite.
double error_of(const Image& picture, const Image& truth, ErrorMetric metric, Encoding encoding = Encoding::linear);

}  // namespace atelier
