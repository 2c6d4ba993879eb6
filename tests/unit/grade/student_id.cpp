#include "grade/intake/student_id.hpp"

#include "catch.hpp"

using namespace atelier::grade;

TEST_CASE("ids are file names that every system takes") {
  struct Row {
    const char* text;
    const char* name;
  };
  const Row rows[] = {{"Ada Lovelace", "ada-lovelace"},
                      {"M\u00fcller, J\u00f6rg", "mueller-joerg"},
                      {"\u0141ukasz \u0160\u0165astn\u00fd", "lukasz-stastny"},
                      {"e\u0301mile", "emile"},
                      {"\u5c71\u7530", ""},
                      {"", ""},
                      {".", ""},
                      {"..", ""},
                      {"../../etc/passwd", "etc-passwd"},
                      {"a..b", "a.b"},
                      {"CON", "student-con"},
                      {"com1.txt", "student-com1.txt"},
                      {"console", "console"},
                      {"a\x1b[2J\u202e\xff b", "a-2j-b"},
                      {"-rf", "rf"}};
  for (const Row& row : rows) {
    INFO(row.text);
    CHECK(file_name_of(row.text) == row.name);
  }
  CHECK(file_name_of(std::string(300, 'a')).size() == 60);
}

TEST_CASE("ids are unique and never empty") {
  std::set<std::string> used;
  CHECK(new_student_id("Ada", "12", used) == "ada-12");
  CHECK(new_student_id("Ada", "", used) == "ada");
  CHECK(new_student_id("ADA", "", used) == "ada-2");
  CHECK(new_student_id("Ada", "2", used) == "ada-2-2");
  CHECK(new_student_id("", "", used) == "student");
  CHECK(new_student_id("\u5c71", "", used) == "student-2");
  CHECK(new_student_id("\u5c71", "77", used) == "77");
  CHECK(new_student_id("", "ada-l", used) == "ada-l");
  CHECK(new_student_id("ada-l", "ada-l", used) == "ada-l-2");
  // A long name leaves the identifier whole.
  CHECK(new_student_id(std::string(200, 'x'), "123456789", used).ends_with("-123456789"));
}
