#include "judge/report/report_html.hpp"

#include "base/printable.hpp"
#include "catch.hpp"
#include "judge/report/report_words.hpp"
#include "sample.hpp"

using namespace atelier;
using namespace atelier::judge;

namespace {

int occurrences(const std::string& text, std::string_view words) {
  int found = 0;
  for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + words.size())) ++found;
  return found;
}

}  // namespace

TEST_CASE("the page is self-contained") {
  const std::string html = html_report(test::sample());
  CHECK(html.starts_with("<!DOCTYPE html>"));
  CHECK(test::mentions(html, {"default-src 'none'; img-src data:;", "script-src 'sha256-", "prefers-color-scheme: dark",
                              "@media print"}));
  for (const char* outside : {"http:", "https:", "url(", "@import", "<link", " src=\"/", "<iframe"}) {
    INFO(outside);
    CHECK(html.find(outside) == std::string::npos);
  }
  CHECK(occurrences(html, "<img") == occurrences(html, "src=\"data:image/png;base64,") + 1);  // and the viewer's
  CHECK(occurrences(html, " alt=\"") == occurrences(html, "<img"));
}

TEST_CASE("the page has a table row and a place for each case") {
  const SubmissionResult result = test::sample();
  const std::string html = html_report(result);
  for (const StepResult& step : result.steps) {
    for (const CaseResult& c : step.cases) {
      const std::string anchor = case_anchor(step, c);
      INFO(anchor);
      const bool passed = c.status == Status::passed;
      CHECK(occurrences(html, "href=\"#" + anchor + "\"") == (passed ? 1 : 2));  // of a failure also in the causes
      CHECK(occurrences(html, "id=\"" + anchor + "\"") == 1);
    }
  }
  CHECK(occurrences(html, "<details class=\"case\"") == 6);              // what did not pass ...
  CHECK(occurrences(html, "\" open>") == 6);                             // ... stands open
  CHECK(occurrences(html, "<details class=\"case passed-case\"") == 2);  // what passed is folded
  for (const char* role : {"difference", "flip", "mask", "signed", "mistake"}) {
    INFO(role);
    CHECK(occurrences(html, "<figure data-role=\"" + std::string(role) + "\"") == 1);
  }
  CHECK(occurrences(html, "<figure data-role=\"detail\"") == 2);
}

TEST_CASE("equal failures are explained once, and each case keeps its place") {
  const SubmissionResult result = test::unbuilt_sample(41);
  const std::string html = html_report(result);
  CHECK(occurrences(html, "<details class=\"case\"") == 1);
  CHECK(occurrences(html, "<tr class=\"row\"") == 1);
  CHECK(occurrences(html, "does not name a type") == 3);  // in the table, of the compiler, in its place
  CHECK(occurrences(html, ">41 cases<") == 2);            // in the table, in its place
  CHECK(test::mentions(html, {"0 / 82 points", "../x leads out of the archive&#39;s folder"}));
  for (const CaseResult& c : result.steps[0].cases)
    CHECK(occurrences(html, "id=\"" + case_anchor(result.steps[0], c) + "\"") == 1);
}

TEST_CASE("hostile text is escaped") {
  const std::string html = html_report(test::hostile_sample());
  CHECK(html.find("<script>alert") == std::string::npos);
  CHECK(html.find("<img src=x") == std::string::npos);
  CHECK(occurrences(html, "<script") == 1);
  CHECK(occurrences(html, "</script") == 1);
  CHECK(printable(html, Layout::keep_lines) == html);
}

TEST_CASE("empty results make a page") {
  CHECK(test::mentions(html_report({}), {"0 of 0 cases passed", "</html>"}));
}
