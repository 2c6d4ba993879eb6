#include "judge/report/report_html.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "base/printable.hpp"
#include "catch.hpp"
#include "judge/report/report_words.hpp"
#include "sample.hpp"

using namespace atelier;
using namespace atelier::judge;

namespace {

int occurrences(std::string_view text, std::string_view words) {
  int found = 0;
  for (std::size_t at = text.find(words); at != text.npos; at = text.find(words, at + words.size())) ++found;
  return found;
}

/// The first of these words that does not follow the one before it in the text; empty if all follow.
std::string out_of_order(std::string_view text, const std::vector<std::string>& words) {
  std::size_t at = 0;
  for (const std::string& word : words) {
    at = text.find(word, at);
    if (at == text.npos) return word;
    at += word.size();
  }
  return {};
}

std::string between(std::string_view text, std::string_view begin, std::string_view end) {
  const std::size_t from = text.find(begin);
  if (from == text.npos) return {};
  return std::string(text.substr(from, text.find(end, from) - from));
}

/// The values of an attribute, in order.
std::vector<std::string> values(std::string_view html, std::string_view attribute) {
  const std::string begin = " " + std::string(attribute) + "=\"";
  std::vector<std::string> found;
  for (std::size_t at = html.find(begin); at != html.npos; at = html.find(begin, at)) {
    at += begin.size();
    found.emplace_back(html.substr(at, html.find('"', at) - at));
  }
  return found;
}

/// The first tag that closes no open element, or the elements left open: empty if all are nested rightly.
std::string nesting_error(std::string_view html) {
  constexpr std::array<std::string_view, 3> without_end = {"meta", "img", "!DOCTYPE"};
  std::vector<std::string_view> open;
  for (std::size_t at = html.find('<'); at != html.npos; at = html.find('<', at + 1)) {
    const bool closes = html[at + 1] == '/';
    const std::size_t name_at = at + 1 + (closes ? 1 : 0);
    const std::string_view name = html.substr(name_at, html.find_first_of(" >\n", name_at) - name_at);
    if (closes) {
      if (open.empty() || open.back() != name) return "</" + std::string(name) + ">";
      open.pop_back();
    } else if (std::find(without_end.begin(), without_end.end(), name) == without_end.end()) {
      open.push_back(name);
      if (name == "script" || name == "style") at = html.find("</", at) - 1;  // text up to its end
    }
  }
  return open.empty() ? "" : "<" + std::string(open.back()) + ">";
}

/// Elements are nested, ids are unique, and every link leads to one; every case has an id and a link to itself.
void check_page(const SubmissionResult& result) {
  const std::string html = html_report(result);
  CHECK(nesting_error(html) == "");
  const std::vector<std::string> ids = values(html, "id"), links = values(html, "href");
  const std::set<std::string> places(ids.begin(), ids.end());
  CHECK(places.size() == ids.size());
  for (const std::string& link : links) {
    INFO(link);
    CHECK((link.starts_with("#") && places.contains(link.substr(1))));
  }
  for (const StepResult& step : result.steps) {
    for (const CaseResult& c : step.cases) {
      const std::string anchor = case_anchor(step, c, steps_in(result));
      INFO(anchor);
      CHECK(places.contains(anchor));
      CHECK(std::count(links.begin(), links.end(), "#" + anchor) == 1);
    }
  }
}

CaseResult named(CaseResult result, const std::string& name, const std::string& waits_for = "") {
  result.name = name, result.waits_for = waits_for;
  return result;
}

/// A step with a passed case, a wrong function that two pictures wait for, and functions as in the skeleton.
SubmissionResult caused_sample() {
  StepResult step{.step = "02-blinn-phong", .title = "Blinn-Phong shading", .score = 2, .max_score = 10};
  step.cases = {test::passed_picture(),
                named(test::failed_probe(), "attenuation"),
                named(test::failed_probe(), "attenuation-far"),
                named(test::failed_picture(), "lamps", "attenuation"),
                named(test::failed_picture(), "hall", "attenuation"),
                named(test::failed_probe(), "cone"),
                named(test::failed_probe(), "encode")};
  step.causes = {
      {.kind = Cause::Kind::function,
       .functions = {"attenuation"},
       .inputs = 6,
       .wrong = 2,
       .shown = {1, 2},
       .waiting = {3, 4}},
      {.kind = Cause::Kind::unwritten, .functions = {"cone", "encode"}, .shown = {5}, .waiting = {6}},
  };
  return {.submission = "ada", .score = 2, .max_score = 10, .steps = {step}, .environment = {}, .notes = {}};
}

SubmissionResult passed_sample() {
  StepResult step{.step = "02-blinn-phong", .title = "Blinn-Phong shading", .score = 4, .max_score = 4};
  CaseResult probe = named(test::failed_probe(), "probe");
  probe.status = Status::passed, probe.score = probe.max_score;
  step.cases = {test::passed_picture(), probe};
  return {.submission = "ada", .score = 4, .max_score = 4, .steps = {step}, .environment = {}, .notes = {}};
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
  CHECK(occurrences(html, "<img") == occurrences(html, "src=\"data:image/png;base64,"));
  CHECK(occurrences(html, " alt=\"") == occurrences(html, "<img"));
}

TEST_CASE("every case has one place and a link to it, and the page is well formed") {
  check_page(test::sample());
  check_page(test::unbuilt_sample(41));
  check_page(test::hostile_sample());
  check_page(caused_sample());
  check_page(passed_sample());
  check_page({});
}

TEST_CASE("the page begins with the first cause, and passed cases come last") {
  const std::string html = html_report(caused_sample());
  CHECK(out_of_order(html, {"<h1>ada",
                            "1 of 7 cases passed",
                            "<details class=\"case cause\" id=\"case-attenuation\" open>",
                            "Begin with attenuation: wrong for 2 of 6 inputs; 4 failing cases need it",
                            "<div class=\"case\" id=\"case-lamps\">",
                            "seen in</span> <a class=\"name\" href=\"#case-lamps\">lamps</a>",
                            "data-role=\"yours\"",
                            "data-role=\"reference\"",
                            "data-role=\"difference\"",
                            "<dt>found</dt><dd>1 of 3 results is wrong",
                            "<dt>try next</dt>",
                            "<code class=\"command\">./atelier check 02 --case attenuation-extremes",
                            "&lt;-- wrong",
                            "more of</span> lamps",
                            "<dt>rerun</dt>",
                            "data-role=\"flip\"",
                            "data-role=\"mask\"",
                            "data-role=\"signed\"",
                            "data-role=\"mistake\"",
                            "also wrong</span> 1 case <span class=\"soft\">attenuation-far",
                            "waiting</span> 1 case <span class=\"soft\">hall",
                            "<details class=\"case cause\" id=\"case-cone\">",
                            "Then cone: it answers as in the skeleton",
                            "also to do encode</span>",
                            "waiting</span> 1 case <span class=\"soft\">encode",
                            "<details class=\"list passed-cases\">",
                            "1 of 7 cases passed",
                            "case-diffuse"}) == "");
  CHECK(occurrences(html, "<table") == 0);
  CHECK(occurrences(html, " open>") == 1);  // all but the first cause is folded
}

TEST_CASE("what must be known before the points is said before all else of a step") {
  SubmissionResult result = test::sample();
  result.steps[1].caveat = "It uses 01-transforms (untouched).";
  const std::string page = html_report(result);
  CHECK(out_of_order(page, {"<h2><span>" + result.steps[1].title, "<strong>It uses 01-transforms (untouched).</strong>",
                            "<details"})
            .empty());
}

TEST_CASE("only the pictures seen first are decoded at once") {
  const std::string html = html_report(caused_sample());
  const std::string first = between(html, "id=\"case-lamps\"", "<dl>");
  CHECK(occurrences(first, "<img") == 3);
  CHECK(occurrences(first, "loading=\"lazy\"") == 0);
  CHECK(occurrences(html, "<img") == 9 + 9 + 2);  // each once
  CHECK(occurrences(html, "loading=\"lazy\"") == 6 + 9 + 2);
}

TEST_CASE("a wrong picture shows itself, and a crash what the program printed") {
  const std::string html = html_report(test::sample());
  const std::string highlight = between(html, "id=\"case-02-blinn-phong.highlight\" open>", "</details>");
  CHECK(out_of_order(highlight, {"Begin with highlight", "data-role=\"yours\"", "<dt>looks like</dt>"}) == "");
  CHECK(occurrences(highlight, "seen in") == 0);
  const std::string crash = between(html, "id=\"case-02-blinn-phong.lights\">", "</details>");
  CHECK(out_of_order(crash, {"class=\"status crashed\">crashed", "Then lights", "segmentation fault", "Program output",
                             "about to draw"}) == "");
  CHECK(occurrences(crash, "<img") == 0);
}

TEST_CASE("probes alone make a page without pictures") {
  SubmissionResult result = caused_sample();
  for (CaseResult& c : result.steps[0].cases) c.evidence.reset();
  check_page(result);
  const std::string html = html_report(result);
  CHECK(occurrences(html, "<img") == 0);
  CHECK(occurrences(html, "class=\"pictures\"") == 0);
  CHECK(out_of_order(html, {"Begin with attenuation", "<dt>found</dt>",
                            "waiting</span> 2 cases <span class=\"soft\">lamps, hall", "id=\"case-lamps\""}) == "");
}

TEST_CASE("when everything has passed, this is said first and the pictures are in sight") {
  const std::string html = html_report(passed_sample());
  CHECK(out_of_order(html, {"4 / 4 points", "<p class=\"tally passed\">All 2 cases passed</p>",
                            "<details class=\"list passed-cases\" open>",
                            "<article class=\"case card\" id=\"case-diffuse\">", "data-role=\"yours\"",
                            "data-role=\"reference\"", "<details class=\"case\" id=\"case-probe\">"}) == "");
  CHECK(occurrences(html, "Begin with") == 0);
  SubmissionResult probes = passed_sample();
  probes.steps[0].cases[0].evidence.reset();
  CHECK(occurrences(html_report(probes), " open>") == 0);  // nothing to look at
}

TEST_CASE("steps with something to correct come before those that passed") {
  const std::string html = html_report(test::sample());
  CHECK(out_of_order(html, {"<nav", "href=\"#step-01-transforms\"", "2 / 2", "href=\"#step-02-blinn-phong\"",
                            "2.45 / 9", "</nav>", "<section id=\"step-02-blinn-phong\">", "2.45 / 9 points",
                            "<section id=\"step-01-transforms\">"}) == "");
  CHECK(occurrences(html_report(caused_sample()), "<nav") == 0);
}

TEST_CASE("equal failures are explained once, and each case keeps its place") {
  const SubmissionResult result = test::unbuilt_sample(41);
  const std::string html = html_report(result);
  CHECK(occurrences(html, "<details class=\"case") == 1);
  CHECK(out_of_order(html, {"Compiler output", "does not name a type", "Begin with these 41 cases: build failed",
                            "0 / 82 points", "<li id=\"case-case-0\"", "<li id=\"case-case-40\"", "<dt>found</dt>",
                            "does not name a type", "Fix the first compiler error."}) == "");
  CHECK(occurrences(html, "does not name a type") == 2);  // of the compiler, in the cause
  CHECK(test::mentions(html, {"../x leads out of the archive&#39;s folder", "0 of 41 cases passed"}));
}

TEST_CASE("a failing case that belongs to no cause is shown too") {
  SubmissionResult result = caused_sample();
  result.steps[0].causes.pop_back();
  check_page(result);
  CHECK(test::mentions(html_report(result), {"other cases</span> 2 cases <span class=\"soft\">cone, encode"}));
}

TEST_CASE("hostile text is escaped") {
  const std::string html = html_report(test::hostile_sample());
  CHECK(html.find("<script>alert") == std::string::npos);
  CHECK(html.find("<img src=x") == std::string::npos);
  CHECK(occurrences(html, "<script") == 1);
  CHECK(occurrences(html, "</script") == 1);
  CHECK(printable(html, Layout::keep_lines) == html);
}

TEST_CASE("names of any characters are places, and are shown as they are") {
  SubmissionResult result = caused_sample();
  const char* const names[] = {"a \"b\"", "a<b", "a#b", "a b", "a-b", "Münze", "a%20b"};
  for (std::size_t i = 0; i < std::size(names); ++i) result.steps[0].cases[i].name = names[i];
  check_page(result);
  CHECK(test::mentions(
      html_report(result),
      {"<a class=\"name\" href=\"#case-a~20~22b~22\">a &quot;b&quot;</a>",
       "<a class=\"name\" href=\"#case-a~3Cb\">a&lt;b</a>", "href=\"#case-a~23b\">a#b<", "href=\"#case-a~20b\">a b<",
       "href=\"#case-a-b\">a-b<", "href=\"#case-M~C3~BCnze\">Münze<", "href=\"#case-a~2520b\">a%20b<"}));
}

TEST_CASE("empty results make a page") {
  CHECK(test::mentions(html_report({}), {"0 of 0 cases passed", "</html>"}));
}

TEST_CASE("a report has a place for one comment, which a later one replaces") {
  const std::string page = html_report(test::sample());
  const std::string once = with_comment(page, "Well <done>\nin time");
  CHECK(test::mentions(once, {"<p class=\"comment\">Well &lt;done&gt;\nin time</p>"}));
  CHECK(nesting_error(once) == "");
  CHECK(with_comment(with_comment(once, "Again </aside>"), "") == page);
  CHECK(with_comment("<p>another page</p>", "text") == "<p>another page</p>");
  const std::string hostile = html_report(test::hostile_sample());
  CHECK(with_comment(with_comment(hostile, test::hostile_text()), "") == hostile);
}
