// The cases distinguish right from wrong, and the references are what the solutions draw.
#include "catch.hpp"
#include "command.hpp"

using namespace atelier;
using namespace atelier::test;
using nlohmann::json;

namespace {

void check_audit(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "audit");
  const Printed audit = printed(std::move(arguments));
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
  CHECK(audit.json["lacks"].empty());
  CHECK(audit.exit_status == 0);
}

}  // namespace

TEST_CASE("known mistakes are caught by their claiming cases, and variants pass", "[audit][each-step]") {
  if (is_whole_course())
    check_audit({"--sample", "3"});
  else
    check_audit(with_steps({}));
}

TEST_CASE("every known mistake is caught by its claiming cases, and every variant passes", "[audit-all]") {
  for (const CourseStep& step : course()) check_audit({step.name});
}

TEST_CASE("the references are what the solutions draw", "[references][each-step]") {
  const Printed references = printed(with_steps({"reference", "--check"}));
  for (const json& r : references.json["references"]) {
    INFO(r.dump());
    CHECK(r["state"] == "as it was");
  }
  CHECK(references.exit_status == 0);
}
