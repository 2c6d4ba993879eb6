#include "base/file_url.hpp"

#include "catch.hpp"

using namespace atelier;

TEST_CASE("The address of a file is encoded") {
  CHECK(file_url("/home/a-b_c.d~/report.html") == "file:///home/a-b_c.d~/report.html");
  CHECK(file_url("/a b#1?/100%/M\u00fcnze\n\x1b") == "file:///a%20b%231%3F/100%25/M%C3%BCnze%0A%1B");
}
