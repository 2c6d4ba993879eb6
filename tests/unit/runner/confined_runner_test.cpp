// The runner with a program in a sandbox.
#include <algorithm>

#include "base/file.hpp"
#include "catch.hpp"
#include "judge/run/runner.hpp"
#include "sandbox/sandbox.hpp"
#include "words.hpp"

namespace atelier::judge {
namespace {

using sandbox::Tier;

/// Asks fake_step for an honest case, one of each scene, and an honest one, in this sandbox.
std::vector<Answer> ask(const sandbox::Sandbox& sandbox, const std::vector<std::string>& scenes,
                        const std::filesystem::path& program = ATELIER_TEST_PROGRAMS "/fake_step") {
  RunSettings settings;
  settings.program = program;
  settings.workers = 1;
  settings.sandbox = &sandbox;
  std::vector<Case> cases;
  const auto add = [&](const std::string& scene) {
    const std::string name = "case-" + std::to_string(cases.size());
    cases.push_back(
        {.name = name, .scene = scene, .camera = {}, .size = {8, 4}, .settings = {}, .probe = {}, .inputs = {}});
  };
  add("honest");
  for (const std::string& scene : scenes) add(scene);
  add("honest");
  return run_cases(settings, cases);
}

/// AddressSanitizer reserves more address space than a confined program gets, so what is built with it cannot start.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool can_start_here = false;
#elif defined(__has_feature)
constexpr bool can_start_here = !__has_feature(address_sanitizer);
#else
constexpr bool can_start_here = true;
#endif

bool works(Tier tier) {
  if (!can_start_here) return false;
  static const sandbox::Possible possible = sandbox::find_possible_tiers();
  return (tier == Tier::full ? possible.why_not_full : possible.why_not_account).empty();
}

}  // namespace

TEST_CASE("in a sandbox each misbehaviour fails its own case too") {
  const Tier tier = GENERATE(Tier::full, Tier::account);
  INFO("tier " << sandbox::to_string(tier));
  if (!works(tier)) SKIP_TEST("this tier does not work here");
  const sandbox::Sandbox sandbox(tier, {.memory = std::size_t(400) << 20});
  const std::vector<Answer> answers = ask(sandbox, {"segfaults", "exits 5", "throws bad_alloc", "link"});
  CHECK(answers[0].ended == Answer::Ended::normally);
  CHECK(has_all(answers[1].error, {"SIGSEGV"}));
  CHECK(has_all(answers[2].error, {"status 5"}));
  CHECK(has_all(answers[3].error, {"std::bad_alloc (a program gets 400 MiB of memory)"}));
  CHECK(has_all(answers[4].error, {"symbolic link"}));
  CHECK(answers[5].ended == Answer::Ended::normally);
}

TEST_CASE("a report says that a program has needed too much memory") {
  const Tier tier = GENERATE(Tier::full, Tier::account);
  INFO("tier " << sandbox::to_string(tier));
  if (!works(tier)) SKIP_TEST("this tier does not work here");
  const sandbox::Sandbox sandbox(tier, {.memory = std::size_t(400) << 20});
  if (!sandbox.has_control_group()) SKIP_TEST("no control group can be made here");
  const std::vector<Answer> answers = ask(sandbox, {"takes memory"});
  CHECK(answers[1].ended == Answer::Ended::crashed);
  CHECK(has_all(answers[1].error, {"since it needed more than 400 MiB of memory during this case"}));
  CHECK(answers[2].ended == Answer::Ended::normally);
}

TEST_CASE("no case is judged where the sandbox does not start the program") {
  const Tier tier = GENERATE(Tier::full, Tier::account);
  INFO("tier " << sandbox::to_string(tier));
  if (!works(tier)) SKIP_TEST("this tier does not work here");
  const std::string error = test::error_of([&] { ask(sandbox::Sandbox(tier), {}, "/usr/bin/no-such-program"); });
  CHECK(test::mentions(error, {"sandbox", "no-such-program"}));
}

}  // namespace atelier::judge
