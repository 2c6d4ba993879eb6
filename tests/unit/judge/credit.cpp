#include "judge/compare/credit.hpp"

#include <cmath>

#include "catch.hpp"

namespace atelier::judge::test {
namespace {

TEST_CASE("partial credit: from the failing fraction, within its caps") {
  // f0 = 0.001; f1 = 0.25, so that the denominator is log10(251) = 2.3997.
  struct Row {
    const char* name;
    PictureFailure failure;
    double fraction;
  };
  const Row rows[]{
      {"as much as may fail", {0.001, 0.001, 1, false, false}, 1 - std::log10(2.0) / std::log10(251.0)},
      {"ten times that", {0.01, 0.001, 1, false, false}, 1 - std::log10(11.0) / std::log10(251.0)},
      {"an eighth of the picture", {0.125, 0.001, 1, false, false}, 1 - std::log10(126.0) / std::log10(251.0)},
      {"a quarter", {0.25, 0.001, 1, false, false}, 0},
      {"all of it", {1, 0.001, 1, false, false}, 0},
      {"as much as the skeleton", {0.1, 0.001, 0.1, false, false}, 0},
      {"half of what the skeleton fails", {0.05, 0.001, 0.1, false, false}, 1 - std::log10(51.0) / std::log10(101.0)},
      {"where the skeleton fails nothing", {0.01, 0.001, 0, false, false}, 0},
      {"capped for a solid area", {0.001, 0.001, 1, true, false}, max_credit_with_blob},
      {"below that cap already", {0.1, 0.001, 1, true, false}, 1 - std::log10(101.0) / std::log10(251.0)},
      {"capped for a whole-picture operation", {0.001, 0.001, 1, true, true}, max_credit_whole_picture},
      {"no budget counts as one pixel of 256x256",
       {1 / 65536.0, 0, 1, false, false},
       1 - std::log10(2.0) / std::log10(1 + 0.25 * 65536)},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    const Credit credit = partial_credit(row.failure);
    CHECK(credit.fraction == Approx(row.fraction).margin(1e-12));  // rounding of the logarithms alone
    CHECK(credit.explanation.empty() == (row.fraction == 0));
  }
}

TEST_CASE("partial credit: more failing pixels never earn more") {
  double last = 1;
  for (double share = 1e-6; share < 1; share *= 1.1) {
    const double fraction = partial_credit({share, 1e-4, 0.8, false, false}).fraction;
    CHECK(fraction <= last);
    CHECK(fraction >= 0);
    last = fraction;
  }
}

TEST_CASE("partial credit is explained") {
  const std::string blob = partial_credit({0.001, 0.001, 1, true, false}).explanation;
  CHECK(atelier::test::mentions(blob, {"0.1 %", "at most 70 %", "solid area"}));
  const std::string whole = partial_credit({0.001, 0.001, 0.1, false, true}).explanation;
  CHECK(atelier::test::mentions(whole, {"skeleton", "at most 40 %", "whole picture"}));
}

TEST_CASE("probes: credit only beyond the skeleton's answers") {
  CHECK(partial_probe_credit(5, 10, 1).fraction == Approx(0.5));
  CHECK(partial_probe_credit(1, 10, 1).fraction == Approx(max_credit_with_blob));  // 0.9, capped
  CHECK(partial_probe_credit(10, 10, 1).fraction == 0);
  CHECK(partial_probe_credit(5, 10, 0.5).fraction == 0);  // the skeleton gets that far
  CHECK(partial_probe_credit(3, 12, 0.5).fraction == Approx(0.5));
  CHECK(partial_probe_credit(1, 10, 0).fraction == 0);
}

}  // namespace
}  // namespace atelier::judge::test
