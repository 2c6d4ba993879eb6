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
      {"expected", result.asked},
      {"found", result.reason},
      {"waits for", result.waits_for},
      {"looks like", mistake},
      {"where", result.worst ? worst_words(*result.worst) : ""},
      {"credit", result.credit},
      {"try next", result.hint},
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

CaseGroup shown_group(const StepResult& step, const Cause& cause) {
  CaseGroup group;
  for (const std::size_t i : cause.shown) group.push_back(&step.cases[i]);
  return group;
}

const CaseResult& shown_case(const StepResult& step, const Cause& cause) {
  return step.cases[(cause.shown.empty() ? cause.waiting : cause.shown).front()];
}

std::string some_names(const std::vector<std::string>& names, std::size_t most) {
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i) text += (i == 0 ? "" : ", ") + names[i];
  return names.size() > most ? fmt::format("{} and {} more", text, names.size() - most) : text;
}

std::string headline(const StepResult& step, std::size_t index) {
  const Cause& cause = step.causes[index];
  const char* const verb = index == 0 ? "Begin with" : "Then";
  const std::size_t count = cause.shown.size() + cause.waiting.size();
  const CaseResult& shown = shown_case(step, cause);
  switch (cause.kind) {
    case Cause::Kind::no_answer:
      return count == 1 ? fmt::format("{} {}: {}", verb, shown.name, status_words(shown.status))
                        : fmt::format("{} these {} cases: {}", verb, count, status_words(shown.status));
    case Cause::Kind::function: {
      const std::string need = fmt::format("{} failing {} it", count, count == 1 ? "case needs" : "cases need");
      if (cause.inputs == 0) return fmt::format("{} {}: wrong; {}", verb, cause.functions[0], need);
      return cause.wrong == cause.inputs
                 ? fmt::format("{} {}: wrong for every input; {}", verb, cause.functions[0], need)
                 : fmt::format("{} {}: wrong for {} of {} inputs; {}", verb, cause.functions[0], cause.wrong,
                               cause.inputs, need);
    }
    case Cause::Kind::unwritten:
      return fmt::format("{} {}: it answers as in the skeleton; {} failing {} it{}", verb, cause.functions[0], count,
                         count == 1 ? "case needs" : "cases need",
                         cause.functions.size() > 1 ? " or other functions that do" : "");
    case Cause::Kind::picture:
      return fmt::format("{} {}: all probes of the functions that it needs pass", verb, shown.name);
    case Cause::Kind::choice:
      return fmt::format("{} {}: a choice in choices.txt", verb, shown.name);
  }
  return {};
}

std::vector<Remark> remarks(const StepResult& step, const Cause& cause) {
  const auto names = [&](auto begin, auto end) {
    std::vector<std::string> list;
    for (auto i = begin; i != end; ++i) list.push_back(step.cases[*i].name);
    return list;
  };
  if (cause.kind == Cause::Kind::no_answer) {
    const CaseGroup group = shown_group(step, cause);
    std::vector<Remark> all = remarks(group);
    if (group.size() > 1) all.insert(all.begin(), {"cases", case_names(group)});
    return all;
  }
  std::vector<Remark> all = remarks(shown_case(step, cause));
  const auto add = [&](const char* label, const std::string& text) {
    if (!text.empty()) all.push_back({label, text});
  };
  if (cause.kind == Cause::Kind::picture) {
    add("may be in", some_names(cause.functions));
    add("also wrong", some_names(names(cause.waiting.begin(), cause.waiting.end())));
    return all;
  }
  if (cause.kind == Cause::Kind::unwritten && cause.functions.size() > 1)
    add("also to do", some_names({cause.functions.begin() + 1, cause.functions.end()}, 30));
  if (cause.shown.size() > 1) add("also wrong", some_names(names(cause.shown.begin() + 1, cause.shown.end())));
  auto waiting = cause.waiting.begin();
  if (cause.shown.empty() && waiting != cause.waiting.end()) ++waiting;  // it is the case that is shown
  if (cause.kind == Cause::Kind::function && waiting != cause.waiting.end())
    if (const CaseResult& picture = step.cases[*waiting]; picture.figures.contains("share")) {
      add("seen in", fmt::format("{} ({})", picture.name, picture.command));
      ++waiting;
    }
  add("waiting", some_names(names(waiting, cause.waiting.end())));
  return all;
}

std::string cases_words(std::size_t number) {
  return fmt::format("{} {}", number, number == 1 ? "case" : "cases");
}

std::string passed_words(std::size_t passed, std::size_t cases) {
  return cases > 1 && passed == cases ? fmt::format("All {} cases passed", cases)
                                      : fmt::format("{} of {} passed", passed, cases_words(cases));
}

std::string passed_words(const StepResult& step) {
  return passed_words(std::size_t(count(step, Status::passed)), step.cases.size());
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

std::string anchor_text(std::string_view name) {
  std::string safe;
  for (const char c : name) {
    const bool kept =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
    safe += kept ? std::string(1, c) : fmt::format("~{:02X}", static_cast<unsigned char>(c));
  }
  return safe;
}

std::string case_anchor(const StepResult& step, const CaseResult& result, StepsInReport steps) {
  return "case-" + (steps == StepsInReport::several ? anchor_text(step.step) + "." : "") + anchor_text(result.name);
}

StepsInReport steps_in(const SubmissionResult& result) {
  return result.steps.size() > 1 ? StepsInReport::several : StepsInReport::one;
}

std::string place_to_begin(const SubmissionResult& result) {
  for (const StepResult& step : result.steps)
    if (!step.causes.empty()) return "#" + case_anchor(step, shown_case(step, step.causes.front()), steps_in(result));
  return {};
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
