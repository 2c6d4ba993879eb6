// The exponent of an error's power law, and the range of the fit.
#include "measure/fit.hpp"

#include <cmath>
#include <vector>

#include "catch.hpp"

namespace atelier::measure {
namespace {

using Points = std::vector<glm::dvec2>;

/// x = 1, 2, 4 ... 2^(count - 1), and what `of` gives for each.
template <class Function>
Points doubling(int count, Function of) {
  Points points;
  for (int i = 0; i < count; ++i) points.emplace_back(std::pow(2, i), of(std::pow(2, i)));
  return points;
}

}  // namespace

TEST_CASE("a pure power law is fitted exactly") {
  struct Row {
    const char* name;
    double slope, factor;
  };
  for (const Row& row :
       {Row{"falls with the square", -2, 3}, {"rises in proportion", 1, 1e-7}, {"flat", 0, 0.5}, {"a root", 0.5, 40}}) {
    INFO(row.name);
    const auto fit = fit_power(doubling(10, [&](double x) { return row.factor * std::pow(x, row.slope); }));
    REQUIRE(fit);
    // A dozen roundings of doubles in sums of ten terms.
    CHECK(fit->slope == Approx(row.slope).margin(1e-12));
    CHECK(fit->factor == Approx(row.factor).epsilon(1e-12));
    CHECK(fit->at(7) == Approx(row.factor * std::pow(7, row.slope)).epsilon(1e-12));
    CHECK(fit->deviation < 1e-12);
    CHECK(fit->points == 10);
    CHECK(fit->from == 1);
    CHECK(fit->to == 512);
  }
}

TEST_CASE("least squares on logarithms, by hand") {
  // (1, 1), (10, 100), (100, 100): the slope through (0, 0), (1, 2), (2, 2) is 1, the mean (1, 4/3).
  const auto fit = fit_power(Points{{1, 1}, {10, 100}, {100, 100}});
  REQUIRE(fit);
  CHECK(fit->slope == Approx(1));
  CHECK(std::log10(fit->factor) == Approx(1.0 / 3));
  CHECK(fit->deviation == Approx(std::sqrt((1.0 / 9 + 4.0 / 9 + 1.0 / 9) / 3)));
}

TEST_CASE("points at the noise floor do not affect the slope") {
  // x^-2 down to a floor of 1e-4, added as squares are: from x = 100 on there is only the floor.
  const Points points = doubling(14, [](double x) { return std::hypot(1 / (x * x), 1e-4); });
  const double floor = noise_floor(points);
  CHECK(floor == Approx(1e-4).epsilon(1e-3));
  const auto bent = fit_power(points), straight = fit_power(points, floor);
  REQUIRE(bent);
  REQUIRE(straight);
  CHECK(std::abs(bent->slope + 2) > 0.4);
  // The last point kept is above three floors: at most 5 % off the power, over six doublings.
  CHECK(std::abs(straight->slope + 2) < 0.02);
  CHECK(straight->to < 64);
}

TEST_CASE("a range includes its ends") {
  const auto fit = fit_power(doubling(10, [](double x) { return x; }), 0, glm::dvec2(4, 64));
  REQUIRE(fit);
  CHECK(fit->points == 5);
  CHECK(fit->from == 4);
  CHECK(fit->to == 64);
}

TEST_CASE("too few points give no line") {
  CHECK_FALSE(fit_power(Points{}));
  CHECK_FALSE(fit_power(Points{{1, 1}, {2, 2}}));
  CHECK_FALSE(fit_power(Points{{3, 1}, {3, 2}, {3, 4}}));
  CHECK_FALSE(fit_power(Points{{1, 0}, {2, 0}, {3, 5}, {0, 1}, {-1, 1}}));
  CHECK(noise_floor(Points{}) == 0);
  CHECK(noise_floor(Points{{1, 0}, {2, 0}}) == 0);
  CHECK(noise_floor(Points{{1, 0}, {2, 5}, {3, 4}}) == 4);
}

}  // namespace atelier::measure
