#include "base/csv.hpp"
#include "catch.hpp"

using namespace atelier;

TEST_CASE("a field of a table is quoted only where it must be", "[base]") {
  CHECK(csv_field("") == "");
  CHECK(csv_field("shadow.fit: casters") == "shadow.fit: casters");
  CHECK(csv_field("a, b") == "\"a, b\"");
  CHECK(csv_field("the \"knee\"") == "\"the \"\"knee\"\"\"");
  CHECK(csv_field("two\nlines") == "\"two\nlines\"");
  CHECK(csv_field("two\r") == "\"two\r\"");
}
