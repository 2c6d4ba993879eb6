// Texts as editors of all systems save them.
#include "grade/intake/text_conversion.hpp"

#include "base/file.hpp"
#include "catch.hpp"
#include "grade/intake/submission.hpp"
#include "made_archive.hpp"

using namespace atelier;
using namespace atelier::grade;
using namespace std::string_literals;

TEST_CASE("texts of all encodings and line ends become UTF-8 with LF") {
  struct Row {
    const char* name;
    std::string bytes, text, encoding, line_ends;
  };
  const Row rows[] = {
      {"plain", "int a;\n", "int a;\n", "", ""},
      {"empty", "", "", "", ""},
      {"UTF-8", "// \u00fc\n", "// \u00fc\n", "", ""},
      {"a mark", "\xef\xbb\xbfint a;\n", "int a;\n", "UTF-8 with a byte-order mark", ""},
      {"only a mark", "\xef\xbb\xbf", "", "UTF-8 with a byte-order mark", ""},
      {"CRLF", "a\r\nb\r\n", "a\nb\n", "", "CRLF"},
      {"CR", "a\rb\r", "a\nb\n", "", "CR"},
      {"CR twice", "a\r\r\nb\r\r\n", "a\nb\n", "", "CRLF"},
      {"mixed", "a\r\nb\nc\rd\n", "a\nb\nc\rd\n", "", "CRLF"},
      {"UTF-16 LE", "\xff\xfe"s + "a\0\r\0\n\0"s, "a\n", "UTF-16", "CRLF"},
      {"UTF-16 BE", "\xfe\xff"s + "\0a\0\n"s, "a\n", "UTF-16", ""},
      {"UTF-16 without a mark", "i\0n\0t\0 \0a\0;\0"s, "int a;", "UTF-16", ""},
      {"UTF-16 BE without a mark", "\0i\0n\0t\0 \0a\0;"s, "int a;", "UTF-16", ""},
      {"Latin-1", "// \xfc\xdf\r\n", "// \u00fc\u00df\n", "Latin-1", "CRLF"},
      {"a mark, but no UTF-8", "\xef\xbb\xbf\xff", "\u00ef\u00bb\u00bf\u00ff", "Latin-1", ""},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    const ConvertedText converted = convert_text(row.bytes);
    CHECK(converted.text == row.text);
    CHECK(converted.encoding == row.encoding);
    CHECK(converted.line_ends == row.line_ends);
    CHECK(converted.why_no_text == "");
  }
}

TEST_CASE("what is no text stays as it is, and is named") {
  for (const auto& [bytes, why] : {std::pair{"%PDF-1.7 \0\r\n"s, "is a PDF, not a text"},
                                   std::pair{"PK\x03\x04..."s, "is an archive or an Office document, not a text"},
                                   std::pair{"\x7f"
                                             "ELF"s,
                                             "is a program, not a text"},
                                   std::pair{"int a\0;\r\n"s, "has NUL characters and is no text"}}) {
    INFO(why);
    CHECK(convert_text(bytes).why_no_text == why);
    CHECK(convert_text(bytes).text == bytes);
  }
}

TEST_CASE("texts are the same up to line ends, marks and blanks at the ends") {
  for (const char* same : {"a\n b\n", "a\r\n b\r\n",
                           "\xef\xbb\xbf"
                           "a\r b",
                           "a  \n b\t\n\n\n"}) {
    INFO(same);
    CHECK(are_same_text("a\n b\n", same));
  }
  for (const char* other : {"a\nb\n", "", "a\n\n b\n", "a\n b\nc"}) {
    INFO(other);
    CHECK_FALSE(are_same_text("a\n b\n", other));
  }
}

TEST_CASE("conversions of a submission are said, line ends once for all files") {
  const TemporaryFolder folder;
  const std::filesystem::path ada = folder.path() / "ada";
  write_file(ada / "01-move/move.cpp", "\xef\xbb\xbfint a;\r\n"s);
  write_file(ada / "02-light-up/light.cpp", "// \xe4\r\n"s);
  write_file(ada / "02-light-up/light.glsl", "a\rb\r"s);
  write_file(ada / "02-light-up/choices.txt", "a\r\n"s);
  write_file(ada / "03-cast-shadows/shadows.cpp", "%PDF-1.4"s);
  const Submission taken = take_submission(test::three_steps, ada, folder.path() / "copy");
  CHECK(read_file(taken.folder / "01-move/move.cpp") == "int a;\n");
  CHECK(read_file(taken.folder / "02-light-up/light.cpp") == "// \u00e4\n");
  CHECK(taken.notes ==
        std::vector<std::string>{"01-move/move.cpp was UTF-8 with a byte-order mark and is read as UTF-8",
                                 "02-light-up/light.cpp is neither UTF-8 nor UTF-16 and is read as Latin-1",
                                 "03-cast-shadows/shadows.cpp is a PDF, not a text",
                                 "line ends CRLF are read as LF: 01-move/move.cpp, 02-light-up/choices.txt, "
                                 "02-light-up/light.cpp",
                                 "line ends CR are read as LF: 02-light-up/light.glsl"});
  CHECK(taken.needs_human == std::vector<std::string>{"03-cast-shadows/shadows.cpp is a PDF, not a text"});
  CHECK(taken.unusable.size() == 1);
}
