// Building a student's files: results, refused input, and no repeated work.
#include "judge/run/build.hpp"

#include <dlfcn.h>
#include <sys/stat.h>

#include <functional>

#include "base/file.hpp"
#include "base/process.hpp"
#include "catch.hpp"
#include "judge/run/build_record.hpp"
#include "tiny_course.hpp"
#include "words.hpp"

using namespace atelier;
using namespace atelier::judge;
using namespace std::chrono_literals;
using test::Course;
using test::error_of;
namespace fs = std::filesystem;

namespace {

/// What sum(2, 3) of a built library returns.
int call_sum(const fs::path& library) {
  // By a copy of its own name: the loader would answer with the library that it has.
  static int copies = 0;
  const fs::path copy = library.parent_path() / ("copy" + std::to_string(++copies) + ".so");
  fs::copy_file(library, copy);
  void* handle = ::dlopen(copy.c_str(), RTLD_NOW | RTLD_LOCAL);
  REQUIRE(handle != nullptr);
  const auto sum = reinterpret_cast<int (*)(int, int)>(::dlsym(handle, "sum"));
  REQUIRE(sum != nullptr);
  const int result = sum(2, 3);
  ::dlclose(handle);
  return result;
}

}  // namespace

TEST_CASE("a student's files become a library, and only what changed is built again") {
  Course course;
  const Built first = course.build();
  INFO(first.log);
  REQUIRE(first.ok);
  CHECK(first.fresh);
  CHECK(first.log.empty());
  CHECK(call_sum(course.library) == 5);

  const Built again = course.build();
  CHECK(again.ok);
  CHECK(!again.fresh);

  struct Row {
    std::string name;
    std::function<void()> change;
    bool fresh;
    int sum;
  };
  const auto write_sum = [&](const std::string& body) {
    course.write("sum.cpp", "#include \"90-sums/sums.hpp\"\nint sum(int a, int b) { return " + body + "; }\n");
  };
  const std::vector<Row> rows = {
      {"the source", [&] { write_sum("a - b"); }, true, -1},
      {"the contract by its short name",
       [&] { course.write("sum.cpp", "#include \"sums.hpp\"\nint sum(int a, int b) { return a + b + ONE; }\n"); }, true,
       6},
      {"the source again", [&] { write_sum("a - b"); }, true, -1},
      {"nothing, but saved anew", [&] { write_sum("a - b"); }, false, -1},
      {"an older copy of the source",
       [&] {
         write_sum("a * b + ONE");
         fs::last_write_time(course.student / "sum.cpp", fs::file_time_type::clock::now() - std::chrono::hours(24));
       },
       true, 7},
      {"a header",
       [&] {
         write_file(course.given / "90-sums/sums.hpp",
                    "#pragma once\nextern \"C\" int sum(int a, int b);\n#define ONE 4\n");
       },
       true, 10},
      {"a flag", [&] { course.flags.compile.push_back("-O1"); }, true, 10},
      {"a link flag", [&] { course.flags.link.push_back("-Wl,-O1"); }, true, 10},
      {"a shader", [&] { course.write("sums.glsl", "// other\n"); }, false, 10},
      {"a file that is not listed", [&] { course.write("more.cpp", "#error not taken\n"); }, false, 10},
      {"the library taken away", [&] { fs::remove(course.library); }, true, 10},
      {"an object taken away", [&] { fs::remove(course.out / "90-sums/objects/sum.cpp.o"); }, true, 10},
      {"a record that cannot be read",
       [&] { write_file(course.out / "90-sums/objects/sum.cpp.o.record", "{\"command\": 3"); }, true, 10},
      {"an empty record", [&] { write_file(course.out / "90-sums/objects/sum.cpp.o.record", "{}"); }, true, 10},
  };
  for (const Row& row : rows) {
    INFO("changed: " << row.name);
    row.change();
    // A header written within the clock tick in which the compiler starts counts as edited meanwhile; ask twice.
    const Built built = course.build();
    INFO(built.log);
    CHECK(built.ok);
    CHECK(built.fresh == row.fresh);
    CHECK(call_sum(course.library) == row.sum);
    course.build();
    CHECK(!course.build().fresh);
  }
}

TEST_CASE("a new precompiled header causes a rebuild") {
  Course course;
  const std::string prelude = (course.folder.path() / "prelude.hpp").string();
  std::vector<std::string> command = {course.flags.compiler};
  command.insert(command.end(), course.flags.compile.begin(), course.flags.compile.end());
  command.insert(command.end(), {"-x", "c++-header", prelude, "-o", prelude + ".gch"});
  const auto precompile = [&](const std::string& text) {
    write_file(prelude, text);
    REQUIRE(run_process({.arguments = command}).ok());
  };
  precompile("#include <vector>\n#define TWO 2\n");
  course.flags.compile.insert(course.flags.compile.end(), {"-include", prelude});
  course.write("sum.cpp", "#include \"sums.hpp\"\nint sum(int a, int b) { return a + b + TWO; }\n");
  REQUIRE(course.build().ok);
  CHECK(call_sum(course.library) == 7);
  CHECK(!course.build().fresh);

  precompile("#include <vector>\n#include <array>\n#define TWO 3\n");
  CHECK(course.build().fresh);
  CHECK(call_sum(course.library) == 8);
}

TEST_CASE("a build with nothing to do repeats the warnings") {
  Course course;
  course.write("product.cpp", "extern \"C\" int product(int a, int b) { int unused; return a * b; }\n");
  const Built first = course.build(), again = course.build();
  CHECK(first.ok);
  CHECK(has_all(first.log, {"product.cpp:1:", "unused"}));
  CHECK(!again.fresh);
  CHECK(again.log == first.log);
}

TEST_CASE("a failed build leaves no library, and reports why") {
  struct Row {
    std::string name;
    std::function<void(Course&)> spoil;
    Words words;
  };
  const std::vector<Row> rows = {
      {"an error", [](Course& c) { c.write("sum.cpp", "int sum(\n"); }, {"sum.cpp:1:", "error"}},
      {"two errors",
       [](Course& c) { c.write("sum.cpp", "x\n"), c.write("product.cpp", "y\n"); },
       {"sum.cpp:1:", "product.cpp:1:"}},
      {"a short cut",
       [](Course& c) { c.write("sum.cpp", "\n#include <glm/gtc/matrix_transform.hpp>\n"); },
       {"sum.cpp:2: #include <glm/gtc/matrix_transform.hpp>", "look_at"}},
      {"a file missing", [](Course& c) { fs::remove(c.student / "product.cpp"); }, {"product.cpp is missing"}},
      {"a shader missing", [](Course& c) { fs::remove(c.student / "sums.glsl"); }, {"sums.glsl is missing"}},
      {"no folder", [](Course& c) { fs::remove_all(c.student); }, {"sum.cpp is missing", "sums.glsl is missing"}},
      {"a link",
       [](Course& c) {
         fs::rename(c.student / "sum.cpp", c.student / "real.cpp");
         fs::create_symlink("real.cpp", c.student / "sum.cpp");
       },
       {"sum.cpp is a symbolic link, which is not followed"}},
      {"a folder",
       [](Course& c) {
         fs::remove(c.student / "sum.cpp");
         fs::create_directory(c.student / "sum.cpp");
       },
       {"sum.cpp is a folder, not a regular file"}},
      {"a huge file",
       [](Course& c) { c.write("sum.cpp", std::string(source_limit + 1, ' ')); },
       {"sum.cpp is larger than the limit of 1000000 bytes"}},
      {"a huge shader",
       [](Course& c) { fs::resize_file(c.student / "sums.glsl", std::uintmax_t(1) << 40); },
       {"sums.glsl is larger than"}},
      {"a FIFO",
       [](Course& c) {
         fs::remove(c.student / "sum.cpp");
         REQUIRE(::mkfifo((c.student / "sum.cpp").c_str(), 0600) == 0);
       },
       {"sum.cpp is a FIFO, not a regular file"}},
      {"a flood of errors",
       [](Course& c) {
         std::string text;
         for (int i = 0; i < 2000; ++i) text += "int x = undeclared_" + std::to_string(i) + ";\n";
         // Two floods: one alone is cut short where the compiler is run.
         c.write("sum.cpp", text), c.write("product.cpp", text);
       },
       {"sum.cpp:1:"}},
      {"the link fails", [](Course& c) { c.flags.link.push_back("-lno-such-library"); }, {"no-such-library"}},
      {"defined twice",
       [](Course& c) { c.write("product.cpp", "extern \"C\" int sum(int, int) { return 0; }\n"); },
       {"sum"}},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    Course course;
    REQUIRE(course.build().ok);
    row.spoil(course);
    const Built built = course.build();
    INFO(built.log);
    CHECK(!built.ok);
    CHECK(has_all(built.log, row.words));
    CHECK(built.log.size() <= log_limit);
    CHECK(!fs::exists(course.library));
  }
}

TEST_CASE("a compiler that takes too long is killed") {
  Course course;
  // 2^40 instances are asked for: without an end for any compiler.
  course.write("sum.cpp",
               "template <int depth, long path> struct Tree {\n"
               "  static constexpr long n = Tree<depth - 1, path * 2>::n + Tree<depth - 1, path * 2 + 1>::n;\n"
               "};\n"
               "template <long path> struct Tree<0, path> { static constexpr long n = 1; };\n"
               "extern \"C\" long sum(int, int) { return Tree<40, 1>::n; }\n");
  const Built built = build_step(course.flags, "90-sums", course.student, course.out, {.time_limit = 1s});
  CHECK(!built.ok);
  CHECK(has_all(built.log, {"sum.cpp: took longer than 1 s"}));
}

TEST_CASE("a step is built without its choices, but with no unusable ones") {
  Course course;
  course.flags.files["90-sums"].push_back("choices.txt");
  CHECK(course.build().ok);
  const fs::path taken = course.folder.path() / "taken";
  CHECK(take_step_files(course.flags, "90-sums", course.student, taken).empty());
  CHECK(fs::exists(taken / "sum.cpp"));
  CHECK_FALSE(fs::exists(taken / "choices.txt"));
  fs::create_directory(course.student / "choices.txt");
  CHECK_FALSE(course.build().ok);
  CHECK(take_step_files(course.flags, "90-sums", course.student, taken).contains("choices.txt"));
}

TEST_CASE("a step without C++ needs no library") {
  Course course;
  course.write("only.glsl", "// a shader\n");
  const Built built = build_step(course.flags, "91-shader", course.student, course.out);
  CHECK(built.ok);
  CHECK(!fs::exists(course.out / "91-shader" / "libstep.so"));
  CHECK(has_all(error_of([&] { build_step(course.flags, "90-sum", course.student, course.out); }),
                {"90-sum", "90-sums"}));
  CHECK(has_all(error_of([&] { build_step(course.flags, "90-sums", course.student, "/dev/null/out"); }),
                {"/dev/null/out"}));
}

TEST_CASE("only the listed files of a submission are used") {
  Course course;
  course.write("CMakeLists.txt", "message(FATAL_ERROR)\n");
  course.write("more.cpp", "");
  fs::remove(course.student / "sums.glsl");
  fs::create_symlink("/etc/passwd", course.student / "sums.glsl");
  const fs::path taken = course.folder.path() / "taken";
  const UnusableFiles left = take_step_files(course.flags, "90-sums", course.student, taken);
  CHECK(left == UnusableFiles{{"sums.glsl", "is a symbolic link, which is not followed"}});
  std::vector<std::string> names;
  for (const auto& file : fs::directory_iterator(taken)) names.push_back(file.path().filename());
  std::sort(names.begin(), names.end());
  CHECK(names == std::vector<std::string>{"product.cpp", "sum.cpp"});
}

TEST_CASE("the flags that CMake wrote are read strictly") {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "step_flags.json";
  const std::string good = R"({"compiler": "g++", "compile": ["-O2"], "link": [],
                               "files": {"01-a": ["a.cpp"]}, "headers": {"01-a": ["01-a/a.hpp"]},
                               "uses": {"01-a": []}, "titles": {"01-a": "A"}, "compiler_version": "GNU 12"})";
  write_file(file, good);
  const StepFlags flags = read_step_flags(file);
  CHECK(flags.compiler == "g++");
  CHECK(flags.compile == std::vector<std::string>{"-O2"});
  CHECK(flags.files.at("01-a") == std::vector<std::string>{"a.cpp"});
  CHECK(flags.headers.at("01-a") == std::vector<std::string>{"01-a/a.hpp"});

  struct Row {
    std::string from, to;
    Words words;
  };
  const std::vector<Row> rows = {
      {"\"compiler\"", "\"compliler\"", {"compliler", "compiler"}},
      {"\"g++\"", "7", {"compiler", "7"}},
      {"[\"-O2\"]", "\"-O2\"", {"compile", "list"}},
      {"\"-O2\"", "2", {"compile", "2"}},
      {"\"link\": [],", "", {"link"}},
      {"{\"01-a\": [\"a.cpp\"]}", "[]", {"files"}},
      {"a.cpp", "../a.cpp", {"files", "01-a", "../a.cpp"}},
      {"a.cpp", "/a.cpp", {"files", "/a.cpp"}},
      {"a.cpp", "-a.cpp", {"files", "-a.cpp"}},
      {"{\"01-a\": \"A\"}", "3", {"titles", "3"}},
      {"{", "", {"step_flags.json"}},
  };
  for (const Row& row : rows) {
    INFO(row.from << " -> " << row.to);
    std::string text = good;
    write_file(file, text.replace(text.find(row.from), row.from.size(), row.to));
    const std::string error = error_of([&] { read_step_flags(file); });
    INFO(error);
    CHECK(has_all(error, {"step_flags.json"}));
    CHECK(has_all(error, row.words));
  }
}

TEST_CASE("dependency files are read as make reads them") {
  struct Row {
    const char* text;
    std::vector<std::string> paths;
  };
  const std::vector<Row> rows = {
      {"a.o: a.cpp\n", {"a.cpp"}},
      {"/x/a\\ b.o: a.cpp /y/h.hpp \\\n  /z/i.hpp\n", {"a.cpp", "/y/h.hpp", "/z/i.hpp"}},
      {"a.o: my\\ file.cpp c$$.hpp d\\#.hpp e\\f.hpp\n", {"my file.cpp", "c$.hpp", "d#.hpp", "e\\f.hpp"}},
      {"a.o:\n", {}},
      {"", {}},
  };
  const TemporaryFolder folder;
  for (const Row& row : rows) {
    INFO(row.text);
    write_file(folder.path() / "x.d", row.text);
    CHECK(read_dependencies(folder.path() / "x.d") == row.paths);
  }
}
