#include "judge/report/report_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/printable.hpp"

namespace atelier::judge {
namespace {

/// Red, green and blue with four significant digits: enough to tell encoded colours and depths apart.
std::string colour_words(const Rgba& c) {
  return fmt::format("{:.4g} {:.4g} {:.4g}", c.r, c.g, c.b);
}

std::string slug(std::string_view text) {
  std::string safe;
  for (char c : text) {
    const bool kept = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
    safe += kept ? c : '-';
  }
  return safe;
}

}  // namespace

std::string points_text(double points) {
  // The small term prevents 0.29, whose floating-point value is slightly smaller, from becoming 0.28.
  const double hundredths = std::floor(points * 100 + 1e-6);
  std::string text = fmt::format("{:.2f}", hundredths / 100);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string score_text(double score, double max_score) {
  return fmt::format("{} / {} {}", points_text(score), points_text(max_score), max_score == 1 ? "point" : "points");
}

std::string status_words(Status status) {
  std::string words = to_string(status);
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

std::string worst_words(const Worst& worst) {
  return fmt::format("pixel ({}, {}): yours {}, reference {}", worst.x, worst.y, colour_words(worst.yours),
                     colour_words(worst.reference));
}

std::vector<Remark> remarks(const CaseResult& result) {
  std::string mistake = result.mistake.value_or("");
  if (result.mistake_sentence && !result.mistake_sentence->empty()) {
    mistake = mistake.empty() ? *result.mistake_sentence : *result.mistake_sentence + " (" + mistake + ")";
  }
  std::vector<Remark> all = {
      {"expected", result.asked}, {"found", result.reason},
      {"looks like", mistake},    {"where", result.worst ? worst_words(*result.worst) : ""},
      {"credit", result.credit},  {"try next", result.hint},
      {"rerun", result.command},
  };
  std::erase_if(all, [](const Remark& remark) { return remark.text.empty(); });
  return all;
}

std::vector<CaseGroup> case_groups(const StepResult& step) {
  std::vector<CaseGroup> groups;
  std::map<std::pair<Status, std::string>, std::size_t> group_of;
  for (const CaseResult& result : step.cases) {
    const bool answered = result.status == Status::passed || result.status == Status::failed;
    const auto [place, is_new] = answered ? std::pair(group_of.end(), true)
                                          : group_of.try_emplace({result.status, result.reason}, groups.size());
    if (is_new)
      groups.push_back({&result});
    else
      groups[place->second].push_back(&result);
  }
  return groups;
}

std::vector<Remark> remarks(const CaseGroup& group) {
  std::vector<Remark> common = remarks(*group.front());
  for (const CaseResult* result : group) {
    const std::vector<Remark> own = remarks(*result);
    std::erase_if(common, [&](const Remark& remark) {
      return remark.label != "rerun" && std::none_of(own.begin(), own.end(), [&](const Remark& other) {
               return other.label == remark.label && other.text == remark.text;
             });
    });
  }
  return common;
}

std::string cases_words(const CaseGroup& group) {
  return fmt::format("{} {}", group.size(), group.size() == 1 ? "case" : "cases");
}

std::string case_names(const CaseGroup& group) {
  std::string names;
  for (const CaseResult* result : group) names += (names.empty() ? "" : ", ") + result->name;
  return names;
}

Points sum_of(const CaseGroup& group) {
  Points sum;
  for (const CaseResult* result : group) sum.score += result->score, sum.max_score += result->max_score;
  return sum;
}

std::string output_of(const CaseGroup& group) {
  for (const CaseResult* result : group)
    if (!result->output.empty()) return result->output;
  return {};
}

int count(const StepResult& step, Status status) {
  return int(std::count_if(step.cases.begin(), step.cases.end(),
                           [&](const CaseResult& result) { return result.status == status; }));
}

std::string case_anchor(const StepResult& step, const CaseResult& result) {
  return slug(step.step) + "." + slug(result.name);
}

std::string escape_markup(std::string_view text) {
  std::string escaped;
  for (char c : printable(text, Layout::keep_lines)) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

}  // namespace atelier::judge
