#include "grade/intake/class_shape.hpp"

#include <algorithm>
#include <set>
#include <system_error>

#include "grade/intake/archive.hpp"
#include "grade/intake/listed_names.hpp"
#include "grade/intake/platform_names.hpp"
#include "grade/intake/step_places.hpp"
#include "grade/intake/version_names.hpp"

namespace atelier::grade {
namespace {

namespace fs = std::filesystem;

bool is_document(const std::string& name) {
  static const std::set<std::string> endings = {".pdf", ".doc", ".docx", ".odt", ".rtf", ".pages"};
  return endings.contains(lower_case(fs::path(name).extension().string()));
}

bool is_source(const std::string& name) {
  static const std::set<std::string> endings = {".cpp", ".cc",  ".cxx",  ".c",    ".hpp",  ".hh",
                                                ".h",   ".inl", ".glsl", ".vert", ".frag", ".comp"};
  return endings.contains(lower_case(fs::path(name).extension().string()));
}

bool is_text(const std::string& name) {
  static const std::set<std::string> endings = {"", ".txt", ".md", ".html", ".htm"};
  return endings.contains(lower_case(fs::path(name).extension().string()));
}

bool is_number(const std::string& name) {
  return without_archive_endings(name).find_first_not_of("0123456789") == std::string::npos;
}

/// Adds what one path says about the entry that it begins with.
void look_at(const judge::StepFlags& flags, const ListedNames& names, const std::string& path, ClassEntry& entry) {
  const auto add_step = [&](const std::string& step) {
    entry.has_steps = true;
    if (std::ranges::find(entry.steps, step) == entry.steps.end()) entry.steps.push_back(step);
  };
  const bool is_folder = path.ends_with('/');
  std::string name = is_folder ? "" : fs::path(path).filename().string();
  const std::string listed = is_folder ? "" : names.find(uploaded_name(name));
  const bool of_step = !listed.empty() && names.tells_step(listed);
  bool given = false;
  for (const fs::path& part : fs::path(path)) {
    if (part.empty()) break;  // of a folder's slash
    name = part.string();
    if (name == ".git") entry.has_repository = true;
    if (is_folder_of_tools(name)) return;
    given |= is_name_of_given(name);
    if (!given && flags.files.contains(name)) add_step(name);
  }
  entry.has_step_files |= of_step;
  entry.only_texts &= is_folder || is_text(name) || is_litter(path);
  if (given) return;
  entry.has_source |= !is_folder && (of_step || is_source(name));
  if (of_step) add_step(*names.steps_with(listed).begin());
  entry.has_archive |= !is_folder && has_archive_name(name);
  entry.has_document |= !is_folder && is_document(name);
}

/// The students that entries may be of, by their names without versions; how many of these have steps or archives.
struct Persons {
  std::set<std::string> names;
  bool any_with_steps = false;
};

Persons persons_in(const judge::StepFlags& flags, const ClassEntries& entries) {
  Persons persons;
  for (const auto& [name, entry] : entries) {
    const bool single_file = !entry.is_folder && !has_archive_name(name);
    const bool of_step = std::ranges::any_of(
        flags.files, [&name = name](const auto& step) { return !is_number(name) && is_like_step(name, step.first); });
    const bool of_person = entry.may_be_handed_in() || (entry.is_folder && entry.only_texts);
    if (is_name_of_work(name) || of_step || single_file || !of_person) continue;
    persons.names.insert(lower_case(split_version(name).base));
    persons.any_with_steps |= entry.has_steps || entry.has_archive;
  }
  return persons;
}

/// Whether the folder of these entries holds steps itself: folders of the steps' names, or a step's files.
bool holds_steps(const judge::StepFlags& flags, const ClassEntries& entries) {
  const ListedNames names(flags);
  return std::ranges::any_of(entries, [&](const auto& entry) {
    if (entry.second.is_folder) return flags.files.contains(entry.first);
    const std::string listed = names.find(entry.first);
    if (!listed.empty()) return names.tells_step(listed);
    return has_archive_name(entry.first) && flags.files.contains(without_archive_endings(entry.first));
  });
}

/// Whether the entries are folders with one step each, all different, whose names are nearly the steps'.
bool are_steps(const judge::StepFlags& flags, const ClassEntries& entries) {
  std::size_t like = 0, folders = 0;
  for (const auto& [name, entry] : entries) {
    folders += entry.is_folder;
    like += entry.is_folder && std::ranges::any_of(flags.files, [&name = name, &entry = entry](const auto& step) {
              return is_like_step(name, step.first) && std::ranges::find(entry.steps, step.first) != entry.steps.end();
            });
  }
  return like > 0 && 2 * like >= folders;
}

bool is_canvas(const ClassEntries& entries, bool has_steps_beside) {
  std::set<std::string> students;
  std::size_t files = 0, named = 0;
  for (const auto& [name, entry] : entries) {
    if (entry.is_folder) continue;
    ++files;
    const auto found = canvas_name(name);
    if (!found) continue;
    ++named;
    students.insert(found->identifier);
  }
  return named > 0 && 2 * named >= files && (students.size() > 1 || !has_steps_beside);
}

std::optional<Platform> platform_of(const judge::StepFlags& flags, const ClassEntries& entries) {
  const auto any = [&](const auto& is) {
    return std::ranges::any_of(entries, [&](const auto& entry) { return is(entry.first, entry.second); });
  };
  if (any([](const std::string& name, const ClassEntry&) { return moodle_name(name).has_value(); }))
    return Platform::moodle;
  if (entries.contains(gradescope_metadata) ||
      any([](const std::string& name, const ClassEntry& e) { return e.is_folder && gradescope_name(name); }))
    return Platform::gradescope;
  const bool steps_in_folder = any([](const std::string&, const ClassEntry& e) { return e.is_folder && e.has_steps; });
  const bool steps = holds_steps(flags, entries);
  if (is_canvas(entries, steps || steps_in_folder)) return Platform::canvas;
  if (steps || are_steps(flags, entries)) return std::nullopt;
  const Persons persons = persons_in(flags, entries);
  if (persons.names.size() < 2 || !persons.any_with_steps) return std::nullopt;
  const bool clones = any([](const std::string&, const ClassEntry& e) { return e.has_repository; });
  return clones ? Platform::github : Platform::folders;
}

/// The only folder, if nothing else lies beside it that could be handed in.
std::optional<std::string> single_folder(const ClassEntries& entries) {
  std::optional<std::string> only;
  for (const auto& [name, entry] : entries) {
    if (entry.is_folder && only) return std::nullopt;
    if (entry.is_folder) only = name;
    if (!entry.is_folder && has_archive_name(name)) return std::nullopt;
  }
  return only;
}

}  // namespace

std::string to_string(Platform platform) {
  constexpr const char* names[] = {"moodle", "canvas", "gradescope", "github", "folders"};
  return names[int(platform)];
}

ClassEntries entries_in(const judge::StepFlags& flags, const std::vector<std::string>& paths,
                        const std::string& inner) {
  const ListedNames names(flags);
  const std::string front = inner.empty() ? "" : inner + "/";
  ClassEntries entries;
  for (const std::string& path : paths) {
    if (!path.starts_with(front) || path.size() == front.size()) continue;
    const std::string below = path.substr(front.size()), name = below.substr(0, below.find('/'));
    const bool is_folder = name.size() < below.size();
    if (name.empty() || (is_folder ? is_folder_of_tools(name) : is_litter(name))) continue;
    ClassEntry& entry = entries[name];
    entry.is_folder |= is_folder;
    look_at(flags, names, below, entry);
  }
  return entries;
}

std::optional<ClassShape> find_class(const judge::StepFlags& flags, const std::vector<std::string>& paths) {
  constexpr int most_levels = 16;
  ClassShape shape;
  for (int level = 0; level < most_levels; ++level) {
    shape.entries = entries_in(flags, paths, shape.inner);
    if (const auto platform = platform_of(flags, shape.entries)) {
      shape.platform = *platform;
      return shape;
    }
    const auto next = single_folder(shape.entries);
    if (!next || holds_steps(flags, shape.entries)) return std::nullopt;
    shape.inner += (shape.inner.empty() ? "" : "/") + *next;
  }
  return std::nullopt;
}

std::vector<std::string> paths_in(const fs::path& folder) {
  constexpr std::size_t most_paths = 200'000;
  constexpr int most_levels = 12;
  std::vector<std::string> paths, level = {""};
  for (int depth = 0; depth < most_levels; ++depth) {
    std::vector<std::string> next;
    for (const std::string& inner : level) {
      std::error_code error;
      for (auto at = fs::directory_iterator(folder / inner, error); !error && at != fs::end(at); at.increment(error)) {
        if (paths.size() >= most_paths) return paths;
        const std::string name = at->path().filename().string();
        std::error_code unknown;
        const bool is_folder = at->symlink_status(unknown).type() == fs::file_type::directory;
        paths.push_back(inner + name + (is_folder ? "/" : ""));
        const bool of_compilers = depth > 1 && is_name_of_given(name);  // may have more files than the whole class
        if (is_folder && !is_folder_of_tools(name) && !of_compilers) next.push_back(paths.back());
      }
    }
    level = std::move(next);
  }
  return paths;
}

}  // namespace atelier::grade
