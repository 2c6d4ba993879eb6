// Expectations from theory against measurements.
#include "measure/expect.hpp"

#include "catch.hpp"
#include "results.hpp"

namespace atelier::measure {
namespace {

using Kind = Expectation::Kind;

SweepResult expecting(Expectation e) {
  SweepResult result = sample_sweep();
  e.reason = "because";
  result.plan.expect = {std::move(e)};
  return result;
}

}  // namespace

TEST_CASE("an expectation reports whether and by how much it is met") {
  struct Row {
    const char* name;
    Expectation expectation;
    bool met;
    std::initializer_list<std::string_view> words;
  };
  const Row rows[] = {
      {"the slope", {.curve = "fine", .number = -2, .tolerance = 0.01}, true, {"wall, kind fine", "slope -2.000"}},
      {"another slope", {.curve = "fine", .number = -1, .tolerance = 0.2}, false, {"slope -2.000", "expected -1"}},
      {"no slope in what is flat", {.curve = "coarse", .number = 0, .tolerance = 0.2}, false, {"too few points"}},
      {"a slope within a range",
       {.curve = "fine", .number = -2, .tolerance = 0.01, .range = glm::dvec2(4, 32)},
       true,
       {"from 4 to 32"}},
      {"an order", {.kind = Kind::order, .curve = "fine", .values = {"256", "16", "2"}}, true, {"256 6.1e-05"}},
      {"equal ones are in order", {.kind = Kind::order, .curve = "coarse", .values = {"2", "256"}}, true, {}},
      {"the other way", {.kind = Kind::order, .curve = "fine", .values = {"2", "16"}}, false, {"not to fall"}},
      {"not above", {.kind = Kind::at_most, .curve = "fine", .number = 1}, true, {"at most 1 (at 2)"}},
      {"above", {.kind = Kind::at_most, .curve = "fine", .number = 0.9}, false, {"at most 1 (at 2)"}},
      {"a value", {.kind = Kind::at, .curve = "fine", .number = 0.25, .values = {"4"}}, true, {"0.25 at 4"}},
      {"another value",
       {.kind = Kind::at, .curve = "fine", .number = 0.3, .tolerance = 0.04, .values = {"4"}},
       false,
       {"0.25 at 4", "0.3 +- 0.04"}},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    const auto found = findings(expecting(row.expectation));
    REQUIRE(found.size() == 1);
    INFO(found[0].words);
    CHECK(found[0].met == row.met);
    CHECK(found[0].reason == "because");
    CHECK(test::mentions(found[0].words, row.words));
  }
}

TEST_CASE("an expectation without a curve applies to every curve") {
  const auto found = findings(expecting({.kind = Kind::at_most, .number = 0.6}));
  REQUIRE(found.size() == 2);
  CHECK_FALSE(found[0].met);
  CHECK(found[1].met);
}

TEST_CASE("a count has no noise floor, so its slope includes the smallest ones") {
  SweepResult result = expecting({.curve = "fine", .number = 1, .tolerance = 0.001});
  result.plan.count = "triangles";
  for (Point& point : result.points) point.error = point.cost.counts.at("triangles");
  const auto found = findings(result);
  REQUIRE(found.size() == 1);
  INFO(found[0].words);
  CHECK(found[0].met);
  CHECK(test::mentions(found[0].words, {"from 2 to 256"}));
  REQUIRE(fit_of(result, "fine"));
  CHECK(fit_of(result, "fine")->points == 8);
}

TEST_CASE("an error that is NaN meets no expectation") {
  for (const Expectation& e : {Expectation{.curve = "fine", .number = -2, .tolerance = 10},
                               Expectation{.kind = Kind::at, .curve = "fine", .tolerance = 10, .values = {"4"}},
                               Expectation{.kind = Kind::order, .curve = "fine", .values = {"4", "2"}}}) {
    SweepResult result = expecting(e);
    for (Point& point : result.points) point.error = std::nan("");
    CHECK_FALSE(findings(result)[0].met);
  }
}

}  // namespace atelier::measure
