#include "grade/class_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <utility>

#include "base/error.hpp"
#include "base/near_names.hpp"
#include "base/printable.hpp"
#include "grade/archive.hpp"
#include "grade/class_shape.hpp"
#include "grade/listed_names.hpp"
#include "grade/platform_names.hpp"
#include "grade/step_places.hpp"
#include "grade/student_id.hpp"
#include "grade/unpack.hpp"
#include "grade/version_names.hpp"

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

std::vector<std::string> names_in_archive(const fs::path& file) {
  return read_archive(
             file, [](const std::string&) { return 0; }, {}, class_limits)
      .names;
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

/// A class's pattern, which the instructor has written. Names are at most 255 bytes long.
std::optional<std::regex> compile(const std::string& pattern) {
  if (pattern.empty()) return std::nullopt;
  try {
    std::regex compiled(pattern, std::regex::ECMAScript);
    if (compiled.mark_count() < 1 || compiled.mark_count() > 2)
      throw Error(
          fmt::format("the pattern '{}' must have one group, the name, or two, name and identifier, such as "
                      "'(.+)_([0-9]+)'",
                      shown_entry(pattern)));
    return compiled;
  } catch (const std::regex_error& error) {
    throw Error(fmt::format("the pattern '{}' is no regular expression: {}", shown_entry(pattern), error.what()));
  }
}

/// An entry that may be a student's.
struct Item {
  fs::path path;
  std::string name;      ///< of the entry
  std::string relative;  ///< to the class's folder
  ClassEntry entry;
};

/// What belongs to one student, before it has an id.
struct Gathered {
  Student student;
  std::vector<std::pair<std::uint64_t, Item>> items;  ///< with the platform's order
  std::optional<std::int64_t> handed_in;
  bool late = false;
  std::vector<std::string> notes, needs_human;
};

class ClassFinder {
 public:
  ClassFinder(const judge::StepFlags& flags, const fs::path& unpacked, const ClassNaming& naming)
      : flags_(flags), unpacked_(unpacked), pattern_(compile(naming.pattern)), pattern_text_(naming.pattern) {}

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
    if (found.shape || pattern_) {
      fs::path top = source;
      if (!found.archive.empty()) top = unpack(found.archive);
      if (!found.shape) found.shape = entries_of_pattern(top);
      add_class(top, *found.shape);
    } else {
      add_items({item_of(source, "")}, Platform::folders);
    }
  }

  /// Several paths, as a shell gives them for "hw/*": each a submission, or a class of its own.
  void add_several(const std::vector<fs::path>& sources) {
    std::vector<Item> items;
    ClassEntries entries;
    for (const fs::path& source : sources) {
      if (!fs::exists(source)) throw Error(fmt::format("{}: there is no such folder or archive", source.string()));
      const Item item = item_of(source, "");
      if (pattern_ || platform_of_name(item)) {
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
    std::map<Platform, std::vector<Item>> by_platform;
    for (Item& item : items) by_platform[platform_of_name(item).value_or(Platform::folders)].push_back(std::move(item));
    for (const auto& [platform, some] : by_platform) add_items(some, platform);
  }

  static std::optional<Platform> platform_of_name(const Item& item) {
    if (moodle_name(item.name)) return Platform::moodle;
    if (item.entry.is_folder && gradescope_name(item.name)) return Platform::gradescope;
    if (!item.entry.is_folder && canvas_name(item.name)) return Platform::canvas;
    return std::nullopt;
  }

  /// A path that was named, also by a link: the instructor's links are followed.
  Item item_of(const fs::path& source, const std::string& relative) const {
    std::error_code error;
    const fs::path whole = fs::canonical(source, error), path = error ? source : whole;
    Item item{.path = path, .name = path.filename().string(), .relative = relative, .entry = {}};
    item.entry.is_folder = is_folder(path);
    item.entry.has_steps = true;
    if (item.relative.empty()) item.relative = item.name;
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
          std::ranges::any_of(shape.entries, [&](const auto& entry) { return matches(entry.first).has_value(); });
      if (any || shape.entries.size() != 1 || !shape.entries.begin()->second.is_folder) return shape;
      shape.inner += (shape.inner.empty() ? "" : "/") + shape.entries.begin()->first;
    }
  }

  void add_class(const fs::path& top, const ClassShape& shape) {
    const fs::path folder = shape.inner.empty() ? top : top / shape.inner;
    std::vector<Item> items;
    for (const auto& [name, entry] : shape.entries) {
      if (fs::is_symlink(folder / name))
        class_.ignored.push_back(fmt::format("{} {}", shown_entry(name), judge::is_link));
      else
        items.push_back({.path = folder / name, .name = name, .relative = group_ + name, .entry = entry});
    }
    if (shape.platform == Platform::gradescope && shape.entries.contains(gradescope_metadata))
      metadata_.merge(read_gradescope_metadata(folder / gradescope_metadata));
    add_items(items, shape.platform);
  }

  void add_items(const std::vector<Item>& items, Platform platform) {
    if (class_.platform.empty()) class_.platform = pattern_ ? "pattern" : to_string(platform);
    if (!pattern_ && platform == Platform::github) prefix_ = common_prefix(items);
    if (!pattern_ && platform == Platform::folders) list_bases(items);
    for (const Item& item : items) {
      if (pattern_)
        add_by_pattern(item);
      else if (platform == Platform::moodle)
        add_moodle(item);
      else if (platform == Platform::canvas)
        add_canvas(item);
      else if (platform == Platform::gradescope)
        add_gradescope(item);
      else if (platform == Platform::github)
        add_github(item);
      else
        add_folder(item);
    }
  }

  void ignore(const Item& item, const std::string& why) {
    class_.ignored.push_back(fmt::format("{} {}", shown_entry(item.relative), why));
  }

  Gathered& gather(const std::string& key, const std::string& name, const std::string& identifier, const Item& item,
                   std::uint64_t order = 0) {
    Gathered& gathered = students_[key];
    gathered.student.name = shown_entry(name);
    gathered.student.identifier = shown_entry(identifier);
    gathered.items.emplace_back(order, item);
    return gathered;
  }

  std::optional<std::smatch> matches(const std::string& name) const {
    std::smatch match;
    return std::regex_match(name, match, *pattern_) ? std::optional(match) : std::nullopt;
  }

  void add_by_pattern(const Item& item) {
    const auto match = matches(item.name);
    if (!match) return ignore(item, fmt::format("does not match the pattern '{}'", shown_entry(pattern_text_)));
    const std::string name = (*match)[1].str(), identifier = match->size() > 2 ? (*match)[2].str() : "";
    gather("pattern/" + name + "/" + identifier, name, identifier, item);
  }

  void add_moodle(const Item& item) {
    const auto found = moodle_name(item.name);
    if (!found) return ignore(item, "has no name of Moodle: NAME_NUMBER_assignsubmission_file_");
    const std::string key = "moodle/" + found->name + "/" + found->identifier;
    if (!found->is_text) {
      gather(key, found->name, found->identifier, item);
    } else {
      ignore(item, "was typed into Moodle's page and is no file");
      texts_.emplace(key, std::pair(*found, item));
    }
  }

  void add_canvas(const Item& item) {
    const auto found = canvas_name(item.name);
    if (!found) return ignore(item, "has no name of Canvas: NAME_NUMBER_NUMBER_FILE");
    Gathered& gathered = gather("canvas/" + found->identifier, found->name, found->identifier, item, found->order);
    gathered.late |= found->late;
  }

  void add_gradescope(const Item& item) {
    const auto found = gradescope_name(item.name);
    if (!found && item.name == gradescope_metadata) return;
    if (!found) return ignore(item, "has no name of Gradescope: submission_NUMBER");
    const auto known = metadata_.find(item.name);
    const GradescopeSubmission about = known == metadata_.end() ? GradescopeSubmission{} : known->second;
    Gathered& gathered = gather("gradescope/" + found->identifier, about.name,
                                about.identifier.empty() ? found->identifier : about.identifier, item);
    gathered.handed_in = about.created;
    if (about.name.empty()) gathered.notes.push_back(fmt::format("{} does not name the student", gradescope_metadata));
  }

  /// What all clones' names begin with, up to a '-': "homework-".
  static std::string common_prefix(const std::vector<Item>& items) {
    std::optional<std::string> prefix;
    for (const Item& item : items) {
      if (!item.entry.is_folder) continue;
      if (!prefix) prefix = item.name;
      const auto end = std::ranges::mismatch(*prefix, item.name).in1;
      prefix->erase(end, prefix->end());
    }
    const auto dash = prefix ? prefix->find_last_of('-') : std::string::npos;
    return dash == std::string::npos ? "" : prefix->substr(0, dash + 1);
  }

  void add_github(const Item& item) {
    if (!item.entry.is_folder && !has_archive_name(item.name)) return ignore(item, "is no clone");
    const std::string name = without_archive_endings(item.name);
    const std::string login = name.starts_with(prefix_) && name != prefix_ ? name.substr(prefix_.size()) : name;
    gather("github/" + login, "", login, item);
  }

  /// Counts the entries that are one student's if versions are left out of their names.
  void list_bases(const std::vector<Item>& items) {
    for (const Item& item : items) ++bases_[without_archive_endings(split_version(item.name).base)];
  }

  void add_folder(const Item& item) {
    const bool single_file = !item.entry.is_folder && !has_archive_name(item.name);
    if (single_file) return ignore(item, "is neither a folder nor an archive");
    if (item.entry.is_folder && !item.entry.may_be_handed_in() && is_name_of_work(item.name))
      return ignore(item, "has none of the steps' files");
    if (is_name_of_given(item.name)) return ignore(item, "is of the course or a compiler");
    if (item.entry.is_folder && add_class_inside(item)) return;
    const std::string whole = without_archive_endings(item.name), base = split_version(item.name).base;
    const bool is_version = !base.empty() && base != whole && bases_[base] > 1;
    const std::string name = is_version ? base : whole;
    Gathered& gathered = gather("folders/" + group_ + name, name, "", item);
    if (group_.empty()) return;
    const std::string where = fmt::format("is one of several in the folder '{}'", shown_entry(group_));
    if (group_size_ > 2)
      gathered.notes.push_back(where);
    else
      gathered.needs_human.push_back(where + ", which may be one student's");
  }

  /// A folder of a group of students, in which several have the same step, is a class in the class.
  bool add_class_inside(const Item& item) {
    constexpr int most_levels = 3;
    if (level_ >= most_levels) return false;
    const auto shape = find_class(flags_, paths_in(item.path));
    if (!shape) return false;
    std::set<std::string> steps;
    bool same = shape->platform != Platform::folders && shape->platform != Platform::github;
    for (const auto& [name, entry] : shape->entries)
      for (const std::string& step : entry.steps) same |= !steps.insert(step).second;
    if (!same) return false;
    const std::string group = std::exchange(group_, item.relative + "/");
    const std::size_t size = std::exchange(group_size_, shape->entries.size());
    ++level_;
    add_class(item.path, *shape);
    --level_;
    group_ = group, group_size_ = size;
    return true;
  }

  /// Texts of students who have handed in nothing else are for a person.
  void add_texts() {
    for (const auto& [key, text] : texts_) {
      if (students_.contains(key)) continue;
      gather(key, text.first.name, text.first.identifier, text.second)
          .needs_human.push_back("handed in a text on Moodle's page and no file");
    }
  }

  /// Students whose names differ only by case may be one.
  void doubt_cases() {
    std::map<std::string, std::vector<Gathered*>> by_lower;
    for (auto& [key, gathered] : students_)
      if (gathered.student.identifier.empty()) by_lower[lower_case(gathered.student.name)].push_back(&gathered);
    for (const auto& [name, same] : by_lower)
      for (Gathered* gathered : same)
        for (const Gathered* other : same)
          if (gathered != other && gathered->student.name != other->student.name)
            gathered->needs_human.push_back(fmt::format(
                "may be of the same student as '{}', a name that differs only by case", other->student.name));
  }

  HandedIn hand_in(Gathered& gathered) {
    auto& items = gathered.items;
    std::ranges::stable_sort(items, [](const auto& a, const auto& b) {
      return a.first != b.first ? a.first < b.first : is_older(a.second.name, b.second.name);
    });
    HandedIn handed{.student = gathered.student,
                    .sources = {},
                    .source = shown_entry(items.back().second.relative),
                    .handed_in = gathered.handed_in,
                    .late = gathered.late,
                    .notes = gathered.notes,
                    .needs_human = gathered.needs_human};
    std::vector<std::string> names;
    bool ordered = true, archives_or_folders = true;
    for (const auto& [order, item] : items) {
      handed.sources.push_back(item.path);
      names.push_back("'" + shown_entry(item.relative) + "'");
      ordered &= order > 0;
      archives_or_folders &= item.entry.is_folder || has_archive_name(item.name);
    }
    if (items.size() > 1 && archives_or_folders) {
      const std::string several =
          fmt::format("handed in {}; of a step in several, the one in {} counts", join(names), names.back());
      if (ordered)
        handed.notes.push_back(several + ", the newest");
      else
        handed.needs_human.push_back(several + ", the newest by its name");
    }
    return handed;
  }

  /// Gives what could not be unpacked to the student whose it is.
  void report_unusable() {
    for (const auto& [path, why] : unusable_) {
      const std::string sentence = shown_entry(path.filename().string()) + " " + why;
      const auto of = std::ranges::find_if(class_.submissions, [&](const HandedIn& handed) {
        return std::ranges::any_of(handed.sources, [&](const fs::path& source) {
          return path == source || path.string().starts_with(source.string() + "/");
        });
      });
      if (of != class_.submissions.end())
        of->needs_human.push_back(sentence);
      else
        class_.ignored.push_back(sentence);
    }
  }

  ClassFolder finish(const std::vector<fs::path>& sources) {
    add_texts();
    doubt_cases();
    std::set<std::string> ids;
    for (auto& [key, gathered] : students_) {
      HandedIn handed = hand_in(gathered);
      handed.student.id = new_student_id(handed.student.name, handed.student.identifier, ids);
      class_.submissions.push_back(std::move(handed));
    }
    report_unusable();
    if (class_.submissions.empty())
      throw Error(fmt::format("{}: has no submission{}", sources.empty() ? "the class" : sources.front().string(),
                              class_.ignored.empty() ? "" : "; ignored: " + class_.ignored.front()));
    std::ranges::sort(class_.submissions, {}, [](const HandedIn& handed) { return handed.student.id; });
    return std::move(class_);
  }

  const judge::StepFlags& flags_;
  fs::path unpacked_;
  std::optional<std::regex> pattern_;
  std::string pattern_text_;
  int unpacked_count_ = 0, level_ = 0;
  std::map<std::string, GradescopeSubmission> metadata_;
  std::string prefix_;                ///< of clones
  std::string group_;                 ///< the folder in the class whose entries are being added, with a slash
  std::size_t group_size_ = 0;        ///< its entries
  std::map<std::string, int> bases_;  ///< entries by name without version
  std::map<fs::path, std::string> unusable_;
  std::map<std::string, std::pair<PlatformName, Item>> texts_;
  std::map<std::string, Gathered> students_;
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
