#include "base/csv.hpp"
#include "catch.hpp"

using namespace atelier;

TEST_CASE("a CSV field is quoted only if necessary", "[base]") {
  CHECK(csv_field("") == "");
  CHECK(csv_field("shadow.fit: casters") == "shadow.fit: casters");
  CHECK(csv_field("a, b") == "\"a, b\"");
  CHECK(csv_field("the \"knee\"") == "\"the \"\"knee\"\"\"");
  CHECK(csv_field("two\nlines") == "\"two\nlines\"");
  CHECK(csv_field("two\r") == "\"two\r\"");
}
