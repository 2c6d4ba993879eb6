#include "cli/student/function_text.hpp"

#include "catch.hpp"

using namespace atelier;

TEST_CASE("a function is found by its name and its brackets") {
  struct Row {
    const char *name, *text;
    int line;
    const char* found;  ///< nullptr: nothing
  };
  const Row rows[] = {
      {"the only one", "int f() {\n  return 1;\n}\n", 1, "int f() {\n  return 1;\n}\n"},
      {"behind another", "int g() { return 2; }\nint f() { return 1; }\n", 2, "int f() { return 1; }\n"},
      {"in a namespace", "namespace a {\n\nint f(int x) {\n  if (x) { return 1; }\n  return 0;\n}\n\n}\n", 3,
       "int f(int x) {\n  if (x) { return 1; }\n  return 0;\n}\n"},
      {"after a declaration and a call", "int f(int);\nint g() { return f(1); }\nint f(int x) { return x; }\n", 3,
       "int f(int x) { return x; }\n"},
      {"no part of another name", "int f2() { return 2; }\nint of() { return 3; }\nint f() { return 1; }\n", 3,
       "int f() { return 1; }\n"},
      {"a bracket in a comment", "int f() {  // {\n  return 1; /* { */\n}\nint g;\n", 1,
       "int f() {  // {\n  return 1; /* { */\n}\n"},
      {"a bracket in a text", "int f() {\n  throw g(\"a } \\\" {\", '}');\n}\nint h;\n", 1,
       "int f() {\n  throw g(\"a } \\\" {\", '}');\n}\n"},
      {"parameters in lines", "int f(int a,\n      int b)\n{\n  return 1;\n}\n", 1,
       "int f(int a,\n      int b)\n{\n  return 1;\n}\n"},
      {"the last line without its end", "int f() {}", 1, "int f() {}\n"},
      {"a name in a comment", "// f() {}\nint g;\n", 1, nullptr},
      {"a bracket that is not closed", "int f() {\n", 1, nullptr},
      {"nothing", "", 1, nullptr},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    const auto found = find_function(row.text, "f");
    REQUIRE(found.has_value() == (row.found != nullptr));
    if (!found) continue;
    CHECK(found->text == row.found);
    CHECK(found->line == row.line);
  }
}
