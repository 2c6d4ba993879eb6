// ./atelier tables: the rows of all steps in README.md and handouts/README.md.
#include <fmt/format.h>

#include "base/error.hpp"
#include "base/file.hpp"
#include "cli/author/step_tables.hpp"
#include "cli/commands.hpp"

namespace atelier {

int run_tables(const TablesOptions& options) {
  const ProjectFolders folders = project_folders();
  const auto course = read_course(folders.step_flags());
  const std::pair<std::filesystem::path, std::string> tables[] = {
      {folders.root / "README.md", rows_of_readme(folders, course)},
      {folders.handouts() / "README.md", rows_of_handouts(folders, course)}};
  int status = exit_ok;
  for (const auto& [file, rows] : tables) {
    const std::string text = read_file(file), wanted = with_rows(text, rows, file.string());
    const bool same = text == wanted;
    if (!same && options.check) status = exit_failed;
    if (!same && !options.check) write_file(file, wanted);
    fmt::print("{}: {}\n", file.string(),
               same            ? "as it was"
               : options.check ? "its rows are out of date: run ./atelier tables"
                               : "written");
  }
  return status;
}

}  // namespace atelier
