// A class is graded by job arrays of Slurm as by processes of this machine, whatever happens to tasks.
#include <fmt/format.h>
#include <signal.h>

#include "catch.hpp"
#include "made_class.hpp"
#include "one_node_slurm.hpp"

using namespace atelier;
using namespace atelier::test;

namespace {

namespace fs = std::filesystem;

using Words = std::vector<std::string>;

/// A class, and graders of it that use a Slurm.
struct SlurmClass {
  MadeClass made;
  OneNodeSlurm slurm;

  Running start(const fs::path& out, const std::string& arguments = "") const {
    std::map<std::string, std::string> environment = made.environment();
    slurm.add_to(environment);
    Words more = {"--engine", "slurm", "--workers", "3"};
    if (!arguments.empty()) more.insert(more.end(), {"--engine-arguments", arguments});
    return Running(made.command(out, more), environment);
  }

  /// The verdicts without Slurm.
  std::map<std::string, std::string> local_verdicts() const {
    Running grader(made.command(made.place("local")), made.environment());
    REQUIRE(grader.wait() == 0);
    return class_verdicts(made.place("local"));
  }

  /// The tasks that grade into this folder, and in whose command these words stand.
  std::vector<pid_t> tasks(const fs::path& out, const std::string& words = "") const {
    std::vector<pid_t> found;
    for (const FoundProcess& process : processes_with(out.string()))
      if (mentions(process.words, {"grade-worker " + out.string(), words})) found.push_back(process.number);
    return found;
  }
};

/// How many tasks are at work on a submission.
int at_work(const fs::path& out) {
  int count = 0;
  for (int task = 0; task < 3; ++task) count += fs::exists(out / "state" / ("worker-" + std::to_string(task)));
  return count;
}

/// Whether the file is there and has this content.
bool is_text(const fs::path& file, const std::string& text) {
  try {
    return read_file(file) == text;
  } catch (const Error&) {
    return false;
  }
}

/// Leaves the running test where there is no Slurm.
#define NEEDS_SLURM() \
  if (!OneNodeSlurm::why_not().empty()) SKIP_TEST(OneNodeSlurm::why_not())

}  // namespace

TEST_CASE("Slurm gives the verdicts that this machine gives", "[slurm]") {
  NEEDS_SLURM();
  const SlurmClass there;
  const fs::path out = there.made.place("out");
  Running grader = there.start(out);
  const int status = grader.wait();
  INFO(grader.output());
  REQUIRE(status == 0);
  CHECK(mentions(grader.output(), {"6 submissions: 6 graded"}));
  CHECK(class_verdicts(out) == there.local_verdicts());
  CHECK(fs::exists(out / "state" / "slurm-2.log"));
  CHECK(comes_true([&] { return there.slurm.queue().empty(); }));
  CHECK(leavings(there.made, out) == Words{});

  Running again = there.start(out);
  CHECK(again.wait() == 0);
  CHECK(mentions(again.output(), {"0 graded", "6 kept from before"}));
}

TEST_CASE("what tasks of Slurm leave that fail or are requeued is graded by others", "[slurm]") {
  NEEDS_SLURM();
  const SlurmClass there;
  const fs::path out = there.made.place("out");
  Running grader = there.start(out);
  REQUIRE(comes_true([&] { return at_work(out) == 3; }));
  const std::string array = read_file(out / "state" / "slurm-array");
  const Finished requeued = there.slurm.command({"scontrol", "requeue", array + "_0"});
  INFO(requeued.output);
  CHECK(requeued.ok());
  const std::vector<pid_t> tasks = there.tasks(out);
  REQUIRE_FALSE(tasks.empty());
  ::kill(tasks.back(), SIGKILL);
  const int status = grader.wait();
  INFO(grader.output());
  REQUIRE(status == 0);
  CHECK(class_verdicts(out) == there.local_verdicts());
}

TEST_CASE("a submission on which tasks of Slurm end twice is left to a person", "[slurm]") {
  NEEDS_SLURM();
  const SlurmClass there;
  const fs::path out = there.made.place("out");
  Running grader = there.start(out);
  int ends = 0;
  const Stopwatch watch;
  while (grader.runs() && watch.seconds() < 200)
    for (int task = 0; task < 3; ++task) {
      const fs::path file = out / "state" / fmt::format("worker-{}", task);
      for (const pid_t process : there.tasks(out, fmt::format("--index {} ", task)))
        if (is_text(file, "bob")) ends += ::kill(process, SIGKILL) == 0;
    }
  CHECK(ends >= 2);
  const int status = grader.wait();
  INFO(grader.output());
  REQUIRE(status == 0);
  const auto verdicts = class_verdicts(out);
  CHECK(mentions(verdicts.at("students/bob"), {"The grader itself has ended 2 times on it"}));
  CHECK(mentions(verdicts.at("students/ada"), {"passed"}));
}

TEST_CASE("whoever stops a grader stops its array", "[slurm]") {
  NEEDS_SLURM();
  const SlurmClass there;
  const fs::path out = there.made.place("out");
  {
    Running grader = there.start(out);
    REQUIRE(comes_true([&] { return at_work(out) > 0; }));
    grader.signal(SIGINT);
    CHECK(grader.wait() == -SIGINT);
    CHECK(comes_true([&] { return there.slurm.queue().empty() && there.tasks(out).empty(); }));
    CHECK_FALSE(fs::exists(out / "gradebook.csv"));
  }
  {
    // One that is killed cannot; the next one does, before its own array.
    Running grader = there.start(out, "--partition=closed");
    REQUIRE(comes_true([&] { return fs::exists(out / "state" / "slurm-array"); }));
    REQUIRE(comes_true([&] { return !there.slurm.queue().empty(); }));
    grader.kill();
  }
  Running last = there.start(out);
  CHECK(last.wait() == 0);
  CHECK(comes_true([&] { return there.slurm.queue().empty(); }));
  CHECK(class_verdicts(out) == there.local_verdicts());
}

TEST_CASE("what Slurm refuses is said", "[slurm]") {
  NEEDS_SLURM();
  const SlurmClass there;
  const fs::path out = there.made.place("out");
  const auto refused = [&](const std::string& arguments, std::initializer_list<std::string_view> words) {
    Running grader = there.start(out, arguments);
    CHECK(grader.wait() == 2);
    INFO(grader.output());
    CHECK(mentions(grader.output(), words));
    CHECK(there.slurm.queue().empty());
  };
  refused("--partition=none", {"error: sbatch: ", "Invalid partition"});
  refused("--nodes=3", {"error: slurm: the job array cannot start (PartitionNodeLimit); see --engine-arguments"});
  refused("--uid=65534", {"error: slurm: 2 job arrays have graded nothing"});  // who may not write the results

  Running waits = there.start(out, "--partition=closed");
  CHECK(comes_true([&] { return mentions(waits.output(), {"Slurm: job array ", " waits: PartitionDown"}); }));
  waits.signal(SIGTERM);
  CHECK(waits.wait() == -SIGTERM);
  CHECK(comes_true([&] { return there.slurm.queue().empty(); }));
}

TEST_CASE("without Slurm, its engine is refused in one sentence", "[class]") {
  const MadeClass made;
  std::map<std::string, std::string> environment = made.environment();
  environment["PATH"] = made.temporary().string();
  Running grader(made.command(made.place("out"), {"--engine", "slurm"}), environment);
  CHECK(grader.wait() == 2);
  CHECK(mentions(grader.output(), {"error: --engine slurm: the program sbatch is not here", "leave --engine out"}));
  CHECK_FALSE(fs::exists(made.place("out")));
}
