#include "grade/results/class_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "base/base64.hpp"
#include "base/file.hpp"
#include "base/near_names.hpp"
#include "grade/results/class_assets.hpp"
#include "grade/results/class_statistics.hpp"
#include "grade/results/class_table.hpp"
#include "grade/results/histogram.hpp"
#include "grade/results/mistake_pictures.hpp"
#include "judge/report/html_page.hpp"
#include "judge/report/report_assets.hpp"
#include "judge/report/report_words.hpp"

namespace atelier::grade {
namespace {

using judge::escape_markup;

constexpr std::size_t most_named = 30;  // students in one list of links

std::string links_html(const std::vector<const ClassRow*>& rows) {
  std::string html;
  for (std::size_t i = 0; i < std::min(rows.size(), most_named); ++i)
    html += (i == 0 ? "" : ", ") + student_link(*rows[i]);
  return rows.size() > most_named ? html + fmt::format(" and {} more", rows.size() - most_named) : html;
}

std::string duration_words(double seconds) {
  if (seconds < 60) return fmt::format("{:.1f} s", seconds);
  const auto whole = static_cast<long long>(seconds);
  if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole / 60 % 60);
}

std::string header_html(const ClassResults& results) {
  const ClassSummary& summary = results.summary;
  std::vector<std::string> parts;
  if (!results.course.title.empty()) parts.push_back(escape_markup(results.course.title));
  parts.push_back(fmt::format("{} {}", results.steps.size(), results.steps.size() == 1 ? "step" : "steps"));
  if (!summary.platform.empty()) parts.push_back("names as in " + escape_markup(summary.platform));
  if (summary.seconds > 0) parts.push_back("graded in " + duration_words(summary.seconds));
  return fmt::format(
      "<header class=\"top\">\n<h1>{}</h1><span class=\"total\">{}</span>\n<p class=\"tally\">{}</p>\n</header>\n",
      escape_markup(summary.name), students_words(results.rows.size()), join(parts, " &middot; "));
}

/// What the class as a whole must have looked at, beside single students.
std::vector<std::string> warnings(const ClassResults& results, const ClassStatistics& statistics) {
  std::vector<std::string> sentences = results.unsaid;
  for (const auto& [tier, submissions] : statistics.sandboxes)
    if (tier == "none")
      sentences.push_back(
          fmt::format("The programs of {} ran without a sandbox: what they printed and drew may be forged.",
                      students_words(std::size_t(submissions))));
  return sentences;
}

std::string needs_human_html(const ClassResults& results, const ClassStatistics& statistics) {
  std::string items;
  for (const std::string& warning : warnings(results, statistics)) items += "<li>" + escape_markup(warning) + "</li>\n";
  for (const HumanReason& reason : statistics.needs_human)
    items += fmt::format("<li>{}<br>{}</li>\n", escape_markup(reason.reason), links_html(reason.students));
  const std::string list = items.empty() ? "<p class=\"passed\">Nothing needs a human.</p>\n"
                                         : "<ul class=\"reasons\">\n" + items + "</ul>\n";
  return "<section id=\"needs-human\">\n<h2>Needs a human</h2>\n" + list + "</section>\n";
}

/// The first picture of a mistake that any of its students has; nothing if there is none.
std::string picture_html(const ClassResults& results, const MistakeStatistics& mistake) {
  for (const ClassRow* row : mistake.students) {
    const std::filesystem::path file =
        mistake_picture(pictures_folder(results.folder, row->record), mistake.step, mistake.mistake);
    std::error_code none;
    const std::uintmax_t size = std::filesystem::file_size(file, none);
    if (none || size > mistake_picture_limit) continue;
    const std::string png = read_file(file, mistake_picture_limit);
    return fmt::format(
        "<img loading=\"lazy\" alt=\"A student's picture, the reference and their difference\" "
        "src=\"data:image/png;base64,{}\">\n",
        base64(std::as_bytes(std::span(png))));
  }
  return {};
}

std::string mistake_html(const ClassResults& results, const MistakeStatistics& mistake) {
  return fmt::format(
      "<article class=\"chart\">\n{}<h3>{}</h3>\n<p class=\"soft\"><span class=\"mono\">{}</span>: {}, {}</p>\n"
      "<p>{}</p>\n<details class=\"list\">\n<summary>who</summary>\n<p>{}</p>\n</details>\n</article>\n",
      picture_html(results, mistake), escape_markup(mistake.title.empty() ? mistake.mistake : mistake.title),
      escape_markup(mistake.step), students_words(mistake.students.size()),
      judge::cases_words(std::size_t(mistake.cases)), escape_markup(mistake.sentence), links_html(mistake.students));
}

std::string mistakes_html(const ClassResults& results, const ClassStatistics& statistics) {
  if (statistics.mistakes.empty()) return {};
  std::string html = "<section id=\"mistakes\">\n<h2>Mistakes made by most</h2>\n<div class=\"charts\">\n";
  const std::size_t shown = std::min(statistics.mistakes.size(), most_mistakes_shown);
  for (std::size_t i = 0; i < shown; ++i) html += mistake_html(results, statistics.mistakes[i]);
  html += "</div>\n";
  if (shown < statistics.mistakes.size())
    html += fmt::format("<p class=\"soft\">{} more are in class.json.</p>\n", statistics.mistakes.size() - shown);
  return html + "</section>\n";
}

std::string histograms_html(const ClassStatistics& statistics) {
  if (statistics.steps.empty()) return {};
  std::string html = "<section id=\"steps\">\n<h2>Points in each step</h2>\n<div class=\"charts\">\n";
  for (const StepStatistics& step : statistics.steps) html += histogram_html(step);
  return html + "</div>\n</section>\n";
}

std::string slowest_html(const ClassStatistics& statistics) {
  std::string items;
  for (const ClassRow* row : statistics.slowest) {
    std::string parts;
    for (const auto& [part, seconds] : row->record.seconds)
      parts += fmt::format("{}{} {}", parts.empty() ? "" : ", ", escape_markup(part), duration_words(seconds));
    items += fmt::format("<li>{} <b>{}</b> <span class=\"soft\">{}</span></li>\n", student_link(*row),
                         duration_words(seconds_of_work(row->record)), parts);
  }
  if (items.empty()) return {};
  return "<section id=\"slowest\">\n<h2>Slowest submissions</h2>\n<ol>\n" + items + "</ol>\n</section>\n";
}

/// How the class was graded: sandbox, entries that were ignored.
std::string running_html(const ClassResults& results, const ClassStatistics& statistics) {
  std::string html = "<section id=\"running\">\n<h2>How it was graded</h2>\n<dl>\n";
  for (const auto& [tier, submissions] : statistics.sandboxes)
    html += fmt::format("<dt>sandbox</dt><dd>{}: {}</dd>\n", escape_markup(tier.empty() ? "unknown" : tier),
                        students_words(std::size_t(submissions)));
  html += "</dl>\n";
  if (!results.summary.ignored.empty()) {
    html += "<p class=\"label\">Ignored in the class's folder</p>\n<ul>\n";
    for (const std::string& entry : results.summary.ignored) html += "<li>" + escape_markup(entry) + "</li>\n";
    html += "</ul>\n";
  }
  return html + "</section>\n";
}

}  // namespace

std::string class_html(const ClassResults& results) {
  const ClassStatistics statistics = class_statistics(results);
  const std::string body = header_html(results) + "<main>\n" + needs_human_html(results, statistics) +
                           "<section id=\"students\">\n<h2>Students</h2>\n" + class_table_html(results, statistics) +
                           "</section>\n" + histograms_html(statistics) + mistakes_html(results, statistics) +
                           slowest_html(statistics) + running_html(results, statistics) + "</main>\n" +
                           judge::environment_footer(results.summary.environment);
  return judge::html_page({.title = results.summary.name + ": " + students_words(results.rows.size()),
                           .style = std::string(judge::report_css) + std::string(class_css),
                           .body = body,
                           .script = std::string(class_script)});
}

}  // namespace atelier::grade
