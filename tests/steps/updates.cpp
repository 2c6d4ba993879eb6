// A student's solved files of an earlier release, updated to this one: no points are lost.
#include <set>

#include "base/file.hpp"
#include "catch.hpp"
#include "cli/author/marked_text.hpp"
#include "cli/student/skeleton_update.hpp"
#include "command.hpp"

using namespace atelier;
using namespace atelier::test;
using nlohmann::json;

namespace {

namespace fs = std::filesystem;

/// Cases that came after the release of tests/updates: its students could not earn them.
const std::set<std::string> new_cases = {"blinds", "blind-lamp", "sixty-four-blinds",
                                         "normal-matrix"};  // it now asks for determinants that underflow

/// A student's folder, with a newer release unpacked over it.
struct OldWork {
  TemporaryFolder folder;
  ProjectFolders there{.root = folder.path(), .build = folder.path() / "build"};

  OldWork() {
    const fs::path old = folders().root / "tests" / "updates";
    fs::copy(old / "given", there.given(), fs::copy_options::recursive);
    fs::copy(old / "solved", there.steps(), fs::copy_options::recursive);
    fs::copy(folders().steps() / "renames.txt", there.steps() / "renames.txt");
    for (const CourseStep& step : course())
      if (fs::exists(old / "given" / step.name))
        for (const std::string& file : step.files) {
          const std::string name = step.name + "/" + file;
          write_file(there.skeletons() / name,
                     cut_skeleton(read_file(folders().solutions() / name), "solutions/" + name, step.name));
        }
  }
};

}  // namespace

TEST_CASE("solved files of an earlier release keep their points", "[updates]") {
  const OldWork work;
  for (const std::string& line : update_skeletons(work.there)) {
    INFO(line);
    CHECK(line.find(".new") == std::string::npos);  // every file was merged
  }
  int judged = 0;
  const json results = graded(work.there.steps());
  for (const json& step : results["steps"])
    for (const json& c : step["cases"]) {
      INFO(step["step"] << " " << c["name"] << ": " << c["reason"]);
      if (!new_cases.contains(c["name"])) CHECK(c["score"] == c["max_score"]);
      ++judged;
    }
  CHECK(judged > 150);
}
