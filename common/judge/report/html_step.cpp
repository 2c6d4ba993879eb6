#include "judge/report/html_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>
#include <vector>

#include "judge/report/html_case.hpp"
#include "judge/report/report_pictures.hpp"

namespace atelier::judge {
namespace {

using Indices = std::vector<std::size_t>;

/// Remarks of a cause that its line, its pictures and its lists of cases show.
bool is_shown_otherwise(const Remark& remark) {
  constexpr std::string_view labels[] = {"cases", "also to do", "seen in", "also wrong", "waiting"};
  return std::find(std::begin(labels), std::end(labels), remark.label) != std::end(labels);
}

class StepPage {
 public:
  StepPage(const StepResult& step, StepsInReport steps) : step_(step), steps_(steps), placed_(step.cases.size()) {}

  std::string html() {
    std::string html = fmt::format(
        "<section id=\"{}\">\n<h2><span>{}</span> <span class=\"soft mono\">{}</span>{}</h2>\n", step_anchor(step_),
        escape_markup(step_.title), escape_markup(step_.step), steps_ == StepsInReport::several ? sums_html() : "");
    if (!step_.caveat.empty()) html += fmt::format("<p><strong>{}</strong></p>\n", escape_markup(step_.caveat));
    html += origin_html();
    html += text_block("Compiler output", step_.build_log);
    for (std::size_t i = 0; i < step_.causes.size(); ++i) html += cause_html(i);
    Indices others;
    for (std::size_t i = 0; i < step_.cases.size(); ++i)
      if (step_.cases[i].status != Status::passed) others.push_back(i);
    return html + list_html("other cases", others) + passed_html() + "</section>\n";
  }

 private:
  std::string anchor(const CaseResult& result) const { return case_anchor(step_, result, steps_); }

  std::size_t index_of(const CaseResult& result) const { return std::size_t(&result - step_.cases.data()); }

  /// Takes a case for the page: false if the page has it already.
  bool place(std::size_t index) {
    const bool is_new = !placed_[index];
    placed_[index] = true;
    return is_new;
  }

  /// The page's heading has them if there is only this step.
  std::string sums_html() const {
    return fmt::format(" <span class=\"score\">{}</span>", score_text(step_.score, step_.max_score));
  }

  std::string origin_html() const {
    if (step_.implementations.empty()) return {};
    std::string html = "<p class=\"soft\">Code used";
    const char* separator = ": ";
    for (const auto& [of_step, who] : step_.implementations) {
      html += fmt::format("{}{} ({})", separator, escape_markup(of_step), escape_markup(who));
      separator = ", ";
    }
    return html + fmt::format("; compared with {} references</p>\n", escape_markup(step_.references));
  }

  /// The first case of a cause with pictures; none if it has none.
  const CaseResult* pictured(const Cause& cause) const {
    Indices candidates = cause.shown;
    if (cause.kind == Cause::Kind::function || cause.kind == Cause::Kind::unwritten)
      candidates.insert(candidates.end(), cause.waiting.begin(), cause.waiting.end());
    for (const std::size_t i : candidates)
      if (!placed_[i] && has_pictures(step_.cases[i])) return &step_.cases[i];
    return nullptr;
  }

  /// Cases under one line that counts and names them, each folded.
  std::string list_html(std::string_view label, const Indices& indices) {
    std::vector<std::string> names;
    std::string cases;
    for (const std::size_t i : indices) {
      if (!place(i)) continue;
      names.push_back(step_.cases[i].name);
      cases += case_html(anchor(step_.cases[i]), step_.cases[i]);
    }
    if (names.empty()) return {};
    return fmt::format(
        "<details class=\"list\">\n<summary><span class=\"label\">{}</span> {} <span class=\"soft\">{}</span>"
        "</summary>\n{}</details>\n",
        label, cases_words(names.size()), escape_markup(some_names(names)), cases);
  }

  /// A failing picture that shows what a wrong function does: what is seen at first, and all that is known about it.
  PicturesHtml seen_html(const CaseResult& result, bool at_once) {
    place(index_of(result));
    PicturesHtml html = pictures_html(result, at_once);
    std::vector<Remark> own = remarks(result);
    std::erase_if(own, [](const Remark& remark) { return remark.label == "waits for" || remark.label == "try next"; });
    html.first =
        fmt::format("<div class=\"case\" id=\"{}\">\n<p><span class=\"label\">seen in</span> {} {}</p>\n{}</div>\n",
                    anchor(result), name_link(anchor(result), result), escape_markup(result.title), html.first);
    html.rest = fmt::format("<details class=\"list\">\n<summary><span class=\"label\">more of</span> {}</summary>\n",
                            escape_markup(result.name)) +
                remarks_html(own) + numbers_html(result) + html.rest + text_block("Program output", result.output) +
                "</details>\n";
    return html;
  }

  /// The names of cases without an answer, each with its place.
  std::string names_html(const CaseGroup& group) const {
    std::string html = "<ul class=\"names\">\n";
    for (const CaseResult* result : group)
      html += fmt::format("<li id=\"{}\" title=\"{}\">{}</li>\n", anchor(*result), escape_markup(result->title),
                          name_link(anchor(*result), *result));
    return html + "</ul>\n";
  }

  /// The line of a cause. Functions that are as in the skeleton stand in it, so that one line says it all.
  std::string cause_summary(std::size_t index, const CaseGroup& group, const std::string& to_do) const {
    const CaseResult& shown = *group.front();
    const Points sum = sum_of(group);
    return fmt::format(
        "<summary>{}<h3>{}</h3> {} <span class=\"score\">{}</span>{}</summary>\n", status_html(shown.status),
        escape_markup(headline(step_, index)), group.size() > 1 ? "" : name_link(anchor(shown), shown),
        score_text(sum.score, sum.max_score),
        to_do.empty() ? "" : "<span class=\"soft to-do\">also to do " + escape_markup(to_do) + "</span>");
  }

  /// What to correct, the first one open: its pictures, its words, then the cases that it explains, folded.
  std::string cause_html(std::size_t index) {
    const Cause& cause = step_.causes[index];
    const CaseResult& shown = shown_case(step_, cause);
    const CaseResult* const picture = pictured(cause);
    const CaseGroup group = cause.kind == Cause::Kind::no_answer ? shown_group(step_, cause) : CaseGroup{&shown};
    const bool first = index == 0, several = group.size() > 1;
    for (const CaseResult* result : group) place(index_of(*result));

    std::string to_do;
    std::vector<Remark> said = remarks(step_, cause);
    std::erase_if(said, [&](const Remark& remark) {
      if (remark.label == "also to do") to_do = remark.text;
      return is_shown_otherwise(remark);
    });
    std::string html = fmt::format("<details class=\"case cause\"{}{}>\n",
                                   several ? "" : fmt::format(" id=\"{}\"", anchor(shown)), first ? " open" : "") +
                       cause_summary(index, group, to_do) + "<div class=\"body\">\n";
    if (several) html += names_html(group);
    PicturesHtml pictures;
    if (picture == &shown)
      pictures = pictures_html(shown, first);
    else if (picture != nullptr)
      pictures = seen_html(*picture, first);
    html += pictures.first + remarks_html(said) + numbers_html(shown) + pictures.rest +
            text_block("Program output", output_of(group)) + list_html("also wrong", cause.shown) +
            list_html(cause.kind == Cause::Kind::picture ? "also wrong" : "waiting", cause.waiting);
    return html + "</div>\n</details>\n";
  }

  /// Pictures as cards, then the rest. In sight if nothing has failed and there is something to look at.
  std::string passed_html() {
    std::string cards, rest;
    for (const CaseResult& result : step_.cases) {
      if (result.status != Status::passed) continue;
      if (has_pictures(result))
        cards += card_html(anchor(result), result);
      else
        rest += case_html(anchor(result), result);
    }
    if (cards.empty() && rest.empty()) return {};
    const bool all = std::size_t(count(step_, Status::passed)) == step_.cases.size();
    if (!cards.empty()) cards = "<div class=\"cards\">\n" + cards + "</div>\n";
    return fmt::format(
        "<details class=\"list passed-cases\"{}>\n<summary><span class=\"label\">{}</span></summary>\n{}{}"
        "</details>\n",
        all && !cards.empty() ? " open" : "", passed_words(step_), cards, rest);
  }

  const StepResult& step_;
  StepsInReport steps_;
  std::vector<bool> placed_;  ///< cases that the page has already
};

}  // namespace

std::string step_html(const StepResult& step, StepsInReport steps) {
  return StepPage(step, steps).html();
}

std::string step_anchor(const StepResult& step) {
  return "step-" + anchor_text(step.step);
}

}  // namespace atelier::judge
