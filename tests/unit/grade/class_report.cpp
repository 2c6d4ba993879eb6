#include "grade/results/class_report.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>

#include "base/file.hpp"
#include "base/printable.hpp"
#include "base/strict_json.hpp"
#include "catch.hpp"
#include "class_sample.hpp"
#include "grade/results/class_json.hpp"
#include "grade/results/class_junit.hpp"
#include "grade/results/class_statistics.hpp"
#include "grade/results/mistake_pictures.hpp"
#include "judge/report/report_html.hpp"

using namespace atelier;
using namespace atelier::grade;
using atelier::test::error_of;
using atelier::test::mentions;

namespace {

namespace fs = std::filesystem;

int times(std::string_view text, std::string_view words) {
  int found = 0;
  for (std::size_t at = text.find(words); at != text.npos; at = text.find(words, at + words.size())) ++found;
  return found;
}

/// The first tag of HTML or XML that closes no open element, or an element left open; empty if all are nested rightly.
std::string wrong_nesting(std::string_view markup) {
  constexpr std::array<std::string_view, 6> alone = {"meta", "img", "br", "input", "!DOCTYPE", "?xml"};
  std::vector<std::string_view> open;
  for (std::size_t at = markup.find('<'); at != markup.npos; at = markup.find('<', at + 1)) {
    const bool closes = markup[at + 1] == '/';
    const std::size_t begin = at + 1 + (closes ? 1 : 0);
    const std::string_view name = markup.substr(begin, markup.find_first_of(" />\n", begin) - begin);
    const bool empty = markup[markup.find('>', at) - 1] == '/';
    if (closes) {
      if (open.empty() || open.back() != name) return "</" + std::string(name) + ">";
      open.pop_back();
    } else if (!empty && std::find(alone.begin(), alone.end(), name) == alone.end()) {
      open.push_back(name);
      if (name == "script" || name == "style") at = markup.find("</", at) - 1;
    }
  }
  return open.empty() ? "" : "<" + std::string(open.back()) + ">";
}

ClassResults made_up_results(const fs::path& folder, int students) {
  return class_results(folder, {}, test::made_up_summary(), test::made_up_class(students));
}

/// A result whose case shows a mistake, with pictures of this side.
judge::SubmissionResult mistaken_result(int side) {
  judge::CaseResult c;
  c.name = "highlight", c.mistake = "rv-for-nh";
  c.evidence = judge::Evidence{
      .yours = Image(side, side, {1, 0, 0, 1}), .reference = Image(side, side), .over = {}, .flip = {}, .mistake = {}};
  judge::StepResult step{.step = "02-blinn-phong", .title = "Light", .cases = {c, c}};
  return {.submission = "ada", .steps = {step}, .environment = {}, .notes = {}};
}

}  // namespace

TEST_CASE("statistics of a class count every student once") {
  const TemporaryFolder folder;
  const ClassResults results = made_up_results(folder.path(), 60);
  const ClassStatistics statistics = class_statistics(results);
  REQUIRE(statistics.steps.size() == 12);
  for (const StepStatistics& step : statistics.steps) {
    INFO(step.step);
    int in_bins = 0;
    for (const int bin : step.bins) in_bins += bin;
    CHECK(in_bins == step.handed_in);
    CHECK(step.handed_in + step.untouched + step.absent == 60);
    CHECK(step.median <= step.max_points);
  }
  for (std::size_t i = 1; i < statistics.mistakes.size(); ++i)
    CHECK(statistics.mistakes[i - 1].students.size() >= statistics.mistakes[i].students.size());
  CHECK(statistics.slowest.size() == 5);
  CHECK(seconds_of_work(statistics.slowest[0]->record) >= seconds_of_work(statistics.slowest[4]->record));
  CHECK(statistics.sandboxes == std::vector<std::pair<std::string, int>>{{"full", 60}});
  CHECK(seconds_of_work(test::ada()) == 6.5);
}

TEST_CASE("points fall into the bin of their share") {
  struct Row {
    double points, max_points;
    std::size_t bin;
  };
  const Row rows[] = {{0, 10, 0},    {0.99, 10, 0}, {1, 10, 1},   {3, 10, 3},  {7, 10, 7},
                      {9.99, 10, 9}, {10, 10, 10},  {14, 10, 10}, {0.3, 1, 3}, {0, 0, 0}};
  const TemporaryFolder folder;
  for (const Row& row : rows) {
    INFO(row.points << " of " << row.max_points);
    SubmissionRecord record{.student = {"a", "", ""}};
    record.steps = {test::step_record("01-transforms", row.points, row.max_points)};
    const ClassResults results = class_results(folder.path(), {}, {}, {record});
    CHECK(class_statistics(results).steps[0].bins[row.bin] == 1);
  }
}

TEST_CASE("class.html is self-contained, well formed, and says first what needs a human") {
  const TemporaryFolder folder;
  for (const int students : {0, 1, 60}) {
    INFO(students);
    const std::string html = class_html(made_up_results(folder.path(), students));
    CHECK(wrong_nesting(html) == "");
    CHECK(times(html, "<tr>") == students + 1);
    for (const char* outside : {"http:", "https:", "url(", "@import", "<link", " src=\"/"}) {
      INFO(outside);
      CHECK(html.find(outside) == std::string::npos);
    }
  }
  const std::string html = class_html(made_up_results(folder.path(), 60));
  const std::size_t human = html.find("<h2>Needs a human"), table = html.find("<table"), chart = html.find("<svg");
  CHECK((human < table && table < chart));
  CHECK(mentions(html, {"is a symbolic link", "href=\"students/student-003/report.html\"", "Jun&#39;ichirō",
                        "script-src 'sha256-", "<h2>Mistakes made by most", "the highlight is about half as wide",
                        "desktop.ini", "graded in 4 min 14 s", "llvmpipe", "aria-label=\"Students by share"}));
  CHECK(times(html, "<svg") == 12);
  CHECK(mentions(class_html(made_up_results(folder.path(), 0)), {"Nothing needs a human.", "0 students"}));
}

TEST_CASE("names and reasons of strangers are escaped in every report of a class") {
  const std::string bad = "<script>alert(1)</script>\"'&]]>--></svg>\x1b[2J\u202e\xff";
  std::vector<SubmissionRecord> records = test::made_up_class(3);
  for (SubmissionRecord& record : records) {
    record.student.name = record.student.identifier = record.source = record.sandbox = bad;
    record.needs_human = record.notes = {bad};
    record.seconds[bad] = 1;
    for (StepRecord& step : record.steps) step.mistakes[bad] = 1, step.step += bad;
  }
  ClassSummary summary = test::made_up_summary();
  summary.name = summary.platform = bad;
  summary.ignored = {bad};
  summary.environment = {{bad, bad}};
  for (StepSummary& step : summary.steps) {
    step.step += bad, step.title = bad;
    step.mistakes = {{.name = bad, .title = bad, .sentence = bad}};
  }
  CourseFile course;
  course.title = bad;
  const TemporaryFolder folder;
  write_file(folder.path() / "comments.csv", std::string_view("id,comment\nstudent-000,<script>alert(2)</script>\n"));
  const ClassResults results = class_results(folder.path(), course, summary, records);
  const std::string html = class_html(results), xml = class_junit_xml(results), json = class_json(results);
  CHECK(wrong_nesting(html) == "");
  CHECK(times(html, "<script") == 1);
  CHECK(html.find("alert(1)</script>") == std::string::npos);
  CHECK(wrong_nesting(xml) == "");
  for (const std::string& text : {html, xml}) CHECK(printable(text, Layout::keep_lines) == text);
  CHECK(strict_json::parse(json, "class.json")["students"].size() == 3);
}

TEST_CASE("a class of 300 students with 12 steps is a page that a browser opens at once") {
  const TemporaryFolder folder;
  const std::string html = class_html(made_up_results(folder.path(), 300));
  CHECK(html.size() < 500'000);
  CHECK(times(html, "<td") == 300 * (1 + 12 + 3));
}

TEST_CASE("class.json has the members that programs rely on") {
  const TemporaryFolder folder;
  const auto document = strict_json::parse(class_json(made_up_results(folder.path(), 60)), "class.json");
  CHECK(document["schema"] == 1);
  CHECK(document["class"] == "homework-2");
  CHECK(document["students"].size() == 60);
  const auto& student = document["students"][3];
  CHECK(student["id"] == "student-003");
  CHECK(student["report"] == "students/student-003");
  CHECK(student["steps"].size() == 12);
  CHECK(student["needs_human"].size() == 1);
  CHECK(student["handed_in"].is_number());
  CHECK(document["steps"][0]["bins"].size() == 11);
  CHECK(document["mistakes"][0]["sentence"].get<std::string>().starts_with("It looks as if"));
  CHECK(document["sandboxes"]["full"] == 60);
  CHECK(document["slowest"].size() == 5);
}

TEST_CASE("JUnit XML of a class has a suite per student and a case per step") {
  const TemporaryFolder folder;
  SubmissionRecord record = test::ada();
  record.steps.push_back(test::step_record("03-shadow-mapping", 0, 30, StepRecord::State::not_built));
  record.steps.push_back(test::step_record("04-point-shadows", 0, 30, StepRecord::State::not_handed_in));
  record.steps.push_back(test::step_record("05-normal-mapping", 9, 9));
  const std::string xml = class_junit_xml(class_results(folder.path(), {}, test::made_up_summary(), {record}));
  CHECK(wrong_nesting(xml) == "");
  CHECK(mentions(
      xml, {"<testsuites name=\"homework-2\" tests=\"5\" failures=\"2\" errors=\"1\" skipped=\"1\">",
            "<testsuite name=\"ada-lovelace\"", "7.5 / 10 points", "12 / 20 points; looks like rv-for-nh",
            "does not compile", "<skipped message=\"not handed in\"/>", "<system-out>9 / 9 points</system-out>"}));
}

TEST_CASE("a mistake is shown with the picture of a student who made it") {
  const TemporaryFolder folder;
  const fs::path student = pictures_folder(folder.path(), test::ada());
  write_mistake_pictures(student, mistaken_result(300));
  const fs::path picture = mistake_picture(student, "02-blinn-phong", "rv-for-nh");
  REQUIRE(fs::exists(picture));
  CHECK(fs::file_size(picture) < mistake_picture_limit);
  const auto html = [&] {
    return class_html(class_results(folder.path(), {}, test::made_up_summary(), {test::ada()}));
  };
  CHECK(times(html(), "src=\"data:image/png;base64,") == 1);
  write_file(picture, std::string(mistake_picture_limit + 1, 'x'));
  CHECK(times(html(), "<img") == 0);
  judge::SubmissionResult nothing = mistaken_result(8);
  for (judge::CaseResult& c : nothing.steps[0].cases) c.evidence.reset();
  write_mistake_pictures(folder.path() / "other", nothing);
  CHECK_FALSE(fs::exists(folder.path() / "other"));
}

TEST_CASE("the results of a class are written together, and a person's comments are kept") {
  const TemporaryFolder folder;
  const fs::path out = folder.path() / "out", report = out / "students/ada-lovelace/report.html";
  judge::write_html_report(report, mistaken_result(8));
  const std::string plain = read_file(report);
  write_class_results(out, {}, test::made_up_summary(), {test::ada()});
  for (const char* name : {"gradebook.csv", "class.html", "class.json", "junit.xml"}) {
    INFO(name);
    CHECK(fs::exists(out / name));
  }
  CHECK(read_file(out / "comments.csv") == "id,points,comment\n");
  CHECK(read_file(report) == plain);

  const std::string said = "id,points,comment\nada-lovelace,-1,<b>Late</b> as agreed\n";
  write_file(out / "comments.csv", std::string_view(said));
  for (int regrade = 0; regrade < 2; ++regrade) {
    if (regrade == 1) judge::write_html_report(report, mistaken_result(8));
    write_class_results(out, {}, test::made_up_summary(), {test::ada()});
    CHECK(read_file(out / "comments.csv") == said);
    CHECK(mentions(read_file(report), {"&lt;b&gt;Late&lt;/b&gt; as agreed", "1 point taken off the total"}));
    CHECK(mentions(read_file(out / "gradebook.csv"), {"18.5", "<b>Late</b> as agreed"}));
    CHECK(mentions(read_file(out / "class.html"), {"&lt;b&gt;Late&lt;/b&gt;"}));
  }
  write_file(out / "comments.csv", std::string_view("id\n"));
  write_class_results(out, {}, test::made_up_summary(), {test::ada()});
  CHECK(read_file(report) == plain);
}

TEST_CASE("if a file of a class cannot be written, none is replaced") {
  const TemporaryFolder folder;
  write_class_results(folder.path(), {}, test::made_up_summary(), {test::ada()});
  const std::string before = read_file(folder.path() / "gradebook.csv");
  fs::create_directories(folder.path() / "junit.xml.new/in-the-way");
  CHECK(error_of([&] { write_class_results(folder.path(), {}, test::made_up_summary(), test::made_up_class(2)); }) !=
        "");
  CHECK(read_file(folder.path() / "gradebook.csv") == before);
  write_file(folder.path() / "comments.csv", std::string_view("ids\n"));
  CHECK(mentions(error_of([&] { write_class_results(folder.path(), {}, {}, {}); }), {"did you mean 'id'?"}));
  CHECK(read_file(folder.path() / "gradebook.csv") == before);
}

TEST_CASE("a class for people to look at, in the folder atelier-class of temporary files", "[.sample]") {
  const fs::path out = fs::temp_directory_path() / "atelier-class";
  write_mistake_pictures(out / "pictures/student-001", mistaken_result(300));
  write_class_results(out, {}, test::made_up_summary(), test::made_up_class(60));
}
