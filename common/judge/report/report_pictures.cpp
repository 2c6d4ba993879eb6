#include "judge/report/report_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "image/draw.hpp"

namespace atelier::judge {
namespace {

constexpr Rgba magenta{1, 0, 1, 1};

bool finite(const Rgba& c) {
  return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b);
}

/// `image` with `low`..`high` mapped to 0..1, opaque; pixels that are not finite are magenta.
Image shown_between(Image image, float low, float high) {
  const float scale = 1 / (high - low);
  const auto mapped = [&](float v) { return std::clamp((v - low) * scale, 0.0f, 1.0f); };
  for (Rgba& c : image.pixels()) c = finite(c) ? Rgba{mapped(c.r), mapped(c.g), mapped(c.b), 1} : magenta;
  return image;
}

Mask to_mask(const Image& over) {
  Mask mask(over.width(), over.height());
  for (int y = 0; y < over.height(); ++y) {
    for (int x = 0; x < over.width(); ++x) mask.set(x, y, over.at(x, y).r > 0.5f);
  }
  return mask;
}

/// The area around the worst pixel, enlarged, with a black and white frame around that pixel.
Image detail(const Image& image, const Worst& worst) {
  const Box box = box_around(image, {worst.x, worst.y}, detail_side, detail_side);
  Image enlarged = enlarge(crop(image, box), detail_zoom);
  const int left = (worst.x - box.x) * detail_zoom, top = (worst.y - box.y) * detail_zoom;
  const auto frame = [&](int distance, Rgba colour) {
    const int low = -distance, high = detail_zoom - 1 + distance;
    for (int y = low; y <= high; ++y) {
      for (int x = low; x <= high; ++x) {
        const bool on_frame = x == low || x == high || y == low || y == high;
        const int px = left + x, py = top + y;
        const bool inside = px >= 0 && py >= 0 && px < enlarged.width() && py < enlarged.height();
        if (on_frame && inside) enlarged.at(px, py) = colour;
      }
    }
  };
  frame(1, {1, 1, 1, 1});
  frame(2, {0, 0, 0, 1});
  return enlarged;
}

/// The atlas stores the mistake's picture at a smaller size: enlarges it by a whole factor to about the reference's
/// size.
Image enlarged_to(const Image& mistake, const Image& reference) {
  const int factor = std::max(1, reference.width() / mistake.width());
  return factor == 1 ? mistake : enlarge(mistake, factor);
}

bool covers(const Image& image, const Worst& worst) {
  return worst.x >= 0 && worst.y >= 0 && worst.x < image.width() && worst.y < image.height();
}

void add_errors(const CaseResult& result, const Displayed& shown, std::vector<ReportPicture>& pictures) {
  const Evidence& evidence = *result.evidence;
  float largest = 0;
  Image difference = difference_picture(shown.yours, shown.reference, largest);
  pictures.push_back({"difference", fmt::format("Difference (brightest {:.0f}/255)", largest * 255),
                      fmt::format("Heat map of the difference for {}, up to {:.0f}/255", result.title, largest * 255),
                      std::move(difference)});
  if (!evidence.flip.empty()) {
    pictures.push_back(
        {"flip", "FLIP: the visible error", "FLIP error map for " + result.title, heat_map(evidence.flip)});
  }
  if (evidence.over.same_size(shown.reference)) {
    const Mask mask = to_mask(evidence.over);
    pictures.push_back({"mask", fmt::format("Over tolerance: {} pixels", mask.count()),
                        fmt::format("{} failing pixels marked on the reference for {}", mask.count(), result.title),
                        overlay(shown.reference, mask)});
  }
  pictures.push_back({"signed", "Signed difference \u00d716",
                      "Yours minus reference, 16 times, around grey, for " + result.title,
                      signed_difference(shown.yours, shown.reference, 16)});
}

void add_mistake(const CaseResult& result, const Displayed& shown, std::vector<ReportPicture>& pictures) {
  const auto& mistake = result.evidence->mistake;
  if (!mistake || mistake->empty()) return;
  pictures.push_back({"mistake", "The mistake it looks like",
                      "The picture of the known mistake " + result.mistake.value_or("") + " for " + result.title,
                      enlarged_to(shown_between(*mistake, shown.low, shown.high), shown.reference)});
}

void add_details(const CaseResult& result, const Displayed& shown, std::vector<ReportPicture>& pictures) {
  if (!result.worst || !covers(shown.reference, *result.worst)) return;
  const std::string place = fmt::format("around ({}, {}), \u00d7{}", result.worst->x, result.worst->y, detail_zoom);
  pictures.push_back({"detail", "Yours " + place, "Yours " + place, detail(shown.yours, *result.worst)});
  pictures.push_back(
      {"detail", "Reference " + place, "The reference " + place, detail(shown.reference, *result.worst)});
}

std::string range_note(const Displayed& shown) {
  if (shown.low == 0 && shown.high == 1) return {};
  return fmt::format(" ({:.4g} is black, {:.4g} is white)", shown.low, shown.high);
}

}  // namespace

Displayed displayed(const Image& yours, const Image& reference) {
  float low = 0, high = 1;
  for (const Rgba& c : reference.pixels()) {
    if (!finite(c)) continue;
    low = std::min({low, c.r, c.g, c.b});
    high = std::max({high, c.r, c.g, c.b});
  }
  return {shown_between(yours, low, high), shown_between(reference, low, high), low, high};
}

Image difference_picture(const Image& yours, const Image& reference, float& largest) {
  Image errors(reference.width(), reference.height());
  largest = 1.0f / 255;  // a smaller difference is invisible
  for (std::size_t i = 0; i < errors.pixels().size(); ++i) {
    const Rgba a = yours.pixels()[i], b = reference.pixels()[i];
    const float error = std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
    errors.pixels()[i] = {error, error, error, 1};
    largest = std::max(largest, error);
  }
  return heat_map(errors, largest);
}

bool has_pictures(const CaseResult& result) {
  return result.evidence && !result.evidence->yours.empty() && !result.evidence->reference.empty();
}

std::vector<ReportPicture> report_pictures(const CaseResult& result) {
  std::vector<ReportPicture> pictures;
  if (!has_pictures(result)) return pictures;
  const Displayed shown = displayed(result.evidence->yours, result.evidence->reference);
  pictures.push_back({"yours", "Yours", "Your picture for " + result.title, shown.yours});
  pictures.push_back(
      {"reference", "Reference" + range_note(shown), "The reference for " + result.title, shown.reference});
  if (result.status != Status::passed) {
    const bool same_size = shown.yours.same_size(shown.reference);
    if (same_size) add_errors(result, shown, pictures);
    add_mistake(result, shown, pictures);
    if (same_size) add_details(result, shown, pictures);
  }
  for (ReportPicture& picture : pictures) picture.pixels = shrink_to(picture.pixels, report_side);
  return pictures;
}

}  // namespace atelier::judge
