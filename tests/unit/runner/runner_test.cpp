// The runner with a program that misbehaves in every way.
#include "judge/run/runner.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>

#include "base/descriptor.hpp"
#include "base/file.hpp"
#include "case/exchange.hpp"
#include "catch.hpp"
#include "words.hpp"

using namespace atelier;
using namespace atelier::judge;
using namespace std::chrono_literals;
using Ended = Answer::Ended;
using test::error_of;
namespace fs = std::filesystem;

namespace {

/// A case that does what `scene` says; "probe" asks for numbers, all else for a picture.
Case make_case(const std::string& name, const std::string& scene) {
  Case c{.name = name, .scene = scene, .camera = {}, .size = {8, 4}, .settings = {}, .probe = {}, .inputs = {}};
  if (scene == "probe") c.probe = "look_at", c.inputs = {Arguments{{{"eye", {0, 0, 1}}}}};
  return c;
}

std::vector<Case> make_cases(const std::vector<std::string>& scenes) {
  std::vector<Case> cases;
  for (const std::string& scene : scenes) cases.push_back(make_case("case-" + std::to_string(cases.size()), scene));
  return cases;
}

RunSettings settings() {
  RunSettings s;
  s.program = ATELIER_TEST_PROGRAMS "/fake_step";
  s.workers = 1;
  return s;
}

std::string to_string(Ended ended) {
  constexpr const char* names[] = {"normally", "missing", "crashed", "timeout", "build_failed"};
  return names[static_cast<int>(ended)];
}

/// The case's number within its process, as the program says in the picture.
float place(const Answer& answer) {
  return answer.pixels ? answer.pixels->at(0, 0).r : -1;
}

}  // namespace

TEST_CASE("each misbehaviour fails only its own case") {
  struct Row {
    std::string scene;
    Ended ended;
    std::string word;  ///< that the sentence must have
    bool own_end;      ///< the process ends with this case, so that the next case is a new one's first
  };
  const std::vector<Row> rows = {
      {"honest", Ended::normally, "", false},
      {"probe", Ended::normally, "", false},
      {"prints", Ended::normally, "", false},
      {"floods", Ended::normally, "", false},
      {"leaves a child", Ended::normally, "", false},
      {"ends others", Ended::normally, "", false},
      {"ends a long line", Ended::normally, "", false},
      {"crashes at exit", Ended::normally, "", false},
      {"stops between cases", Ended::normally, "", true},
      {"nothing", Ended::missing, "", false},
      {"refuses", Ended::missing, "look_at threw: eye and target agree", false},
      {"refuses after drawing", Ended::missing, "too late", false},
      {"throws", Ended::crashed, "int was thrown: 42", false},
      {"throws to nobody", Ended::crashed, "SIGABRT) during this case: int was thrown: 43", true},
      {"link", Ended::missing, ".pixels", false},
      {"fifo", Ended::missing, ".pixels", false},
      {"folder", Ended::missing, ".pixels", false},
      {"short", Ended::missing, ".pixels", false},
      {"huge", Ended::missing, ".pixels", false},
      {"garbage", Ended::missing, ".pixels", false},
      {"ends early", Ended::missing, ".pixels", false},
      {"exits", Ended::missing, "status 0 during this case", true},
      {"exits 5", Ended::missing, "status 5 during this case", true},
      {"ends on stdout", Ended::missing, "status 0 during this case", true},
      {"leaves a child, exits", Ended::missing, "status 0 during this case", true},
      {"segfaults", Ended::crashed, "SIGSEGV", true},
      {"draws, then aborts", Ended::crashed, "SIGABRT", true},
      {"hangs", Ended::timeout, "longer than 0.4 s", true},
      {"leaves its group, hangs", Ended::timeout, "longer than 0.4 s", true},
      {"hangs, floods", Ended::timeout, "longer than 0.4 s", true},
      {"hangs, floods progress", Ended::timeout, "longer than 0.4 s", true},
      {"hangs without pipes", Ended::timeout, "longer than 0.4 s", true},
  };
  for (const Row& row : rows) {
    INFO("scene: " << row.scene);
    RunSettings s = settings();
    // Enough for an honest case of this program even on a busy machine, which takes some milliseconds.
    s.case_limit = row.ended == Ended::timeout ? 400ms : 10s;
    const std::vector<Case> cases = {make_case("first", "honest"), make_case("odd", row.scene),
                                     make_case("last", "honest")};
    const std::vector<Answer> answers = run_cases(s, cases);
    REQUIRE(answers.size() == 3);
    CHECK(to_string(answers[0].ended) == "normally");
    CHECK(to_string(answers[1].ended) == to_string(row.ended));
    CHECK(has_all(answers[1].error, {row.word}));
    CHECK(answers[1].error.empty() == (row.ended == Ended::normally));
    CHECK(answers[1].pixels.has_value() == (row.ended == Ended::normally && row.scene != "probe"));
    CHECK(answers[1].values.has_value() == (row.scene == "probe"));
    CHECK(to_string(answers[2].ended) == "normally");
    CHECK(place(answers[2]) == (row.own_end ? 1 : 3));
    CHECK(answers[1].output.size() <= s.output_limit);
  }
}

TEST_CASE("a folder of answers that is exchanged for a link is neither read nor emptied") {
  const TemporaryFolder temporary;
  const fs::path precious = temporary.path() / "precious", away = temporary.path() / "away";
  fs::create_directories(away);
  const std::vector<Case> cases =
      make_cases({"exchanges its folder", "honest", "exchanges its folder, hangs", "honest"});
  // What a judge that follows the link would read, and remove: answers, and a folder named like ours.
  fs::create_directories(precious / "out");
  for (const Case& c : cases)
    for (const char* const folder : {".", "out"}) write_pixels(precious / folder / (c.name + ".pixels"), Image(8, 4));
  write_file(precious / "out" / (cases[1].name + ".error"), "a secret");
  const auto names = [&] {
    std::set<fs::path> all;
    for (const auto& entry : fs::recursive_directory_iterator(precious)) all.insert(entry.path());
    return all;
  };
  const std::set<fs::path> before = names();
  RunSettings s = settings();
  s.case_limit = 400ms;
  s.environment = {{"FAKE_AWAY", away.string()}, {"FAKE_PRECIOUS", precious.string()}};

  const std::vector<Answer> answers = run_cases(s, cases);

  for (const std::size_t i : {0u, 1u}) {
    CHECK(to_string(answers[i].ended) == "missing");
    CHECK(answers[i].error ==
          "the program has moved, removed or replaced the folder for its answers: none of them is read");
    CHECK_FALSE(answers[i].pixels.has_value());
  }
  CHECK(to_string(answers[2].ended) == "timeout");
  CHECK(to_string(answers[3].ended) == "normally");  // a new process has a new folder
  CHECK(place(answers[3]) == 1);
  CHECK(names() == before);
  for (const auto& moved : fs::directory_iterator(away)) CHECK(fs::is_empty(moved));  // what the judge made is removed
}

TEST_CASE("a case that crashes in every process is run once") {
  const auto answers = run_cases(settings(), make_cases({"segfaults", "segfaults", "honest", "segfaults"}));
  CHECK(to_string(answers[0].ended) == "crashed");
  CHECK(to_string(answers[1].ended) == "crashed");
  CHECK(to_string(answers[2].ended) == "normally");
  CHECK(to_string(answers[3].ended) == "crashed");
}

TEST_CASE("after three time-outs no further case is run") {
  RunSettings s = settings();
  s.case_limit = 300ms;
  const std::vector<Case> cases = make_cases({"hangs", "hangs", "honest", "hangs", "honest", "hangs"});
  struct Row {
    const char* name;
    int most, workers;
    std::vector<bool> asked;
  };
  const Row rows[] = {{"by default", s.max_time_outs, 1, {true, true, true, true, false, false}},
                      {"one", 1, 1, {true, false, false, false, false, false}},
                      {"never", 0, 1, {true, true, true, true, true, true}}};
  for (const Row& row : rows) {
    INFO(row.name);
    s.max_time_outs = row.most;
    std::size_t delivered = 0;
    const auto answers = run_cases(s, cases, [&](std::size_t, const Answer&) { ++delivered; });
    CHECK(delivered == cases.size());
    for (std::size_t i = 0; i < cases.size(); ++i) {
      INFO("case " << i << ": " << answers[i].error);
      const bool honest = cases[i].scene == "honest";
      CHECK(to_string(answers[i].ended) == (honest && row.asked[i] ? "normally" : "timeout"));
      CHECK(has_all(answers[i].error, {"was not run, because"}) == !row.asked[i]);
    }
  }
}

TEST_CASE("time-outs are counted over all workers together") {
  RunSettings s = settings();
  s.case_limit = 300ms, s.workers = 2, s.max_time_outs = 1;
  const auto answers = run_cases(s, make_cases({"hangs", "hangs, floods", "honest", "honest", "hangs", "honest"}));
  for (std::size_t i = 2; i < answers.size(); ++i) {
    INFO("case " << i << ": " << answers[i].error);
    CHECK(to_string(answers[i].ended) == "timeout");
    CHECK(has_all(answers[i].error, {"was not run, because"}));
  }
}

TEST_CASE("a program that cannot start fails every case with its message") {
  struct Row {
    std::string start;
    Ended ended;
    std::string word;
  };
  const std::vector<Row> rows = {
      {"refuses", Ended::missing, "setting 'shadow.size' is not known; did you mean 'shadow.resolution'?"},
      {"lacks a library", Ended::missing, "undefined symbol: look_at"},
      {"exits", Ended::missing, "status 0 before its first case"},
      {"segfaults", Ended::crashed, "SIGSEGV) before its first case"},
      {"hangs", Ended::timeout, "did not begin its first case within 0.3 s"},
  };
  for (const Row& row : rows) {
    INFO("start: " << row.start);
    RunSettings s = settings();
    s.workers = 2;
    s.environment["FAKE_START"] = row.start;
    if (row.ended == Ended::timeout) s.start_limit = 300ms, s.case_limit = 1h;
    for (const Answer& answer : run_cases(s, make_cases({"honest", "honest", "honest"}))) {
      CHECK(to_string(answer.ended) == to_string(row.ended));
      CHECK(has_all(answer.error, {row.word}));
      CHECK(!has_all(answer.error, {"error: "}));
    }
  }
}

TEST_CASE("the start limit is separate from the case limit") {
  RunSettings s = settings();
  s.start_limit = 1h, s.case_limit = 300ms;
  CHECK(to_string(run_cases(s, make_cases({"hangs"}))[0].ended) == "timeout");
}

TEST_CASE("a program that does not exit is killed soon") {
  const auto answers = run_cases(settings(), make_cases({"honest", "hangs at exit"}));
  CHECK(to_string(answers[0].ended) == "normally");
  CHECK(to_string(answers[1].ended) == "normally");
}

TEST_CASE("an interrupted run kills its programs without waiting") {
  RunSettings s = settings();
  s.case_limit = s.start_limit = 1h;
  int asked = 0;
  s.interrupted = [&] { return ++asked == 10; };
  CHECK_THROWS_AS(run_cases(s, make_cases({"hangs", "honest"})), Interrupted);
  CHECK(asked == 10);
}

TEST_CASE("answers are in the order of the cases, for any workers and run order") {
  const std::vector<Case> cases = make_cases({"honest", "probe", "honest", "segfaults", "honest", "prints", "nothing"});
  const auto plain = run_cases(settings(), cases);
  for (const int workers : {1, 2, 3, 64}) {
    for (const auto shuffle : {std::optional<std::uint64_t>(), std::optional<std::uint64_t>(7)}) {
      INFO(workers << " workers, " << (shuffle ? "shuffled" : "in order"));
      RunSettings s = settings();
      s.workers = workers, s.shuffle = shuffle;
      std::vector<std::size_t> delivered;
      const auto answers = run_cases(s, cases, [&](std::size_t index, const Answer&) { delivered.push_back(index); });
      REQUIRE(answers.size() == cases.size());
      for (std::size_t i = 0; i < cases.size(); ++i) {
        INFO("case " << i);
        CHECK(to_string(answers[i].ended) == to_string(plain[i].ended));
        CHECK(answers[i].pixels.has_value() == plain[i].pixels.has_value());
        CHECK(answers[i].values.has_value() == plain[i].values.has_value());
      }
      std::sort(delivered.begin(), delivered.end());
      CHECK(delivered == case_order(cases.size(), {}));
    }
  }
}

TEST_CASE("shards are short runs of one scene, shuffled by the seed") {
  RunSettings s = settings();
  s.workers = 2;
  const auto places = [&](const std::vector<std::string>& scenes) {
    std::vector<int> found;
    for (const Answer& answer : run_cases(s, make_cases(scenes))) found.push_back(int(place(answer)));
    return found;
  };
  CHECK(places(std::vector<std::string>(2, "honest")) == std::vector{1, 1});
  CHECK(places(std::vector<std::string>(6, "honest")) == std::vector{1, 2, 3, 1, 2, 3});
  CHECK(places(std::vector<std::string>(12, "honest")) == std::vector{1, 2, 3, 4, 1, 2, 3, 4, 5, 6, 5, 6});
  const std::vector<int> mixed = places({"honest", "prints", "prints", "honest"});
  CHECK(mixed[0] == 1);
  CHECK(mixed[3] == 2);

  s.workers = 1, s.shuffle = 3;
  const std::vector<Case> cases = make_cases(std::vector<std::string>(6, "honest"));
  const auto shuffled = run_cases(s, cases);
  const auto order = case_order(6, 3);
  for (std::size_t i = 0; i < 6; ++i) CHECK(place(shuffled[order[i]]) == float(i + 1));

  CHECK(order != case_order(6, {}));
  CHECK(case_order(50, 1) == case_order(50, 1));
  CHECK(case_order(50, 1) != case_order(50, 2));
  const auto all = case_order(50, 1);
  CHECK(std::set<std::size_t>(all.begin(), all.end()).size() == 50);
  CHECK(case_order(0, 1).empty());
}

TEST_CASE("a program's output is kept, up to a limit") {
  const auto alone = run_cases(settings(), make_cases({"prints"}));
  CHECK(alone[0].output == "out of case-0\nerr of case-0\n");

  // Progress and print come through two pipes: what is printed close to a case's end may be counted to its neighbour.
  std::string all;
  for (const Answer& answer : run_cases(settings(), make_cases({"prints", "honest", "prints", "prints, segfaults"})))
    all += answer.output;
  CHECK(all == "out of case-0\nerr of case-0\nout of case-2\nerr of case-2\nout of case-3\nerr of case-3\n");

  RunSettings s = settings();
  s.output_limit = 20;
  CHECK(run_cases(s, make_cases({"prints"}))[0].output == "out of case-0\nerr of");
}

TEST_CASE("the environment does not depend on the caller's") {
  ::setenv("LP_NATIVE_VECTOR_WIDTH", "512", 1);
  ::setenv("GALLIUM_DRIVER", "softpipe", 1);
  ::setenv("MESA_GL_VERSION_OVERRIDE", "2.1", 1);
  ::setenv("LD_LIBRARY_PATH", "/nowhere", 1);
  ::setenv("LC_ALL", "de_DE.UTF-8", 1);
  ::setenv("ATELIER_TEST_KEPT", "yes", 1);
  const TemporaryFolder folder;
  RunSettings s = settings();
  s.driver_threads = 3;
  s.shader_cache = folder.path() / "new" / "cache";
  s.environment = {{"EXTRA", "1"}, {"GALLIVM_PERF", "mine"}};
  s.output_limit = 1 << 16;
  const auto answers = run_cases(s, make_cases({"environment"}));
  for (const char* name : {"LP_NATIVE_VECTOR_WIDTH", "GALLIUM_DRIVER", "MESA_GL_VERSION_OVERRIDE", "LD_LIBRARY_PATH",
                           "LC_ALL", "ATELIER_TEST_KEPT"})
    ::unsetenv(name);

  const std::string text = "\n" + answers[0].output;
  CHECK(has_all(text, {"\nLANG=C\n", "\nLP_NUM_THREADS=3\n", "\nEXTRA=1\n", "\nGALLIVM_PERF=mine\n",
                       "\nATELIER_TEST_KEPT=yes\n", "\nMESA_SHADER_CACHE_DIR=" + s.shader_cache.string() + "\n"}));
  for (const char* name : {"LP_NATIVE", "GALLIUM_", "MESA_GL", "LD_", "LC_ALL", "MESA_SHADER_CACHE_DISABLE"}) {
    INFO(name);
    CHECK(!has_all(text, {std::string("\n") + name}));
  }
  CHECK(std::filesystem::is_directory(s.shader_cache));

  const auto defaults = program_environment(settings());
  CHECK(defaults.at("GALLIVM_PERF") == "nopt");
  CHECK(defaults.at("MESA_SHADER_CACHE_DISABLE") == "true");
  CHECK(defaults.count("MESA_SHADER_CACHE_DIR") == 0);
}

TEST_CASE("a program inherits none of our descriptors") {
  const Descriptor ours(::open("/dev/null", O_RDONLY));  // on purpose without close-on-exec
  const Descriptor high(::fcntl(ours.get(), F_DUPFD, 200));
  REQUIRE(high);
  const auto answers = run_cases(settings(), make_cases({"honest"}));
  REQUIRE(answers[0].pixels);
  CHECK(answers[0].pixels->at(0, 0).g == 1);
}

TEST_CASE("a program's children end with it") {
  for (const char* scene : {"leaves a child", "leaves a child, exits", "leaves a child, hangs"}) {
    INFO(scene);
    const TemporaryFolder folder;
    const std::string file = (folder.path() / "lock").string();
    write_file(file, "");
    RunSettings s = settings();
    s.environment["FAKE_LOCK"] = file;
    s.case_limit = 400ms;
    run_cases(s, make_cases({scene}));
    const Descriptor lock(::open(file.c_str(), O_RDWR | O_CLOEXEC));
    // A killed process lets go of its lock when the system gets round to it: within milliseconds. A living one never
    // does.
    bool free = false;
    for (int tries = 0; tries < 500 && !free; ++tries) {
      free = ::flock(lock.get(), LOCK_EX | LOCK_NB) == 0;
      if (!free) ::usleep(10'000);
    }
    CHECK(free);
  }
}

TEST_CASE("an exception in the callback ends the run and every program") {
  RunSettings s = settings();
  s.workers = 2;
  const auto run = [&] {
    run_cases(s, make_cases({"honest", "hangs"}), [](std::size_t, const Answer&) { throw Error("enough"); });
  };
  CHECK(error_of(run) == "enough");
}

TEST_CASE("invalid runs are refused with a message") {
  struct Row {
    std::string name;
    std::function<void(RunSettings&)> change;
    std::string word;
  };
  const std::vector<Row> rows = {
      {"no workers", [](RunSettings& s) { s.workers = 0; }, "1..64"},
      {"too many workers", [](RunSettings& s) { s.workers = 65; }, "65"},
      {"negative threads", [](RunSettings& s) { s.driver_threads = -1; }, "0..32"},
      {"no time", [](RunSettings& s) { s.case_limit = 0ms; }, "time limit of a case"},
      {"no time to start", [](RunSettings& s) { s.start_limit = -1ms; }, "time limit of the start"},
      {"unknown context", [](RunSettings& s) { s.context = "vulkan"; }, "osmesa, egl, window"},
      {"missing program", [](RunSettings& s) { s.program = "/nowhere/01-none"; }, "/nowhere/01-none"},
      {"a folder as program", [](RunSettings& s) { s.program = "/tmp"; }, "/tmp"},
      {"a cache in a file", [](RunSettings& s) { s.shader_cache = "/dev/null/cache"; }, "/dev/null/cache"},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    RunSettings s = settings();
    row.change(s);
    CHECK(has_all(error_of([&] { run_cases(s, make_cases({"honest"})); }), {row.word}));
  }
  const std::vector<Case> twice = {make_case("same", "honest"), make_case("same", "honest")};
  CHECK(has_all(error_of([&] { run_cases(settings(), twice); }), {"same", "twice"}));
  CHECK(run_cases(settings(), {}).empty());
}
