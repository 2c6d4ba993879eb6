#include "judge/report/kept_steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/file.hpp"
#include "judge/report/report_words.hpp"

namespace atelier::judge {
namespace {

using OrderedJson = nlohmann::ordered_json;

std::string begin_of(const std::string& step) {
  return fmt::format("<!-- step {} -->", anchor_text(step));
}
constexpr std::string_view end_mark = "<!-- end of the step -->\n";

/// Empty if the report has no such section.
std::string section_of(const std::string& report, const std::string& step) {
  const std::size_t begin = report.find(begin_of(step));
  const std::size_t end = begin == report.npos ? report.npos : report.find(end_mark, begin);
  if (end == report.npos) return "";
  const std::size_t inside = begin + begin_of(step).size();
  return report.substr(inside, end - inside);
}

Status status_named(const std::string& name) {
  for (const Status status : {Status::passed, Status::failed, Status::missing, Status::crashed, Status::timeout})
    if (name == to_string(status)) return status;
  return Status::build_failed;
}

StepResult step_of(const OrderedJson& json) {
  StepResult step;
  step.step = json.at("step");
  step.title = json.at("title");
  step.score = json.at("score");
  step.max_score = json.at("max_score");
  for (const OrderedJson& c : json.at("cases")) {
    CaseResult& result = step.cases.emplace_back();
    result.name = c.at("name");
    result.title = c.at("title");
    result.status = status_named(c.at("status"));
    result.score = c.at("score");
    result.max_score = c.at("max_score");
    result.reason = c.at("reason");
  }
  return step;
}

}  // namespace

std::vector<StepResult> kept_steps(const std::filesystem::path& folder, const std::vector<StepResult>& graded) {
  std::vector<StepResult> kept;
  try {
    const std::string report = read_file(folder / "report.html");
    const OrderedJson results = OrderedJson::parse(read_file(folder / "results.json"));
    for (const OrderedJson& json : results.at("steps")) {
      StepResult step = step_of(json);
      const auto is_same = [&](const StepResult& other) { return other.step == step.step; };
      const std::string html = section_of(report, step.step);
      if (html.empty() || std::ranges::any_of(graded, is_same)) continue;
      step.kept = KeptStep{.html = html, .json = json.dump()};
      kept.push_back(std::move(step));
    }
  } catch (const Error&) {
    return {};  // there is no earlier report
  } catch (const OrderedJson::exception&) {
    return {};
  }
  return kept;
}

std::string marked_section(const std::string& step, const std::string& html) {
  return begin_of(step) + html + std::string(end_mark);
}

}  // namespace atelier::judge
