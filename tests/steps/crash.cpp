// A crash in a student's function is reported with that function's name.
#include "base/file.hpp"
#include "catch.hpp"
#include "command.hpp"

using namespace atelier;
using namespace atelier::test;
using nlohmann::json;

namespace {

/// What `grade` says of the case `rotation` where the first line of the student's function is `line`.
std::string reason_with(const std::string& line) {
  const TemporaryFolder submission;
  const std::filesystem::path to = submission.path() / "01-transforms";
  std::filesystem::create_directory(to);
  for (const std::string file : {"transforms.cpp", "transforms.glsl", "choices.txt"}) {
    std::string text = read_file(folders().solutions() / "01-transforms" / file);
    const std::string begin = "glm::mat4 rotation(const glm::vec3& axis, float angle) {\n";
    if (const auto found = text.find(begin); found != std::string::npos) text.insert(found + begin.size(), line + "\n");
    write_file(to / file, text);
  }
  const json results = graded(submission.path());
  for (const json& step : results["steps"])
    for (const json& c : step["cases"])
      if (c["name"] == "rotation") return c["status"].get<std::string>() + ": " + c["reason"].get<std::string>();
  return "no such case";
}

}  // namespace

TEST_CASE("a crash names the student's function", "[crash]") {
  struct Row {
    const char* name;
    const char* line;
  };
  const Row rows[] = {
      {"nothing to point at", "  *static_cast<volatile int*>(nullptr) = 1;"},
      {"a division of whole numbers by zero",
       "  volatile int some = 7, zero = 0; if (some / zero == 7) return glm::mat4(2.0f);"},
      {"a stack that runs over", "  if (angle < 1e9f) return rotation(axis, angle + 1e-3f) * glm::mat4(2.0f);"},
  };
  for (const Row& row : rows) {
    const std::string reason = reason_with(row.line);
    INFO(row.name << ": " << reason);
    CHECK(reason.starts_with("crashed: "));
    CHECK(reason.find("in atelier::transforms::rotation (01-transforms)") != std::string::npos);
  }
}
