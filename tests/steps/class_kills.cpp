// Graders of a class are killed at random moments. In the end every verdict is there, and nothing was graded twice.
#include <signal.h>

#include <random>

#include "catch.hpp"
#include "made_class.hpp"
#include "running.hpp"

using namespace atelier;
using namespace atelier::test;

namespace {

namespace fs = std::filesystem;

using Stamps = std::map<std::string, std::string>;

/// The reports of those that have a record.
Stamps stamps_of(const fs::path& out) {
  Stamps stamps;
  for (const std::string& student : MadeClass::students())
    if (const auto stamp = stamp_of_graded(out, student)) stamps[student] = *stamp;
  return stamps;
}

/// Nobody who had a record has been graded again.
void require_kept(const Stamps& before, const fs::path& out) {
  const Stamps now = stamps_of(out);
  for (const auto& [student, stamp] : before) {
    INFO(student);
    CHECK((now.contains(student) && now.at(student) == stamp));
  }
}

/// Seconds that a run lasts undisturbed, and its verdicts.
struct Undisturbed {
  double seconds = 0;
  std::map<std::string, std::string> verdicts;
  explicit Undisturbed(const MadeClass& made) {
    const fs::path out = made.place("undisturbed");
    const Stopwatch watch;
    Running grader(made.command(out), made.environment());
    REQUIRE(grader.wait() == 0);
    seconds = watch.seconds();
    verdicts = class_verdicts(out);
  }
};

void pause(double seconds) {
  comes_true([] { return false; }, seconds);
}

void require_all(const MadeClass& made, const fs::path& out, const Undisturbed& undisturbed) {
  CHECK(class_verdicts(out) == undisturbed.verdicts);
  CHECK(leavings(made, out) == std::vector<std::string>{});
}

}  // namespace

TEST_CASE("a grader that is killed again and again loses no verdict", "[class-kills]") {
  const MadeClass made;
  const Undisturbed undisturbed(made);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> moment(0.02, 0.7);
  int kills = 0, kept = 0;
  for (int game = 0; game < 8; ++game) {
    const fs::path out = made.place("out-" + std::to_string(game));
    Stamps before;
    for (int run = 0; run < 6; ++run) {
      Running grader(made.command(out), made.environment());
      pause(moment(random) * undisturbed.seconds);
      if (!grader.runs()) break;
      grader.kill();
      ++kills;
      require_kept(before, out);
      before = stamps_of(out);
      kept += int(before.size());
    }
    Running last(made.command(out), made.environment());
    INFO(last.output());
    REQUIRE(last.wait() == 0);
    require_kept(before, out);
    require_all(made, out, undisturbed);
  }
  CHECK(kills > 16);  // else nothing was proven
  CHECK(kept > 8);
}

TEST_CASE("a process that is killed while it grades loses no verdict", "[class-kills]") {
  const MadeClass made;
  const Undisturbed undisturbed(made);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> moment(0.05, 0.9);
  int kills = 0;
  for (int game = 0; game < 12; ++game) {
    const fs::path out = made.place("out-" + std::to_string(game));
    Running grader(made.command(out), made.environment());
    pause(moment(random) * undisturbed.seconds);
    Stamps before;
    if (const std::vector<pid_t> workers = grader.children(); !workers.empty()) {
      before = stamps_of(out);
      kills += ::kill(workers[random() % workers.size()], SIGKILL) == 0;
    }
    INFO(grader.output());
    REQUIRE(grader.wait() == 0);
    require_kept(before, out);
    require_all(made, out, undisturbed);
  }
  CHECK(kills > 6);  // else nothing was proven
}
