#include "base/utf16.hpp"

#include "catch.hpp"

using atelier::from_utf16;
using namespace std::string_literals;

TEST_CASE("UTF-16 of either order becomes UTF-8") {
  CHECK(from_utf16("\377\376a\0\n\0"s) == "a\n");
  CHECK(from_utf16("\xfe\xff\0a\0\n"s) == "a\n");
  CHECK(from_utf16("\xff\xfe"s) == "");
  CHECK(from_utf16("\xff\xfe\xe9\0\xac\x20\x3d\xd8\x00\xde"s) == "\u00e9\u20ac\U0001f600");
}

TEST_CASE("what is no UTF-16 with a mark is left alone") {
  for (const std::string& text : {""s, "int a;"s, "\xef\xbb\xbfint a;"s,
                                  "\xff\xfe"
                                  "a"s,
                                  "\xff\xfe\x3d\xd8"s,
                                  "\xff\xfe\x3d\xd8"
                                  "a\0"s,
                                  "\xff\xfe\x00\xde"
                                  "a\0"s}) {
    INFO(text);
    CHECK_FALSE(from_utf16(text));
  }
}
