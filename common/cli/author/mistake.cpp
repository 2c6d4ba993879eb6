// ./atelier mistake: makes patches of known mistakes and variants from an edited copy of a step's solution, and updates
// them when the solution has changed.
#include <fmt/format.h>

#include <algorithm>
#include <regex>

#include "base/error.hpp"
#include "base/file.hpp"
#include "cli/author/mistake_list.hpp"
#include "cli/author/solution_patch.hpp"
#include "cli/commands.hpp"
#include "cli/layout.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;

/// The file of a patch, and the list that names it.
struct Place {
  fs::path patch, list;
};

Place place_of(const ProjectFolders& folders, const CourseStep& step, const MistakeOptions& options) {
  const fs::path list = options.variant ? folders.variants_file(step.name) : folders.mistakes_file(step.name);
  const auto beside = [&](const std::string& ending) { return list.parent_path() / (options.name + ending); };
  if (!options.spelling) return {beside(".patch"), list};
  fs::path patch = beside(".other.patch");
  for (int number = 2; fs::exists(patch); ++number) patch = beside(fmt::format(".other-{}.patch", number));
  return {patch, list};
}

std::string relative(const ProjectFolders& folders, const fs::path& path) {
  return path.lexically_relative(folders.root).generic_string();
}

/// The command line with another ending.
std::string command(const CourseStep& step, const MistakeOptions& options, const std::string& ending = "") {
  const char* kind = options.variant ? " --variant" : options.spelling ? " --spelling" : "";
  return fmt::format("./atelier mistake {} {}{}{}", step.number(), options.name, kind, ending);
}

void check_name(const MistakeOptions& options) {
  static const std::regex form("[a-z0-9-]{1,64}");
  if (!std::regex_match(options.name, form))
    throw Error(
        fmt::format("mistake '{}': a name has lower-case letters, digits and dashes, at most 64", options.name));
  if (options.variant && options.spelling)
    throw Error("mistake: --variant and --spelling exclude each other: only a mistake has other spellings");
}

int begin(const ProjectFolders& folders, const CourseStep& step, const MistakeOptions& options,
          const fs::path& folder) {
  const Sources solution = sources_of(folders.solutions() / step.name);
  if (fs::exists(folder) && sources_of(folder) != solution)
    throw Error(fmt::format("{}: has been edited; turn it into a patch with {}, or remove the folder", folder.string(),
                            command(step, options)));
  for (const auto& [name, text] : solution) write_file(folder / name, text);
  fmt::print("{} is a copy of the solution. Make the {} there, then type\n\n  {}\n", folder.string(),
             options.variant ? "variant" : "mistake", command(step, options));
  return exit_ok;
}

void print_next_commands(const ProjectFolders& folders, const CourseStep& step, const MistakeOptions& options,
                         const Place& place) {
  const std::string list = relative(folders, place.list), number = step.number();
  const bool unwritten = read_file(place.list, 1 << 20).find(to_be_written) != std::string::npos;
  fmt::print("\nNext:\n");
  if (unwritten) fmt::print("  write the texts of '{}' in {}\n", options.name, list);
  if (!options.spelling && !options.variant)
    fmt::print("  name it in the \"rejects\" of a case in tests/cases/{}/cases.json\n  {} --spelling --begin\n",
               step.name, command(step, options));
  if (!options.variant) fmt::print("  ./atelier reference {}\n", number);
  fmt::print("  ./atelier audit {}\n", number);
}

/// The list with the patch in it: as it is where it has it already, because the patch is made again.
std::string listed(const Place& place, const MistakeOptions& options) {
  const std::string text = fs::exists(place.list) ? read_file(place.list, 1 << 20) : std::string();
  const std::string file = place.list.string();
  if (text.find('"' + place.patch.filename().string() + '"') != text.npos) return text;
  if (options.spelling) return with_spelling(text, options.name, place.patch.filename().string(), file);
  return with_entry(text, options.variant ? variant_entry(options.name) : mistake_entry(options.name), file);
}

int take(const ProjectFolders& folders, const CourseStep& step, const MistakeOptions& options, const fs::path& folder) {
  const Place place = place_of(folders, step, options);
  if (fs::exists(place.patch))
    throw Error(fmt::format("{}: exists already; choose another name, or remove this file to make it again",
                            place.patch.string()));
  if (!fs::exists(folder))
    throw Error(
        fmt::format("{}: there is no such folder; {} creates it", folder.string(), command(step, options, " --begin")));
  const std::string patch = patch_between(sources_of(folders.solutions() / step.name), sources_of(folder));
  if (patch.empty())
    throw Error(fmt::format("{}: is still the unchanged solution; make the {} there first", folder.string(),
                            options.variant ? "variant" : "mistake"));
  const std::string list = listed(place, options);
  write_file(place.patch, patch);
  write_file(place.list, list);
  if (options.from.empty()) fs::remove_all(folder);  // the patch has all changes
  fmt::print("{}\n{}\n", relative(folders, place.patch), relative(folders, place.list));
  print_next_commands(folders, step, options, place);
  return exit_ok;
}

/// The patches of a step, mistakes before variants.
std::vector<fs::path> patches_of(const ProjectFolders& folders, const CourseStep& step) {
  std::vector<fs::path> patches;
  for (const fs::path& folder : {folders.mistakes() / step.name, folders.variants() / step.name}) {
    const std::size_t before = patches.size();
    std::error_code missing;
    for (const auto& entry : fs::directory_iterator(folder, missing))
      if (entry.path().extension() == ".patch") patches.push_back(entry.path());
    std::sort(patches.begin() + std::ptrdiff_t(before), patches.end());
  }
  return patches;
}

int rebase(const ProjectFolders& folders, const CourseStep& step, const std::string& revision) {
  using State = Renewed::State;
  const Sources before = sources_at(folders.root, revision, "solutions/" + step.name);
  const Sources now = sources_of(folders.solutions() / step.name);
  int renewed = 0, left = 0;
  const std::vector<fs::path> patches = patches_of(folders, step);
  for (const fs::path& patch : patches) {
    const Renewed made = renewed_patch(patch, before, now);
    const std::string name = relative(folders, patch);
    switch (made.state) {
      case State::as_it_was:
        continue;
      case State::renewed:
        write_file(patch, made.text);
        ++renewed;
        fmt::print("{}\n", name);
        continue;
      case State::conflict:
        fmt::print("! {}: the solution has changed in the same lines; remove the patch and make it again\n", name);
        break;
      case State::lost:
        fmt::print("! {}: the solution now does the same; remove the patch, or make it again\n", name);
        break;
      case State::not_on_before:
        fmt::print("! {}: does not apply to the solution of {}\n", name, revision);
        break;
    }
    ++left;
  }
  fmt::print("{} patches: {} updated, {} unchanged, {} to fix by hand\n", patches.size(), renewed,
             int(patches.size()) - renewed - left, left);
  if (renewed > 0) fmt::print("Next:\n  ./atelier reference {0}\n  ./atelier audit {0}\n", step.number());
  return left == 0 ? exit_ok : exit_failed;
}

}  // namespace

int run_mistake(const MistakeOptions& options) {
  const ProjectFolders folders = project_folders();
  const CourseStep step = resolve_step(read_course(folders.step_flags()), options.step);
  if (!options.rebase.empty()) {
    if (!options.name.empty()) throw Error("mistake --rebase updates all patches of a step: leave the name out");
    return rebase(folders, step, options.rebase);
  }
  check_name(options);
  const fs::path folder = options.from.empty() ? folders.out() / "mistake" / step.name : fs::absolute(options.from);
  return options.begin ? begin(folders, step, options, folder) : take(folders, step, options, folder);
}

}  // namespace atelier
