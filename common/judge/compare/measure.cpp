#include "judge/compare/measure.hpp"

#include <algorithm>
#include <cmath>

namespace atelier::judge {
namespace {

template <class Channel>
Image per_channel(Image image, Channel channel) {
  for (Rgba& p : image.pixels()) p = {channel(p.r), channel(p.g), channel(p.b), p.a};
  return image;
}

/// Replaces masked pixels by the reference's, so that they do not differ.
Image with_mask(Image yours, const Image& reference, const std::vector<Rectangle>& mask) {
  const Mask masked = mask_of(mask, {reference.width(), reference.height()});
  for (int y = 0; y < reference.height(); ++y)
    for (int x = 0; x < reference.width(); ++x)
      if (masked.at(x, y)) yours.at(x, y) = reference.at(x, y);
  return yours;
}

Measurement measure_all(const Image& yours, const Image& reference, const JudgedCase& c, double slack) {
  Measurement measured;
  measured.pixels = int(reference.pixels().size());
  const double delta = c.profile == Profile::exact ? 0 : c.delta * slack;
  measured.difference = c.profile == Profile::robust ? compare_robust(yours, reference, measure_of(c.unit), delta)
                                                     : compare_strict(yours, reference, measure_of(c.unit), delta);
  const Difference& found = measured.difference;
  const bool plain = c.mask.empty() && c.regions.empty();
  measured.failing_fraction = plain ? found.share : weighted_fraction(found.mask, c.mask, c.regions);
  if (c.profile == Profile::exact) {
    measured.passed = found.over == 0;
    return measured;
  }
  measured.shift = fit_shift(yours, reference);
  const bool robust = c.profile == Profile::robust;
  measured.shifted = measured.shift.length() >= slack * (robust ? max_shift_robust : max_shift_strict);
  const bool few = robust || found.over <= slack * effective_budget(c, measured.pixels);
  measured.passed = few && found.blob == 0 && !measured.shifted;
  return measured;
}

}  // namespace

Image compared_form(const Image& raw, const JudgedCase& c) {
  if (!is_colour(c.unit)) return raw;
  Image form = c.unit == Unit::colour ? encode_for_comparison(raw, float(c.exposure))
                                      : per_channel(raw, [](float v) { return std::clamp(v, 0.0f, 1.0f); });
  if (c.profile != Profile::exact) return form;
  return per_channel(std::move(form), [](float v) { return std::round(v * 255.0f) / 255.0f; });
}

Encoding encoding_of(Unit unit) {
  return unit == Unit::colour ? Encoding::linear : unit == Unit::encoded ? Encoding::srgb : Encoding::data;
}

bool is_colour(Unit unit) {
  return unit == Unit::colour || unit == Unit::encoded;
}

Measure measure_of(Unit unit) {
  switch (unit) {
    case Unit::colour:
    case Unit::encoded:
      return Measure::level;
    case Unit::degrees:
      return Measure::degrees;
    case Unit::number:
      return Measure::number;
  }
  return Measure::number;
}

int effective_budget(const JudgedCase& c, int pixels) {
  return pixels < 32 * 32 ? std::min(c.budget, pixels / 256) : c.budget;
}

Measurement measure(const Image& yours, const Image& reference, const JudgedCase& c, double slack) {
  if (c.mask.empty()) return measure_all(yours, reference, c, slack);
  return measure_all(with_mask(yours, reference, c.mask), reference, c, slack);
}

Worst worst_pixel(const Measurement& measured, const Image& yours, const Image& reference, Unit unit) {
  const Position at = measured.difference.worst;
  const float scale = is_colour(unit) ? 255.0f : 1.0f;
  const auto scaled = [&](const Rgba& p) { return Rgba{p.r * scale, p.g * scale, p.b * scale, p.a}; };
  return {at.x, at.y, scaled(yours.at(at.x, at.y)), scaled(reference.at(at.x, at.y))};
}

double margin(const Image& yours, const Image& reference, const JudgedCase& c) {
  const auto fails = [&](double slack) { return !measure(yours, reference, c, slack).passed; };
  // FailingPicture at some slack implies failing at every smaller one: bracket the limit by doubling, then bisect.
  double low = 0.01;
  if (!fails(low)) return 0;
  double high = 2 * low;
  while (fails(high)) {
    low = high;
    high *= 2;
    if (low >= max_margin) return max_margin;
  }
  while (high > 1.01 * low) {
    const double middle = std::sqrt(low * high);
    (fails(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace atelier::judge
