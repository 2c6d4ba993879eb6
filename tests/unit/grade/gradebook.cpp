#include "grade/results/gradebook.hpp"

#include <filesystem>

#include "base/csv.hpp"
#include "base/file.hpp"
#include "base/printable.hpp"
#include "catch.hpp"
#include "class_sample.hpp"

using namespace atelier;
using namespace atelier::grade;
using atelier::test::error_of;
using atelier::test::mentions;
using Field = GradebookColumn::Field;

namespace {

using Rows = std::vector<std::vector<std::string>>;

Rows gradebook_rows(const ClassResults& results) {
  Rows rows;
  for (CsvRow& row : parse_csv(gradebook_csv(results), "gradebook.csv")) rows.push_back(std::move(row.fields));
  return rows;
}

ClassResults results_of(const std::vector<SubmissionRecord>& records, const CourseFile& course = {},
                        const std::string& comments = "") {
  const TemporaryFolder folder;
  if (!comments.empty()) write_file(folder.path() / "comments.csv", comments);
  return class_results(folder.path(), course, {}, records);
}

}  // namespace

TEST_CASE("a gradebook has the usual columns and a row for each student, sorted by id") {
  SubmissionRecord grace{.student = {"grace-hopper", "", ""}, .source = "hopper.zip"};
  grace.steps = {test::step_record("02-blinn-phong", 0, 20),
                 test::step_record("03-shadow-mapping", 0, 30, StepRecord::State::not_handed_in)};
  grace.late = true;
  grace.needs_human = {"One.", "Two, too."};
  CHECK(gradebook_csv(results_of({grace, test::ada()})) ==
        "student,id,01-transforms,02-blinn-phong,03-shadow-mapping,total,late,needs_human,report\r\n"
        "Ada Lovelace,ada-lovelace,7.5,12,,19.5,,,students/ada-lovelace\r\n"
        "hopper.zip,grace-hopper,,0,,0,yes,\"yes: One; Two, too\",students/grace-hopper\r\n");
  CHECK(gradebook_csv(results_of({})) == "student,id,total,late,needs_human,report\r\n");
}

TEST_CASE("a gradebook has the columns of course.toml") {
  CourseFile course;
  course.columns = {{"ID", Field::identifier, ""},         {"=Light", Field::step, "02-blinn-phong"},
                    {"Term", Field::text, "winter, 2026"}, {"None", Field::step, "05-normal-mapping"},
                    {"Off", Field::adjustment, ""},        {"Said", Field::comment, ""}};
  course.byte_order_mark = true;
  CHECK(gradebook_csv(results_of({test::ada()}, course, "id,points,comment\nada-lovelace,-1.25,\"well, well\"\n")) ==
        "\xEF\xBB\xBFID,'=Light,Term,None,Off,Said\r\n4711,12,\"winter, 2026\",,-1.25,\"well, well\"\r\n");
}

TEST_CASE("an empty cell stays a cell, also the first of its row") {
  CourseFile course;
  course.columns = {{"Late", Field::late, ""}, {"ID", Field::id, ""}, {"Note", Field::text, ""}};
  CHECK(gradebook_csv(results_of({test::ada()}, course)) == "Late,ID,Note\r\n,ada-lovelace,\r\n");
}

TEST_CASE("where nothing but the skeleton was handed in there are no points, not 0") {
  SubmissionRecord grace{.student = {"grace-hopper", "", ""}, .source = "hopper.zip"};
  grace.steps = {test::step_record("02-blinn-phong", 0, 20, StepRecord::State::untouched),
                 test::step_record("03-shadow-mapping", 0, 30, StepRecord::State::not_handed_in)};
  CHECK(mentions(gradebook_csv(results_of({grace})), {"hopper.zip,grace-hopper,,,,,,"}));
}

TEST_CASE("two students of one name keep their rows, two records of one id are refused") {
  SubmissionRecord other = test::ada();
  other.student.id = "ada-lovelace-2";
  const Rows rows = gradebook_rows(results_of({other, test::ada()}));
  REQUIRE(rows.size() == 3);
  CHECK(rows[1][1] == "ada-lovelace");
  CHECK(rows[2][1] == "ada-lovelace-2");
  CHECK(mentions(error_of([] { results_of({test::ada(), test::ada()}); }), {"'ada-lovelace' has two records"}));
}

TEST_CASE("what strangers write is no formula and moves nothing") {
  struct Row {
    const char *text, *cell;
  };
  const Row rows[] = {
      {"", ""},
      {"Ada", "Ada"},
      {"=1+1", "'=1+1"},
      {"+49", "'+49"},
      {"-1", "'-1"},
      {"@SUM(A1)", "'@SUM(A1)"},
      {"\t=1", "' =1"},
      {"  =1", "'  =1"},
      {"\r\n=1", "' =1"},
      {"\u200b=1", "'=1"},
      {"\ufeff=1", "'=1"},
      {"\u202e=1", "'=1"},
      {"\uff1d1", "'\uff1d1"},
      {"\uff0b1", "'\uff0b1"},
      {"a=b", "a=b"},
      {"a\u202eb\u2066c\u061cd", "abcd"},
      {"a\x1b[2Jb", "a[2Jb"},
      {"two\nlines", "two lines"},
      {"\xff\xc3", "\ufffd\ufffd"},
      {"Müller 李", "Müller 李"},
      {"nul\x7f", "nul"},
  };
  for (const Row& row : rows) {
    INFO(row.text);
    CHECK(safe_cell(row.text) == row.cell);
  }
}

TEST_CASE("a hostile class gives a clean gradebook with a row for each student") {
  const std::string bad = "=cmd|'/c calc'!A1\",\"\n\x1b]0;x\x07\u202e\xff,;\r\n@x";
  std::vector<SubmissionRecord> records = test::made_up_class(20);
  for (SubmissionRecord& record : records) record.student.name = record.source = bad, record.needs_human = {bad};
  CourseFile course;
  course.columns = {{"student", Field::student, ""}, {"h", Field::needs_human, ""}, {"t", Field::text, bad}};
  const std::string csv = gradebook_csv(results_of(records, course));
  CHECK(printable(csv, Layout::keep_lines).size() == csv.size() - 21);  // only the \r of each line is taken away
  const Rows rows = gradebook_rows(results_of(records, course));
  REQUIRE(rows.size() == 21);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    REQUIRE(rows[i].size() == 3);
    for (const std::string& cell : rows[i]) CHECK((cell[0] == '\'' || cell[0] == 'y'));
  }
}

TEST_CASE("comments and points of people are read, and their mistakes named") {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "comments.csv";
  CHECK(read_comments(file).empty());
  create_comments(file);
  CHECK(read_file(file) == "id,points,comment\n");
  CHECK(read_comments(file).empty());
  write_file(file, std::string_view("\xEF\xBB\xBF"
                                    "comment;id;points\r\n\"a;\"\"b\nc\";ada;+1,5\r\n;bob;\r\nx;eve\r\n\r\n"));
  create_comments(file);  // changes nothing
  const Comments comments = read_comments(file);
  REQUIRE(comments.size() == 3);
  CHECK(comments.at("ada").text == "a;\"b c");
  CHECK(comments.at("ada").points == 1.5);
  CHECK(comments.at("bob").points == 0);
  CHECK(comments.at("eve").text == "x");
  CHECK(comments.at("eve").line == 5);
  const std::vector<std::string> misplaced = misplaced_comments(comments, {"ada", "bobb"}, file);
  REQUIRE(misplaced.size() == 2);
  CHECK(mentions(misplaced[0], {"comments.csv:4: ", "'bob'", "did you mean 'bobb'?"}));

  struct Row {
    const char* text;
    std::initializer_list<std::string_view> says;
  };
  const Row rows[] = {
      {"name,points\nada,1\n", {":1: unknown heading 'name'", "known are id, points, comment"}},
      {"id,coment\n", {":1: unknown heading 'coment'; did you mean 'comment'?"}},
      {"points,comment\n", {":1: heading 'id' is missing"}},
      {"id,id\n", {":1: heading 'id' appears twice"}},
      {"id,points\nada,one\n", {":2: points: 'one' is not allowed; it takes a number -10000..10000"}},
      {"id,points\nada,nan\n", {":2: points: 'nan'"}},
      {"id,points\nada,1e9\n", {":2: points: '1e9'"}},
      {"id,points\n,1\n", {":2: id is empty"}},
      {"id,points\nada,1\n\nada,2\n", {":4: id 'ada' appears twice, first in line 2"}},
      {"id,comment\nada,M\xFCller\n", {":2: is not UTF-8", "CSV UTF-8"}},
      {"\xFF\xFEi", {":1: is not UTF-8"}},
      {"id,comment\nada,well, well\n", {":2: has 3 fields, and there are 2 headings"}},
      {"id,comment\nada,\"open\n", {":2: a quote is not closed"}},
      {"id,comment\nada,\"a\" b\n", {":2: text follows a closed quote"}},
  };
  for (const Row& row : rows) {
    INFO(row.text);
    write_file(file, std::string_view(row.text));
    const std::string error = error_of([&] { read_comments(file); });
    INFO(error);
    CHECK(mentions(error, {"comments.csv"}));
    CHECK(mentions(error, row.says));
  }
}

TEST_CASE("comments enter the gradebook") {
  const std::string comments = "id,points,comment\nada-lovelace,2,=agreed\nnobody,1,lost\n";
  const ClassResults results = results_of({test::ada()}, {}, comments);
  CHECK(results.rows[0].grade.points == 21.5);
  CHECK(results.commented);
  REQUIRE(results.unsaid.size() == 1);
  const Rows rows = gradebook_rows(results);
  CHECK(rows[0].back() == "comment");
  CHECK(rows[1][4] == "21.5");
  CHECK(rows[1][8] == "2");
  CHECK(rows[1][9] == "'=agreed");
}
