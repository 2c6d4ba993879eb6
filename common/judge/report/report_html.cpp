#include "judge/report/report_html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

#include "base/file.hpp"
#include "judge/report/html_page.hpp"
#include "judge/report/html_step.hpp"
#include "judge/report/kept_steps.hpp"
#include "judge/report/report_assets.hpp"
#include "judge/report/report_words.hpp"

namespace atelier::judge {
namespace {

bool all_passed(const StepResult& step) {
  return std::size_t(count(step, Status::passed)) == step.cases.size();
}

std::string header_html(const SubmissionResult& result) {
  std::size_t cases = 0;
  int passed = 0;
  std::string bar;
  for (const StepResult& step : result.steps) {
    cases += step.cases.size();
    passed += count(step, Status::passed);
    for (const CaseResult& c : step.cases) bar += fmt::format("<span class=\"{}\"></span>", to_string(c.status));
  }
  const std::string words = passed_words(passed, cases);
  return fmt::format(
      "<header class=\"top\">\n<h1>{}</h1><span class=\"score total\">{}</span>\n<div class=\"bar\" role=\"img\" "
      "aria-label=\"{}\">{}</div>\n<p class=\"tally{}\">{}</p>\n</header>\n",
      escape_markup(result.submission), score_text(result.score, result.max_score), words, bar,
      cases > 0 && passed == int(cases) ? " passed" : "", words);
}

std::string notes_html(const std::vector<std::string>& notes) {
  if (notes.empty()) return {};
  std::string html = "<p class=\"soft\">Notes on this submission:</p>\n<ul>\n";
  for (const std::string& note : notes) html += "<li>" + escape_markup(note) + "</li>\n";
  return html + "</ul>\n";
}

/// Links to the steps with their points; nothing for a single step.
std::string steps_html(const std::vector<StepResult>& steps) {
  if (steps.size() < 2) return {};
  std::string html = "<nav aria-label=\"Steps\">\n<ul>\n";
  for (const StepResult& step : steps)
    html += fmt::format("<li><a href=\"#{}\">{}</a> <span class=\"score{}\">{} / {}</span></li>\n", step_anchor(step),
                        escape_markup(step.step), all_passed(step) ? " passed" : "", points_text(step.score),
                        points_text(step.max_score));
  return html + "</ul>\n</nav>\n";
}

constexpr std::string_view comment_begin = "<aside id=\"comment\">", comment_end = "</aside>";

std::string section_html(const StepResult& step, StepsInReport steps) {
  return marked_section(step.step, step.kept ? step.kept->html : step_html(step, steps));
}

}  // namespace

std::string html_report(const SubmissionResult& result) {
  std::string body = header_html(result) + "<main>\n" + std::string(comment_begin) + std::string(comment_end) + "\n" +
                     notes_html(result.notes) + steps_html(result.steps);
  for (const bool passed : {false, true})
    for (const StepResult& step : result.steps)
      if (all_passed(step) == passed) body += section_html(step, steps_in(result));
  body += "</main>\n" + environment_footer(result.environment);
  return html_page({.title = result.submission + ": " + score_text(result.score, result.max_score),
                    .style = std::string(report_css),
                    .body = body,
                    .script = std::string(report_script)});
}

std::string with_comment(const std::string& page, const std::string& text) {
  const std::size_t begin = page.find(comment_begin), end = page.find(comment_end, begin);
  if (begin == std::string::npos || end == std::string::npos) return page;
  const std::string html =
      text.empty() ? "" : "<p class=\"label\">From your course</p>\n<p class=\"comment\">" + escape_markup(text) + "</p>\n";
  return page.substr(0, begin + comment_begin.size()) + html + page.substr(end);
}

void write_html_report(const std::filesystem::path& file, const SubmissionResult& result) {
  write_file(file, html_report(result));
}

}  // namespace atelier::judge
