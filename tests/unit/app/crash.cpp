#include "app/crash.hpp"

#include <string>

#include "catch.hpp"

using namespace atelier;

namespace {

std::string name_of(const char* mangled, std::size_t room = 256) {
  std::string name(room, '?');
  name.resize(qualified_name(mangled, name.data(), room));
  return name;
}

}  // namespace

TEST_CASE("a function's name is extracted from its mangled name") {
  struct Row {
    const char* mangled;
    const char* name;
  };
  const Row rows[] = {
      {"_ZN7atelier10transforms7look_atERKN3glm3vecILi3EfLNS1_9qualifierE0EEES6_S6_", "atelier::transforms::look_at"},
      {"_ZN7atelier1fEv", "atelier::f"},
      {"_ZN3glm3vecILi3EfLNS_9qualifierE0EEC1Ev", ""},  // a template's constructor
      {"_ZNK7atelier5Image5widthEv", ""},               // a member
      {"_Z4mainv", ""},
      {"main", ""},
      {"", ""},
      {"_ZN", ""},
      {"_ZN7atel", ""},                            // ends within a part
      {"_ZN99999999999999999999999atelierE", ""},  // a length that is none
      {"_ZN7atelier", ""},
  };
  for (const Row& row : rows) {
    INFO(row.mangled);
    CHECK(name_of(row.mangled) == row.name);
  }
  CHECK(name_of("_ZN7atelier1fEv", 10) == "atelier::f");
  CHECK(name_of("_ZN7atelier1fEv", 9).empty());
}
