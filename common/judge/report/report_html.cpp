#include "judge/report/report_html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/base64.hpp"
#include "base/file.hpp"
#include "base/sha256.hpp"
#include "judge/report/html_step.hpp"
#include "judge/report/report_assets.hpp"
#include "judge/report/report_words.hpp"

namespace atelier::judge {
namespace {

/// The script's hash for the content security policy, which allows only this script to run.
std::string script_hash() {
  const std::string digits = sha256(report_script);
  std::vector<std::byte> bytes;
  for (std::size_t i = 0; i < digits.size(); i += 2)
    bytes.push_back(std::byte(std::stoi(digits.substr(i, 2), nullptr, 16)));
  return "sha256-" + base64(bytes);
}

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

std::string footer_html(const Environment& environment) {
  if (environment.empty()) return {};
  std::string html = "<footer>\n<details class=\"list\">\n<summary>Environment</summary>\n<dl>\n";
  for (const auto& [name, value] : environment) {
    html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", escape_markup(name), escape_markup(value));
  }
  return html + "</dl>\n</details>\n</footer>\n";
}

}  // namespace

std::string html_report(const SubmissionResult& result) {
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; style-src "
      "'unsafe-inline'; script-src '{}'\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{}: {}</title>\n<style>{}</style>\n</head>\n<body>\n",
      script_hash(), escape_markup(result.submission), score_text(result.score, result.max_score), report_css);
  html += header_html(result) + "<main>\n" + notes_html(result.notes) + steps_html(result.steps);
  for (const bool passed : {false, true})
    for (const StepResult& step : result.steps)
      if (all_passed(step) == passed) html += step_html(step, steps_in(result));
  html += "</main>\n" + footer_html(result.environment);
  return html + fmt::format("<script>{}</script>\n</body>\n</html>\n", report_script);
}

void write_html_report(const std::filesystem::path& file, const SubmissionResult& result) {
  write_file(file, html_report(result));
}

}  // namespace atelier::judge
