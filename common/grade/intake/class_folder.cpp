#include "grade/intake/class_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "base/error.hpp"
#include "base/printable.hpp"
#include "grade/intake/archive.hpp"
#include "grade/intake/bounded_list.hpp"
#include "grade/intake/class_shape.hpp"
#include "grade/intake/class_students.hpp"
#include "grade/intake/listed_names.hpp"
#include "grade/intake/platform_names.hpp"
#include "grade/intake/submission.hpp"
#include "grade/intake/unpack.hpp"

namespace atelier::grade {
namespace {

namespace fs = std::filesystem;

std::string shown_entry(const std::string& name) {
  return shorten(printable(name), 100);
}

bool is_folder(const fs::path& path) {
  std::error_code error;
  return fs::is_directory(path, error);
}

/// The only archive in a folder that has nothing else in it; empty: there is none.
fs::path single_archive(const judge::StepFlags& flags, const fs::path& folder, const std::vector<std::string>& paths) {
  const ClassEntries entries = entries_in(flags, paths, "");
  if (entries.size() != 1 || entries.begin()->second.is_folder || !has_archive_name(entries.begin()->first)) return {};
  const fs::path file = folder / entries.begin()->first;
  return fs::is_symlink(file) ? fs::path() : file;
}

/// Of a tar archive all bytes must be inflated for its names: of a student's no more than where it is taken, of a
/// class's, which is packed archives or source code, in proportion to its size.
std::vector<std::string> names_in_archive(const fs::path& file) {
  constexpr std::uintmax_t ratio_of_sources = 20;
  std::error_code error;
  const std::uintmax_t size = fs::file_size(file, error);
  ArchiveLimits limits = class_limits;
  if (!error)
    limits.skipped_bytes =
        std::clamp<std::uintmax_t>(ratio_of_sources * size, ArchiveLimits{}.skipped_bytes, class_limits.skipped_bytes);
  const auto nothing_wanted = [](const std::string&) { return 0; };
  return read_archive(file, nothing_wanted, {}, limits).names;
}

/// The class that a folder or an archive is, and where it is.
struct Found {
  std::optional<ClassShape> shape;
  fs::path archive;  ///< empty: the class is in a folder
};

Found look_for_class(const judge::StepFlags& flags, const fs::path& source) {
  if (!is_folder(source)) return {find_class(flags, names_in_archive(source)), source};
  const std::vector<std::string> paths = paths_in(source);
  Found found{find_class(flags, paths), {}};
  if (const fs::path archive = single_archive(flags, source, paths); !found.shape && !archive.empty())
    found = {find_class(flags, names_in_archive(archive)), archive};
  return found;
}

class ClassFinder {
 public:
  ClassFinder(const judge::StepFlags& flags, const fs::path& unpacked, const ClassNaming& naming)
      : flags_(flags), unpacked_(unpacked), students_(naming) {}

  ClassFolder find(const std::vector<fs::path>& sources) {
    if (sources.size() == 1)
      add_source(sources[0]);
    else
      add_several(sources);
    return finish(sources);
  }

 private:
  /// One folder or archive: a class or, if it is none, a submission.
  void add_source(const fs::path& source) {
    if (!fs::exists(source)) throw Error(fmt::format("{}: there is no such folder or archive", source.string()));
    Found found = look_for_class(flags_, source);
    if (found.shape || students_.has_pattern()) {
      fs::path top = source;
      if (!found.archive.empty()) top = unpack(found.archive);
      if (!found.shape) found.shape = entries_of_pattern(top);
      add_class(top, *found.shape);
    } else {
      add_items({.platform = Platform::folders, .items = {item_of(source)}, .group = {}, .metadata = {}});
    }
  }

  /// Several paths, as a shell gives them for "hw/*": each a submission, or a class of its own.
  void add_several(const std::vector<fs::path>& sources) {
    std::vector<ClassItem> items;
    for (const fs::path& source : sources) {
      if (!fs::exists(source)) throw Error(fmt::format("{}: there is no such folder or archive", source.string()));
      const ClassItem item = item_of(source);
      if (students_.has_pattern() || platform_of_name(item)) {
        items.push_back(item);
        continue;
      }
      Found found;
      try {
        found = look_for_class(flags_, source);
      } catch (const Error&) {  // a broken archive is one student's: take_submission says what is wrong
      }
      if (!found.shape)
        items.push_back(item);
      else
        add_class(found.archive.empty() ? source : unpack(found.archive), *found.shape);
    }
    std::map<Platform, std::vector<ClassItem>> by_platform;
    for (ClassItem& item : items)
      by_platform[platform_of_name(item).value_or(Platform::folders)].push_back(std::move(item));
    for (const auto& [platform, some] : by_platform)
      add_items({.platform = platform, .items = some, .group = {}, .metadata = {}});
  }

  static std::optional<Platform> platform_of_name(const ClassItem& item) {
    if (moodle_name(item.name)) return Platform::moodle;
    if (item.entry.is_folder && gradescope_name(item.name)) return Platform::gradescope;
    if (!item.entry.is_folder && canvas_name(item.name)) return Platform::canvas;
    return std::nullopt;
  }

  /// A path that was named, also by a link: the instructor's links are followed.
  static ClassItem item_of(const fs::path& source) {
    std::error_code error;
    const fs::path whole = fs::canonical(source, error), path = error ? source : whole;
    const std::string name = path.filename().string();
    ClassItem item{.path = path, .name = name, .relative = name, .entry = {}};
    item.entry.is_folder = is_folder(path);
    item.entry.has_steps = true;
    return item;
  }

  /// Unpacks a class's archive to a folder of its own. What it refuses is kept for the student whose it is.
  fs::path unpack(const fs::path& archive) {
    const fs::path folder = unpacked_ / fmt::format("class-{}", ++unpacked_count_);
    const ArchiveContents contents = unpack_archive(archive, folder);
    for (const auto& [name, why] : contents.unusable) unusable_[folder / name] = why;
    for (const std::string& sentence : contents.skipped) class_.ignored.push_back(sentence);
    return folder;
  }

  /// The entries that match the pattern, in the nearest folder that has any.
  ClassShape entries_of_pattern(const fs::path& top) const {
    const std::vector<std::string> paths = paths_in(top);
    ClassShape shape;
    for (;;) {
      shape.entries = entries_in(flags_, paths, shape.inner);
      const bool any =
          std::ranges::any_of(shape.entries, [&](const auto& entry) { return students_.matches_pattern(entry.first); });
      if (any || shape.entries.size() != 1 || !shape.entries.begin()->second.is_folder) return shape;
      shape.inner += (shape.inner.empty() ? "" : "/") + shape.entries.begin()->first;
    }
  }

  /// Adds the students of a class, or of a folder in one. Folders of groups are classes in the class, if all are: one
  /// student's folder cannot pass for several.
  void add_class(const fs::path& top, const ClassShape& shape, const std::string& group = {}) {
    const fs::path folder = shape.inner.empty() ? top : top / shape.inner;
    ClassItems found{.platform = shape.platform, .items = {}, .group = group, .metadata = {}};
    std::map<std::string, std::optional<ClassShape>> inside;  // by relative path
    bool all_groups = shape.platform == Platform::folders && !students_.has_pattern();
    for (const auto& [name, entry] : shape.entries) {
      const std::string relative = group.empty() ? name : group + "/" + name;
      if (fs::is_symlink(folder / name)) {
        class_.ignored.push_back(fmt::format("{} {}", shown_entry(relative), judge::is_link));
        continue;
      }
      found.items.push_back({.path = folder / name, .name = name, .relative = relative, .entry = entry});
      if (all_groups && entry.may_be_handed_in()) {
        inside[relative] = class_inside(folder / name);
        all_groups &= inside[relative].has_value();
      }
    }
    if (all_groups && !inside.empty()) {
      for (const ClassItem& item : found.items)
        if (inside[item.relative]) add_class(item.path, *inside[item.relative], item.relative);
      std::erase_if(found.items, [&](const ClassItem& item) { return inside[item.relative].has_value(); });
    }
    if (shape.platform == Platform::gradescope && fs::is_regular_file(folder / gradescope_metadata))
      found.metadata = read_gradescope_metadata(folder / gradescope_metadata);
    add_items(found);
  }

  void add_items(const ClassItems& items) {
    if (class_.platform.empty()) class_.platform = students_.has_pattern() ? "pattern" : to_string(items.platform);
    students_.add(items);
  }

  /// A folder of a group of students: a class in which several have the same step.
  std::optional<ClassShape> class_inside(const fs::path& folder) const {
    if (!is_folder(folder)) return std::nullopt;
    std::optional<ClassShape> shape = find_class(flags_, paths_in(folder));
    if (!shape) return std::nullopt;
    std::set<std::string> steps;
    bool same = shape->platform != Platform::folders && shape->platform != Platform::github;
    for (const auto& [name, entry] : shape->entries)
      for (const std::string& step : entry.steps) same |= !steps.insert(step).second;
    return same ? shape : std::nullopt;
  }

  /// Gives what could not be unpacked to the student whose it is; a person must look at what could hold steps.
  void report_unusable() {
    std::map<fs::path, std::vector<HandedIn*>> owners;  // several of a group
    for (HandedIn& handed : class_.submissions)
      for (const fs::path& source : handed.sources) owners[source].push_back(&handed);
    const ListedNames names(flags_);
    for (const auto& [path, why] : unusable_) {
      const std::string name = path.filename().string(), sentence = shown_entry(name) + " " + why;
      fs::path of = path;
      while (!owners.contains(of) && of != of.parent_path()) of = of.parent_path();
      if (!owners.contains(of)) class_.ignored.push_back(sentence);
      const bool could_be_steps =
          of == path || has_archive_name(name) || !names.find(name).empty() || flags_.files.contains(name);
      for (HandedIn* owner : owners[of]) std::erase(owner->sources, path);  // else it would be missing too
      for (HandedIn* owner : owners[of]) (could_be_steps ? owner->needs_human : owner->notes).push_back(sentence);
    }
  }

  ClassFolder finish(const std::vector<fs::path>& sources) {
    class_.submissions = students_.hand_in(class_.ignored);
    report_unusable();
    constexpr std::size_t most_ignored = 1000;
    shorten_list(class_.ignored, most_ignored);
    for (HandedIn& handed : class_.submissions)
      shorten_list(handed.notes, max_notes), shorten_list(handed.needs_human, max_notes);
    if (class_.submissions.empty())
      throw Error(fmt::format("{}: has no submission{}", sources.empty() ? "the class" : sources.front().string(),
                              class_.ignored.empty() ? "" : "; ignored: " + class_.ignored.front()));
    return std::move(class_);
  }

  const judge::StepFlags& flags_;
  fs::path unpacked_;
  ClassStudents students_;
  int unpacked_count_ = 0;
  std::map<fs::path, std::string> unusable_;  ///< files that could not be unpacked, and why
  ClassFolder class_;
};

}  // namespace

bool is_class(const judge::StepFlags& flags, const std::vector<fs::path>& sources) {
  if (sources.size() != 1) return sources.size() > 1;
  try {
    return look_for_class(flags, sources[0]).shape.has_value();
  } catch (const Error&) {  // neither a folder nor an archive that can be read: take_submission says what is wrong
    return false;
  }
}

ClassFolder find_submissions(const judge::StepFlags& flags, const std::vector<fs::path>& sources,
                             const fs::path& unpacked, const ClassNaming& naming) {
  return ClassFinder(flags, unpacked, naming).find(sources);
}

}  // namespace atelier::grade
