// Drivers' logs, in the formats of Mesa 22.3, NVIDIA 535 and Apple's and ANGLE's compilers.
#include "catch.hpp"
#include "gl/shader.hpp"

using namespace atelier;

namespace {

/// #version, main.glsl's lines 1 and 2, all of 02/lit.glsl, and the rest of main.glsl: 12 lines.
ShaderSource two_files() {
  ShaderSource source{.lines = {{-1, 1}, {0, 1}, {0, 2}}, .names = {"main.glsl", "02/lit.glsl"}};
  for (std::size_t line = 1; line <= 7; ++line) source.lines.push_back({1, line});
  source.lines.insert(source.lines.end(), {{0, 4}, {0, 5}});
  return source;
}

}  // namespace

TEST_CASE("Each driver's log becomes file, line and message") {
  struct Row {
    const char *name, *log, *translated;
  };
  const Row rows[] = {
      {"Mesa", "0:11(5): error: `x' undeclared\n", "main.glsl:4: error: `x' undeclared"},
      {"Mesa, included file", "0:6(15): warning: `n' used uninitialized\n",
       "02/lit.glsl:3: warning: `n' used uninitialized"},
      {"NVIDIA", "0(10) : error C1503: undefined variable \"x\"\n",
       "02/lit.glsl:7: error C1503: undefined variable \"x\""},
      {"Apple", "ERROR: 0:3: Use of undeclared identifier 'x'\n",
       "main.glsl:2: error: Use of undeclared identifier 'x'"},
      {"ANGLE", "ERROR: 0:7: 'x' : undeclared identifier\n", "02/lit.glsl:4: error: 'x' : undeclared identifier"},
      {"warning", "WARNING: 0:12: 'y' : unused\n", "main.glsl:5: warning: 'y' : unused"},
      {"in the defines", "0:1(9): error: illegal\n", "(defines):1: error: illegal"},
      {"Windows line ends and null", "0:2(1): error: a\r\n0:3(1): error: b\r\n",
       "main.glsl:1: error: a\nmain.glsl:2: error: b"},
      {"repeats", "0:2(1): error: a\n0:3(1): error: b\n0:2(9): error: a\n\n",
       "main.glsl:1: error: a\nmain.glsl:2: error: b"},
      {"a linker's message", "error: vertex shader lacks `main'\n", "error: vertex shader lacks `main'"},
      {"a message with numbers", "limit 3:4 reached\n", "limit 3:4 reached"},
      {"past the end", "0:99(1): error: unexpected end\n", "main.glsl:5: error: unexpected end"},
      {"line zero", "0:0(0): error: a\n", "(defines):1: error: a"},
      {"empty", "", ""},
      {"blank", "\n \n\r\n", ""},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    CHECK(translate_shader_log(row.log, two_files()) == row.translated);
  }
}

TEST_CASE("a name that is defined twice: the message says where else") {
  ShaderSource source = two_files();
  source.text =
      "#version 330 core\n"
      "const float PI = 3.14159265;\n"
      "\n"
      "// PI, once more\n"
      "float half_turn() {\n"
      "  float turn = PI;\n"
      "  return turn;\n"
      "}\n"
      "const float PI = 3.1416;\n"
      "float turn = 1.0;\n"
      "float turn() { return PI; }\n"
      "\n";
  const auto said = [&](const char* log) { return translate_shader_log(log, source); };
  CHECK(said("0:9(13): error: `PI' redeclared\n") ==
        "02/lit.glsl:6: error: `PI' redeclared (also in main.glsl:1: both are parts of one shader, so rename yours)");
  CHECK(said("ERROR: 0:11: 'turn' : redefinition\n") ==
        "main.glsl:4: error: 'turn' : redefinition (also in 02/lit.glsl:7: both are parts of one shader, so rename "
        "yours)");
  CHECK(said("0:9(13): error: `PI' undeclared\n") == "02/lit.glsl:6: error: `PI' undeclared");
  CHECK(said("0:2(13): error: `PI' redeclared\n") == "main.glsl:1: error: `PI' redeclared");  // nothing before it
}

TEST_CASE("A very long log is truncated") {
  std::string log;
  for (int message = 1; message <= 1000; ++message) log += "0:2(1): error: x" + std::to_string(message) + "\n";
  const std::string translated = translate_shader_log(log, two_files());
  CHECK(translated.find("main.glsl:1: error: x30\n(970 lines more)") != std::string::npos);
  CHECK(translated.find("x31") == std::string::npos);
}
