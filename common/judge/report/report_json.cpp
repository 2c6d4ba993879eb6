#include "judge/report/report_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/file.hpp"
#include "base/printable.hpp"
#include "base/strict_json.hpp"

namespace atelier::judge {
namespace {

using OrderedJson = nlohmann::ordered_json;  // keeps the order of members, for human readers

OrderedJson number(double value) {
  return OrderedJson(strict_json::from_number(value));
}

OrderedJson points(double value) {
  return number(std::round(value * 1e6) / 1e6);
}

OrderedJson text_or_null(const std::optional<std::string>& text) {
  return text ? OrderedJson(*text) : OrderedJson(nullptr);
}

OrderedJson colour(const Rgba& c) {
  return {number(c.r), number(c.g), number(c.b), number(c.a)};
}

OrderedJson worst_json(const std::optional<Worst>& worst) {
  if (!worst) return nullptr;
  return {{"x", worst->x}, {"y", worst->y}, {"yours", colour(worst->yours)}, {"reference", colour(worst->reference)}};
}

OrderedJson case_json(const CaseResult& result) {
  OrderedJson figures = OrderedJson::object();
  for (const auto& [name, value] : result.figures) figures[name] = number(value);
  return {{"name", result.name},
          {"title", result.title},
          {"status", to_string(result.status)},
          {"score", points(result.score)},
          {"max_score", points(result.max_score)},
          {"reason", result.reason},
          {"waits_for", result.waits_for},
          {"mistake", text_or_null(result.mistake)},
          {"hint", result.hint},
          {"asked", result.asked},
          {"mistake_sentence", text_or_null(result.mistake_sentence)},
          {"credit", result.credit},
          {"command", result.command},
          {"other_numbers", result.other_numbers},
          {"figures", std::move(figures)},
          {"worst", worst_json(result.worst)},
          {"table", result.table},
          {"output", printable(result.output, Layout::keep_lines)}};
}

OrderedJson causes_json(const StepResult& step) {
  const auto names = [&](const std::vector<std::size_t>& indices) {
    OrderedJson list = OrderedJson::array();
    for (const std::size_t i : indices) list.push_back(step.cases[i].name);
    return list;
  };
  OrderedJson causes = OrderedJson::array();
  for (std::size_t i = 0; i < step.causes.size(); ++i) {
    const Cause& cause = step.causes[i];
    causes.push_back({{"kind", to_string(cause.kind)},
                      {"functions", cause.functions},
                      {"headline", headline(step, i)},
                      {"cases", names(cause.shown)},
                      {"waiting", names(cause.waiting)}});
  }
  return causes;
}

OrderedJson step_json(const StepResult& step) {
  if (step.kept) return OrderedJson::parse(step.kept->json);
  OrderedJson cases = OrderedJson::array();
  for (const CaseResult& result : step.cases) cases.push_back(case_json(result));
  return {{"step", step.step},
          {"title", step.title},
          {"score", points(step.score)},
          {"max_score", points(step.max_score)},
          {"references", step.references},
          {"implementations", step.implementations},
          {"caveat", step.caveat},
          {"build_log", step.build_log},
          {"causes", causes_json(step)},
          {"cases", std::move(cases)}};
}

}  // namespace

std::string results_json(const SubmissionResult& result) {
  OrderedJson steps = OrderedJson::array();
  for (const StepResult& step : result.steps) steps.push_back(step_json(step));
  const OrderedJson document = {{"submission", result.submission},
                                {"score", points(result.score)},
                                {"max_score", points(result.max_score)},
                                {"seed", result.seed ? OrderedJson(*result.seed) : OrderedJson(nullptr)},
                                {"steps", std::move(steps)},
                                {"environment", result.environment},
                                {"notes", result.notes}};
  return document.dump(1, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

void write_results_json(const std::filesystem::path& file, const SubmissionResult& result) {
  write_file(file, results_json(result));
}

}  // namespace atelier::judge
