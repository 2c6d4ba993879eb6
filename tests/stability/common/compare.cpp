// image/compare and image/flip: what the judge makes of pictures that are no pictures.
#include "image/compare.hpp"
#include "image/flip.hpp"
#include "stability/common/rows.hpp"

namespace atelier::stability {

namespace {

Image grey(int width, int height, float value = 0.5f) {
  return Image(width, height, {value, value, value, 1});
}

Image with(Image image, int x, int y, float value) {
  image.at(x, y).g = value;
  return image;
}

const std::pair<const char*, Measure> measures[] = {
    {"levels", Measure::level}, {"degrees", Measure::degrees}, {"numbers", Measure::number}};

void add_compare_rows_of(Group& group, Difference (*compare)(const Image&, const Image&, Measure, double)) {
  group.refuses("pictures of two sizes", [=] { compare(grey(2, 1), grey(1, 2), Measure::level, 1); });
  group.refuses("empty pictures", [=] { compare(Image(), Image(), Measure::level, 1); });
  group.refuses("a delta of NaN", [=] { compare(grey(1, 1), grey(1, 1), Measure::level, double(not_a_number)); });
  group.refuses("a delta of -1", [=] { compare(grey(1, 1), grey(1, 1), Measure::level, -1); });
  for (const auto& [words, measure] : measures) {
    group.equals(fmt::format("1x1, equal, delta 0, {}", words),
                 [=, m = measure] {
                   const Difference d = compare(grey(1, 1), grey(1, 1), m, 0);
                   return Values{double(d.over), double(d.blob), d.worst_distance};
                 },
                 {0, 0, 0});
    group.equals(fmt::format("a NaN against a number is over any delta, {}", words),
                 [=, m = measure] {
                   const Difference d = compare(with(grey(5, 5), 2, 3, not_a_number), grey(5, 5), m, 179);
                   return Values{double(d.over), double(d.worst.x), double(d.worst.y), d.worst_distance};
                 },
                 {1, 2, 3, double(infinite)});
    group.equals(fmt::format("NaN against the same NaN is no agreement, {}", words),
                 [=, m = measure] {
                   const Image broken = with(grey(1, 1), 0, 0, not_a_number);
                   return Values{double(compare(broken, broken, m, 179).over)};
                 },
                 {1});
    group.equals(
        fmt::format("an infinity against a number, {}", words),
        [=, m = measure] { return Values{double(compare(with(grey(3, 1), 1, 0, infinite), grey(3, 1), m, 179).over)}; },
        {1});
  }
  group.equals("a whole picture of NaN, 4x4",
               [=] {
                 const Difference d = compare(grey(4, 4, not_a_number), grey(4, 4), Measure::level, 3);
                 return Values{double(d.over), d.share, double(d.blob)};
               },
               {16, 1, 4});
  group.equals("colours of 1e30 against 1e30",
               [=] { return Values{double(compare(grey(2, 2, 1e30f), grey(2, 2, 1e30f), Measure::number, 0).over)}; },
               {0});
}

void add_other_rows(Table& table) {
  Group shift = table.of("fit_shift");
  shift.equals("1x1", [] { return Values{fit_shift(grey(1, 1), grey(1, 1)).length()}; }, {0});
  shift.equals("two plain pictures", [] { return Values{fit_shift(grey(9, 9, 0.1f), grey(9, 9, 0.9f)).length()}; },
               {0});
  shift.finite("a picture of NaN", [] { return Values{fit_shift(grey(9, 9, not_a_number), grey(9, 9)).length()}; });
  shift.finite("one pixel of 1e30",
               [] { return Values{fit_shift(with(grey(9, 9), 4, 4, 1e30f), grey(9, 9)).length()}; });
  shift.refuses("empty pictures", [] { fit_shift(Image(), Image()); });

  Group single = table.of("is_single_colour");
  single.equals("empty, 1x1, and a NaN among greys",
                [] {
                  return Values{double(is_single_colour(Image())), double(is_single_colour(grey(1, 1))),
                                double(is_single_colour(with(grey(3, 3), 1, 1, not_a_number)))};
                },
                {1, 1, 0});
  Group scan = table.of("find_non_finite");
  scan.equals("none, one NaN, all infinite",
              [] {
                return Values{double(find_non_finite(grey(3, 3)).count),
                              double(find_non_finite(with(grey(3, 3), 2, 2, not_a_number)).count),
                              double(find_non_finite(grey(5, 5, infinite)).count),
                              double(find_non_finite(grey(5, 5, infinite)).first.size())};
              },
              {0, 1, 25, 10});
  scan.equals("the largest float and a denormal are numbers",
              [] { return Values{double(find_non_finite(with(grey(2, 2, largest_float), 0, 0, denormal)).count)}; },
              {0});

  Group flips = table.of("flip");
  flips.equals("1x1, equal", [] { return Values{flip(grey(1, 1), grey(1, 1)).mean}; }, {0});
  flips.close("1x1, black and white",
              {0.05, "absolute", "the two are as far apart as colours can be, up to the filters' constants"},
              [] { return std::abs(flip(grey(1, 1, 0), grey(1, 1, 1)).mean - 1); });
  flips.finite("NaN and infinity", [] {
    const Flip f = flip(with(grey(7, 5), 3, 2, not_a_number), with(grey(7, 5), 3, 2, infinite));
    return Values{f.mean, double(f.map.at(3, 2).r)};
  });
  flips.equals("1xN: every value 0 to 1",
               [] {
                 double wrong = 0;
                 const Flip f = flip(grey(1, 64, 0.2f), with(grey(1, 64, 0.2f), 0, 30, 1));
                 for (const Rgba& p : f.map.pixels()) wrong += !(p.r >= 0 && p.r <= 1);
                 return Values{wrong};
               },
               {0});
  flips.refuses("empty pictures", [] { flip(Image(), Image()); });
}

}  // namespace

void add_compare_rows(Table& table) {
  Group strict = table.of("compare_strict"), robust = table.of("compare_robust");
  add_compare_rows_of(strict, compare_strict);
  add_compare_rows_of(robust, compare_robust);
  add_other_rows(table);
}

}  // namespace atelier::stability
