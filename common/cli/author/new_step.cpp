// ./atelier new-step: creates a step that builds, is judged and passes the tests, as a starting point for a real one.
#include <fmt/format.h>

#include "base/file.hpp"
#include "cli/author/step_template.hpp"
#include "cli/commands.hpp"
#include "cli/layout.hpp"

namespace atelier {

int run_new_step(const NewStepOptions& options) {
  const std::filesystem::path root = project_folders().root, templates = root / "templates";
  const StepNames names = names_of_step(options.step, options.title);
  const StepFiles files = files_of_step(templates / "step", names);
  const std::filesystem::path after = templates / "after-new-step.txt";
  const std::string instructions = filled_in(read_file(after), names, after.string());
  refuse_taken(root, names, files);
  write_step(root, files);
  for (const auto& [path, text] : files) fmt::print("{}\n", path);
  fmt::print("{} files were created.\n\n{}", files.size(), instructions);
  return 0;
}

}  // namespace atelier
