#include "grade/course/course_file.hpp"

#include "base/file.hpp"
#include "catch.hpp"
#include "grade/course/course_words.hpp"

using namespace atelier;
using namespace atelier::grade;
using atelier::test::error_of;
using atelier::test::mentions;
using Field = GradebookColumn::Field;

namespace {

const std::vector<std::string> steps_of_course = {"01-transforms", "02-blinn-phong", "03-shadow-mapping"};

CourseFile course_of(const std::string& text) {
  const TemporaryFolder folder;
  write_file(folder.path() / "course.toml", text);
  return read_course_file(folder.path() / "course.toml", steps_of_course);
}

}  // namespace

TEST_CASE("the documented course.toml is read, and every value arrives") {
  const CourseFile course = read_course_file(ATELIER_SOURCE_DIR "/docs/course.toml", steps_of_course);
  CHECK(course.title == "Real-time rendering, winter 2026");
  CHECK(course.attempts == Attempts::last);
  CHECK(course.feedback == Feedback::full);
  CHECK(course.tiers.at("further") == TierRule::counts);
  CHECK(course.tiers.at("challenge") == TierRule::bonus);
  CHECK(course.late.percent_per_day == 10);
  CHECK(course.late.grace_minutes == 15);
  CHECK(course.late.days == 3);
  REQUIRE(course.steps.size() == 3);
  CHECK(course.steps[0].points == 10.0);
  CHECK(course.steps[0].deadline == 1'793'660'340);  // 2026-11-02 22:59 UTC, as `date -d` says
  CHECK(course.steps[0].deadline_text == "2026-11-02T23:59:00+01:00");
  CHECK_FALSE(course.steps[2].points);
  CHECK_FALSE(course.steps[2].deadline);
  REQUIRE(course.columns.size() == 8);
  CHECK(course.columns[0].heading == "Identifier");
  CHECK(course.columns[1].heading == "Full name");  // the file's order, not the alphabet's
  CHECK(course.columns[2].field == Field::step);
  CHECK(course.columns[2].argument == "01-transforms");
  CHECK(course.columns[7].field == Field::text);
  CHECK(course.columns[7].argument == "winter 2026");
  CHECK_FALSE(course.byte_order_mark);
  CHECK(course.naming == "([^_]+)_([0-9]+)_.*");
  CHECK(course.seconds == 10.0);
  CHECK(course.counts("01-transforms"));
  CHECK_FALSE(course.counts("04-point-shadows"));
}

TEST_CASE("an empty course.toml lets all steps count as they are") {
  const CourseFile course = course_of("");
  CHECK(course.steps.empty());
  CHECK(course.counts("02-blinn-phong"));
  CHECK(course.columns.empty());
  CHECK_FALSE(course.late.days);
  CHECK(mentions(course_in_words(course, {{"01-transforms", "Transforms"}}),
                 {"01-transforms", "of cases", "Transforms"}));
}

TEST_CASE("steps are sorted, dates are moments, and columns keep their order in one line too") {
  const CourseFile course = course_of(
      "[steps]\n03-shadow-mapping = {points = 5, deadline = 1970-01-02T00:00:00Z}\n01-transforms = {}\n"
      "[gradebook]\ncolumns = {Z = \"id\", A = \"total\", M = \"text:\"}\n");
  CHECK(course.steps[0].step == "01-transforms");
  CHECK(course.steps[1].deadline == 86400);
  CHECK(course.columns[0].heading == "Z");
  CHECK(course.columns[1].heading == "A");
  CHECK(course.columns[2].argument.empty());
}

TEST_CASE("what is wrong in a course.toml is named with its line") {
  struct Row {
    const char *text, *line;
    std::initializer_list<std::string_view> says;
  };
  const Row rows[] = {
      {"title = ", "1", {}},
      {"title = 'a'\ntitle = 'b'", "2", {}},
      {"\n\ntilte = 'a'", "3", {"unknown key 'tilte'", "did you mean 'title'?"}},
      {"title = ''", "1", {"title: '' is not allowed", "text in quotes"}},
      {"title = 3", "1", {"title: 3 is not allowed"}},
      {"title = \"a\\u202eb\"", "1", {"without control characters"}},
      {"attempts = 'first'", "1", {"'first' is not allowed; it takes \"last\", \"best\""}},
      {"feedback = true", "1", {"true is not allowed; it takes \"full\", \"where\", \"score\""}},
      {"late = 3", "1", {"late: 3 is not allowed; it takes a table, [late]"}},
      {"[late]\npercent_per_day = 101", "2", {"101 is not allowed; it takes a number 0..100"}},
      {"[late]\npercent_per_day = nan", "2", {"nan is not allowed"}},
      {"[late]\ngrace_minutes = 1.5", "2", {"1.5 is not allowed; it takes a whole number 0..10080"}},
      {"[late]\ndays = -1", "2", {"whole number 0..365"}},
      {"[late]\ndays = 99999999999999999", "2", {"whole number 0..365"}},
      {"[late]\npercent = 10", "2", {"unknown key 'percent'"}},
      {"[tiers]\ncore = 'bonus'\nfurther = 'bonus'\nchallenge = 'ignored'", "1", {"no tier counts"}},
      {"[tiers]\ncor = 'bonus'", "2", {"did you mean 'core'?"}},
      {"[steps]", "1", {"lists no step"}},
      {"[steps.02-blin-phong]", "1", {"there is no step '02-blin-phong'; did you mean '02-blinn-phong'?"}},
      {"[steps.01-transforms]\npoints = -1", "2", {"points: -1 is not allowed; it takes a number 0..10000"}},
      {"[steps.01-transforms]\ndeadline = 2026-11-02", "2", {"2026-11-02 is not allowed", "offset"}},
      {"[steps.01-transforms]\ndeadline = 2026-11-02T23:59:00",
       "2",
       {"offset, without quotes, such as 2026-11-02T23:59:00+01:00"}},
      {"[steps.01-transforms]\ndeadline = '2026-11-02T23:59:00+01:00'", "2", {"deadline: '2026"}},
      {"[steps.01-transforms]\ndeadline = 2026-13-02T23:59:00Z", "2", {}},
      {"[gradebook]\ncolumns = {}", "2", {"has no column"}},
      {"[gradebook.columns]\nA = 'nmae'", "2", {"'nmae' is not allowed; it takes student, id"}},
      {"[gradebook.columns]\nA = 'totla'", "2", {"did you mean 'total'?"}},
      {"[gradebook.columns]\nA = 'step:02'", "2", {"'02' is no step that counts"}},
      {"[gradebook.columns]\nA = 'step:02-blinn-phong'\n[steps.01-transforms]", "2", {"is no step that counts"}},
      {"[gradebook.columns]\n\"a\\tb\" = 'id'", "2", {"heading"}},
      {"[gradebook]\nbyte_order_mark = 'yes'", "2", {"true or false"}},
      {"[naming]\npattern = '('", "2", {"regular expression"}},
      {"[naming]\npattern = 'abc'", "2", {"one or two groups"}},
      {"[naming]\npattern = '(a)(b)(c)'", "2", {"one or two groups"}},
      {"[limits]\nseconds = 0", "2", {"a number 1..600"}},
      {"[[steps]]\na = 1", "1", {"steps: a list is not allowed; it takes a table"}},
  };
  for (const Row& row : rows) {
    INFO(row.text);
    const std::string error = error_of([&] { course_of(row.text); });
    INFO(error);
    CHECK(mentions(error, {std::string("course.toml:") + row.line + ": "}));
    CHECK(mentions(error, row.says));
  }
  CHECK(mentions(error_of([] { read_course_file("/nowhere/course.toml", {}); }), {"/nowhere/course.toml"}));
}

TEST_CASE("every beginning of a course.toml is read or refused") {
  const std::string text = read_file(ATELIER_SOURCE_DIR "/docs/course.toml");
  for (std::size_t length = 0; length < text.size(); length += 11) {
    const std::string error = error_of([&] { course_of(text.substr(0, length)); });
    if (!error.empty()) CHECK(mentions(error, {"course.toml:"}));
  }
}

TEST_CASE("settings without effect are named") {
  const std::map<std::string, std::string> titles = {{"01-transforms", "Transforms"}};
  CHECK(mentions(course_in_words(course_of("[late]\ndays = 3"), titles), {"[late] has no effect"}));
  CHECK(mentions(course_in_words(course_of("[steps.01-transforms]\ndeadline = 1970-01-01T00:00:00Z"), titles),
                 {"late steps keep all points"}));
  CHECK(mentions(course_in_words(course_of("[gradebook.columns]\nA = 'total'"), titles),
                 {"no column says whose row", "need a human"}));
}
