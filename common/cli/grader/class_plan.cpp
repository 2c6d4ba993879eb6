#include "cli/grader/class_plan.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <span>

#include "base/error.hpp"
#include "base/file.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

template <class Value>
Json or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json(nullptr);
}

template <class Value>
std::optional<Value> optional_of(const Json& json) {
  return json.is_null() ? std::nullopt : std::optional<Value>(json.get<Value>());
}

Json json_of(const grade::HandedIn& handed_in) {
  Json sources = Json::array();
  for (const fs::path& source : handed_in.sources) sources.push_back(source.string());
  return {
      {"id", handed_in.student.id},    {"name", handed_in.student.name}, {"identifier", handed_in.student.identifier},
      {"sources", std::move(sources)}, {"source", handed_in.source},     {"handed_in", or_null(handed_in.handed_in)},
      {"late", handed_in.late},        {"notes", handed_in.notes},       {"needs_human", handed_in.needs_human}};
}

grade::HandedIn handed_in_of(const Json& json) {
  grade::HandedIn handed_in;
  handed_in.student = {.id = json.at("id"), .name = json.at("name"), .identifier = json.at("identifier")};
  for (const Json& source : json.at("sources")) handed_in.sources.emplace_back(source.get<std::string>());
  handed_in.source = json.at("source");
  handed_in.handed_in = optional_of<std::int64_t>(json.at("handed_in"));
  handed_in.late = json.at("late");
  handed_in.notes = json.at("notes").get<std::vector<std::string>>();
  handed_in.needs_human = json.at("needs_human").get<std::vector<std::string>>();
  return handed_in;
}

}  // namespace

grade::CourseFile read_rules(const fs::path& file, const std::vector<CourseStep>& course) {
  if (file.empty()) return {};
  std::vector<std::string> names;
  for (const CourseStep& step : course) names.push_back(step.name);
  return grade::read_course_file(file, names);
}

// CBOR, because names of files are bytes and need not be UTF-8.
void write_plan(const ClassPlaces& places, const ClassPlan& plan) {
  Json submissions = Json::array();
  for (const grade::HandedIn& handed_in : plan.folder.submissions) submissions.push_back(json_of(handed_in));
  const Json json = {{"name", plan.name},
                     {"platform", plan.folder.platform},
                     {"submissions", std::move(submissions)},
                     {"ignored", plan.folder.ignored},
                     {"steps", plan.steps},
                     {"course_file", plan.course_file.string()},
                     {"cases", plan.cases.string()},
                     {"context", plan.context},
                     {"sandbox", plan.sandbox},
                     {"seed", or_null(plan.seed)},
                     {"shuffle", or_null(plan.shuffle)},
                     {"criteria", plan.criteria}};
  const std::vector<std::uint8_t> bytes = Json::to_cbor(json);
  write_file(places.plan(), std::as_bytes(std::span(bytes)));
}

ClassPlan read_plan(const ClassPlaces& places) {
  const std::string bytes = read_file(places.plan());
  try {
    const Json json = Json::from_cbor(bytes);
    ClassPlan plan{.name = json.at("name"),
                   .folder = {.platform = json.at("platform"),
                              .submissions = {},
                              .ignored = json.at("ignored").get<std::vector<std::string>>()},
                   .steps = json.at("steps").get<std::vector<std::string>>(),
                   .course_file = json.at("course_file").get<std::string>(),
                   .cases = json.at("cases").get<std::string>(),
                   .context = json.at("context"),
                   .sandbox = json.at("sandbox"),
                   .seed = optional_of<std::uint64_t>(json.at("seed")),
                   .shuffle = optional_of<std::uint64_t>(json.at("shuffle")),
                   .criteria = json.at("criteria").get<std::map<std::string, std::string>>()};
    for (const Json& submission : json.at("submissions")) plan.folder.submissions.push_back(handed_in_of(submission));
    return plan;
  } catch (const Json::exception& error) {
    throw Error(fmt::format("{}: is damaged ({}); grade the class again", places.plan().string(), error.what()));
  }
}

}  // namespace atelier
