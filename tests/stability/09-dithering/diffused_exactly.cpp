// diffused: against errors in double precision, on pictures of 1 pixel to 8192, with 2 to 256 levels.
#include "stability/09-dithering/diffusions.hpp"
#include "stability/09-dithering/rows.hpp"

namespace atelier::stability {

namespace {

/// Roundings in a picture of this size.
Bound roundings_of(int width, int height, int levels) {
  return {8 * rounding_unit * levels * (2 * height + width), "levels above half a step",
          "at each pixel some eight roundings of numbers up to the last level; those of the row so far and twice those "
          "of the rows above may arrive together"};
}

}  // namespace

void add_diffused_exactly_rows(Table& table) {
  Group group = table.of("diffused (in doubles)");
  for (const DiffusionWay& way : diffusion_ways) {
    for (const auto& [width, height] : {std::pair{1, 1}, {2, 1}, {1, 2}, {2, 2}, {3, 3}, {4, 3}, {1, 64}, {64, 1}})
      group.close(fmt::format("{}: 200 pictures of noise, {} x {}, 2 to 256 levels", way.name, width, height),
                  roundings_of(width, height, 256), [=, width = width, height = height] {
                    return worst_of(200, 960, [=](Trial& t) {
                      const Grey picture = noise_picture(width, height, std::uint64_t(t.between(0, 1e9)));
                      const dithering::Diffusion how = way.with(int(t.size_between(2, 257)));
                      return level_missed_by(picture, how, levels_of(picture, how));
                    });
                  });
    for (const int levels : {2, 3, 16, 256}) {
      const auto words = [=](const char* what) { return fmt::format("{}, {} levels: {}", way.name, levels, what); };
      const auto missed_by = [=](const Grey& picture) {
        return level_missed_by(picture, way.with(levels), levels_of(picture, way.with(levels)));
      };
      group.close(words("noise, 64 x 48"), roundings_of(64, 48, levels),
                  [=] { return missed_by(noise_picture(64, 48, 961)); });
      group.close(words("codes on a slope, 64 x 48"), roundings_of(64, 48, levels),
                  [=] { return missed_by(slope_picture(64, 48, 962)); });
      group.close(words("20 flat pictures, 32 x 24"), roundings_of(32, 24, levels), [=] {
        return worst_of(20, 963, [=](Trial& t) { return missed_by(flat_picture(32, 24, float(t.between(0, 1)))); });
      });
      group.close(
          words("flat pictures within 1e-6 of black, white and the half, 32 x 24"), roundings_of(32, 24, levels), [=] {
            double worst = 0;
            for (const float value :
                 {denormal, 1e-30f, 1e-6f, 0.5f - 1e-6f, 0.5f, 0.5f + 1e-6f, 1 - 1e-6f, std::nextafter(1.0f, 0.0f)})
              worst = std::max(worst, missed_by(flat_picture(32, 24, value)));
            return worst;
          });
    }
    for (const auto& [width, height] : {std::pair{1, 8192}, {8192, 1}, {2, 4096}, {4096, 2}})
      group.close(fmt::format("{}, 2 levels: noise, {} x {}", way.name, width, height), roundings_of(width, height, 2),
                  [=, width = width, height = height] {
                    const Grey picture = noise_picture(width, height, 964);
                    return level_missed_by(picture, way.with(2), levels_of(picture, way.with(2)));
                  });
  }
}

}  // namespace atelier::stability
