// The cases distinguish right from wrong, and the references are what the solutions draw.
#include "catch.hpp"
#include "command.hpp"

using namespace atelier;
using namespace atelier::test;
using nlohmann::json;

TEST_CASE("every known mistake is caught by its claiming cases, and every variant passes", "[audit][each-step]") {
  const Printed audit = printed(with_steps({"audit"}));
  CHECK(!audit.json["mistakes"].empty());
  CHECK(!audit.json["variants"].empty());
  for (const json& m : audit.json["mistakes"]) {
    INFO(m.dump());
    CHECK(m["built"] == true);
    CHECK(m["caught"] == true);
    CHECK(m["caught_by"] == m["expected_case"]);
    CHECK(m["trouble"] == "");
  }
  for (const json& v : audit.json["variants"]) {
    INFO(v.dump());
    CHECK(v["passed"] == true);
  }
  CHECK(audit.exit_status == 0);
}

TEST_CASE("the references are what the solutions draw", "[references][each-step]") {
  const Printed references = printed(with_steps({"reference", "--check"}));
  for (const json& r : references.json["references"]) {
    INFO(r.dump());
    CHECK(r["state"] == "as it was");
  }
  CHECK(references.exit_status == 0);
}
