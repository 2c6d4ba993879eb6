#include "cli/author/marked_text.hpp"

#include "catch.hpp"

using namespace atelier;
using atelier::test::error_of;
using atelier::test::mentions;

TEST_CASE("a skeleton is the solution without its marked parts") {
  struct Row {
    const char *name, *marked, *skeleton;
  };
  const Row rows[] = {
      {"no marks", "int a;\n", "int a;\n"},
      {"nothing", "", ""},
      {"a part that leaves nothing", "{\n  // >>> student: add\n  a += b;\n  // <<< student\n}\n",
       "{\n  // TODO(01-x): add\n}\n"},
      {"a stand-in", "  // >>> student: add\n  return a + b;\n  // --- skeleton\n  // | return a;\n  // <<< student\n",
       "  // TODO(01-x): add\n  return a;\n"},
      {"the stand-in's own indentation", "// >>> student: t\nx;\n// --- skeleton\n  // |   y;\n// <<< student\n",
       "// TODO(01-x): t\n    y;\n"},
      {"an empty line in the stand-in", "// >>> student: t\n// --- skeleton\n// | a;\n// |\n// | b;\n// <<< student\n",
       "// TODO(01-x): t\na;\n\nb;\n"},
      {"two blocks", "// >>> student: s\na;\n// <<< student\nb;\n// >>> student: t\nc;\n// <<< student\n",
       "// TODO(01-x): s\nb;\n// TODO(01-x): t\n"},
      {"a last line without its end", "// >>> student: s\na;\n// <<< student\nb;", "// TODO(01-x): s\nb;\n"},
      {"shifts are no marks", "x = a >> b << c; // shifts >>> and <<<\n", "x = a >> b << c; // shifts >>> and <<<\n"},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    CHECK(cut_skeleton(row.marked, "x.cpp", "01-x") == row.skeleton);
  }
}

TEST_CASE("broken marks are refused with their line") {
  struct Row {
    const char *name, *marked, *where, *why;
  };
  const Row rows[] = {
      {"not closed", "a;\n// >>> student: t\nb;\n", "x.cpp:2", "not closed"},
      {"not open", "a;\n// <<< student\n", "x.cpp:2", "not open"},
      {"nested", "// >>> student: s\n// >>> student: t\n// <<< student\n", "x.cpp:2", "line 1"},
      {"no task", "// >>> student:\n// <<< student\n", "x.cpp:1", "task is missing"},
      {"misspelt open", "// >>> Student: t\n", "x.cpp:1", "is not a mark"},
      {"misspelt close", "// >>> student: t\nb;\n// <<< students\n", "x.cpp:3", "is not a mark"},
      {"stand-in outside", "// --- skeleton\n", "x.cpp:1", "is not a mark"},
      {"stand-in twice", "// >>> student: t\n// --- skeleton\n// --- skeleton\n// <<< student\n", "x.cpp:3",
       "is not a mark"},
      {"code in the stand-in", "// >>> student: t\n// --- skeleton\nreturn;\n// <<< student\n", "x.cpp:3", "// |"},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    CHECK(mentions(error_of([&] { cut_skeleton(row.marked, "x.cpp", "01-x"); }), {row.where, row.why}));
  }
}

TEST_CASE("the finished text has neither marks nor the skeleton's lines") {
  CHECK(finished_text("{\n  // >>> student: add\n  a + b;\n  // --- skeleton\n  // | a;\n  // <<< student\n}\n",
                      "x.cpp") == "{\n  a + b;\n}\n");
  CHECK(finished_text("int a;\n", "x.cpp") == "int a;\n");
}

TEST_CASE("tasks are counted") {
  CHECK(count_tasks("int a;\n", "x.cpp") == 0);
  CHECK(count_tasks("// >>> student: s\n// <<< student\n// >>> student: t\n// <<< student\n", "x.cpp") == 2);
}

TEST_CASE("the lines of a solution are those that the skeleton leaves out") {
  const char* const marked =
      "a;\n  // >>> student: s\n  b;\n\n  c;\n  // --- skeleton\n  // | d;\n  // <<< student\ne;\n";
  CHECK(solution_lines(marked, "x.cpp") == std::vector<std::string>{"b;", "", "c;"});
  CHECK(solution_lines("a;\n", "x.cpp").empty());
}
