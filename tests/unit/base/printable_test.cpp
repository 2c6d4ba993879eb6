#include "base/printable.hpp"

#include "catch.hpp"

using namespace atelier;

#define BAD "\xEF\xBF\xBD"  // U+FFFD

TEST_CASE("unprintable text is escaped") {
  struct Row {
    const char* name;
    std::string text, one_line, lines;
  };
  const Row rows[] = {
      {"plain", "Grüße, 世界 🙂", "Grüße, 世界 🙂", "Grüße, 世界 🙂"},
      {"line ends", "a\r\nb\tc\n", "a" BAD BAD "b" BAD "c" BAD, "a\nb\tc\n"},
      {"lone return", "a\rb", "a" BAD "b", "a" BAD "b"},
      {"escape", "\x1b]8;;x\x07", BAD "]8;;x" BAD, BAD "]8;;x" BAD},
      {"C1 in UTF-8",
       "\xC2\x9B"
       "31m",
       BAD "31m", BAD "31m"},
      {"C1 as a byte",
       "\x9B"
       "31m",
       BAD "31m", BAD "31m"},
      {"delete", "a\x7f", "a" BAD, "a" BAD},
      {"right to left", "\xE2\x80\xAE", BAD, BAD},
      {"isolate", "\xE2\x81\xA6", BAD, BAD},
      {"overlong", "\xC0\xAF", BAD BAD, BAD BAD},
      {"overlong of three", "\xE0\x80\xAF", BAD BAD BAD, BAD BAD BAD},
      {"surrogate", "\xED\xA0\x80", BAD BAD BAD, BAD BAD BAD},
      {"cut off", "\xF0\x9F\x99", BAD BAD BAD, BAD BAD BAD},
      {"too large", "\xF4\x90\x80\x80", BAD BAD BAD BAD, BAD BAD BAD BAD},
      {"noncharacter", "\xEF\xBF\xBF", BAD, BAD},
      {"the replacement itself", BAD, BAD, BAD},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    CHECK(printable(row.text) == row.one_line);
    CHECK(printable(row.text, Layout::keep_lines) == row.lines);
  }
}

TEST_CASE("a quoted argument is one word for a shell") {
  CHECK(shell_word("/home/ada/a=b,c_1.zip") == "/home/ada/a=b,c_1.zip");
  CHECK(shell_word("Ada Lovelace; rm -r x") == "'Ada Lovelace; rm -r x'");
  CHECK(shell_word("it's $HOME") == "'it'\\''s $HOME'");
  CHECK(shell_word("Müller") == "'Müller'");
  CHECK(shell_word("a\nb") == "");
  CHECK(shell_word("\x1b[31m") == "");
}

TEST_CASE("text is truncated between characters") {
  CHECK(shorten("abcdef", 6) == "abcdef");
  CHECK(shorten("abcdefg", 6) == "abc...");
  CHECK(shorten("aäöü", 6) == "aä...");
  CHECK(shorten("aaäöü", 6) == "aa...");
  CHECK(shorten("abcdef", 2) == "..");
}
