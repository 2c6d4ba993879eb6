#include "grade/varied_cases.hpp"

#include <fmt/format.h>

#include <utility>

#include "base/error.hpp"

namespace atelier::grade {
namespace {

using judge::Answer;
using judge::CaseReferences;
using judge::CaseResult;
using judge::JudgedCase;
using judge::Status;

}  // namespace

std::optional<CaseReferences> as_references(const JudgedCase& c, Answer answer) {
  const bool is_probe = c.profile == judge::Profile::values;
  const bool is_whole =
      is_probe ? answer.values && answer.values->size() == c.ask.inputs.size() : answer.pixels.has_value();
  if (answer.ended != Answer::Ended::normally || !is_whole) return std::nullopt;
  CaseReferences references;
  if (answer.pixels) references.pictures = {std::move(*answer.pixels)};
  if (answer.values) references.values = std::move(*answer.values);
  return references;
}

std::vector<VariedCase> draw_numbers(const std::vector<JudgedCase>& cases, std::uint64_t seed) {
  std::vector<VariedCase> drawn;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (!cases[i].vary) continue;
    judge::Varied varied = judge::vary(cases[i].ask, *cases[i].vary, seed);
    JudgedCase judged = cases[i];
    judged.ask = std::move(varied.ask);
    // The answers stored for other numbers are wrong for these.
    judged.expected.clear(), judged.expected_file.clear(), judged.references.clear();
    drawn.push_back({.judged = std::move(judged), .of = i, .numbers = std::move(varied.numbers)});
  }
  return drawn;
}

VariedCases vary_cases(const std::vector<JudgedCase>& cases, const judge::StepReferences& stored, std::uint64_t seed,
                       const judge::RunSettings& solution) {
  VariedCases varied{
      .seed = seed, .cases = draw_numbers(cases, seed), .references = judge::StepReferences(stored.step())};
  std::vector<Case> asks;
  for (const VariedCase& c : varied.cases) asks.push_back(c.judged.ask);
  if (asks.empty()) return varied;
  std::vector<Answer> answers = judge::run_cases(solution, asks);
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const VariedCase& c = varied.cases[i];
    const std::string error = answers[i].error;
    std::optional<CaseReferences> references = as_references(c.judged, std::move(answers[i]));
    if (!references)
      throw Error(fmt::format("the solution of {} does not answer case '{}' with other numbers ({}, seed {}): {}",
                              stored.step(), cases[c.of].ask.name, c.numbers, seed, error));
    references->skeleton_fraction = stored.of(cases[c.of]).skeleton_fraction;
    varied.references.add(c.judged.ask.name, std::move(*references));
  }
  return varied;
}

CaseResult both(CaseResult stored, CaseResult varied, const std::string& numbers) {
  if (stored.status != Status::passed) return stored;
  if (varied.status == Status::passed) {
    stored.reason += fmt::format(" It is right with other numbers too ({}).", numbers);
    return stored;
  }
  varied.name = stored.name;
  varied.command = stored.command;
  varied.other_numbers = numbers;
  varied.reason = fmt::format("Right with the known numbers, but with others ({}): {}", numbers, varied.reason);
  return varied;
}

}  // namespace atelier::grade
