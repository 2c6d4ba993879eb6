#include "case/output.hpp"

#include "catch.hpp"

using namespace atelier;

TEST_CASE("stages are read by the names that are written") {
  for (const Stage stage :
       {Stage::surface, Stage::light, Stage::pass, Stage::colour, Stage::after_colour, Stage::aside, Stage::other_view})
    CHECK(stage_named(to_string(stage)) == stage);
  CHECK(to_string(Stage::after_colour) == "after_colour");
  CHECK(test::mentions(test::error_of([] { stage_named("passes"); }), {"'passes'", "surface, light, pass"}));
}
