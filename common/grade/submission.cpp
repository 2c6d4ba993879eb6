#include "grade/submission.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/file.hpp"
#include "case/printable.hpp"
#include "case/suggest.hpp"
#include "grade/unzip.hpp"

namespace atelier::grade {
namespace {

namespace fs = std::filesystem;

void take_folder(const judge::StepFlags& flags, const fs::path& source, Submission& submission) {
  for (const auto& [step, files] : flags.files) {
    std::error_code error;
    // A step's folder that is a link leads out of what was handed in.
    if (fs::symlink_status(source / step, error).type() != fs::file_type::directory) continue;
    submission.present.insert(step);
    judge::take_step_files(flags, step, source / step, submission.folder / step);
  }
}

void take_zip(const judge::StepFlags& flags, const fs::path& source, Submission& submission) {
  std::set<std::string> wanted;
  for (const auto& [step, files] : flags.files)
    for (const std::string& file : files) wanted.insert(step + "/" + file);
  const ZipLimits limits{.member_bytes = judge::source_limit};
  for (const auto& [name, bytes] : read_zip(source, wanted, limits)) {
    submission.present.insert(name.substr(0, name.find('/')));
    write_file(submission.folder / name, bytes);
  }
}

/// The last part of the path, also for "solutions/", "." and "..".
std::string name_of(const fs::path& source) {
  fs::path path = fs::weakly_canonical(source);
  if (path.extension() == ".zip") path = path.stem();
  const std::string name = printable(path.filename().string());
  return name.empty() ? "submission" : name;
}

}  // namespace

Submission take_submission(const judge::StepFlags& flags, const fs::path& source, const fs::path& folder) {
  if (!fs::exists(source)) throw Error(fmt::format("{}: there is no such folder or archive", source.string()));
  Submission submission{.name = name_of(source), .folder = folder, .present = {}};
  fs::create_directories(folder);
  if (fs::is_directory(source))
    take_folder(flags, source, submission);
  else
    take_zip(flags, source, submission);
  if (submission.present.empty()) {
    std::vector<std::string> steps;
    for (const auto& [step, files] : flags.files) steps.push_back(step);
    throw Error(
        fmt::format("{}: holds none of the steps; it must have folders such as {}", source.string(), join(steps)));
  }
  return submission;
}

}  // namespace atelier::grade
