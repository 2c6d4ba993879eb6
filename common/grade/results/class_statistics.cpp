#include "grade/results/class_statistics.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace atelier::grade {
namespace {

using State = StepRecord::State;
using Rows = std::vector<const ClassRow*>;

constexpr std::size_t most_slowest = 5;

double median_of(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 != 0 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

const StepSummary* summary_of(const ClassResults& results, const std::string& step) {
  for (const StepSummary& summary : results.summary.steps)
    if (summary.step == step) return &summary;
  return nullptr;
}

void add_to_bins(double points, double max_points, std::array<int, 11>& bins) {
  const double share = max_points > 0 ? points / max_points : 0;
  ++bins[std::size_t(std::clamp(int(share * 10 + 1e-9), 0, 10))];
}

StepStatistics statistics_of(const ClassResults& results, const std::string& step) {
  StepStatistics statistics{.step = step, .title = ""};
  if (const StepSummary* summary = summary_of(results, step)) statistics.title = summary->title;
  std::vector<double> points;
  for (const ClassRow& row : results.rows) {
    const StepGrade* const grade = step_grade(row, step);
    if (grade != nullptr) statistics.max_points = std::max(statistics.max_points, grade->max_points);
    if (grade == nullptr || grade->state == State::not_handed_in) {
      ++statistics.absent;
      continue;
    }
    if (grade->state == State::untouched) {
      ++statistics.untouched;
      continue;
    }
    points.push_back(grade->points);
    statistics.not_built += grade->state == State::not_built ? 1 : 0;
    add_to_bins(grade->points, grade->max_points, statistics.bins);
  }
  statistics.handed_in = int(points.size());
  statistics.median = median_of(points);
  if (!points.empty()) statistics.mean = std::accumulate(points.begin(), points.end(), 0.0) / double(points.size());
  return statistics;
}

std::vector<MistakeStatistics> mistakes_of(const ClassResults& results) {
  std::map<std::pair<std::string, std::string>, MistakeStatistics> by_name;
  for (const ClassRow& row : results.rows)
    for (const StepRecord& step : row.record.steps)
      for (const auto& [mistake, cases] : step.mistakes) {
        MistakeStatistics& statistics = by_name[{step.step, mistake}];
        statistics.step = step.step, statistics.mistake = mistake;
        statistics.students.push_back(&row);
        statistics.cases += cases;
      }
  std::vector<MistakeStatistics> mistakes;
  for (auto& [name, statistics] : by_name) {
    if (const StepSummary* summary = summary_of(results, statistics.step))
      for (const judge::Mistake& known : summary->mistakes)
        if (known.name == statistics.mistake) statistics.title = known.title, statistics.sentence = known.sentence;
    mistakes.push_back(std::move(statistics));
  }
  std::stable_sort(mistakes.begin(), mistakes.end(),
                   [](const auto& a, const auto& b) { return a.students.size() > b.students.size(); });
  return mistakes;
}

std::vector<HumanReason> reasons_of(const ClassResults& results) {
  std::vector<HumanReason> reasons;
  for (const ClassRow& row : results.rows)
    for (const std::string& reason : row.grade.needs_human) {
      const auto same = [&](const HumanReason& known) { return known.reason == reason; };
      auto found = std::find_if(reasons.begin(), reasons.end(), same);
      if (found == reasons.end()) found = reasons.insert(reasons.end(), {reason, {}});
      if (found->students.empty() || found->students.back() != &row) found->students.push_back(&row);
    }
  std::stable_sort(reasons.begin(), reasons.end(),
                   [](const auto& a, const auto& b) { return a.students.size() < b.students.size(); });
  return reasons;
}

Rows slowest_of(const ClassResults& results) {
  Rows rows;
  for (const ClassRow& row : results.rows)
    if (seconds_of_work(row.record) > 0) rows.push_back(&row);
  std::stable_sort(rows.begin(), rows.end(), [](const ClassRow* a, const ClassRow* b) {
    return seconds_of_work(a->record) > seconds_of_work(b->record);
  });
  rows.resize(std::min(rows.size(), most_slowest));
  return rows;
}

}  // namespace

const StepGrade* step_grade(const ClassRow& row, const std::string& step) {
  for (const StepGrade& grade : row.grade.steps)
    if (grade.step == step) return &grade;
  return nullptr;
}

ClassStatistics class_statistics(const ClassResults& results) {
  ClassStatistics statistics;
  for (const std::string& step : results.steps) statistics.steps.push_back(statistics_of(results, step));
  statistics.mistakes = mistakes_of(results);
  statistics.needs_human = reasons_of(results);
  statistics.slowest = slowest_of(results);
  std::map<std::string, int> sandboxes;
  for (const ClassRow& row : results.rows) ++sandboxes[row.record.sandbox];
  statistics.sandboxes.assign(sandboxes.begin(), sandboxes.end());
  return statistics;
}

}  // namespace atelier::grade
