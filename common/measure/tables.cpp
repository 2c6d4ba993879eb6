#include "measure/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "base/csv.hpp"
#include "measure/expect.hpp"
#include "measure/pareto.hpp"

namespace atelier::measure {
namespace {

using OrderedJson = nlohmann::ordered_json;

std::string csv_number(const std::optional<double>& number) {
  return number ? fmt::format("{:.6g}", *number) : std::string();
}

std::set<std::string> names_of_counts(const StepMeasured& measured) {
  std::set<std::string> names;
  const auto add = [&](const std::vector<Point>& points) {
    for (const Point& point : points)
      for (const auto& [name, count] : point.cost.counts) names.insert(name);
  };
  for (const SweepResult& sweep : measured.sweeps) add(sweep.points);
  for (const FrontResult& front : measured.fronts) add(front.points);
  return names;
}

std::string line_of(const std::string& name, const std::string& quantity, const Point& point,
                    const std::set<std::string>& counts) {
  const auto& times = point.cost.times;
  const auto time = [&](double FrameTimes::*member) {
    return csv_number(times ? std::optional(times.value().*member) : std::nullopt);
  };
  std::string line =
      fmt::format("{},{},{},{},{},{},{},{},{},{}", csv_field(name), csv_field(point.curve), csv_field(point.value),
                  csv_field(quantity), csv_number(point.error), csv_number(point.rmse), csv_number(point.flip),
                  time(&FrameTimes::median), time(&FrameTimes::least), time(&FrameTimes::most));
  for (const std::string& count : counts) {
    const auto found = point.cost.counts.find(count);
    line += found == point.cost.counts.end() ? "," : fmt::format(",{}", found->second);
  }
  return line + "\n";
}

OrderedJson json_of(const std::optional<double>& number) {
  return number ? OrderedJson(*number) : OrderedJson();
}

OrderedJson json_of(const Point& point) {
  OrderedJson json = {{"curve", point.curve},       {"value", point.value},        {"x", point.x},
                      {"error", point.error},       {"rmse", json_of(point.rmse)}, {"flip", json_of(point.flip)},
                      {"counts", point.cost.counts}};
  if (const auto& times = point.cost.times)
    json["frames"] = {
        {"count", times->count}, {"median_s", times->median}, {"least_s", times->least}, {"most_s", times->most}};
  return json;
}

OrderedJson json_of(const std::vector<Point>& points) {
  OrderedJson list = OrderedJson::array();
  for (const Point& point : points) list.push_back(json_of(point));
  return list;
}

OrderedJson json_of(const SweepResult& sweep) {
  OrderedJson json = {
      {"name", sweep.plan.name},        {"title", sweep.plan.title},         {"scene", sweep.plan.ask.scene},
      {"setting", sweep.plan.setting},  {"curves_by", sweep.plan.curves_by}, {"metric", quantity_of(sweep.plan)},
      {"noise_floor", floor_of(sweep)}, {"fits", OrderedJson::array()},      {"findings", OrderedJson::array()}};
  for (const std::string& curve : curves_of(sweep))
    if (const auto fit = fit_of(sweep, curve))
      json["fits"].push_back({{"curve", curve},
                              {"slope", fit->slope},
                              {"factor", fit->factor},
                              {"deviation", fit->deviation},
                              {"from", fit->from},
                              {"to", fit->to},
                              {"points", fit->points}});
  for (const Finding& finding : findings(sweep))
    json["findings"].push_back({{"met", finding.met}, {"words", finding.words}, {"reason", finding.reason}});
  json["points"] = json_of(sweep.points);
  return json;
}

OrderedJson json_of(const FrontResult& front) {
  const Ranking ranking = rank(front);
  OrderedJson json = {{"name", front.plan.name},
                      {"title", front.plan.title},
                      {"scene", front.plan.ask.scene},
                      {"metric", to_string(front.plan.metric)},
                      {"pareto_front", OrderedJson::array()},
                      {"knee", ranking.knee ? OrderedJson(front.points[*ranking.knee].value) : OrderedJson()}};
  for (const std::size_t i : ranking.front) json["pareto_front"].push_back(front.points[i].value);
  json["points"] = json_of(front.points);
  return json;
}

struct Row {
  std::string name;  ///< all columns but the error
  double error = 0;
};

std::vector<Row> rows_of(const std::string& csv) {
  std::vector<Row> rows;
  std::istringstream text(csv);
  std::string line;
  std::getline(text, line);  // the header
  while (std::getline(text, line)) {
    const auto comma = line.rfind(',');
    if (comma == std::string::npos) continue;
    rows.push_back({line.substr(0, comma), std::strtod(line.c_str() + comma + 1, nullptr)});
  }
  return rows;
}

}  // namespace

std::string as_csv(const StepMeasured& measured) {
  const std::set<std::string> counts = names_of_counts(measured);
  std::string csv = "sweep,curve,value,metric,error,rmse,flip,median_s,least_s,most_s";
  for (const std::string& count : counts) csv += "," + csv_field(count);
  csv += "\n";
  for (const SweepResult& sweep : measured.sweeps)
    for (const Point& point : sweep.points) csv += line_of(sweep.plan.name, quantity_of(sweep.plan), point, counts);
  for (const FrontResult& front : measured.fronts)
    for (const Point& point : front.points)
      csv += line_of(front.plan.name, to_string(front.plan.metric), point, counts);
  return csv;
}

std::string as_json(const StepMeasured& measured) {
  OrderedJson json = {{"step", measured.step},
                      {"environment", measured.environment},
                      {"sweeps", OrderedJson::array()},
                      {"fronts", OrderedJson::array()}};
  for (const SweepResult& sweep : measured.sweeps) json["sweeps"].push_back(json_of(sweep));
  for (const FrontResult& front : measured.fronts) json["fronts"].push_back(json_of(front));
  return json.dump(2) + "\n";
}

std::string errors_as_csv(const SweepResult& result) {
  std::string csv = fmt::format("{},{},{}\n", csv_field(result.plan.curves_by), csv_field(result.plan.setting),
                                csv_field(quantity_of(result.plan)));
  for (const Point& point : result.points)
    csv += fmt::format("{},{},{:.6g}\n", csv_field(point.curve), csv_field(point.value), point.error);
  return csv;
}

std::string difference(const std::string& ours, const std::string& stored) {
  constexpr double relative = 0.1, of_largest = 0.01;
  const std::vector<Row> a = rows_of(ours), b = rows_of(stored);
  if (ours.substr(0, ours.find('\n')) != stored.substr(0, stored.find('\n'))) return "the columns differ";
  if (a.size() != b.size()) return fmt::format("{} lines, but {} are stored", a.size(), b.size());
  double largest = 0;
  for (const Row& row : b) largest = std::max(largest, std::abs(row.error));
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].name != b[i].name) return fmt::format("a line for {}, but one for {} is stored", a[i].name, b[i].name);
    const double allowed = std::max(relative * std::abs(b[i].error), of_largest * largest);
    if (!(std::abs(a[i].error - b[i].error) <= allowed))
      return fmt::format("{}: {:.4g}, but {:.4g} is stored", a[i].name, a[i].error, b[i].error);
  }
  return {};
}

Ranking rank(const FrontResult& front) {
  Ranking ranking;
  for (const Point& point : front.points) {
    if (!point.cost.times) return {};
    ranking.points.emplace_back(point.cost.times->median, point.error);
  }
  ranking.front = pareto_front(ranking.points);
  std::vector<glm::dvec2> along;
  for (const std::size_t i : ranking.front) along.push_back(ranking.points[i]);
  if (const auto found = knee(along)) ranking.knee = ranking.front[*found];
  return ranking;
}

}  // namespace atelier::measure
