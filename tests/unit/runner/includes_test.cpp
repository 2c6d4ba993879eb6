// The includes that are found in a source text, and those that a step may use.
#include "judge/run/includes.hpp"

#include "catch.hpp"
#include "words.hpp"

using namespace atelier::judge;

namespace {

/// "3 <cmath>; 5 "x.hpp"" of all includes.
std::string listed(std::string_view source) {
  std::string text;
  for (const Include& include : find_includes(source))
    text += (text.empty() ? "" : "; ") + std::to_string(include.line) + " " + include.target;
  return text;
}

}  // namespace

TEST_CASE("includes are found as by a compiler") {
  struct Row {
    const char *name, *source, *expected;
  };
  const std::vector<Row> rows = {
      {"none", "int f() { return 1; }\n", ""},
      {"empty file", "", ""},
      {"plain", "#include <cmath>\n#include \"a/b.hpp\"\n", "1 <cmath>; 2 \"a/b.hpp\""},
      {"no last line end", "#include <cmath>", "1 <cmath>"},
      {"a byte-order mark", "\xEF\xBB\xBF#include <thread>\n", "1 <thread>"},
      {"CRLF", "#include <cmath>\r\n#include <vector>\r\n", "1 <cmath>; 2 <vector>"},
      {"blanks", "\n  \t#  include\t<cmath>   // why\n", "2 <cmath>"},
      {"no blank", "#include<cmath>\n#include\"x.hpp\"", "1 <cmath>; 2 \"x.hpp\""},
      {"comments between", "/* a */ # /* b */ include /* c */ <cmath> /* d */\n", "1 <cmath>"},
      {"a comment of many lines before", "/*\n*/ #include <cmath>\n", "2 <cmath>"},
      {"a comment of many lines within", "#include /*\n*/ <cmath>\n", "1 <cmath>"},
      {"a comment of many lines behind", "#include <cmath> /*\n#include <no>\n*/ int x;\n#include <vector>",
       "1 <cmath>; 4 <vector>"},
      {"spliced lines", "#inc\\\nlude <cm\\\nath>\n#include <vector>", "1 <cmath>; 4 <vector>"},
      {"spliced with blanks", "#inc\\  \nlude <cmath>", "1 <cmath>"},
      {"a spliced line comment", "// text \\\n#include <no>\n#include <cmath>", "3 <cmath>"},
      {"digraph", "%:include <cmath>", "1 <cmath>"},
      {"macro", "#define H <cmath>\n#include H  // two\n", "2 H"},
      {"other words", "#include_next <cmath>\n#import <a>\n#embed <b>\n#pragma once\n#define include <no>",
       "1 <cmath>; 2 <a>; 3 <b>"},
      {"without a header", "#include\n#include <cmath>", "1 ; 2 <cmath>"},
      {"unclosed", "#include <cmath\n#include \"x", "1 <cmath; 2 \"x"},
      {"not at the begin", "int x; #include <no>\n", ""},
      {"commented out", "//#include <no>\n/* #include <no>\n#include <no> */\n", ""},
      {"an endless comment", "/* #include <no>\n", ""},
      {"in a string", "const char* s = \"\\\n#include <no>\";\n#include <cmath>", "3 <cmath>"},
      {"in a raw string", "auto s = R\"x(\n#include <no>\n)\" )x\";\n#include <cmath>", "4 <cmath>"},
      {"a comment mark in a string", "auto s = \"/*\"; auto c = '\"'; auto d = '\\''; // \"\n#include <cmath>",
       "2 <cmath>"},
      {"an escaped quote", "auto s = \"\\\"/*\";\n#include <cmath>", "2 <cmath>"},
      {"a splice does not end a raw string", "auto s = R\"( )\\\n\" /* )\";\n#include <cmath>\n/* */", "3 <cmath>"},
      {"a prefix that is none", "auto s = éR\"( \" ;\n#include <cmath>\n// )\"", "2 <cmath>"},
      {"a number before a string", "auto n = 1e+R\"(\";\n#include <cmath>\n// )\"", "2 <cmath>"},
      {"digit separators", "int n = 1'000'000; int m = 0x1'F;\n#include <cmath>", "2 <cmath>"},
      {"an apostrophe in a directive", "#error don't\n#include <cmath>", "2 <cmath>"},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    CHECK(listed(row.source) == row.expected);
  }
}

TEST_CASE("text that is not C++ is read to its end") {
  for (const std::string& source : {std::string(10, '\0') + "\n#include <cmath>", std::string("R\""), std::string("\\"),
                                    std::string("\\\n"), std::string("R\"("), std::string("'"),
                                    std::string("\xff\xfe#"), std::string(100'000, '/'), std::string(100'000, '\\')}) {
    INFO(source.substr(0, 20));
    CHECK(find_includes(source).size() == (source.find("cmath") == std::string::npos ? 0 : 1));
  }
}

TEST_CASE("only allowed includes are accepted, others are refused with the reason") {
  const std::vector<std::string> headers = {"02-blinn-phong/blinn_phong.hpp", "01-transforms/transforms.hpp"};
  struct Row {
    const char* include;
    Words words;  ///< of the refusal; none where it is open
  };
  const std::vector<Row> rows = {
      {"<cmath>", {}},
      {"<unordered_map>", {}},
      {"<glm/glm.hpp>", {}},
      {"\"02-blinn-phong/blinn_phong.hpp\"", {}},
      {"\"01-transforms/transforms.hpp\"", {}},
      {"<glm/gtc/matrix_transform.hpp>", {"look_at", "<glm/glm.hpp>"}},
      {"\"glm/glm.hpp\"", {"<glm/glm.hpp>"}},
      {"\"blinn_phong.hpp\"", {}},
      {"\"transforms.hpp\"", {"write #include \"01-transforms/transforms.hpp\""}},
      {"<02-blinn-phong/blinn_phong.hpp>", {"write #include \"02-blinn-phong/blinn_phong.hpp\""}},
      {"\"03-shadow-mapping/shadow_mapping.hpp\"", {"its listed files", "\"01-transforms/transforms.hpp\""}},
      {"\"/etc/passwd\"", {"its listed files"}},
      {"\"../solutions/02-blinn-phong/blinn_phong.cpp\"", {"its listed files"}},
      {"\"cmath\"", {"its listed files"}},
      {"<fstream>", {"computation, containers and printing"}},
      {"<thread>", {"computation, containers and printing"}},
      {"<sys/socket.h>", {"computation, containers and printing"}},
      {"HEADER", {"write the header's name in"}},
      {"", {"write the header's name in"}},
      {"<cmath", {"write the header's name in"}},
      {"<>", {"write the header's name in"}},
  };
  for (const Row& row : rows) {
    INFO(row.include);
    const std::string source = std::string("// one\n#include ") + row.include + "\n";
    const std::string refused = refused_includes(source, "blinn_phong.cpp", "02-blinn-phong", headers);
    CHECK(refused.empty() == (row.words.size() == 0));
    if (!refused.empty()) CHECK(refused.starts_with("blinn_phong.cpp:2: #include " + std::string(row.include)));
    CHECK(has_all(refused, row.words));
  }
  CHECK(has_all(refused_includes("#include \"x\"", "a.cpp", "01-a", {}), {"only from its listed files"}));
  const std::string escape = refused_includes("#include \"\x1b[2J\"", "a.cpp", "01-a", {});
  CHECK(escape.find('\x1b') == std::string::npos);
}
