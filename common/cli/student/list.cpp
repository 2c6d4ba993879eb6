// ./atelier list: the steps of the course, the student's progress, and what is built.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/near_names.hpp"
#include "cli/author/skeleton_record.hpp"
#include "cli/commands.hpp"
#include "cli/layout.hpp"
#include "cli/student/standing.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;
using OrderedJson = nlohmann::ordered_json;

struct ListedStep {
  Standing standing;
  std::vector<SkeletonState> states;                     ///< of its files
  bool program = false, mine = false, solution = false;  ///< what is built
};

ListedStep describe(const ProjectFolders& folders, const Standing& standing, const SkeletonRecord& record) {
  ListedStep row{.standing = standing, .states = {}};
  const CourseStep& step = standing.step;
  for (const std::string& file : step.files)
    row.states.push_back(skeleton_state(folders.steps(), record, step.name + "/" + file));
  const auto built = [&](const fs::path& whose) { return fs::exists(whose / step.name / "libstep.so"); };
  row.program = fs::exists(folders.program(step.name));
  row.mine = built(folders.own_implementations());
  row.solution = built(folders.implementations() / "solutions");
  return row;
}

std::string files_in_words(const ListedStep& row) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < row.states.size(); ++i)
    words.push_back(fmt::format("{} ({})", row.standing.step.files[i], to_string(row.states[i])));
  return join(words);
}

void print_table(const std::vector<ListedStep>& rows) {
  fmt::print("{:<20} {:>5} {:>6}  {:<24} {}\n", "step", "cases", "points", "you", "title");
  for (const ListedStep& row : rows) {
    const Standing& s = row.standing;
    fmt::print("{:<20} {:>5} {:>6g}  {:<24} {}\n", s.step.name, s.cases, s.max_score, in_words(s), s.step.title);
    fmt::print("{:<33}  {}{}\n", "", files_in_words(row), row.program ? "" : "; its program is not built");
  }
}

OrderedJson to_json(const std::vector<ListedStep>& rows) {
  OrderedJson steps = OrderedJson::array();
  for (const ListedStep& row : rows) {
    OrderedJson files = OrderedJson::array();
    for (std::size_t i = 0; i < row.states.size(); ++i)
      files.push_back({{"name", row.standing.step.files[i]}, {"state", to_string(row.states[i])}});
    steps.push_back({{"step", row.standing.step.name},
                     {"title", row.standing.step.title},
                     {"files", files},
                     {"uses", row.standing.step.uses},
                     {"cases", row.standing.cases},
                     {"points", row.standing.max_score},
                     {"standing", in_words(row.standing)},
                     {"built", {{"program", row.program}, {"mine", row.mine}, {"solution", row.solution}}}});
  }
  return {{"steps", steps}};
}

}  // namespace

int run_list(const ListOptions& options) {
  const ProjectFolders folders = project_folders();
  const SkeletonRecord record = read_skeleton_record(folders.steps());
  std::vector<ListedStep> rows;
  for (const Standing& standing :
       standings(folders, read_course(folders.step_flags()), read_progress(folders.progress())))
    rows.push_back(describe(folders, standing, record));
  if (options.json)
    fmt::print("{}\n", to_json(rows).dump(2));
  else
    print_table(rows);
  return exit_ok;
}

}  // namespace atelier
