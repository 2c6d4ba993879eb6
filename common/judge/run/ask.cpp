#include "judge/run/ask.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/file.hpp"
#include "judge/run/choices_file.hpp"

namespace atelier::judge {
namespace {

constexpr std::size_t max_bytes = 64 << 10;  ///< of a choices file

/// Cases that are asked in one run, with their indices in the whole list.
struct Part {
  std::vector<Case> asks;
  std::vector<std::size_t> places;
  void add(Case ask, std::size_t place) {
    asks.push_back(std::move(ask));
    places.push_back(place);
  }
};

Choices choices_of(const RunSettings& settings, const std::string& step) {
  const std::string name = step + "/" + choices_file;
  const std::filesystem::path file = settings.implementations.find(name);
  if (file.empty()) throw Error(name + " is missing");
  return read_choices(read_file(file, max_bytes), choices_file);
}

void run(const RunSettings& settings, const Part& part, std::vector<Answer>& answers, const OnAnswer& on_answer) {
  if (part.asks.empty()) return;
  run_cases(settings, part.asks, [&](std::size_t index, const Answer& answer) {
    answers[part.places[index]] = answer;
    if (on_answer) on_answer(part.places[index], answer);
  });
}

}  // namespace

std::vector<Answer> ask_cases(const RunSettings& settings, const std::string& step,
                              const std::vector<JudgedCase>& cases, const OnAnswer& on_answer) {
  std::vector<Answer> answers(cases.size());
  Part plain, chosen;
  std::optional<Choices> choices;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (!cases[i].choice) {
      plain.add(cases[i].ask, i);
      continue;
    }
    try {
      if (!choices) choices = choices_of(settings, step);
      chosen.add(with_choices(cases[i], *choices), i);
    } catch (const Error& error) {
      answers[i].error = error.what();
      if (on_answer) on_answer(i, answers[i]);
    }
  }
  run(settings, plain, answers, on_answer);
  RunSettings counted = settings;
  counted.count = true;
  if (settings.solution) {
    counted.implementations = *settings.solution;
    counted.sandbox = nullptr;
    // Do not share cached shaders with the student's program: they are machine code.
    if (!counted.shader_cache.empty()) counted.shader_cache /= "counted";
  }
  run(counted, chosen, answers, on_answer);
  return answers;
}

Case ask_of(const RunSettings& settings, const std::string& step, const JudgedCase& c) {
  return c.choice ? with_choices(c, choices_of(settings, step)) : c.ask;
}

std::vector<Answer> ask_truths(const RunSettings& settings, const std::vector<JudgedCase>& cases) {
  std::vector<Answer> answers(cases.size());
  Part part;
  for (std::size_t i = 0; i < cases.size(); ++i)
    if (cases[i].choice) part.add(cases[i].ask, i);
  RunSettings traced = settings;
  traced.truth = true;
  run(traced, part, answers, {});
  return answers;
}

}  // namespace atelier::judge
