#include "grade/submission.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/near_names.hpp"
#include "base/printable.hpp"
#include "grade/step_places.hpp"
#include "grade/unzip.hpp"

namespace atelier::grade {
namespace {

namespace fs = std::filesystem;

/// Keeps the first notes; a last note says how many more there were.
void keep_first(std::vector<std::string>& notes) {
  if (notes.size() <= max_notes) return;
  const std::size_t more = notes.size() - (max_notes - 1);
  notes.resize(max_notes - 1);
  notes.push_back(fmt::format("{} more", more));
}

/// Why a path is not a folder; empty if it is. Links are refused, because they can point outside the submission.
std::string why_not_folder(const fs::path& path) {
  std::error_code error;
  const fs::file_type type = fs::symlink_status(path, error).type();
  if (type == fs::file_type::symlink) return judge::is_link;
  return type == fs::file_type::directory ? "" : "is not a folder";
}

bool exists_unfollowed(const fs::path& path) {
  std::error_code error;
  return fs::exists(fs::symlink_status(path, error));
}

bool holds_steps(const judge::StepFlags& flags, const fs::path& folder) {
  return std::any_of(flags.files.begin(), flags.files.end(),
                     [&](const auto& step) { return exists_unfollowed(folder / step.first); });
}

/// The folder that holds the steps: `source`, or the only folder in it that does.
fs::path folder_with_steps(const judge::StepFlags& flags, const fs::path& source) {
  if (holds_steps(flags, source)) return source;
  std::vector<fs::path> holders;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(source, error))
    if (entry.symlink_status(error).type() == fs::file_type::directory && holds_steps(flags, entry.path()))
      holders.push_back(entry.path());
  std::sort(holders.begin(), holders.end());
  if (holders.size() > 1)
    throw Error(fmt::format("{}: has steps in two folders, '{}' and '{}'; name one of them", source.string(),
                            printable(holders[0].filename().string()), printable(holders[1].filename().string())));
  return holders.empty() ? source : holders.front();
}

void take_folder(const judge::StepFlags& flags, Submission& submission) {
  for (const auto& [step, files] : flags.files) {
    const fs::path folder = submission.source / step;
    if (!exists_unfollowed(folder)) continue;
    if (const std::string why = why_not_folder(folder); !why.empty()) {
      submission.skipped[step] = why;
      submission.notes.push_back(step + " " + why);
      continue;
    }
    submission.present.insert(step);
    const judge::UnusableFiles unusable = judge::take_step_files(flags, step, folder, submission.folder / step);
    if (!unusable.empty()) submission.unusable[step] = unusable;
    for (const auto& [file, why] : unusable)
      if (why != judge::is_missing) submission.notes.push_back(fmt::format("{}/{} {}", step, file, why));
  }
}

/// Returns the names of all members.
std::vector<std::string> take_zip(const judge::StepFlags& flags, const fs::path& source, Submission& submission) {
  std::set<std::string> wanted;
  for (const auto& [step, files] : flags.files)
    for (const std::string& file : files) wanted.insert(step + "/" + file);
  const ZipContents contents = read_zip(source, wanted);
  const auto step_of = [](const std::string& name) { return name.substr(0, name.find('/')); };
  for (const auto& [name, bytes] : contents.files) {
    submission.present.insert(step_of(name));
    write_file(submission.folder / name, bytes);
  }
  for (const auto& [name, why] : contents.unusable) {
    submission.present.insert(step_of(name));
    submission.notes.push_back(name + " " + why);
  }
  for (const std::string& sentence : contents.skipped) submission.notes.push_back(sentence);

  for (const std::string& step : submission.present)
    for (const std::string& file : flags.files.at(step)) {
      const std::string name = step + "/" + file;
      if (contents.files.contains(name)) continue;
      const auto found = contents.unusable.find(name);
      submission.unusable[step][file] = found == contents.unusable.end() ? judge::is_missing : found->second;
    }
  return contents.names;
}

/// Says in one line why there is no step: where steps or their files were found, and what was skipped.
[[noreturn]] void refuse_without_steps(const judge::StepFlags& flags, const fs::path& source,
                                       const Submission& submission, const std::vector<std::string>& paths) {
  std::vector<std::string> steps;
  for (const auto& [step, files] : flags.files) steps.push_back(step);
  std::string words =
      fmt::format("{}: has none of the steps; it must have folders such as {}", source.string(), join(steps));

  const std::vector<std::string> found = folders_of_steps(flags, paths);
  std::vector<std::string> deeper = found;
  std::erase_if(deeper, [&](const std::string& front) { return front.find('/') == std::string::npos; });
  const fs::path whole = fs::weakly_canonical(source);
  if (flags.files.contains(whole.filename().string()))
    words += fmt::format("; it is the folder of one step: name its parent folder, {}", whole.parent_path().string());
  else if (!deeper.empty() && !submission.source.empty())
    words += fmt::format("; steps were found in {}: name that folder", (source / deeper.front()).string());
  else if (!deeper.empty())
    words += fmt::format("; steps were found in {}: they must be at the top or one folder below it", join(deeper));
  else if (!found.empty() && submission.notes.empty())
    words += "; it has folders of steps, but none of their files";
  else if (const auto stray = stray_files(flags, paths); !stray.empty())
    words += "; " + join(stray);
  if (!submission.notes.empty()) words += "; skipped: " + join(submission.notes);
  throw Error(words);
}

/// The last part of the path, also for "solutions/", "." and "..".
std::string name_of(const fs::path& source) {
  fs::path path = fs::weakly_canonical(source);
  if (path.extension() == ".zip") path = path.stem();
  const std::string name = printable(path.filename().string());
  return name.empty() || name == "." || name == ".." ? "submission" : name;  // "...zip" has the stem ".."
}

}  // namespace

Submission take_submission(const judge::StepFlags& flags, const fs::path& source, const fs::path& folder) {
  if (!fs::exists(source)) throw Error(fmt::format("{}: there is no such folder or archive", source.string()));
  Submission submission;
  submission.name = name_of(source);
  submission.folder = folder;
  fs::create_directories(folder);
  std::vector<std::string> paths;
  if (fs::is_directory(source)) {
    submission.source = folder_with_steps(flags, source);
    take_folder(flags, submission);
    if (submission.present.empty()) paths = list_folder(source);
  } else {
    paths = take_zip(flags, source, submission);
  }
  keep_first(submission.notes);
  if (submission.present.empty()) refuse_without_steps(flags, source, submission, paths);
  return submission;
}

}  // namespace atelier::grade
