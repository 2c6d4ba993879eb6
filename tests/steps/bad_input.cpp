// Bad input gets one clear message and status 2, and leaves nothing behind.
#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <functional>

#include "base/file.hpp"
#include "catch.hpp"
#include "command.hpp"

using namespace atelier;
using namespace atelier::test;

TEST_CASE("bad input gets one message, status 2, and leaves nothing behind", "[bad-input]") {
  const TemporaryFolder empty;
  write_file(empty.path() / "not-a.zip", std::string_view("PK nothing"));
  write_file(empty.path() / "empty.zip", std::string_view());
  write_file(empty.path() / "cut.zip", std::string_view("PK\3\4 and no more"));
  write_file(empty.path() / "course.toml", std::string_view("[late]\npercent_per_day = 200\n"));
  std::filesystem::create_directory(empty.path() / "no-steps");
  const std::string out = (empty.path() / "out").string();
  const auto path = [&](const char* name) { return (empty.path() / name).string(); };
  struct Row {
    const char* name;
    std::vector<std::string> arguments;
    const char* says;
  };
  const Row rows[] = {
      {"no command", {}, "subcommand"},
      {"an unknown command", {"chekc"}, "chekc"},
      {"an unknown option", {"list", "--jsno"}, "--jsno"},
      {"an unknown step", {"check", "99", "--report", out}, "99"},
      {"an ambiguous step", {"check", "-", "--report", out}, "could be"},
      {"an unknown case", {"check", "00", "--case", "no-such-case", "--report", out}, "no-such-case"},
      {"an unknown context", {"check", "00", "--context", "vulkan", "--report", out}, "vulkan"},
      {"no such folder", {"grade", path("nowhere"), "--out", out}, "nowhere"},
      {"a folder without a step", {"grade", path("no-steps"), "--out", out}, "none of the steps"},
      {"no archive", {"grade", path("not-a.zip"), "--out", out}, "not-a.zip"},
      {"an empty archive", {"grade", path("empty.zip"), "--out", out}, "is empty (0 bytes)"},
      {"half an archive", {"grade", path("cut.zip"), "--out", out}, "is cut off or damaged"},
      {"a step's own folder", {"grade", "solutions/00-hello", "--out", out}, "name its parent folder"},
      {"a step that is not there", {"grade", "solutions", "--step", "99", "--out", out}, "99"},
      {"no worker", {"grade", "solutions", "--workers", "0", "--out", out}, "--workers"},
      {"a course without a command", {"course"}, "known are check"},
      {"an unknown command of a course", {"course", "chekc"}, "did you mean 'check'?"},
      {"no course.toml", {"course", "check", path("nowhere.toml")}, "docs/course.toml is one to copy"},
      {"an impossible course.toml",
       {"course", "check", path("course.toml")},
       "course.toml:2: percent_per_day: 200 is not allowed; it takes a number 0..100"},
      {"a case of no step", {"reference", "--case", "x"}, "--case"},
      {"no step to run", {"run"}, "which step"},
      {"a pixel without its case", {"explain", "02"}, "name a case with a picture: encoded, "},
      {"a pixel of no case", {"explain", "02", "backlihgt"}, "did you mean 'backlight'?"},
      {"a pixel of a case like none", {"explain", "02", "zzzzzzzz"}, "known are encoded, "},
      {"a pixel of a probe",
       {"explain", "02", "mipmaps"},
       "is a probe: it has no pixels; cases with pictures: encoded, "},
      {"a pixel outside", {"explain", "02", "backlight", "--pixel", "256,0"}, "X 0..255, Y 0..255"},
      {"a pixel left of it", {"explain", "02", "backlight", "--pixel=-1,5"}, "--pixel -1,5: it takes X,Y"},
      {"half a pixel", {"explain", "02", "backlight", "--pixel", "1.5,2"}, "two whole numbers"},
      {"a pixel without y", {"explain", "02", "backlight", "--pixel", "3"}, "--pixel 3: it takes X,Y"},
      {"a pixel of three", {"explain", "02", "backlight", "--pixel", "3,4,5"}, "--pixel 3,4,5: it takes X,Y"},
      {"a hint for no case", {"hint", "00", "no-such-case"}, "no-such-case"},
      {"a fourth level", {"hint", "00", "--level", "4"}, "--level"},
      {"a file that nobody writes", {"reset", "steps/00-hello/given/main.cpp"}, "hello.glsl"},
      {"a function that nobody writes", {"compare", "00", "no_such_function"}, "no_such_function"},
      {"too many repeats", {"bench", "--repeats", "100000"}, "--repeats"},
      {"two tiers", {"test", "--quick", "--all"}, "--all"},
  };
  for (const Row& row : rows) {
    const Finished finished = run_atelier(row.arguments);
    INFO(row.name << ": " << finished.output);
    CHECK(finished.exit_status == 2);
    CHECK(finished.output.starts_with("error: "));
    CHECK(mentions(finished.output, {row.says}));
    CHECK(std::count(finished.output.begin(), finished.output.end(), '\n') == 1);
    CHECK(!std::filesystem::exists(out));
  }
}

namespace {

/// A submission of step 00, spoilt.
void write_hello(const std::filesystem::path& submission,
                 const std::function<void(const std::filesystem::path&)>& spoil) {
  std::filesystem::create_directory(submission);
  std::filesystem::copy(folders().solutions() / "00-hello", submission / "00-hello");
  std::filesystem::remove(submission / "00-hello/hello.glsl");
  spoil(submission / "00-hello/hello.glsl");
}

}  // namespace

TEST_CASE("a skipped file is reported with its reason, once per step", "[bad-input]") {
  const std::filesystem::path solution = folders().solutions() / "00-hello/hello.glsl";
  struct Row {
    const char* name;
    std::function<void(const std::filesystem::path&)> spoil;
    std::string reason;
  };
  const Row rows[] = {
      {"missing", [](const auto&) {}, "hello.glsl is missing"},
      {"link", [&](const auto& file) { std::filesystem::create_symlink(solution, file); },
       "hello.glsl is a symbolic link, which is not followed"},
      {"large", [](const auto& file) { write_file(file, std::string(1'000'001, ' ')); },
       "hello.glsl is larger than the limit of 1000000 bytes"},
      {"fifo", [](const auto& file) { REQUIRE(::mkfifo(file.c_str(), 0600) == 0); },
       "hello.glsl is a FIFO, not a regular file"},
  };
  for (const Row& row : rows) {
    const TemporaryFolder folder;
    write_hello(folder.path() / "ada", row.spoil);
    const std::filesystem::path out = folder.path() / "out";
    const Finished finished = run_atelier({"grade", (folder.path() / "ada").string(), "--out", out.string()});
    INFO(row.name << ": " << finished.output);
    REQUIRE(finished.exit_status == 0);
    const auto results = nlohmann::json::parse(read_file(out / "results.json"));
    REQUIRE(results["steps"].size() == 1);
    CHECK(results["steps"][0]["build_log"] == "");
    CHECK(results["notes"].size() == (row.name == std::string("missing") ? 0 : 1));
    for (const auto& c : results["steps"][0]["cases"]) {
      CHECK(c["status"] == "missing");
      CHECK(c["reason"].get<std::string>().starts_with(row.reason));
    }
    CHECK(!mentions(finished.output, {"compiler output"}));
    CHECK(mentions(finished.output, {fmt::format("these {} cases: missing", results["steps"][0]["cases"].size())}));
    for (const char* report : {"report.html", "junit.xml"}) CHECK(mentions(read_file(out / report), {row.reason}));
  }
}

TEST_CASE("an exception in a student's code fails only its case", "[bad-input]") {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "ada/01-transforms/transforms.cpp";
  std::filesystem::create_directory(folder.path() / "ada");
  std::filesystem::copy(folders().solutions() / "01-transforms", file.parent_path());
  std::string code = read_file(file);
  const auto throw_in = [&](const std::string& function, const std::string& what) {
    const std::size_t begin = code.find(function + "(");
    REQUIRE(begin != std::string::npos);
    code.insert(code.find("{\n", begin) + 2, "  if (true) throw " + what + ";\n");
  };
  throw_in("mat4 orthographic", "42");
  throw_in("mat3 normal_matrix", "std::out_of_range(\"no such row\")");
  write_file(file, "#include <stdexcept>\n" + code);
  const auto results = graded(folder.path() / "ada");
  INFO(results["steps"][0]["build_log"].get<std::string>());
  int passed = 0;
  for (const auto& c : results["steps"][0]["cases"]) {
    INFO(c["name"].get<std::string>() << ": " << c["reason"].get<std::string>());
    if (c["name"] == "orthographic") CHECK(c["reason"] == "int was thrown: 42");
    if (c["name"] == "normal-matrix") CHECK(c["reason"] == "std::out_of_range was thrown: no such row");
    if (c["name"] == "orthographic" || c["name"] == "normal-matrix") CHECK(c["status"] == "crashed");
    passed += c["status"] == "passed";
  }
  CHECK(passed > 10);
}

TEST_CASE("the reported driver is the one that draws, whatever the caller's environment", "[bad-input]") {
  const TemporaryFolder folder;
  const auto driver = [&](const char* settings) {
    const Finished finished =
        run_process({.arguments = {"sh", "-c",
                                   std::string("exec env ") + settings +
                                       " \"$0\" grade solutions --step 00 --json --out \"$1\" " + "2>/dev/null",
                                   (folders().build / "bin/atelier").string(), folder.path().string()},
                     .folder = folders().root});
    const auto results = nlohmann::json::parse(finished.output);
    CHECK(results["score"] == results["max_score"]);
    return results["environment"]["driver"].get<std::string>();
  };
  CHECK(driver("GALLIUM_DRIVER=softpipe MESA_GL_VERSION_OVERRIDE=4.6") == driver(""));
}

TEST_CASE("nothing is graded on a machine that cannot draw", "[bad-input]") {
  const TemporaryFolder folder;
  const auto out = folder.path() / "out";
  const Finished finished = run_process(
      {.arguments = {"env", "-u", "DISPLAY", "-u", "WAYLAND_DISPLAY", (folders().build / "bin/atelier").string(),
                     "grade", "solutions", "--step", "00", "--context", "window", "--out", out.string()},
       .folder = folders().root});
  CHECK(finished.exit_status == 2);
  CHECK(mentions(finished.output, {"error: this machine cannot draw, so nothing is graded: "}));
  CHECK_FALSE(std::filesystem::exists(out));
}

TEST_CASE("progress goes to stderr, and leaves the JSON on stdout as it is", "[bad-input]") {
  const TemporaryFolder folder;
  const std::string program = (folders().build / "bin/atelier").string(), out = folder.path().string();
  const auto shell = [&](const std::string& streams) {
    return run_process(
        {.arguments = {"sh", "-c", "exec \"$0\" grade solutions --step 00 --json --out \"$1\" " + streams, program,
                       out},
         .folder = folders().root});
  };
  const auto printed = nlohmann::json::parse(shell("2>/dev/null").output);
  CHECK(printed["score"] == printed["max_score"]);
  const std::string progress = shell("2>&1 >/dev/null").output;
  CHECK(mentions(progress, {"00-hello: ", "cases passed (step 1 of 1)\n"}));
  CHECK(std::count(progress.begin(), progress.end(), '\n') == 1);
}

TEST_CASE("a step's program refuses options without effect", "[bad-input]") {
  const TemporaryFolder empty;
  const std::string out = (empty.path() / "out.png").string(), film = (empty.path() / "out.mp4").string();
  const std::string turn = (empty.path() / "out.gif").string();
  struct Row {
    const char* step;
    std::vector<std::string> arguments;
    std::vector<std::string_view> says;
  };
  const Row rows[] = {
      {"00-hello", {"--out", out, "--eye", "0,1,2"}, {"00-hello has no camera", "--eye"}},
      {"00-hello", {"--record", turn, "--frames", "2"}, {"00-hello has no camera", "--record"}},
      {"00-hello", {"--out", out, "--set", "frame.samples=2"}, {"'frame.samples'", "'2'", "1, 4"}},
      {"00-hello", {"--out", out, "--set", "frame.format=srgb"}, {"'frame.format'", "'srgb'", "32f, 16f, 8"}},
      {"01-transforms", {"--out", out, "--set", "frame.supersampling=5"}, {"'frame.supersampling'", "5", "1..4"}},
      {"01-transforms", {"--record", turn, "--vary", "hall.segment=3..9"}, {"'hall.segment'", "hall.segments"}},
      {"01-transforms", {"--record", turn, "--vary", "hall.segments=2..9"}, {"'hall.segments'", "2", "3..4096"}},
      {"01-transforms",
       {"--record", turn, "--vary", "depth.format=16..24"},
       {"--vary depth.format=16..24", "numeric range"}},
      {"01-transforms", {"--out", out, "--frames", "2"}, {"--frames", "--record"}},
      {"01-transforms", {"--out", out, "--eye", "1,2,3", "--target", "1,2,3"}, {"--eye", "--target"}},
      {"01-transforms", {"--out", out, "--scene", "materials", "--eye", "0,0,0"}, {"--eye", "scene's camera looks"}},
      {"01-transforms", {"--out", out, "--scene", "materials", "--target", "0,0,8"}, {"--target", "camera stands"}},
      {"01-transforms", {"--out", out, "--implementations", ""}, {"--implementations", "no value"}},
      {"01-transforms", {"--record", film}, {"--record", ".gif", ".png, .bmp or .exr"}},
  };
  for (const Row& row : rows) {
    std::vector<std::string> arguments = {folders().program(row.step).string()};
    arguments.insert(arguments.end(), row.arguments.begin(), row.arguments.end());
    const Finished finished = run_process({.arguments = arguments});
    INFO(finished.output);
    CHECK(finished.exit_status == 2);
    CHECK(finished.output.starts_with("error: "));
    for (std::string_view word : row.says) CHECK(mentions(finished.output, {word}));
    CHECK(std::count(finished.output.begin(), finished.output.end(), '\n') == 1);
    CHECK(std::filesystem::is_empty(empty.path()));
  }
}

TEST_CASE("Ctrl-C leaves nothing in the system's temporary folder", "[bad-input]") {
  const TemporaryFolder empty;
  const std::filesystem::path temporary = empty.path() / "tmp";
  std::filesystem::create_directory(temporary);
  // As from a terminal: the shell that made the folder asks all its children to stop once there is something to lose.
  const std::string script = fmt::format(
      "set -m; export TMPDIR='{0}'; '{1}' grade '{2}' --out '{0}/../out' & "
      "while kill -0 $! 2>/dev/null && ! ls '{0}'/atelier-run* >/dev/null 2>&1; do sleep 0.02; done; "
      "kill -INT -- -$!; wait $!; echo status $?",
      temporary.string(), (folders().build / "bin" / "atelier").string(), folders().solutions().string());
  const Finished finished = run_process({.arguments = {"bash", "-c", script}});
  INFO(finished.output);
  CHECK(finished.output.find("status 130") != std::string::npos);  // 128 and SIGINT: what ended it
  CHECK(std::filesystem::is_empty(temporary));
}

TEST_CASE("results are written before output, and a closed pipe is harmless", "[bad-input]") {
  const TemporaryFolder folder;
  const std::string program = (folders().build / "bin/atelier").string(), out = folder.path().string();
  for (const char* const listener : {"| true", ">/dev/full"}) {
    INFO(listener);
    std::filesystem::remove_all(folder.path() / "results.json");
    run_process(
        {.arguments = {"sh", "-c", std::string("\"$0\" grade solutions --step 00 --out \"$1\" 2>/dev/null ") + listener,
                       program, out},
         .folder = folders().root});
    const auto results = nlohmann::json::parse(read_file(folder.path() / "results.json"));
    CHECK(results["steps"].size() == 1);
  }
}

TEST_CASE("a student's library that deletes itself is not replaced by the solution", "[bad-input]") {
  const TemporaryFolder folder;
  const auto copy = std::filesystem::copy_options::recursive;
  std::filesystem::create_directories(folder.path() / "ada");
  std::filesystem::copy(folders().root / "steps/01-transforms", folder.path() / "ada/01-transforms", copy);
  const auto file = folder.path() / "ada/01-transforms/transforms.cpp";
  std::string code = "#include <cstdlib>\n" + read_file(file);
  const std::size_t begin = code.find("mat4 translation(");
  REQUIRE(begin != std::string::npos);
  code.insert(code.find("{\n", begin) + 2, "  std::abort();  // whoever begins again finds no library\n");
  code += R"(
#include <cstdio>
#include <cstring>
static const bool gone = [] {
  char line[4096];
  std::FILE* maps = std::fopen("/proc/self/maps", "r");
  while (maps && std::fgets(line, sizeof line, maps)) {
    char* path = std::strchr(line, '/');
    if (!path || !std::strstr(path, "/libraries/01-transforms/libstep.so")) continue;
    *std::strchr(path, '\n') = '\0';
    std::remove(path);
  }
  return true;
}();
)";
  write_file(file, code);
  const auto results = graded(folder.path() / "ada");
  INFO(results["steps"][0]["build_log"].get<std::string>());
  CHECK(results["score"] == 0);
  CHECK(std::none_of(results["steps"][0]["cases"].begin(), results["steps"][0]["cases"].end(),
                     [](const auto& c) { return c["status"] == "passed"; }));
}
