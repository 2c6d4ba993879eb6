#include "cli/student/contract.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "cli/student/function_text.hpp"
#include "cli/student/reset_file.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;

std::optional<Contract> contract_in(const std::string& text, const fs::path& file, const std::string& function) {
  const auto found = find_contract(text, function);
  if (!found) return std::nullopt;
  return Contract{.file = "steps" / file, .line = found->line, .text = found->text};
}

std::string pristine_or_nothing(const ProjectFolders& folders, const StudentFile& file) {
  try {
    return pristine_text(folders, file);
  } catch (const Error&) {
    return {};
  }
}

}  // namespace

std::optional<Contract> contract_of(const ProjectFolders& folders, const CourseStep& step,
                                    const std::string& function) {
  for (const std::string& header : step.headers)
    if (header.starts_with(step.name + "/"))
      if (auto contract = contract_in(read_file(folders.root / "steps" / header), header, function)) return contract;
  for (const std::string& name : step.files) {
    if (!name.ends_with(".glsl")) continue;
    const StudentFile file{step, name};
    const fs::path own = folders.steps() / file.below_steps();
    if (fs::exists(own))
      if (auto contract = contract_in(read_file(own), file.below_steps(), function)) return contract;
    if (auto contract = contract_in(pristine_or_nothing(folders, file), file.below_steps(), function)) return contract;
  }
  return std::nullopt;
}

}  // namespace atelier
