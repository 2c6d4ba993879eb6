#include "judge/report_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "case/printable.hpp"

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
  // The small term keeps 0.29 (which is stored a little below) from being cut to 0.28.
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
      {"asked", result.asked},   {"seen", result.reason},
      {"looks like", mistake},   {"where", result.worst ? worst_words(*result.worst) : ""},
      {"credit", result.credit}, {"try next", result.hint},
      {"again", result.command},
  };
  std::erase_if(all, [](const Remark& remark) { return remark.text.empty(); });
  return all;
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
