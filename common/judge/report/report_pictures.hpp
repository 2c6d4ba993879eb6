// The pictures that explain a verdict, made from its evidence.
#pragma once

#include <string>
#include <vector>

#include "judge/compare/result.hpp"

namespace atelier::judge {

/// A picture ready for the screen, with its words.
struct ReportPicture {
  std::string role;   ///< "reference", "yours", "difference", "flip", "mask", "signed", "detail", "mistake"
  std::string title;  ///< a few words above or below it
  std::string alt;    ///< what a reader who cannot see it must know
  Image pixels;       ///< encoded, finite, 0..1, opaque; at most `report_side` a side
};

inline constexpr int report_side = 768;  ///< pixels; larger pictures are shrunk for reports
inline constexpr int detail_side = 24;   ///< pixels of the picture around the worst one, before they are enlarged
inline constexpr int detail_zoom = 8;

/// For a failure: reference, yours, difference; FLIP error, mask of failing pixels, signed difference; both details
/// around the worst pixel, which a frame marks; the mistake's picture. What the evidence does not have is left out. For
/// a pass: reference and yours alone. Empty without evidence.
std::vector<ReportPicture> report_pictures(const CaseResult& result);

/// Pictures as a screen can show them. Where the reference leaves 0..1 (depths in metres, say) its range becomes 0..1,
/// for both pictures alike. A NaN or infinity becomes magenta, the colour that no scene of the course uses.
struct Displayed {
  Image yours, reference;
  float low = 0, high = 1;  ///< what is shown as 0 and as 1
};
Displayed displayed(const Image& yours, const Image& reference);

/// The largest difference over red, green and blue of each pixel, as heat colours from black (none) to pale yellow (the
/// largest in the picture, at least 1/255), which `largest` receives. Both of one size.
Image difference_picture(const Image& yours, const Image& reference, float& largest);

}  // namespace atelier::judge
