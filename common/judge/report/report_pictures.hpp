// The pictures of a report, made from a result's evidence.
#pragma once

#include <string>
#include <vector>

#include "judge/compare/result.hpp"

namespace atelier::judge {

/// A picture ready for display, with its texts.
struct ReportPicture {
  std::string role;   ///< "yours", "reference", "difference", "flip", "mask", "signed", "mistake", "detail"
  std::string title;  ///< the caption
  std::string alt;    ///< the text alternative, for readers who cannot see it
  Image pixels;       ///< encoded, finite, 0..1, opaque; at most `report_side` a side
};

inline constexpr int report_side = 768;  ///< pixels; larger pictures are shrunk for reports
inline constexpr int detail_side = 24;   ///< pixels around the worst one, before enlarging
inline constexpr int detail_zoom = 8;

/// Whether a result has evidence that report_pictures can show.
bool has_pictures(const CaseResult& result);

/// For a failure: yours, reference, difference; FLIP error, mask of failing pixels, signed difference; the mistake's
/// picture; yours and the reference enlarged around the worst pixel, which a frame marks. Missing evidence is left out.
/// For a pass: only yours and the reference. Empty without evidence.
std::vector<ReportPicture> report_pictures(const CaseResult& result);

/// Pictures mapped for display. If the reference exceeds 0..1 (with depths in metres, for example), its range is mapped
/// to 0..1 in both pictures. NaN and infinity become magenta, which no scene of the course uses.
struct Displayed {
  Image yours, reference;
  float low = 0, high = 1;  ///< the values shown as 0 and as 1
};
Displayed displayed(const Image& yours, const Image& reference);

/// A heat map of each pixel's largest difference in red, green and blue, from black (none) to pale yellow (the largest
/// in the picture, at least 1/255). `largest` receives that largest difference. Both pictures must have the same size.
Image difference_picture(const Image& yours, const Image& reference, float& largest);

}  // namespace atelier::judge
