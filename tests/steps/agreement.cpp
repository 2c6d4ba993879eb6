// The verdict on a step does not depend on how it is judged: OSMesa or EGL, one worker or two, in order, shuffled, each
// case alone.
#include <bit>
#include <chrono>
#include <cstdint>

#include "catch.hpp"
#include "cli/author/workshop.hpp"
#include "command.hpp"
#include "grade/environment.hpp"

using namespace atelier;
using namespace atelier::test;
using judge::Answer;
using nlohmann::json;

namespace {

bool has_egl() {
  return !grade::describe_driver("egl").starts_with("none");
}

/// {step, case, status, score} of every case, in the order of the report.
std::vector<std::string> verdicts(const json& results) {
  std::vector<std::string> lines;
  for (const json& step : results["steps"])
    for (const json& c : step["cases"])
      lines.push_back(json{step["step"], c["name"], c["status"], c["score"], c["mistake"]}.dump());
  return lines;
}

bool same_bits(float a, float b) {
  return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

/// Bit by bit: a NaN equals the same NaN.
bool same_answer(const Answer& a, const Answer& b) {
  if (a.ended != b.ended || a.pixels.has_value() != b.pixels.has_value()) return false;
  if (!a.pixels) return a.values == b.values;
  const auto x = a.pixels->pixels(), y = b.pixels->pixels();
  return a.pixels->same_size(*b.pixels) && std::equal(x.begin(), x.end(), y.begin(), [](const Rgba& p, const Rgba& q) {
           return same_bits(p.r, q.r) && same_bits(p.g, q.g) && same_bits(p.b, q.b) && same_bits(p.a, q.a);
         });
}

std::vector<Case> asks_of(const CourseStep& step) {
  std::vector<Case> asks;
  for (const auto& c : judge::read_case_file(folders().case_file(step.name)).cases) asks.push_back(c.ask);
  return asks;
}

}  // namespace

TEST_CASE("verdicts do not depend on context, workers or order", "[agreement]") {
  for (const auto& submission : {folders().solutions(), folders().steps()}) {
    const auto expected = verdicts(graded(submission));
    // All at once: where none of them matters, neither do they together.
    std::vector<std::string> otherwise = {"--workers", "1", "--shuffle", "7"};
    if (has_egl()) otherwise.insert(otherwise.end(), {"--context", "egl"});
    INFO(submission.string());
    CHECK(verdicts(graded(submission, otherwise)) == expected);
  }
  if (!has_egl()) SKIP_TEST("there is no EGL here: only the rest agrees");
}

TEST_CASE("pictures and numbers agree bit by bit", "[bits]") {
  for (const CourseStep& step : steps_in_turn()) {
    const Workshop workshop(folders(), step);
    const Version solution = workshop.solution();
    REQUIRE(solution.built);
    const std::vector<Case> asks = asks_of(step);
    judge::RunSettings plain = workshop.settings(solution);
    plain.case_limit = std::chrono::minutes(2);  // a busy machine is no other answer
    const auto expected = judge::run_cases(plain, asks);
    judge::RunSettings shuffled = plain, optimised = plain, egl = plain;
    shuffled.workers = 2;
    shuffled.shuffle = 7;
    optimised.driver_threads = 2;
    optimised.environment["GALLIVM_PERF"] = "";
    egl.context = "egl";
    // Pictures of EGL are the same bits only where the same driver stands behind it.
    const bool same_driver = grade::describe_driver("egl") == grade::describe_driver("osmesa");
    struct Row {
      const char* name;
      const judge::RunSettings& settings;
    };
    for (const Row& row : {Row{"two workers, shuffled", shuffled},
                           Row{"optimised shaders, the driver's own threads", optimised}, Row{"EGL", egl}}) {
      if (&row.settings == &egl && !same_driver) continue;
      const auto answers = judge::run_cases(row.settings, asks);
      for (std::size_t i = 0; i < asks.size(); ++i) {
        INFO(step.name << ", " << row.name << ", " << asks[i].name);
        CHECK(same_answer(answers[i], expected[i]));
      }
    }
  }
}

TEST_CASE("a case alone gets the same answer as among all", "[alone]") {
  for (const CourseStep& step : course()) {
    const Workshop workshop(folders(), step);
    const judge::RunSettings settings = workshop.settings(workshop.solution());
    const std::vector<Case> asks = asks_of(step);
    const auto expected = judge::run_cases(settings, asks);
    for (std::size_t i = 0; i < asks.size(); ++i) {
      INFO(step.name << ", " << asks[i].name);
      CHECK(same_answer(judge::run_cases(settings, {asks[i]}).front(), expected[i]));
    }
  }
}
