#include "grade/results/class_json.hpp"

#include <nlohmann/json.hpp>

#include "grade/results/class_statistics.hpp"

namespace atelier::grade {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson ids_json(const std::vector<const ClassRow*>& rows) {
  OrderedJson ids = OrderedJson::array();
  for (const ClassRow* row : rows) ids.push_back(row->record.student.id);
  return ids;
}

OrderedJson statistics_json(const StepStatistics& step) {
  return {{"step", step.step},
          {"title", step.title},
          {"max_points", step.max_points},
          {"bins", step.bins},
          {"handed_in", step.handed_in},
          {"not_built", step.not_built},
          {"untouched", step.untouched},
          {"absent", step.absent},
          {"median", step.median},
          {"mean", step.mean}};
}

OrderedJson grade_json(const StepGrade& grade, const SubmissionRecord& record) {
  OrderedJson mistakes = OrderedJson::object();
  for (const StepRecord& step : record.steps)
    if (step.step == grade.step)
      for (const auto& [mistake, cases] : step.mistakes) mistakes[mistake] = cases;
  return {{"step", grade.step},
          {"state", to_string(grade.state)},
          {"points", grade.points},
          {"max_points", grade.max_points},
          {"penalty", grade.penalty},
          {"days_late", grade.days_late},
          {"mistakes", std::move(mistakes)}};
}

OrderedJson student_json(const ClassRow& row) {
  const SubmissionRecord& record = row.record;
  OrderedJson steps = OrderedJson::array();
  for (const StepGrade& grade : row.grade.steps) steps.push_back(grade_json(grade, record));
  return {{"id", record.student.id},
          {"name", record.student.name},
          {"identifier", record.student.identifier},
          {"points", row.grade.points},
          {"max_points", row.grade.max_points},
          {"adjustment", row.grade.adjustment},
          {"comment", row.comment},
          {"late", row.grade.late},
          {"handed_in", record.handed_in ? OrderedJson(*record.handed_in) : OrderedJson(nullptr)},
          {"report", report_folder(record)},
          {"sandbox", record.sandbox},
          {"seconds", seconds_of_work(record)},
          {"needs_human", row.grade.needs_human},
          {"steps", std::move(steps)}};
}

OrderedJson mistake_json(const MistakeStatistics& mistake) {
  return {{"step", mistake.step},         {"mistake", mistake.mistake}, {"title", mistake.title},
          {"sentence", mistake.sentence}, {"cases", mistake.cases},     {"students", ids_json(mistake.students)}};
}

}  // namespace

std::string class_json(const ClassResults& results) {
  const ClassStatistics statistics = class_statistics(results);
  OrderedJson steps = OrderedJson::array(), students = OrderedJson::array(), mistakes = OrderedJson::array(),
              needs_human = OrderedJson::array(), sandboxes = OrderedJson::object();
  for (const StepStatistics& step : statistics.steps) steps.push_back(statistics_json(step));
  for (const ClassRow& row : results.rows) students.push_back(student_json(row));
  for (const MistakeStatistics& mistake : statistics.mistakes) mistakes.push_back(mistake_json(mistake));
  for (const HumanReason& reason : statistics.needs_human)
    needs_human.push_back({{"reason", reason.reason}, {"students", ids_json(reason.students)}});
  for (const auto& [tier, number] : statistics.sandboxes) sandboxes[tier] = number;
  const OrderedJson document = {{"schema", 1},
                                {"class", results.summary.name},
                                {"course", results.course.title},
                                {"platform", results.summary.platform},
                                {"seconds", results.summary.seconds},
                                {"steps", std::move(steps)},
                                {"students", std::move(students)},
                                {"mistakes", std::move(mistakes)},
                                {"needs_human", std::move(needs_human)},
                                {"slowest", ids_json(statistics.slowest)},
                                {"sandboxes", std::move(sandboxes)},
                                {"misplaced_comments", results.unsaid},
                                {"ignored", results.summary.ignored},
                                {"environment", results.summary.environment}};
  return document.dump(1, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

}  // namespace atelier::grade
