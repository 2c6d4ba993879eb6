#include "grade/submission.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/near_names.hpp"
#include "base/printable.hpp"
#include "base/sha256.hpp"
#include "base/utf16.hpp"
#include "grade/archive.hpp"
#include "grade/step_places.hpp"
#include "grade/varied_cases.hpp"

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

/// The folders in these folders, in their order. Links are not followed; what Macs and version control keep there is no
/// student's.
std::vector<fs::path> folders_in(const std::vector<fs::path>& folders) {
  std::vector<fs::path> found;
  for (const fs::path& folder : folders) {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
      if (is_folder_of_tools(entry.path().filename().string())) continue;
      if (entry.symlink_status(error).type() == fs::file_type::directory) found.push_back(entry.path());
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// The folder that holds the steps: `source`, or the only one that does on the next level below it that has any.
fs::path folder_with_steps(const judge::StepFlags& flags, const fs::path& source) {
  constexpr int most_levels = 8;
  constexpr std::size_t most_folders = 10'000;
  if (holds_steps(flags, source)) return source;
  std::vector<fs::path> level = folders_in({source}), holders;
  for (int depth = 1; depth <= most_levels && level.size() <= most_folders && holders.empty(); ++depth) {
    std::ranges::copy_if(level, std::back_inserter(holders),
                         [&](const fs::path& folder) { return holds_steps(flags, folder); });
    if (holders.empty()) level = folders_in(level);
  }
  if (holders.size() > 1)
    throw Error(fmt::format("{}: has steps in two folders, '{}' and '{}'; name one of them", source.string(),
                            printable(holders[0].lexically_relative(source).string()),
                            printable(holders[1].lexically_relative(source).string())));
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
  const ArchiveContents contents = read_archive(source, wanted);
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
      if (found == contents.unusable.end() && judge::may_miss(file)) continue;
      submission.unusable[step][file] = found == contents.unusable.end() ? judge::is_missing : found->second;
    }
  return contents.names;
}

/// Compilers read no UTF-16.
void convert_texts(const judge::StepFlags& flags, Submission& submission) {
  for (const std::string& step : submission.present)
    for (const std::string& file : flags.files.at(step)) {
      const fs::path copy = submission.folder / step / file;
      if (!fs::exists(copy)) continue;
      const std::optional<std::string> text = from_utf16(read_file(copy));
      if (!text) continue;
      write_file(copy, *text);
      submission.notes.push_back(fmt::format("{}/{} was UTF-16 and is read as UTF-8", step, file));
    }
}

/// Says in one line why there is no step: where steps or their files were found, and what was skipped.
[[noreturn]] void refuse_without_steps(const judge::StepFlags& flags, const fs::path& source,
                                       const Submission& submission, const std::vector<std::string>& paths) {
  std::vector<std::string> steps;
  for (const auto& [step, files] : flags.files) steps.push_back(step);
  std::string words =
      fmt::format("{}: has none of the steps; it must have folders such as {}", source.string(), join(steps));

  const fs::path whole = fs::weakly_canonical(source);
  if (flags.files.contains(whole.filename().string()))
    words += fmt::format("; it is the folder of one step: name its parent folder, {}", whole.parent_path().string());
  else if (has_folders_of_steps(flags, paths) && submission.notes.empty())
    words += "; it has folders of steps, but none of their files";
  else if (const auto stray = stray_files(flags, paths); !stray.empty())
    words += "; " + join(stray);
  if (!submission.notes.empty()) words += "; skipped: " + join(submission.notes);
  throw Error(words);
}

/// The last part of the path, also for "solutions/", "." and "..".
std::string name_of(const fs::path& source) {
  fs::path path = fs::weakly_canonical(source);
  const std::set<std::string> of_archives = {".zip", ".tar", ".gz", ".tgz", ".xz", ".txz", ".7z"};
  while (of_archives.contains(path.extension().string()) && path.stem() != path) path = path.stem();
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
  convert_texts(flags, submission);
  keep_first(submission.notes);
  if (submission.present.empty()) refuse_without_steps(flags, source, submission, paths);
  return submission;
}

std::uint64_t seed_of(const Submission& submission) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(submission.folder))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::string text;
  for (const fs::path& file : files)
    text += file.lexically_relative(submission.folder).generic_string() + '\0' + sha256(read_file(file)) + '\n';
  return std::stoull(sha256(text).substr(0, 16), nullptr, 16) & max_seed;
}

}  // namespace atelier::grade
