// diffused: pictures of one pixel, row or column, values that are none or far outside of 0..1, flat pictures, 256
// levels, and what the contract refuses.
#include "stability/09-dithering/diffusions.hpp"
#include "stability/09-dithering/rows.hpp"

namespace atelier::stability {

using dithering::diffused;
using dithering::Diffusion;
using dithering::Kernel;

namespace {

/// Values that count as others.
struct Counted {
  float value, as;
};
constexpr std::array<Counted, 13> counted_values = {{{not_a_number, 0},
                                                     {-not_a_number, 0},
                                                     {infinite, 1},
                                                     {-infinite, 0},
                                                     {largest_float, 1},
                                                     {-largest_float, 0},
                                                     {1e30f, 1},
                                                     {-1e30f, 0},
                                                     {1 + 0x1p-23f, 1},
                                                     {2, 1},
                                                     {-1, 0},
                                                     {-denormal, 0},
                                                     {-0.0f, 0}}};

/// A picture of which every third value is one of these, or what it counts as.
Grey picture_with(float Counted::*which) {
  Grey picture = noise_picture(29, 17, 950);
  for (std::size_t i = 0; i < picture.values.size(); i += 3)
    picture.values[i] = counted_values[i / 3 % counted_values.size()].*which;
  return picture;
}

/// How far the sum of all levels is from that of all values: in levels.
double sum_missed_by(const Grey& picture, const Diffusion& how) {
  double sum = 0;
  for (const float value : picture.values) sum += double(value) * (how.levels - 1);
  for (const double level : level_numbers(picture, how)) sum -= level;
  return std::abs(sum);
}

/// How many pixels have another level than the one that their value stands for. Values stand for a code of 8 bits.
double other_than_codes(const Grey& picture, const Diffusion& how) {
  const Values levels = level_numbers(picture, how);
  double others = 0;
  for (std::size_t i = 0; i < levels.size(); ++i) others += levels[i] != std::round(255 * double(picture.values[i]));
  return others;
}

/// How many of the flat pictures of 9 x 8 that have the value of a level are changed.
double changed_flat(const DiffusionWay& way, int levels) {
  double changed = 0;
  for (int level = 0; level < levels; ++level) {
    const Grey picture = flat_picture(9, 8, float(level) / float(levels - 1));
    const Values found = level_numbers(picture, way.with(levels));
    changed += found != Values(picture.values.size(), double(level));
  }
  return changed;
}

/// Levels without the first row.
Values without_first_row(Values levels, int width) {
  levels.erase(levels.begin(), levels.begin() + width);
  return levels;
}

Values mirrored_numbers(Values levels, int width) {
  for (auto row = levels.begin(); row != levels.end(); row += width) std::reverse(row, row + width);
  return levels;
}

void add_refusal_rows(Group& group) {
  const std::vector<float> six(6, 0.5f);
  for (const int levels : {1, 0, -1, -2, 257, 65536, least_int, largest_int})
    group.refuses(fmt::format("{} levels", levels), [=] { diffused(six, 3, {.levels = levels}); });
  for (const int width : {0, -1, -3, least_int, 4, 5, 7, largest_int})
    group.refuses(fmt::format("6 values, a width of {}", width), [=] { diffused(six, width, {}); });
  group.refuses("1 level, Atkinson, serpentine", [=] { diffused(six, 3, {1, Kernel::atkinson, true}); });
  group.refuses("no values, a width of 0", [] { diffused({}, 0, {}); });
  group.refuses("no values, 1 level", [] { diffused({}, 1, {.levels = 1}); });
}

void add_sum_rows(Group& group) {
  const Bound bound{
      1, "levels",
      "the last pixel's error alone is lost: half a level, or what it has received beyond black or white, which "
      "is 1, 5/8 and 1/16 of errors of about half a level"};
  for (const auto& [width, height] : {std::pair{1, 1}, {2, 1}, {1, 2}, {64, 1}, {1, 64}, {33, 7}, {40, 40}})
    for (const bool serpentine : {false, true}) {
      const auto how = [=](int levels) { return Diffusion{levels, Kernel::floyd_steinberg, serpentine}; };
      const auto words = [=, width = width, height = height](const char* what) {
        return fmt::format("{} of {} x {}{}: the sum of all values", what, width, height,
                           serpentine ? ", serpentine" : "");
      };
      group.close(words("200 flat pictures"), bound, [=, width = width, height = height] {
        return worst_of(200, 951, [=](Trial& t) {
          const float value = float(t.between(0, 1));
          return sum_missed_by(flat_picture(width, height, value), how(int(t.size_between(2, 257))));
        });
      });
      group.close(words("50 pictures of noise"), bound, [=, width = width, height = height] {
        return worst_of(50, 952, [=](Trial& t) {
          const auto seed = std::uint64_t(t.between(0, 1e9));
          return sum_missed_by(noise_picture(width, height, seed), how(int(t.size_between(2, 257))));
        });
      });
    }
}

}  // namespace

void add_diffused_rows(Table& table) {
  Group group = table.of("diffused");
  add_refusal_rows(group);
  group.equals("twice 0.3 in a row", [] { return level_numbers({2, 1, {0.3f, 0.3f}}, {}); }, {0, 1});
  for (const int levels : {2, 256})
    for (const DiffusionWay& way : diffusion_ways) {
      const auto words = [=](const std::string& what) {
        return fmt::format("{}, {} levels: {}", way.name, levels, what);
      };
      const Diffusion how = way.with(levels);
      const double last = levels - 1;
      group.equals(words("no values"), [=] { return level_numbers({7, 0, {}}, how); }, {});
      for (const Counted& counted : counted_values)
        group.equals(words(fmt::format("one pixel of {:.9g}", counted.value)),
                     [=] {
                       return level_numbers({1, 1, {counted.value}}, how);
                     },
                     {last * double(counted.as)});
      group.same(
          words("every third value none, infinite or outside of 0..1: as with the values that these count as"),
          [=] { return level_numbers(picture_with(&Counted::value), how); },
          [=] { return level_numbers(picture_with(&Counted::as), how); });
    }
  for (const DiffusionWay& way : diffusion_ways) {
    const auto words = [=](const char* what) { return fmt::format("{}: {}", way.name, what); };
    group.equals(words("flat pictures of each level of 2, 3, 5, 17, 100 and 256, of which some are changed"),
                 [=] {
                   Values changed;
                   for (const int levels : {2, 3, 5, 17, 100, 256}) changed.push_back(changed_flat(way, levels));
                   return changed;
                 },
                 {0, 0, 0, 0, 0, 0});
    group.equals(words("256 levels, codes of 8 bits, 64 x 64: pixels that change"),
                 [=] { return Values{other_than_codes(slope_picture(64, 64, 953), way.with(256))}; }, {0});
    group.equals(words("256 levels, all codes of 8 bits in a row, and in a column: pixels that change"),
                 [=] {
                   Grey row{256, 1, {}};
                   for (int code = 0; code < 256; ++code) row.values.push_back(float(code) * (1.0f / 255));
                   const Grey column{1, 256, row.values};
                   return Values{other_than_codes(row, way.with(256)), other_than_codes(column, way.with(256))};
                 },
                 {0, 0});
    group.same(
        words("the lower half of a picture changes: the upper half"),
        [=] {
          Grey changed = noise_picture(31, 24, 954);
          std::fill(changed.values.begin() + 12 * 31, changed.values.end(), 0.7f);
          Values levels = level_numbers(changed, way.with(4));
          levels.resize(12 * 31);
          return levels;
        },
        [=] {
          Values levels = level_numbers(noise_picture(31, 24, 954), way.with(4));
          levels.resize(12 * 31);
          return levels;
        });
  }
  for (const Kernel kernel : {Kernel::floyd_steinberg, Kernel::atkinson}) {
    const auto words = [=](const std::string& what) {
      return fmt::format("{}: {}", kernel == Kernel::atkinson ? "Atkinson" : "Floyd and Steinberg", what);
    };
    for (const int levels : {2, 5}) {
      group.same(
          words(fmt::format("one row of 200, {} levels: serpentine as without", levels)),
          [=] {
            return level_numbers(noise_picture(200, 1, 955), {levels, kernel, true});
          },
          [=] {
            return level_numbers(noise_picture(200, 1, 955), {levels, kernel, false});
          });
      // A row of 0 has no errors, and the rows after it run the other way.
      group.same(
          words(fmt::format("serpentine, {} levels, after a row of 0: the mirrored picture mirrored", levels)),
          [=] {
            Grey picture = noise_picture(37, 20, 956);
            picture.values.insert(picture.values.begin(), 37, 0.0f);
            ++picture.height;
            return without_first_row(level_numbers(picture, {levels, kernel, true}), 37);
          },
          [=] {
            const Grey picture = mirrored(noise_picture(37, 20, 956));
            return mirrored_numbers(level_numbers(picture, {levels, kernel, true}), 37);
          });
    }
  }
  add_sum_rows(group);
}

}  // namespace atelier::stability
