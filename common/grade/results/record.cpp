#include "grade/results/record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/printable.hpp"
#include "base/strict_json.hpp"

namespace atelier::grade {
namespace {

using strict_json::Json;
using OrderedJson = nlohmann::ordered_json;

constexpr double most_points = 1e9, most_seconds = 1e9;
constexpr std::size_t longest_text = 4000;
const std::vector<std::string> names_of_states = {"judged", "not_built", "not_handed_in", "untouched"};

OrderedJson step_record_json(const StepRecord& step) {
  OrderedJson tiers = OrderedJson::object(), mistakes = OrderedJson::object();
  for (const auto& [tier, points] : step.tiers) {
    tiers[tier]["score"] = points.score;
    tiers[tier]["max_score"] = points.max_score;
  }
  for (const auto& [mistake, cases] : step.mistakes) mistakes[mistake] = cases;
  return {{"step", step.step},           {"state", to_string(step.state)}, {"score", step.score},
          {"max_score", step.max_score}, {"tiers", std::move(tiers)},      {"passed", step.passed},
          {"cases", step.cases},         {"mistakes", std::move(mistakes)}};
}

/// Reads the members of an object one by one; an error names the file and the member.
class RecordReader {
 public:
  RecordReader(const Json& object, std::string where, std::vector<std::string> members)
      : object_(object), where_(std::move(where)) {
    strict_json::refuse_unknown(object_, members, where_);
  }

  const Json& member(const char* name) const { return strict_json::required(object_, name, where_); }
  std::string place(const char* name) const { return where_ + ": " + name; }

  std::string text(const char* name) const { return printable_text(member(name), place(name)); }
  double number(const char* name, double low, double high) const {
    return strict_json::number(member(name), place(name), low, high);
  }
  int count(const char* name) const { return strict_json::integer(member(name), place(name), 0, 1'000'000); }

  std::vector<std::string> texts(const char* name) const {
    std::vector<std::string> list;
    for (const Json& element : array(name)) list.push_back(printable_text(element, place(name)));
    return list;
  }

  const Json& array(const char* name) const {
    const Json& list = member(name);
    if (!list.is_array()) strict_json::refuse(list, place(name), "a list [...]");
    return list;
  }

  const Json& table(const char* name) const {
    const Json& members = member(name);
    if (!members.is_object()) strict_json::refuse(members, place(name), "an object {...}");
    return members;
  }

 private:
  static std::string printable_text(const Json& value, const std::string& where) {
    return value == "" ? "" : strict_json::text(value, where, longest_text);
  }

  const Json& object_;
  std::string where_;
};

StepRecord read_step(const Json& value, const std::string& where) {
  const RecordReader reader(value, where,
                            {"step", "state", "score", "max_score", "tiers", "passed", "cases", "mistakes"});
  StepRecord step;
  step.step = strict_json::name(reader.member("step"), reader.place("step"));
  const std::string state = strict_json::one_of(reader.member("state"), reader.place("state"), names_of_states);
  step.state =
      StepRecord::State(std::find(names_of_states.begin(), names_of_states.end(), state) - names_of_states.begin());
  step.score = reader.number("score", 0, most_points);
  step.max_score = reader.number("max_score", 0, most_points);
  step.passed = reader.count("passed");
  step.cases = reader.count("cases");
  for (const auto& [tier, points] : reader.table("tiers").items()) {
    const RecordReader of_tier(points, reader.place("tiers") + ": " + tier, {"score", "max_score"});
    step.tiers[tier] = {of_tier.number("score", 0, most_points), of_tier.number("max_score", 0, most_points)};
  }
  for (const auto& [mistake, cases] : reader.table("mistakes").items()) {
    const std::string name = strict_json::name(mistake, reader.place("mistakes"));
    step.mistakes[name] = strict_json::integer(cases, reader.place("mistakes") + ": " + name, 1, 1'000'000);
  }
  return step;
}

std::optional<std::int64_t> read_moment(const Json& value, const std::string& where) {
  if (value.is_null()) return std::nullopt;
  // As a double, every number compares; up to 2^53 exactly.
  if (!value.is_number_integer() || std::abs(value.get<double>()) > 1e12)
    strict_json::refuse(value, where, "seconds since 1970, or null");
  return value.get<std::int64_t>();
}

Student read_student(const Json& value, const std::string& where) {
  const RecordReader reader(value, where, {"id", "name", "identifier"});
  Student student{.id = reader.text("id"), .name = reader.text("name"), .identifier = reader.text("identifier")};
  const auto allowed = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '.' || c == '-'; };
  if (student.id.empty() || student.id[0] == '.' || student.id.size() > 200 ||
      !std::all_of(student.id.begin(), student.id.end(), allowed))
    strict_json::refuse(reader.member("id"), reader.place("id"), "1..200 characters a-z 0-9 . - and no dot in front");
  return student;
}

}  // namespace

std::string to_string(StepRecord::State state) {
  return names_of_states[std::size_t(state)];
}

StepRecord record_of(const judge::StepResult& step, StepRecord::State state) {
  StepRecord record{.step = step.step, .state = state, .score = step.score, .max_score = step.max_score};
  for (const judge::CaseResult& result : step.cases) {
    TierPoints& tier = record.tiers[result.tier];
    tier.score += result.score;
    tier.max_score += result.max_score;
    if (result.max_score > 0) {
      ++record.cases;
      record.passed += result.status == judge::Status::passed ? 1 : 0;
    }
    if (state == StepRecord::State::judged && result.mistake) ++record.mistakes[*result.mistake];
  }
  return record;
}

std::string to_json_text(const SubmissionRecord& record) {
  OrderedJson steps = OrderedJson::array();
  for (const StepRecord& step : record.steps) steps.push_back(step_record_json(step));
  const OrderedJson document = {
      {"schema", 1},
      {"student",
       {{"id", record.student.id}, {"name", record.student.name}, {"identifier", record.student.identifier}}},
      {"source", record.source},
      {"handed_in", record.handed_in ? OrderedJson(*record.handed_in) : OrderedJson(nullptr)},
      {"late", record.late},
      {"steps", std::move(steps)},
      {"needs_human", record.needs_human},
      {"notes", record.notes},
      {"sandbox", record.sandbox},
      {"key", record.key},
      {"seed", record.seed},
      {"seconds", record.seconds}};
  return document.dump(1, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

SubmissionRecord read_record(const std::filesystem::path& file) {
  const std::string where = file.string();
  const Json document = strict_json::parse(read_file(file, 16 << 20), where);
  const RecordReader reader(document, where,
                            {"schema", "student", "source", "handed_in", "late", "steps", "needs_human", "notes",
                             "sandbox", "key", "seed", "seconds"});
  strict_json::integer(reader.member("schema"), reader.place("schema"), 1, 1);

  SubmissionRecord record;
  record.student = read_student(reader.member("student"), reader.place("student"));
  record.source = reader.text("source");
  record.handed_in = read_moment(reader.member("handed_in"), reader.place("handed_in"));
  record.late = strict_json::boolean(reader.member("late"), reader.place("late"));
  for (const Json& step : reader.array("steps")) {
    const std::size_t index = record.steps.size();
    record.steps.push_back(read_step(step, fmt::format("{}[{}]", reader.place("steps"), index)));
  }
  record.needs_human = reader.texts("needs_human");
  record.notes = reader.texts("notes");
  record.sandbox = reader.text("sandbox");
  record.key = reader.text("key");
  if (!reader.member("seed").is_number_unsigned())
    strict_json::refuse(reader.member("seed"), reader.place("seed"), "a whole number from 0");
  record.seed = reader.member("seed").get<std::uint64_t>();
  for (const auto& [part, seconds] : reader.table("seconds").items())
    record.seconds[part] = strict_json::number(seconds, reader.place("seconds") + ": " + part, 0, most_seconds);
  return record;
}

}  // namespace atelier::grade
