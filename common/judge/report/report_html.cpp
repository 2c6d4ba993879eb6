#include "judge/report/report_html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string_view>
#include <vector>

#include "base/base64.hpp"
#include "base/file.hpp"
#include "base/sha256.hpp"
#include "image_io/image_io.hpp"
#include "judge/report/report_assets.hpp"
#include "judge/report/report_pictures.hpp"
#include "judge/report/report_words.hpp"

namespace atelier::judge {
namespace {

constexpr int small_side = 256;  // the page enlarges smaller pictures with sharp pixels

/// The script's hash for the content security policy, which allows only this script to run.
std::string script_hash() {
  const std::string digits = sha256(report_script);
  std::vector<std::byte> bytes;
  for (std::size_t i = 0; i < digits.size(); i += 2)
    bytes.push_back(std::byte(std::stoi(digits.substr(i, 2), nullptr, 16)));
  return "sha256-" + base64(bytes);
}

std::string status_label(Status status) {
  return fmt::format("<span class=\"status {}\">{}</span>", to_string(status), status_words(status));
}

/// The class of cases that the filter hides.
const char* passed_class(const CaseResult& result) {
  return result.status == Status::passed ? " passed-case" : "";
}

std::string picture_html(const ReportPicture& picture) {
  const std::string data = base64(encode_png(picture.pixels, {.encoding = Encoding::srgb}));
  const bool small = picture.pixels.width() < small_side;
  return fmt::format(
      "<figure data-role=\"{}\"><button><img{} width=\"{}\" height=\"{}\" alt=\"{}\" data-title=\"{}\" "
      "src=\"data:image/png;base64,{}\"></button><figcaption>{}</figcaption></figure>\n",
      picture.role, small ? " class=\"small\"" : "", picture.pixels.width(), picture.pixels.height(),
      escape_markup(picture.alt), escape_markup(picture.title), data, escape_markup(picture.title));
}

std::string remark_html(const Remark& remark) {
  const char* const looks = remark.label == "looks like" ? " class=\"looks\"" : "";
  std::string text = escape_markup(remark.text);
  if (remark.label == "rerun") text = "<code class=\"command\">" + text + "</code>";
  return fmt::format("<dt{}>{}</dt><dd{}>{}</dd>\n", looks, remark.label, looks, text);
}

std::string figures_html(const CaseResult& result) {
  if (result.figures.empty()) return {};
  std::string html = "<div class=\"figures\">";
  for (const auto& [name, value] : result.figures) {
    html += fmt::format("<span>{} <b>{:.4g}</b></span> ", escape_markup(name), value);
  }
  return html + "</div>\n";
}

std::string text_block(const char* label, const std::string& text, const char* kind = "") {
  if (text.empty()) return {};
  return fmt::format("<div class=\"soft\">{}</div><pre{}>{}</pre>\n", label, kind, escape_markup(text));
}

/// The names of a group's cases, each with its anchor "STEP.CASE".
std::string names_html(const StepResult& step, const CaseGroup& group) {
  std::string html = "<p class=\"soft names\">";
  for (const CaseResult* c : group)
    html += fmt::format("<span id=\"{}\" title=\"{}\">{}</span> ", case_anchor(step, *c), escape_markup(c->title),
                        escape_markup(c->name));
  return html + "</p>\n";
}

/// One case, or several with the same failure.
std::string group_html(const StepResult& step, const CaseGroup& group) {
  const CaseResult& first = *group.front();
  const bool several = group.size() > 1;
  const Points sum = sum_of(group);
  std::string html = fmt::format(
      "<details class=\"case{}\"{}{}>\n<summary>{}<span class=\"title\">{}</span><span class=\"soft mono\">{}"
      "</span><span class=\"score\">{}</span></summary>\n<div class=\"body\">\n",
      passed_class(first), several ? "" : fmt::format(" id=\"{}\"", case_anchor(step, first)),
      first.status == Status::passed ? "" : " open", status_label(first.status),
      escape_markup(several ? cases_words(group) : first.title), several ? "" : escape_markup(first.name),
      score_text(sum.score, sum.max_score));
  if (several) html += names_html(step, group);
  html += "<dl>\n";
  for (const Remark& remark : remarks(group)) html += remark_html(remark);
  html += "</dl>\n" + figures_html(first) + text_block("Inputs and numbers", first.table, " class=\"table\"");
  if (const std::vector<ReportPicture> pictures = report_pictures(first); !pictures.empty()) {
    html += "<div class=\"pictures\">\n";
    for (const ReportPicture& picture : pictures) html += picture_html(picture);
    html += "</div>\n";
  }
  return html + text_block("Program output", output_of(group)) + "</div>\n</details>\n";
}

std::string step_html(const StepResult& step) {
  std::string html = fmt::format(
      "<section>\n<h2><span>{}</span><span class=\"soft mono\">{}</span><span class=\"score\">"
      "{}</span></h2>\n",
      escape_markup(step.title), escape_markup(step.step), score_text(step.score, step.max_score));
  if (!step.implementations.empty()) {
    html += "<p class=\"soft\">Code used";
    const char* separator = ": ";
    for (const auto& [of_step, who] : step.implementations) {
      html += fmt::format("{}{} ({})", separator, escape_markup(of_step), escape_markup(who));
      separator = ", ";
    }
    html += fmt::format("; compared with {} references</p>\n", escape_markup(step.references));
  }
  html += text_block("Compiler output", step.build_log);
  for (const CaseGroup& group : case_groups(step)) html += group_html(step, group);
  return html + "</section>\n";
}

/// Whether a remark is about a whole cause: the others stand with its case.
bool is_of_cause(const Remark& remark) {
  constexpr std::string_view labels[] = {"looks like", "also wrong", "also to do", "seen in", "may be in", "waiting"};
  return std::find(std::begin(labels), std::end(labels), remark.label) != std::end(labels);
}

/// What to correct, in order, each with a link to the case that shows it best.
std::string causes_html(const StepResult& step) {
  if (step.causes.empty()) return {};
  std::string html = fmt::format("<section class=\"causes\">\n<h2>{}</h2>\n<ol>\n", escape_markup(step.title));
  for (std::size_t i = 0; i < step.causes.size(); ++i) {
    const Cause& cause = step.causes[i];
    html += fmt::format("<li><a href=\"#{}\">{}</a><dl>\n", case_anchor(step, shown_case(step, cause)),
                        escape_markup(headline(step, i)));
    for (const Remark& remark : remarks(step, cause))
      if (is_of_cause(remark)) html += remark_html(remark);
    html += "</dl></li>\n";
  }
  return html + "</ol>\n</section>\n";
}

std::string table_html(const SubmissionResult& result) {
  std::string html =
      "<table>\n<thead><tr><th scope=\"col\">Case</th><th scope=\"col\" class=\"verdict\">Verdict</th><th "
      "scope=\"col\" class=\"reason\">"
      "Reason</th><th scope=\"col\" class=\"score\">Points</th></tr></thead>\n";
  for (const StepResult& step : result.steps) {
    html += fmt::format(
        "<tbody>\n<tr><th scope=\"rowgroup\" colspan=\"3\">{} <span class=\"soft mono\">{}</span></th>"
        "<th class=\"score\">{} / {}</th></tr>\n",
        escape_markup(step.title), escape_markup(step.step), points_text(step.score), points_text(step.max_score));
    for (const CaseGroup& group : case_groups(step)) {
      const CaseResult& first = *group.front();
      const Points sum = sum_of(group);
      html += fmt::format(
          "<tr class=\"row{}\"><td><a href=\"#{}\">{}</a></td><td>{}</td><td class=\"reason\">{}</td>"
          "<td class=\"score\">{} / {}</td></tr>\n",
          passed_class(first), case_anchor(step, first),
          escape_markup(group.size() > 1 ? cases_words(group) : first.title), status_label(first.status),
          escape_markup(first.reason), points_text(sum.score), points_text(sum.max_score));
    }
    html += "</tbody>\n";
  }
  return html + "</table>\n";
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
  return fmt::format(
      "<header class=\"top\">\n<h1>{}</h1><span class=\"score total\">{}</span>\n<div class=\"bar\" role=\"img\" "
      "aria-label=\"{} of {} cases passed\">{}</div>\n<p class=\"tally\">{} of {} cases passed</p>\n</header>\n",
      escape_markup(result.submission), score_text(result.score, result.max_score), passed, cases, bar, passed, cases);
}

std::string notes_html(const std::vector<std::string>& notes) {
  if (notes.empty()) return {};
  std::string html = "<p class=\"soft\">Skipped in this submission:</p>\n<ul>\n";
  for (const std::string& note : notes) html += "<li>" + escape_markup(note) + "</li>\n";
  return html + "</ul>\n";
}

std::string footer_html(const Environment& environment) {
  std::string html = "<footer>\n<div>Environment</div>\n<dl>\n";
  for (const auto& [name, value] : environment) {
    html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", escape_markup(name), escape_markup(value));
  }
  return html + "</dl>\n</footer>\n";
}

}  // namespace

std::string html_report(const SubmissionResult& result) {
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; style-src "
      "'unsafe-inline'; script-src '{}'\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{}: {}</title>\n<style>{}</style>\n</head>\n<body>\n",
      script_hash(), escape_markup(result.submission), score_text(result.score, result.max_score), report_css);
  html += header_html(result) +
          "<main>\n<p class=\"tools\"><button id=\"filter\" aria-pressed=\"false\" hidden>Hide passed "
          "cases</button></p>\n" +
          notes_html(result.notes);
  for (const StepResult& step : result.steps) html += causes_html(step);
  html += table_html(result);
  for (const StepResult& step : result.steps) html += step_html(step);
  html += "</main>\n" + footer_html(result.environment);
  html +=
      "<dialog id=\"viewer\"><figure><img alt=\"\"><figcaption><span class=\"caption\"></span> <span class=\"soft\">"
      "\u2190 \u2192 to change, Esc to close</span></figcaption></figure></dialog>\n";
  return html + fmt::format("<script>{}</script>\n</body>\n</html>\n", report_script);
}

void write_html_report(const std::filesystem::path& file, const SubmissionResult& result) {
  write_file(file, html_report(result));
}

}  // namespace atelier::judge
