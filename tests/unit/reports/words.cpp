#include "judge/report/report_words.hpp"

#include "base/base64.hpp"
#include "base/printable.hpp"
#include "catch.hpp"
#include "sample.hpp"

using namespace atelier;
using namespace atelier::judge;

TEST_CASE("points are rounded down, so that a failure never shows full points") {
  struct Row {
    double points;
    const char* text;
  };
  const Row rows[] = {{0, "0"},          {2, "2"},     {1.5, "1.5"}, {1.999999, "1.99"}, {0.29, "0.29"},
                      {1.0 / 3, "0.33"}, {100, "100"}, {0.001, "0"}, {10, "10"}};
  for (const Row& row : rows) CHECK(points_text(row.points) == row.text);
  CHECK(score_text(0.5, 1) == "0.5 / 1 point");
  CHECK(score_text(0, 0) == "0 / 0 points");
}

TEST_CASE("a verdict has a fixed order, without empty parts") {
  std::string labels;
  for (const Remark& remark : remarks(test::failed_picture())) labels += remark.label + ",";
  CHECK(labels == "expected,found,looks like,where,credit,try next,rerun,");
  CaseResult bare;
  CHECK(remarks(bare).empty());
  bare.mistake = "no-specular";
  REQUIRE(remarks(bare).size() == 1);
  CHECK(remarks(bare)[0].text == "no-specular");
  bare.mistake_sentence = "It is missing.";
  CHECK(remarks(bare)[0].text == "It is missing. (no-specular)");
}

TEST_CASE("cases without an answer for the same reason are a group") {
  StepResult step;
  const auto add = [&](const char* name, Status status, const char* reason, const char* hint) {
    CaseResult c;
    c.name = name, c.status = status, c.reason = reason, c.hint = hint, c.command = std::string("check ") + name;
    c.score = 0.5, c.max_score = 1;
    step.cases.push_back(c);
  };
  add("a", Status::timeout, "not drawn", "loop");
  add("b", Status::failed, "too dark", "loop");
  add("c", Status::failed, "too dark", "loop");  // an answer is its own matter
  add("d", Status::timeout, "not drawn", "another");
  add("e", Status::crashed, "not drawn", "loop");
  const std::vector<CaseGroup> groups = case_groups(step);
  std::string names;
  for (const CaseGroup& group : groups) names += case_names(group) + "; ";
  CHECK(names == "a, d; b; c; e; ");
  CHECK(cases_words(groups[0].size()) == "2 cases");
  CHECK(sum_of(groups[0]).score == 1);
  CHECK(sum_of(groups[0]).max_score == 2);
  std::string said;
  for (const Remark& remark : remarks(groups[0])) said += remark.label + ": " + remark.text + "; ";
  CHECK(said == "found: not drawn; rerun: check a; ");
  step.cases[3].output = "hello\n";
  CHECK(output_of(groups[0]) == "hello\n");
}

TEST_CASE("anchors are safe in ids and addresses, and differ where names differ") {
  StepResult step;
  step.step = "02-x";
  const auto anchor = [&](std::string name, StepsInReport steps = StepsInReport::one) {
    return case_anchor(step, {.name = std::move(name), .title = ""}, steps);
  };
  struct Row {
    const char* name;
    const char* anchor;
  };
  const Row rows[] = {{"sphere-2_a", "case-sphere-2_a"},
                      {"a b", "case-a~20b"},
                      {"a-b", "case-a-b"},
                      {"a#b", "case-a~23b"},
                      {"\"'<>&", "case-~22~27~3C~3E~26"},
                      {"M\u00fcnze", "case-M~C3~BCnze"},
                      {"a%20b", "case-a~2520b"},
                      {"a~20b", "case-a~7E20b"},
                      {"a.b", "case-a~2Eb"},
                      {"", "case-"}};
  for (const Row& row : rows) CHECK(anchor(row.name) == row.anchor);
  CHECK(anchor("sphere", StepsInReport::several) == "case-02-x.sphere");
  CHECK(anchor_text(test::hostile_text()).find_first_of(" \t\n\"'<>&#%./\x1b\x7f") == std::string::npos);
}

TEST_CASE("a report begins at its first cause") {
  SubmissionResult result = test::sample();
  CHECK(place_to_begin(result) == "#case-02-blinn-phong.highlight");
  result.steps.erase(result.steps.begin());  // the step that passed
  CHECK(place_to_begin(result) == "#case-highlight");
  result.steps[0].causes.clear();
  CHECK(place_to_begin(result) == "");
}

TEST_CASE("passed cases are counted in words") {
  CHECK(passed_words(31, 48) == "31 of 48 cases passed");
  CHECK(passed_words(48, 48) == "All 48 cases passed");
  CHECK(passed_words(0, 1) == "0 of 1 case passed");
  CHECK(passed_words(1, 1) == "1 of 1 case passed");
  CHECK(passed_words(0, 0) == "0 of 0 cases passed");
}

TEST_CASE("markup is escaped") {
  CHECK(escape_markup("a<b>&\"'") == "a&lt;b&gt;&amp;&quot;&#39;");
  CHECK(escape_markup("one\r\ntwo\t") == "one\ntwo\t");
  const std::string escaped = escape_markup(test::hostile_text());
  CHECK(escaped.find_first_of("<>\"'\x1b\x07\x08\x0b\x7f") == std::string::npos);
  CHECK(escaped == printable(escaped, Layout::keep_lines));  // nothing is left to replace
}

TEST_CASE("base64 as in RFC 4648, section 10") {
  const char* const rows[][2] = {{"", ""},
                                 {"f", "Zg=="},
                                 {"fo", "Zm8="},
                                 {"foo", "Zm9v"},
                                 {"foob", "Zm9vYg=="},
                                 {"fooba", "Zm9vYmE="},
                                 {"foobar", "Zm9vYmFy"}};
  for (const auto& row : rows) CHECK(base64(std::as_bytes(std::span(std::string_view(row[0])))) == row[1]);
  const std::byte high[] = {std::byte(0xFF), std::byte(0xFE), std::byte(0xFB)};
  CHECK(base64(high) == "//77");
}
