// The rows of all steps in their tables.
#include "cli/author/step_tables.hpp"

#include "base/file.hpp"
#include "catch.hpp"

using namespace atelier;
using atelier::test::error_of;
using atelier::test::mentions;

namespace {

const std::string begins(table_begins), ends(table_ends);

/// A project with one step and two that are planned.
struct Tabled {
  TemporaryFolder folder;
  ProjectFolders folders{.root = folder.path(), .build = {}};
  std::vector<CourseStep> course = {{.name = "05-mist", .title = "Mist"}};
  Tabled() {
    write_file(folder.path() / "docs/steps/05-mist.json",
               std::string_view(R"({"picture": "A grey hill", "sentence": "Air.", "topics": "air, hills"})"));
    write_file(
        folder.path() / "docs/steps/planned.json",
        std::string_view(R"([{"step": "05-other", "sentence": "No."}, {"step": "06-rain", "sentence": "Drops."}])"));
    write_file(folder.path() / "handouts/05-mist.md",
               std::string_view("# 05 Mist\n\n| core | 1 | 4 | a |\n| further | 1½ | 2 | b |\n"));
    write_file(folders.case_file("05-mist"), std::string_view(R"({"schema": 1, "step": "05-mist", "cases": [
      {"name": "a", "title": "a", "asked": "a", "hint": "a", "points": 4, "scene": "s", "rejects": ["x"]},
      {"name": "b", "title": "b", "asked": "b", "hint": "b", "points": 2, "scene": "s", "rejects": ["x"], "tier": "further"}]})"));
  }
};

}  // namespace

TEST_CASE("rows are made from cases, handouts and the texts of a step") {
  const Tabled project;
  CHECK(rows_of_readme(project.folders, project.course) ==
        "| ![A grey hill](docs/pictures/05-mist.png) | **05-mist** ([handout](handouts/05-mist.md)) | 6 | Air. |\n"
        "| *planned* | 06-rain | | Drops. |\n");
  CHECK(rows_of_handouts(project.folders, project.course) ==
        "| 05 | [Mist](05-mist.md): air, hills | 4 + 2 + 0 | 1 + 1½ |\n");
  write_file(project.folder.path() / "docs/steps/05-mist.json", std::string_view(R"({"picture": "A grey hill"})"));
  CHECK(mentions(error_of([&] { rows_of_readme(project.folders, project.course); }), {"05-mist.json", "sentence"}));
}

TEST_CASE("rows replace the old rows between two marker lines") {
  const std::string text = "before\n" + begins + "| a |\n|---|\n| old |\n" + ends + "after\n";
  const std::string wanted = "before\n" + begins + "| a |\n|---|\n| new |\n" + ends + "after\n";
  CHECK(with_rows(text, "| new |\n", "README.md") == wanted);
  CHECK(with_rows(wanted, "| new |\n", "README.md") == wanted);
  for (const std::string& bad : {std::string("none\n"), begins + "| a |\n|---|\n", ends + begins,
                                 begins + "words\n" + ends, begins + ends, text + text}) {
    INFO(bad);
    CHECK(mentions(error_of([&] { with_rows(bad, "", "README.md"); }), {"README.md", "between the lines"}));
  }
}
