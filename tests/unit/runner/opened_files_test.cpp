// What a compiler opens decides, however a text is written.
#include "judge/run/opened_files.hpp"

#include "catch.hpp"
#include "tiny_course.hpp"
#include "words.hpp"

namespace {

using namespace atelier;
using namespace std::string_literals;
using test::Course;

/// Builds with this text before that of sum.cpp.
judge::Built built_with(const std::string& text) {
  Course course;
  course.write("sum.cpp", text + "#include \"90-sums/sums.hpp\"\nint sum(int a, int b) { return a + b; }\n");
  return course.build();
}

}  // namespace

TEST_CASE("a header that is not allowed is refused, however its include is written") {
  // GCC opens <thread> in all of these. Not all are found by our own reading of the text.
  for (const std::string& text : {"int a;\r#include <thread>\nint b;\n"s,
                                  "\r#include <thread>\n"s,
                                  "\v#include <thread>\n"s,
                                  "\f#include <thread>\n"s,
                                  "\0#include <thread>\n"s,
                                  "#\0include <thread>\n"s,
                                  "#include\0<thread>\n"s,
                                  "#inc\\\rlude <thread>\n"s,
                                  "#inc\\\r\nlude <thread>\n"s,
                                  "/* *\\\n/ #include <thread>\n"s,
                                  "\x1a\n#include <thread>\n"s,
                                  "#define xR \"(\n#include <thread>\n// )\"\n"s,
                                  "int n = 0'a';\n#include <thread>\n"s,
                                  "#inc\\\v\nlude <thread>\n"s,
                                  "#inc\\\f\nlude <thread>\n"s,
                                  "#inc\\\0\nlude <thread>\n"s,
                                  "#if 0\n'\n#endif\n#include <thread>\n"s,
                                  "#if 0\n\"\n#endif\n#include <thread>\n"s,
                                  "#define H <thread>\n#include H\n"s,
                                  "#include <../12/thread>\n"s,
                                  "#include_next <thread>\n"s,
                                  "#import <thread>\n"s,
                                  "%:include <thread>\n"s,
                                  "#include <glm/gtc/matrix_transform.hpp>\n"s}) {
    INFO(text);
    const judge::Built built = built_with(text);
    INFO(built.log);
    CHECK_FALSE(built.ok);
  }
}

TEST_CASE("no message shows a line of a file that may not be opened") {
  Course course;
  const std::filesystem::path secret = course.folder.path() / "secret.txt";
  write_file(secret, "int the_reference = 12345;\n");
  for (const std::string& text : {
           "#line 1 \"" + secret.string() + "\"\nint sum(int\n",
           "# 1 \"" + secret.string() + "\"\nint sum(int\n",
           "\r#include \"" + secret.string() + "\"\nint sum(int\n",
           "\r#include \"" + secret.string() + "\"\n#error no\n",
           "\v#include \"" + secret.string() + "\"\nint the_reference;\n",
           "\r#include \"" + secret.string() + "\"\n#include \"no-such-file.hpp\"\n",
       }) {
    INFO(text);
    course.write("sum.cpp", text);
    const judge::Built built = course.build();
    INFO(built.log);
    CHECK_FALSE(built.ok);
    CHECK_FALSE(built.log.empty());
    CHECK(built.log.find("12345") == std::string::npos);
  }
  course.write("sum.cpp", "#line 1 \"" + secret.string() + "\"\nint sum(int\n");
  CHECK(has_all(course.build().log, {"sum.cpp: a #line names", "secret.txt", "not allowed in a step"}));
  course.write("sum.cpp", "\r#include \"" + secret.string() + "\"\n");
  CHECK(has_all(course.build().log, {"secret.txt"}));
}

TEST_CASE("what is allowed stays so in any form") {
  for (const std::string& text :
       {"#include <vector>\r\n#include <map>\r\n"s, "#define _GLIBCXX_DEBUG\n#include <vector>\n#include <map>\n"s,
        "#include <regex>\n#include <random>\n#include <iostream>\n"s, "#line 100\n"s, "#line 7 \"sum.cpp\"\n"s,
        "#include <glm/glm.hpp>\n"s, "#include \"sums.hpp\"\n"s,
        "#if __has_include(<thread>)\n#define HAS 1\n#endif\n"s,
        "const char* text = R\"(\n#line 1\n#include <thread>\n)\";\n"s, "#define NDEBUG\n#include <cassert>\n"s,
        "#define _USE_MATH_DEFINES\n#include <cmath>\n#include <numbers>\n"s,
        "// a comment \\\n#include <thread>\n"s}) {
    INFO(text);
    const judge::Built built = built_with(text);
    INFO(built.log);
    CHECK(built.ok);
  }
}
