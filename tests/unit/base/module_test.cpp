#include "base/module.hpp"

#include "catch.hpp"

using atelier::module_symbol;
using atelier::test::error_of;
using atelier::test::mentions;

TEST_CASE("A module's function is found, and the module is loaded once") {
  void* address = module_symbol("atelier-test-module", "atelier_test_answer");
  REQUIRE(address != nullptr);
  CHECK(reinterpret_cast<int (*)()>(address)() == 42);
  CHECK(module_symbol("atelier-test-module", "atelier_test_answer") == address);
}

TEST_CASE("A missing module or symbol is named") {
  CHECK(
      mentions(error_of([] { module_symbol("atelier-no-such", "f"); }), {"atelier-no-such", "libatelier-no-such.so"}));
  CHECK(
      mentions(error_of([] { module_symbol("atelier-test-module", "no_such"); }), {"atelier-test-module", "no_such"}));
}
