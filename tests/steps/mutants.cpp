// Changes of the solutions that a machine makes: what changes the meaning loses points, what keeps it keeps them.
// The numbers are small here, and of the steps whose turn it is; --all tries many (the tests whose topics end in
// "-all").
#include <cstdlib>

#include "catch.hpp"
#include "command.hpp"

using namespace atelier;
using namespace atelier::test;
using nlohmann::json;

namespace {

/// None may fall short: survive, lose points, or not build.
void check_mutations(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "mutate");
  const Printed run = printed(with_steps(std::move(arguments), steps_in_turn()));
  CHECK(!run.json["mutations"].empty());
  int built = 0;
  for (const json& step : run.json["mutations"]) {
    INFO(step["step"].get<std::string>() << ", seed " << step["seed"].dump());
    built += step["built"].get<int>();
    for (const json& mutant : step["survived"]) {
      INFO(mutant.dump(2));
      CHECK(false);
    }
  }
  if (is_whole_course()) CHECK(built > 0);  // step 00 alone has nothing to change
  CHECK(run.exit_status == 0);
}

/// More of them if one step is tested alone.
std::string count(int usually, int of_one_step) {
  return std::to_string(is_whole_course() ? usually : of_one_step);
}

}  // namespace

TEST_CASE("mutants of the solutions are caught", "[mutants][each-step]") {
  check_mutations({"--count", count(6, 20)});
}

TEST_CASE("solutions in other words keep all points", "[rewritings][each-step]") {
  check_mutations({"--preserving", "--count", count(2, 12)});
}

TEST_CASE("150 mutants of each solution are caught", "[mutants-all]") {
  check_mutations({"--count", "150"});
}

TEST_CASE("100 forms of each solution keep all points", "[rewritings-all]") {
  check_mutations({"--preserving", "--count", "100"});
}

TEST_CASE("no case depends on the last bits of what earlier steps return", "[last-bits]") {
  check_mutations({"--last-bits"});
}
