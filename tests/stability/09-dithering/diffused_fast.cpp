// diffused_fast: the levels of diffused, bit for bit, on pictures of all small sizes and of long sides.
#include "stability/09-dithering/diffusions.hpp"
#include "stability/09-dithering/rows.hpp"

namespace atelier::stability {

using dithering::diffused_fast;

namespace {

/// Pixels of four channels: noise, or slopes with noise.
std::vector<std::uint8_t> random_codes(Trial& t, int width, int height) {
  std::array<double, 4> across{}, noise{};
  for (std::size_t channel = 0; channel < 4; ++channel) {
    noise[channel] = channel == 0 ? 256 : t.between(1, 40);
    across[channel] = t.between(0, 256 - noise[channel]);
  }
  std::vector<std::uint8_t> codes;
  for (int i = 0; i < width * height; ++i)
    for (std::size_t channel = 0; channel < 4; ++channel)
      codes.push_back(std::uint8_t(across[channel] * (i % width) / width + t.between(0, noise[channel])));
  return codes;
}

/// How many levels of the four channels are others than those of `diffused`; infinite if their number is.
double other_than_diffused(const std::vector<std::uint8_t>& codes, int width, int levels) {
  const std::vector<std::uint8_t> fast = diffused_fast(codes, width, levels);
  if (fast.size() != codes.size()) return double(INFINITY);
  double others = 0;
  for (std::size_t channel = 0; channel < 4; ++channel) {
    Grey picture{width, int(codes.size() / 4) / width, {}};
    for (std::size_t i = channel; i < codes.size(); i += 4) picture.values.push_back(float(codes[i]) * (1.0f / 255));
    const std::vector<std::uint8_t> slow = levels_of(picture, {.levels = levels});
    for (std::size_t i = 0; i < slow.size(); ++i) others += fast[4 * i + channel] != slow[i];
  }
  return others;
}

/// How many levels of flat pictures are others, for each code.
double other_of_flat(int width, int height, int levels) {
  double others = 0;
  for (int code = 0; code < 256; ++code)
    others += other_than_diffused(
        std::vector<std::uint8_t>(4 * std::size_t(width) * std::size_t(height), std::uint8_t(code)), width, levels);
  return others;
}

}  // namespace

void add_fast_rows(Table& table) {
  Group group = table.of("diffused_fast");
  const std::vector<std::uint8_t> six(4 * 6, 128);
  for (const int levels : {1, 0, -1, 257, 65536, least_int, largest_int})
    group.refuses(fmt::format("{} levels", levels), [=] { diffused_fast(six, 3, levels); });
  for (const int width : {0, -1, -3, least_int, 4, 5, 7, 12, 24, largest_int})
    group.refuses(fmt::format("6 pixels, a width of {}", width), [=] { diffused_fast(six, width, 2); });
  for (const std::size_t codes : {1, 2, 3, 5, 23})
    group.refuses(fmt::format("{} codes, a width of 1: a pixel without all channels", codes),
                  [=] { diffused_fast(std::vector<std::uint8_t>(codes, 0), 1, 2); });
  group.refuses("no codes, a width of 0", [] { diffused_fast({}, 0, 2); });
  group.refuses("no codes, 1 level", [] { diffused_fast({}, 1, 1); });
  group.equals("no codes", [] { return Values{double(diffused_fast({}, 5, 2).size())}; }, {0});

  for (const int levels : {2, 3, 17, 128, 256})
    group.equals(fmt::format("all sizes of 1..40 x 1..20, {} levels: levels that are not those of diffused", levels),
                 [=] {
                   double others = 0;
                   for (int width = 1; width <= 40; ++width)
                     for (int height = 1; height <= 20; ++height) {
                       Trial t(970, width * 100 + height);
                       others += other_than_diffused(random_codes(t, width, height), width, levels);
                     }
                   return Values{others};
                 },
                 {0});
  group.equals("500 random pictures up to 40 x 20, 2 to 256 levels: levels that are not those of diffused",
               [] {
                 return Values{worst_of(500, 971, [](Trial& t) {
                   const int width = int(t.between(1, 41)), height = int(t.between(1, 21));
                   const int levels = int(t.between(2, 257));
                   return other_than_diffused(random_codes(t, width, height), width, levels);
                 })};
               },
               {0});
  for (const auto& [width, height] : {std::pair{1, 5000}, {5000, 1}, {2, 2500}, {2500, 2}, {1000, 9}, {9, 1000}})
    group.equals(fmt::format("{} x {}, 2 and 16 levels: levels that are not those of diffused", width, height),
                 [width = width, height = height] {
                   Trial t(972, width);
                   const std::vector<std::uint8_t> codes = random_codes(t, width, height);
                   return Values{other_than_diffused(codes, width, 2), other_than_diffused(codes, width, 16)};
                 },
                 {0, 0});
  group.equals("256 flat pictures, 19 x 10, 2, 3 and 256 levels: levels that are not those of diffused",
               [] {
                 return Values{other_of_flat(19, 10, 2), other_of_flat(19, 10, 3), other_of_flat(19, 10, 256)};
               },
               {0, 0, 0});
  group.equals("four channels alike: pixels whose levels differ",
               [] {
                 Trial t(973, 0);
                 std::vector<std::uint8_t> codes = random_codes(t, 50, 30);
                 for (std::size_t i = 0; i < codes.size(); ++i) codes[i] = codes[i / 4 * 4];
                 const std::vector<std::uint8_t> levels = diffused_fast(codes, 50, 4);
                 double differing = 0;
                 for (std::size_t i = 0; i < levels.size(); ++i) differing += levels[i] != levels[i / 4 * 4];
                 return Values{differing};
               },
               {0});
}

}  // namespace atelier::stability
