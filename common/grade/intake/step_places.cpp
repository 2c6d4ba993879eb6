#include "grade/intake/step_places.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <set>
#include <tuple>

#include "base/near_names.hpp"
#include "base/printable.hpp"
#include "grade/intake/archive.hpp"
#include "grade/intake/listed_names.hpp"
#include "grade/intake/version_names.hpp"

namespace atelier::grade {
namespace {

std::string last_part(const std::string& path) {
  return path.substr(path.find_last_of('/') + 1);
}

/// The folder that a path is in; empty: the top.
std::string parent_of(const std::string& path) {
  const auto slash = path.find_last_of('/');
  return slash == path.npos ? "" : path.substr(0, slash);
}

bool is_in(const std::string& path, const std::string& folder) {
  return folder.empty() || path == folder || path.starts_with(folder + "/");
}

std::string shown_path(const std::string& path) {
  return shorten(printable(path), 100);
}

std::string shown_folder(const std::string& folder) {
  return folder.empty() ? "the top" : "'" + shown_path(folder) + "'";
}

/// Letters and digits in lower case: "02blinnphong" for "02_Blinn-Phong".
std::string plain(const std::string& name) {
  std::string plain = lower_case(name);
  std::erase_if(plain, [](unsigned char c) { return !std::isalnum(c); });
  return plain;
}

/// The value of digits without zeros in front: "2" for "02".
std::string number_in(const std::string& text) {
  const auto begin = text.find_first_of("0123456789");
  if (begin == text.npos) return "";
  const auto end = std::min(text.find_first_not_of("0123456789", begin), text.size());
  const auto value = text.find_first_not_of('0', begin);
  return value >= end ? "0" : text.substr(value, end - value);
}

/// Whether a folder's or archive's name has the words of a step's.
bool has_words_of(const std::string& name, const std::string& step) {
  const auto dash = step.find('-');
  const std::string words = plain(dash == step.npos ? step : step.substr(dash + 1));
  return plain(without_archive_endings(name)).find(words) != std::string::npos;
}

/// How surely a folder is a step's.
enum class Fit { exact, like, by_files };

struct Candidate {
  std::string step, folder;
  Fit fit = Fit::exact;
  std::string holder;  ///< the folder in front, also of several that are named like the step: "a" for "a/02-x/02-x"
  int depth = 0;       ///< of the holder; more in folders that compilers make or the course gives
};

constexpr int of_given = 100;  // depth of a folder that compilers make or the course gives: any other place is nearer

int depth_of(const std::string& folder) {
  int depth = 0;
  for (std::string at = folder; !at.empty(); at = parent_of(at))
    depth += is_name_of_given(last_part(at)) ? of_given : 1;
  return depth;
}

class StepFinder {
 public:
  StepFinder(const judge::StepFlags& flags, const SourceFiles& files, const Compare& compare)
      : flags_(flags), names_(flags), files_(files), compare_(compare) {}

  StepPlaces find() {
    list_folders();
    find_candidates();
    take_holder();
    take_others();
    prefer_changed();
    report_skipped();
    report_unused();
    return std::move(places_);
  }

 private:
  using Listed = std::map<std::string, std::string>;  ///< paths by listed name

  Against compare(const std::string& path, const std::string& step, const std::string& listed) const {
    return compare_ ? compare_(files_.files.at(path), step, listed) : Against::changed;
  }

  /// Whether the second of two files for one name is work on a step, and the first is none.
  bool is_work_beside_skeleton(const std::string& path, const std::string& other, const std::string& listed) const {
    return compare_ && std::ranges::any_of(names_.steps_with(listed), [&](const std::string& step) {
             return compare(path, step, listed) == Against::skeleton &&
                    compare(other, step, listed) == Against::changed;
           });
  }

  /// The listed files of each folder. Of several that stand for one name, such as "light.cpp" and "light (1).cpp", the
  /// one with the exact name counts, unless it alone is as in the skeleton.
  void list_folders() {
    for (const auto& [path, file] : files_.files) {
      const std::string name = last_part(path), listed = names_.find(name);
      auto& [folder, paths] = *folders_.try_emplace(parent_of(path)).first;
      const auto [at, fresh] = paths.try_emplace(listed, path);
      if (fresh) continue;
      bool better = name == listed || (last_part(at->second) != listed && is_older(at->second, path));
      if (is_work_beside_skeleton(better ? path : at->second, better ? at->second : path, listed)) better = !better;
      const std::string loser = better ? at->second : path;
      if (better) at->second = path;
      places_.ignored.push_back(fmt::format("{}: {} counts", shown_path(loser), shown_path(last_part(at->second))));
      doubles_.emplace(at->second, loser);
    }
    // Folders of steps whose files lie further down.
    for (const auto& [path, file] : files_.files)
      for (std::string at = parent_of(path); !at.empty(); at = parent_of(at))
        if (names_.steps_with(names_.find(last_part(path))).contains(last_part(at))) folders_.try_emplace(at);
  }

  /// Whether a folder in front of a step's is named like the step itself, as programs make that unpack or pack it.
  static bool wraps(const std::string& name, const std::string& step) {
    return has_words_of(name, step) || (has_archive_name(name) && is_like_step(name, step));
  }

  void add(const std::string& step, const std::string& folder, Fit fit) {
    std::string holder = folder;
    if (fit != Fit::by_files)
      for (holder = parent_of(folder); !holder.empty() && wraps(last_part(holder), step);) holder = parent_of(holder);
    candidates_.push_back({.step = step, .folder = folder, .fit = fit, .holder = holder, .depth = depth_of(holder)});
  }

  void find_candidates() {
    for (const auto& [path, why] : files_.step_folders)
      if (why.empty()) folders_.try_emplace(path);
    for (const auto& [folder, listed] : folders_) {
      const std::string name = last_part(folder);
      std::set<std::string> steps;  // that the folder stands for
      if (flags_.files.contains(name)) {
        add(name, folder, Fit::exact);
        steps.insert(name);
      } else {
        for (const auto& [step, files] : flags_.files)
          if (is_like_step(name, step) && has_some(listed, step)) steps.insert(step);
        if (steps.size() > 1)
          std::erase_if(steps, [&, &listed = listed](const std::string& step) { return !tells(listed, step); });
        for (const std::string& step : steps) add(step, folder, Fit::like);
      }
      for (const auto& [step, files] : flags_.files)
        if (!steps.contains(step) && tells(listed, step)) add(step, folder, Fit::by_files);
    }
  }

  /// Whether any of the files is of the step.
  bool has_some(const Listed& listed, const std::string& step) const {
    return std::ranges::any_of(listed, [&](const auto& file) { return names_.steps_with(file.first).contains(step); });
  }

  /// Whether any of the files is of this step alone.
  bool tells(const Listed& listed, const std::string& step) const {
    return std::ranges::any_of(listed, [&](const auto& file) {
      return names_.tells_step(file.first) && names_.steps_with(file.first).contains(step);
    });
  }

  /// Takes the steps with exact names in the folder nearest to the top that has any.
  void take_holder() {
    std::optional<int> nearest;
    for (const Candidate& c : candidates_)
      if (c.fit == Fit::exact) nearest = std::min(nearest.value_or(c.depth), c.depth);
    if (!nearest) return;
    std::vector<std::string> holders;
    for (const Candidate& c : candidates_)
      if (c.fit == Fit::exact && c.depth == *nearest && std::ranges::find(holders, c.holder) == holders.end())
        holders.push_back(c.holder);
    std::ranges::sort(holders, is_older);
    if (holders.size() > 1) {
      std::vector<std::string> sorted = holders;
      std::ranges::sort(sorted);
      places_.two_folders = fmt::format("{} and {}", shown_folder(sorted[0]), shown_folder(sorted[1]));
      places_.needs_human.push_back(
          fmt::format("steps are in {} folders, such as {}; of a step in several, the one in {} "
                      "counts",
                      holders.size(), places_.two_folders, shown_folder(holders.back())));
    }
    places_.base = holders.back();
    for (const std::string& holder : holders)  // the last one's steps replace the others'
      for (const auto& [step, files] : flags_.files)
        take_nearest(step, [&](const Candidate& c) { return c.fit == Fit::exact && c.holder == holder; });
  }

  /// Takes what is still missing. Where some steps have been found, what the course gives and empty folders are no
  /// more.
  void take_others() {
    const bool some = !places_.steps.empty();
    for (const auto& [step, files] : flags_.files)
      if (!places_.steps.contains(step))
        take_nearest(
            step, [&](const Candidate& c) { return !some || (c.depth < of_given && !folders_.at(c.folder).empty()); });
  }

  /// Takes a step from the nearest of these places, of two equally near from the newer version.
  template <class Accepts>
  void take_nearest(const std::string& step, Accepts&& accepts) {
    std::vector<Candidate> found;
    for (const Candidate& c : candidates_)
      if (c.step == step && accepts(c)) found.push_back(c);
    if (found.empty()) return;
    const auto place = [](const Candidate& c) { return std::tuple(c.depth, c.fit, depth_of(c.folder)); };
    std::ranges::sort(found, [&](const Candidate& a, const Candidate& b) {
      return place(a) != place(b) ? place(a) < place(b) : is_older(b.folder, a.folder);
    });
    if (found.size() > 1 && place(found[0]) == place(found[1]) && overlap(found[0], found[1]))
      places_.needs_human.push_back(fmt::format("{} is in {} and in {}; the one in {} counts", step,
                                                shown_folder(found[0].folder), shown_folder(found[1].folder),
                                                shown_folder(found[0].folder)));
    take(found[0]);
  }

  /// Takes a step from a changed copy, where that in its place is as in the skeleton or cannot be used.
  void prefer_changed() {
    if (!compare_) return;
    for (const auto& [step, files] : flags_.files) {
      const auto found = places_.steps.find(step);
      if (found == places_.steps.end() || found->second.changed) continue;
      const StepPlace before = found->second;
      std::vector<const Candidate*> changed;
      for (const Candidate& c : candidates_)
        if (c.step == step && c.folder != before.folder && is_changed(c)) changed.push_back(&c);
      if (changed.empty()) continue;
      const bool any_exact = std::ranges::any_of(changed, [](const Candidate* c) { return c->fit == Fit::exact; });
      take_nearest(step, [&](const Candidate& c) {
        return c.folder != before.folder && (!any_exact || c.fit == Fit::exact) && is_changed(c);
      });
      StepPlace& place = places_.steps.at(step);
      for (const auto& [file, path] : before.files) place.files.try_emplace(file, path);
      const std::string chosen = shown_folder(place.folder);
      places_.notes.push_back(fmt::format("{} {} in {}; the changed one in {} counts", step,
                                          before.untouched ? "is as in the skeleton" : "has no usable file",
                                          shown_folder(before.folder), chosen));
      if (depth_of(place.folder) >= of_given)
        places_.needs_human.push_back(
            fmt::format("{} is taken from {}, which is named as a folder of the course or a compiler", step, chosen));
      if (changed.size() > 1)
        places_.needs_human.push_back(
            fmt::format("{} has {} changed copies; the one in {} counts", step, changed.size(), chosen));
    }
  }

  /// Whether a folder has work on the step: a file of its own that differs from the skeleton.
  bool is_changed(const Candidate& c) const {
    return std::ranges::any_of(folders_.at(c.folder), [&](const auto& file) {
      return names_.steps_with(file.first).contains(c.step) &&
             (c.fit != Fit::by_files || names_.tells_step(file.first)) &&
             compare(file.second, c.step, file.first) == Against::changed;
    });
  }

  /// Whether two folders have a file of the step in common, so that they are versions and not parts.
  bool overlap(const Candidate& a, const Candidate& b) const {
    const Listed &first = folders_.at(a.folder), &second = folders_.at(b.folder);
    return std::ranges::any_of(flags_.files.at(a.step),
                               [&](const std::string& file) { return first.contains(file) && second.contains(file); });
  }

  void take(const Candidate& c) {
    StepPlace place{.folder = c.folder, .exact = c.fit == Fit::exact && parent_of(c.folder) == c.holder, .files = {}};
    const Listed& here = folders_.at(c.folder);
    for (const std::string& file : flags_.files.at(c.step)) {
      const auto found = here.find(file);
      if (found != here.end() && (names_.tells_step(file) || c.fit != Fit::by_files || belongs_alone(c, file)))
        place.files[file] = found->second;
      else if (const std::string elsewhere = find_elsewhere(c, file); !elsewhere.empty())
        place.files[file] = elsewhere;
    }
    for (const auto& [file, path] : place.files) place.exact &= path == c.folder + "/" + file;
    std::size_t as_given = 0;
    for (const auto& [file, path] : place.files) {
      const Against against = compare(path, c.step, file);
      as_given += against == Against::skeleton;
      place.changed |= against == Against::changed;
    }
    place.untouched = as_given > 0 && as_given == place.files.size();
    places_.steps[c.step] = place;
    placed_[c.step] = c;
  }

  /// Whether a file that several steps list belongs to this one, whose other files lie beside it.
  bool belongs_alone(const Candidate& c, const std::string& file) {
    std::vector<std::string> others;
    for (const Candidate& other : candidates_)
      if (other.folder == c.folder && other.step != c.step && names_.steps_with(file).contains(other.step))
        others.push_back(other.step);
    if (others.empty()) return true;
    const std::string path = shown_path(folders_.at(c.folder).at(file));
    if (!std::ranges::any_of(candidates_, [&](const Candidate& other) {
          return other.folder == c.folder && other.fit != Fit::by_files && names_.steps_with(file).contains(other.step);
        })) {
      others.push_back(c.step);
      std::ranges::sort(others);
      const std::string doubt = fmt::format("{} could belong to {}; it is not read", path, join(others, " or "));
      if (std::ranges::find(places_.needs_human, doubt) == places_.needs_human.end())
        places_.needs_human.push_back(doubt);
    }
    return false;
  }

  /// The only file of this name that lies beside its step's folder: it may be of another version.
  std::string find_only(const Candidate& c, const std::string& file) {
    std::vector<std::string> found;
    for (const auto& [folder, listed] : folders_)
      if (listed.contains(file) && depth_of(folder) < of_given) found.push_back(listed.at(file));
    if (found.size() != 1) return "";
    places_.needs_human.push_back(
        fmt::format("'{}' lies beside the other files of {}, in {}; it may be of another version", shown_path(found[0]),
                    c.step, shown_folder(c.folder)));
    return found[0];
  }

  /// A file that is not in its step's folder: the only one below it, the one in the nearest folder above it, or the
  /// only one anywhere.
  std::string find_elsewhere(const Candidate& c, const std::string& file) {
    std::vector<std::string> deeper;
    for (const auto& [folder, listed] : folders_)
      if (folder != c.folder && !c.folder.empty() && is_in(folder, c.folder) && listed.contains(file))
        deeper.push_back(listed.at(file));
    if (deeper.size() == 1) return deeper[0];
    if (!deeper.empty() || !names_.tells_step(file)) return "";
    for (std::string at = c.folder; !at.empty();) {
      at = parent_of(at);
      const auto around = folders_.find(at);
      if (around != folders_.end() && around->second.contains(file)) return around->second.at(file);
    }
    return find_only(c, file);
  }

  /// Steps that are not there because the place of their folder holds something else.
  void report_skipped() {
    for (const auto& [path, why] : files_.step_folders) {
      const std::string step = last_part(path);
      if (!why.empty() && !places_.steps.contains(step) && (places_.steps.empty() || parent_of(path) == places_.base))
        places_.skipped[step] = why;
    }
  }

  /// Says where the steps are, and which files with listed names count for none.
  void report_unused() {
    std::set<std::string> used;
    for (const auto& [step, place] : places_.steps) {
      const Candidate& c = placed_.at(step);
      const bool at_base = c.fit == Fit::exact && c.holder == places_.base;
      if (!at_base || parent_of(c.folder) != c.holder)
        places_.notes.push_back(fmt::format("{} is read from {}", step, shown_folder(c.folder)));
      for (const auto& [file, path] : place.files) {
        used.insert(path);
        const std::string usual = c.folder.empty() ? file : c.folder + "/" + file;
        if (path != usual)
          places_.notes.push_back(fmt::format("{}/{} is read from '{}'", step, file, shown_path(path)));
        if (const auto loser = doubles_.find(path); loser != doubles_.end())
          places_.needs_human.push_back(fmt::format("'{}' stands for {}/{} too, but '{}' counts",
                                                    shown_path(loser->second), step, file, shown_path(path)));
      }
    }
    for (const auto& [folder, listed] : folders_)
      for (const auto& [file, path] : listed)
        if (!used.contains(path)) places_.ignored.push_back(shown_path(path));
    for (auto& [step, place] : places_.steps)
      if (place.untouched) list_elsewhere(step, place, used);
  }

  /// Files beside an untouched step that could be work on it: with a listed name, or with one that begins like it, such
  /// as "light_solved.cpp".
  void list_elsewhere(const std::string& step, StepPlace& place, const std::set<std::string>& used) const {
    for (const auto& [path, file] : files_.files) {
      const std::string listed = names_.find(last_part(path));
      if (!used.contains(path) && names_.steps_with(listed).contains(step) &&
          compare(path, step, listed) != Against::skeleton)
        place.elsewhere.push_back(shown_path(path));
    }
    for (const std::string& path : files_.others)
      if (depth_of(parent_of(path)) < of_given && std::ranges::any_of(flags_.files.at(step), [&](const std::string& f) {
            const std::string stem = f.substr(0, f.find('.'));
            return names_.tells_step(f) && lower_case(last_part(path)).find(lower_case(stem)) != std::string::npos;
          }))
        place.elsewhere.push_back(shown_path(path));
  }

  const judge::StepFlags& flags_;
  ListedNames names_;
  const SourceFiles& files_;
  const Compare& compare_;
  std::map<std::string, Listed> folders_;
  std::map<std::string, std::string> doubles_;  ///< by the path that counts, one that does not
  std::vector<Candidate> candidates_;
  std::map<std::string, Candidate> placed_;  ///< by step
  StepPlaces places_;
};

}  // namespace

bool is_folder_of_tools(const std::string& name) {
  return name == "__MACOSX" || (name.starts_with(".") && name != "." && name != "..");
}

bool is_litter(const std::string& path) {
  const std::string name = lower_case(last_part(path));
  static const std::set<std::string> names = {"thumbs.db", "desktop.ini", "icon\r"};
  static const std::set<std::string> endings = {".obj",     ".o",       ".pdb",  ".ilk", ".exe",  ".dll",
                                                ".so",      ".sln",     ".user", ".suo", ".ipch", ".tlog",
                                                ".vcxproj", ".filters", ".swp",  ".pch"};
  const auto dot = name.find_last_of('.');
  if (name.starts_with('.') || name.ends_with('~') || names.contains(name)) return true;
  if (dot != name.npos && endings.contains(name.substr(dot))) return true;
  for (std::string at = parent_of(path); !at.empty(); at = parent_of(at))
    if (is_folder_of_tools(last_part(at))) return true;
  return false;
}

bool is_like_step(const std::string& name, const std::string& step) {
  if (has_words_of(name, step)) return true;
  std::string letters = plain(split_version(name).base);
  const std::string number = number_in(letters);
  std::erase_if(letters, [](unsigned char c) { return std::isdigit(c) != 0; });
  static const std::set<std::string> prefixes = {"",    "step", "task", "ex",       "exercise", "assignment", "hw",
                                                 "lab", "part", "week", "homework", "aufgabe",  "uebung"};
  return !number.empty() && number == number_in(step) && prefixes.contains(letters);
}

StepPlaces find_steps(const judge::StepFlags& flags, const SourceFiles& files, const Compare& compare) {
  return StepFinder(flags, files, compare).find();
}

}  // namespace atelier::grade
