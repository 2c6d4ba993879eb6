#include "grade/intake/submission.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/near_names.hpp"
#include "base/printable.hpp"
#include "base/sha256.hpp"
#include "grade/intake/archive.hpp"
#include "grade/intake/bounded_list.hpp"
#include "grade/intake/listed_names.hpp"
#include "grade/intake/platform_names.hpp"
#include "grade/intake/source_files.hpp"
#include "grade/intake/step_places.hpp"
#include "grade/intake/text_conversion.hpp"
#include "grade/varied_cases.hpp"

namespace atelier::grade {
namespace {

namespace fs = std::filesystem;

std::string shown_name(const std::string& name) {
  return shorten(printable(name), 100);
}

/// The last part of the path, also for "solutions/", "." and "..".
std::string name_of(const fs::path& source) {
  const std::string name = printable(without_archive_endings(fs::weakly_canonical(source).filename().string()));
  return name.empty() || name == "." || name == ".." ? "submission" : name;  // "...zip" has the stem ".."
}

/// One version of a submission, as it was found.
struct Version {
  std::string name;  ///< printable
  fs::path folder;   ///< if it is one; otherwise empty
  SourceFiles files;
  StepPlaces places;
};

/// The bytes of a file that may be a student's; empty, with the reason in `why`: it is unusable.
std::string usable_bytes(const SourceFile& file, std::string& why) {
  why = file.why_unusable;
  if (why.empty() && !file.at.empty()) why = judge::why_unusable(file.at);
  if (!why.empty()) return "";
  return file.at.empty() ? file.bytes : read_file(file.at);
}

/// Compares with SKELETONS/NN-name/FILE; nothing to compare with if `skeletons` is empty.
Compare compare_with(const fs::path& skeletons) {
  if (skeletons.empty()) return {};
  return [skeletons](const SourceFile& file, const std::string& step, const std::string& listed) {
    std::string why;
    const std::string bytes = usable_bytes(file, why);
    const fs::path skeleton = skeletons / step / listed;
    if (!why.empty() || !convert_text(bytes).why_no_text.empty() || bytes.empty()) return Against::unusable;
    return fs::exists(skeleton) && are_same_text(bytes, read_file(skeleton)) ? Against::skeleton : Against::changed;
  };
}

class SubmissionTaker {
 public:
  SubmissionTaker(const judge::StepFlags& flags, const fs::path& folder) : flags_(flags) {
    taken_.folder = folder;
    fs::create_directories(folder);
  }

  /// Takes the steps of one version; they replace those of earlier ones.
  void take(const Version& version) {
    for (const auto& [step, why] : version.places.skipped) {
      taken_.skipped[step] = why;
      taken_.notes.push_back(step + " " + why);
    }
    for (const auto& [step, place] : version.places.steps) {
      const auto earlier = versions_.find(step);
      if (earlier != versions_.end() && place.files.empty()) continue;  // an empty folder is no newer version
      for (const std::string& path : place.elsewhere) elsewhere_[step].push_back(path);
      if (earlier != versions_.end() && place.untouched && changed_.contains(step)) {
        note(fmt::format("{} is as in the skeleton in {}; the changed one in {} counts", step, version.name,
                         earlier->second));
        need_human(
            fmt::format("{} was handed in changed in {} and later, in {}, as in the skeleton; the changed one "
                        "counts, unless the student meant to withdraw it",
                        step, earlier->second, version.name));
        continue;
      }
      if (earlier != versions_.end()) {
        taken_.notes.push_back(
            fmt::format("{} is in {} too; the newer in {} counts", step, earlier->second, version.name));
        fs::remove_all(taken_.folder / step);
      }
      versions_[step] = version.name;
      if (place.changed)
        changed_.insert(step);
      else
        changed_.erase(step);
      taken_.skipped.erase(step);
      taken_.present.insert(step);
      take_step(version, step, place);
    }
    append(taken_.notes, version.places.notes);
    append(taken_.notes, version.files.notes);
    append(taken_.needs_human, version.places.needs_human);
    append(taken_.ignored, version.places.ignored);
    for (const std::string& path : version.files.others) taken_.ignored.push_back(shown_name(path));
  }

  void need_human(const std::string& sentence) { taken_.needs_human.push_back(sentence); }
  void note(const std::string& sentence) { taken_.notes.push_back(sentence); }

  /// Notes what could not be read beside steps; a person must look at it if one of these is untouched.
  void note_unread(const std::string& sentence) {
    note(sentence);
    unread_.push_back(sentence);
  }

  Submission finish(const fs::path& skeletons) {
    say_line_ends("CRLF"), say_line_ends("CR");
    for (const std::string& step : taken_.present) {
      std::vector<std::string> files;
      for (const std::string& file : flags_.files.at(step))
        if (fs::exists(taken_.folder / step / file)) files.push_back(file);
      taken_.taken.push_back(fmt::format("{}: {}", step, files.empty() ? "none of its files" : join(files)));
      if (!is_untouched(step, files, skeletons)) continue;
      taken_.untouched.insert(step);
      if (!elsewhere_[step].empty()) {
        shorten_list(elsewhere_[step], most_named);
        need_human(fmt::format("{} is as in the skeleton, but {} could be work on it", step, join(elsewhere_[step])));
      }
    }
    if (!taken_.untouched.empty())
      for (const std::string& sentence : unread_)
        need_human(fmt::format("{}, while {} as in the skeleton", sentence,
                               taken_.untouched.size() > 1 ? fmt::format("{} steps are", taken_.untouched.size())
                                                           : *taken_.untouched.begin() + " is"));
    for (const auto& [step, files] : taken_.unusable)
      for (const auto& [file, why] : files) need_human(fmt::format("{}/{} {}", step, file, why));
    for (const auto& [step, why] : taken_.skipped) need_human(step + " " + why);
    for (std::vector<std::string>* list : {&taken_.notes, &taken_.needs_human, &taken_.taken, &taken_.ignored})
      shorten_list(*list, max_notes);
    return std::move(taken_);
  }

  const Submission& so_far() const { return taken_; }

 private:
  static void append(std::vector<std::string>& to, const std::vector<std::string>& more) {
    to.insert(to.end(), more.begin(), more.end());
  }

  void take_step(const Version& version, const std::string& step, const StepPlace& place) {
    judge::UnusableFiles unusable;
    for (const std::string& file : flags_.files.at(step)) {
      const auto found = place.files.find(file);
      const std::string why =
          found == place.files.end() ? judge::is_missing : take_file(version.files.files.at(found->second), step, file);
      if (why.empty() || (why == judge::is_missing && judge::may_miss(file))) continue;
      unusable[file] = why;
      if (why != judge::is_missing) taken_.notes.push_back(fmt::format("{}/{} {}", step, file, why));
    }
    taken_.unusable.erase(step);
    if (!unusable.empty()) taken_.unusable[step] = unusable;
  }

  /// Copies a file as a compiler reads it. Returns why it is unusable; empty: it is usable.
  std::string take_file(const SourceFile& found, const std::string& step, const std::string& file) {
    std::string why_not;
    const ConvertedText converted = convert_text(usable_bytes(found, why_not));
    if (!why_not.empty()) return why_not;
    if (!converted.why_no_text.empty()) return converted.why_no_text;
    const fs::path copy = taken_.folder / step / file;
    write_file(copy, std::string_view(converted.text));
    if (const std::string why = judge::why_unusable(copy); !why.empty()) {
      fs::remove(copy);
      return why;
    }
    const std::string name = step + "/" + file;
    if (converted.encoding == "Latin-1")
      note(name + " is neither UTF-8 nor UTF-16 and is read as Latin-1");
    else if (!converted.encoding.empty())
      note(fmt::format("{} was {} and is read as UTF-8", name, converted.encoding));
    if (!converted.line_ends.empty()) line_ends_[converted.line_ends].insert(name);
    return "";
  }

  /// One note for all files: most students on Windows have these line ends everywhere.
  void say_line_ends(const std::string& kind) {
    std::vector<std::string> names;
    for (const std::string& name : line_ends_[kind])
      if (taken_.present.contains(name.substr(0, name.find('/')))) names.push_back(name);
    if (names.empty()) return;
    constexpr std::size_t most = 3;
    const std::size_t more = names.size() > most ? names.size() - most : 0;
    names.resize(names.size() - more);
    note(fmt::format("line ends {} are read as LF: {}{}", kind, join(names),
                     more > 0 ? fmt::format(" and {} more", more) : ""));
  }

  bool is_untouched(const std::string& step, const std::vector<std::string>& files, const fs::path& skeletons) const {
    if (skeletons.empty() || files.empty() || taken_.unusable.contains(step)) return false;
    return std::ranges::all_of(files, [&](const std::string& file) {
      const fs::path skeleton = skeletons / step / file;
      return fs::exists(skeleton) && are_same_text(read_file(taken_.folder / step / file), read_file(skeleton));
    });
  }

  static constexpr std::size_t most_named = 5;  // files in one sentence

  const judge::StepFlags& flags_;
  Submission taken_;
  std::map<std::string, std::string> versions_;                ///< by step, the version that counts
  std::map<std::string, std::set<std::string>> line_ends_;     ///< files, by the line ends that they had
  std::set<std::string> changed_;                              ///< steps with a file that is not as in the skeleton
  std::map<std::string, std::vector<std::string>> elsewhere_;  ///< by step, files that could be work on it
  std::vector<std::string> unread_;
};

Version read_version(const judge::StepFlags& flags, const fs::path& source, const Compare& compare) {
  Version version;
  if (fs::is_directory(source)) version.folder = source;
  version.files = read_source(flags, source);
  version.places = find_steps(flags, version.files, compare);
  return version;
}

/// Whether all that is present are the folders NN-name in `base` and the files in them.
bool all_exact(const StepPlaces& places) {
  const std::string front = places.base.empty() ? "" : places.base + "/";
  return std::ranges::all_of(
      places.steps, [&](const auto& step) { return step.second.exact && step.second.folder == front + step.first; });
}

/// What was found in place of steps.
std::string what_is_there(const SourceFiles& files) {
  if (files.has_folders_of_steps && files.notes.empty()) return "; it has folders of steps, but none of their files";
  std::vector<std::string> names;
  for (const std::string& path : files.others) names.push_back(shown_name(path));
  for (const auto& [path, file] : files.files) names.push_back(shown_name(path));
  if (names.empty()) return "";
  constexpr std::size_t most = 3;
  const std::size_t count = names.size();
  names.resize(std::min(count, most));
  return fmt::format("; it has {}{}", join(names), count > most ? fmt::format(" and {} more", count - most) : "");
}

/// Says in one line why there is no step.
[[noreturn]] void refuse_without_steps(const judge::StepFlags& flags, const fs::path& source, const SourceFiles& files,
                                       const std::vector<std::string>& notes) {
  std::vector<std::string> steps;
  for (const auto& [step, names] : flags.files) steps.push_back(step);
  std::string words =
      fmt::format("{}: has none of the steps; it must have folders such as {}", source.string(), join(steps));
  words += what_is_there(files);
  if (!files.unread.empty()) words += "; not read: " + join(files.unread);
  if (!notes.empty()) words += "; skipped: " + join(notes);
  throw Error(words);
}

/// Whether a folder is that of one step, and holds no folders of steps.
bool is_folder_of_one_step(const judge::StepFlags& flags, const Version& version, const fs::path& source) {
  return !version.folder.empty() && flags.files.contains(fs::weakly_canonical(source).filename().string()) &&
         std::ranges::none_of(version.places.steps, [](const auto& step) { return step.second.exact; });
}

/// Reads one of several versions; what is wrong with it goes to those who must look at it.
void take_version(const judge::StepFlags& flags, const fs::path& source, const std::string& name,
                  const Compare& compare, SubmissionTaker& taker) {
  Version version;
  try {
    version = read_version(flags, source, compare);
  } catch (const std::exception& error) {  // also of the file system: the source may have names that it refuses
    std::string what = error.what();
    if (what.starts_with(source.string() + ": ")) what.erase(0, source.string().size() + 2);
    taker.need_human(fmt::format("{} {}", name, shorten(printable(what), 300)));
    return;
  }
  version.name = name;
  taker.take(version);
  for (const std::string& sentence : version.files.unread)
    if (version.places.steps.empty())
      taker.need_human(name + ": " + sentence);
    else
      taker.note_unread(sentence);
  if (version.places.steps.empty() && version.files.unread.empty())
    taker.need_human(version.files.files.empty() && version.files.others.empty() && version.files.notes.empty()
                         ? name + " is empty: nothing was handed in"
                         : fmt::format("{} has none of the steps{}", name, what_is_there(version.files)));
}

/// Takes single files together, as if they lay in one folder. Returns the names of files that no step lists.
void take_loose_files(const judge::StepFlags& flags, const std::vector<fs::path>& files, const Compare& compare,
                      SubmissionTaker& taker) {
  const ListedNames names(flags);
  std::map<std::string, fs::path> by_name;
  std::vector<std::string> others;
  for (const fs::path& file : files) {
    const std::string uploaded = uploaded_name(file.filename().string()), shown = shown_name(uploaded);
    const std::string listed = names.find(uploaded);
    if (listed.empty()) {
      others.push_back(shown);
      continue;
    }
    const auto [at, fresh] = by_name.try_emplace(listed, file);
    if (fresh) continue;
    const std::string before = shown_name(uploaded_name(at->second.filename().string()));
    const auto all_are = [&](const fs::path& path, Against against) {
      const SourceFile one{.at = path, .bytes = {}, .why_unusable = {}};
      return compare && std::ranges::all_of(names.steps_with(listed), [&](const std::string& step) {
               return compare(one, step, listed) == against;
             });
    };
    if (all_are(file, Against::skeleton) && all_are(at->second, Against::changed)) {
      taker.need_human(fmt::format("{} was handed in twice; {}, the later, is as in the skeleton, and {} counts",
                                   listed, shown, before));
      continue;
    }
    at->second = file;
    taker.note(fmt::format("{} was handed in twice; {} counts", listed, shown));
  }
  Version version;
  version.name = "single files";
  version.files = read_loose_files(flags, {by_name.begin(), by_name.end()});
  version.files.others = others;
  version.places = find_steps(flags, version.files, compare);
  taker.take(version);
  if (by_name.empty() && taker.so_far().present.empty())
    taker.need_human(fmt::format("has {}, but none of the steps' files", join(others)));
}

}  // namespace

Submission take_submission(const judge::StepFlags& flags, const fs::path& source, const fs::path& folder,
                           const fs::path& skeletons) {
  if (!fs::exists(source)) throw Error(fmt::format("{}: there is no such folder or archive", source.string()));
  const Version version = read_version(flags, source, compare_with(skeletons));
  if (!version.places.two_folders.empty())
    throw Error(
        fmt::format("{}: has steps in two folders, {}; name one of them", source.string(), version.places.two_folders));
  if (is_folder_of_one_step(flags, version, source))
    throw Error(fmt::format("{}: has none of the steps; it is the folder of one step: name its parent folder, {}",
                            source.string(), fs::weakly_canonical(source).parent_path().string()));
  SubmissionTaker taker(flags, folder);
  taker.take(version);
  if (taker.so_far().present.empty()) refuse_without_steps(flags, source, version.files, taker.so_far().notes);
  for (const std::string& sentence : version.files.unread) taker.note(sentence);
  Submission submission = taker.finish({});
  submission.name = name_of(source);
  if (!version.folder.empty() && all_exact(version.places)) {
    submission.source = source;
    if (!version.places.base.empty()) submission.source /= version.places.base;
  }
  return submission;
}

Submission take_submission(const judge::StepFlags& flags, const std::vector<fs::path>& sources, const fs::path& folder,
                           const fs::path& skeletons) {
  SubmissionTaker taker(flags, folder);
  const Compare compare = compare_with(skeletons);
  std::vector<fs::path> loose;
  std::vector<std::string> names;
  for (const fs::path& source : sources) names.push_back(source.filename().string());
  const std::vector<std::string> shown = names_for_sentences(names);
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const fs::path& source = sources[i];
    std::error_code error;
    const fs::file_type type = fs::symlink_status(source, error).type();
    if (type == fs::file_type::directory || (type == fs::file_type::regular && has_archive_name(names[i])))
      take_version(flags, source, shown_name(shown[i]), compare, taker);
    else if (type == fs::file_type::regular)
      loose.push_back(source);
    else
      taker.need_human(fmt::format("{} {}", shown_name(shown[i]),
                                   type == fs::file_type::not_found ? judge::is_missing
                                   : type == fs::file_type::symlink ? judge::is_link
                                                                    : "is neither a folder nor a regular file"));
  }
  if (!loose.empty()) take_loose_files(flags, loose, compare, taker);
  Submission submission = taker.finish(skeletons);
  submission.name = sources.empty() ? "submission" : name_of(sources.back());
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
