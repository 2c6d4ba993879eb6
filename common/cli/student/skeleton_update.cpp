#include "cli/student/skeleton_update.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/folder_lock.hpp"
#include "base/sha256.hpp"
#include "cli/author/skeleton_record.hpp"
#include "cli/merge.hpp"
#include "cli/student/function_text.hpp"
#include "cli/student/renames.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;

/// "NN-name/FILE" of every file in a folder of steps.
std::vector<std::string> files_below(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& step : fs::directory_iterator(folder)) {
    if (!step.is_directory()) continue;
    for (const auto& file : fs::directory_iterator(step.path()))
      if (file.is_regular_file()) names.push_back(fs::relative(file.path(), folder).generic_string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::optional<std::string> read_where_there(const fs::path& path) {
  if (!fs::exists(path)) return std::nullopt;
  return read_file(path);
}

/// Merges a release's changes into the student's text. If both changed the same lines but only comments of the skeleton
/// changed, the student's lines are kept.
std::optional<std::string> with_changes(const std::string& mine, const std::string& given,
                                        const std::string& skeleton) {
  return merged(mine, given, skeleton, same_code(given, skeleton) ? Conflict::keep_mine : Conflict::give_up);
}

class Update {
 public:
  explicit Update(const ProjectFolders& folders)
      : skeletons_(folders.skeletons()),
        given_(folders.given()),
        steps_(folders.steps()),
        renames_(renames_to_do(read_renames(steps_ / "renames.txt"), read_renames(given_ / "renames.txt"))) {}

  std::vector<std::string> run() {
    if (names_of_new().empty() && renames_.empty()) return {};
    // Lock: a second command must not mistake the first one's changes for a student's edit.
    const FolderLock lock(skeletons_);
    const std::vector<std::string> names = names_of_new();
    if (names.empty() && renames_.empty()) return {};
    SkeletonRecord record = read_skeleton_record(steps_);
    for (const std::string& name : names) {
      update(name);
      record[name] = sha256(read_file(skeletons_ / name));
    }
    write_skeleton_record(steps_, record);
    if (!renames_.empty())
      write_file(given_ / "renames.txt", read_file(steps_ / "renames.txt"));  // last, when everything is done
    return std::move(lines_);
  }

 private:
  /// Skeletons that were not given yet, of missing files, and of files that contain a renamed identifier.
  std::vector<std::string> names_of_new() const {
    std::vector<std::string> names = files_below(skeletons_);
    std::erase_if(names, [&](const std::string& name) {
      if (!fs::exists(steps_ / name) || read_where_there(given_ / name) != read_file(skeletons_ / name)) return false;
      const std::string mine = read_file(steps_ / name);
      return with_new_names(name, mine) == mine;
    });
    return names;
  }

  std::string with_new_names(const std::string& name, const std::string& text) const {
    return renamed(text, name.substr(0, name.find('/')), renames_);
  }

  void update(const std::string& name) {
    const std::string skeleton = read_file(skeletons_ / name);
    auto given = read_where_there(given_ / name);
    const auto mine = read_where_there(steps_ / name);
    if (!mine) {
      put(name, skeleton, "is new: write it");
    } else if (mine == given) {
      put(name, skeleton, "was untouched, and was replaced by this release's skeleton");
    } else if (*mine != skeleton) {
      if (given) given = with_new_names(name, *given);
      keep(name, *mine, given, skeleton);
    }
    write_file(given_ / name, skeleton);  // last, so that an interrupted run is repeated
  }

  void keep(const std::string& name, const std::string& mine, const std::optional<std::string>& given,
            const std::string& skeleton) {
    const std::string mine_renamed = with_new_names(name, mine);
    const auto both = given == skeleton ? mine_renamed
                      : given           ? with_changes(mine_renamed, *given, skeleton)
                                        : std::nullopt;
    if (both == mine) return;  // both have made the same changes
    if (both) {
      const fs::path before = free_path(steps_ / name, ".before-merge");
      write_file(before, mine);
      put(name, *both,
          fmt::format("now has your work and this release's changes; {} is your old version",
                      before.filename().string()));
      return;
    }
    const fs::path beside = free_path(steps_ / name, ".new");
    write_file(beside, skeleton);
    say(name, fmt::format("is unchanged; this release's skeleton is in {}", beside.filename().string()));
  }

  void put(const std::string& name, const std::string& text, const std::string& what) {
    write_file(steps_ / name, text);
    say(name, what);
  }

  void say(const std::string& name, const std::string& what) {
    lines_.push_back(fmt::format("steps/{} {}", name, what));
  }

  fs::path skeletons_, given_, steps_;
  std::vector<Rename> renames_;  ///< not yet applied to the student's files
  std::vector<std::string> lines_;
};

}  // namespace

std::vector<std::string> update_skeletons(const ProjectFolders& folders) {
  if (!fs::is_directory(folders.skeletons())) return {};
  return Update(folders).run();
}

}  // namespace atelier
