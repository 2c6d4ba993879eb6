#include "cli/author/solution_patch.hpp"

#include <fmt/format.h>

#include <sstream>
#include <vector>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/near_names.hpp"
#include "base/process.hpp"
#include "cli/merge.hpp"
#include "judge/compare/mistakes.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t largest_source = 1 << 20;

std::vector<std::string> file_names(const Sources& sources) {
  std::vector<std::string> names;
  for (const auto& [name, text] : sources) names.push_back(name);
  return names;
}

void write_sources(const Sources& sources, const fs::path& folder) {
  for (const auto& [name, text] : sources) write_file(folder / name, text);
}

std::string said_by_git(const fs::path& root, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"git", "-C", root.string()});
  const Finished git = run_process({.arguments = arguments});
  if (!git.ok()) throw Error(fmt::format("{}: {}", join(arguments, " "), git.output));
  return git.output;
}

/// Whether the unchanged patch turns `now` into `wanted`, with exact context lines.
bool makes(const fs::path& patch, const Sources& now, const Sources& wanted) {
  const TemporaryFolder folder("atelier-patched");
  write_sources(now, folder.path());
  const Finished applied = run_process(
      {.arguments = {"patch", "-p1", "--fuzz=0", "--batch", "--forward", "-i", fs::absolute(patch).string()},
       .folder = folder.path()});
  return applied.ok() && sources_of(folder.path()) == wanted;
}

}  // namespace

Sources sources_of(const fs::path& folder) {
  if (!fs::is_directory(folder)) throw Error(fmt::format("{}: there is no such folder", folder.string()));
  Sources sources;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file()) sources[entry.path().filename().string()] = read_file(entry.path(), largest_source);
  return sources;
}

Sources sources_at(const fs::path& root, const std::string& revision, const std::string& folder) {
  if (revision.empty() || revision.starts_with('-'))
    throw Error(fmt::format("--rebase '{}': write a revision of git, as in HEAD or HEAD~2", revision));
  Sources sources;
  std::istringstream paths(said_by_git(root, {"ls-tree", "--name-only", revision, folder + "/"}));
  for (std::string path; std::getline(paths, path);)
    sources[fs::path(path).filename().string()] = said_by_git(root, {"show", revision + ":" + path});
  if (sources.empty())
    throw Error(
        fmt::format("--rebase {}: it has no {}: commit the step before you change its solution", revision, folder));
  return sources;
}

std::string patch_between(const Sources& before, const Sources& after) {
  if (file_names(before) != file_names(after))
    throw Error(fmt::format("a patch changes files, and adds or removes none: here are {}, the solution has {}",
                            join(file_names(after)), join(file_names(before))));
  const TemporaryFolder folder("atelier-diff");
  write_sources(before, folder.path() / "a");
  write_sources(after, folder.path() / "b");
  std::string patch;
  for (const auto& [name, text] : before) {
    const Finished diff = run_process(
        {.arguments = {"diff", "-u", "--label", "a/" + name, "--label", "b/" + name, "a/" + name, "b/" + name},
         .folder = folder.path()});
    if (diff.exit_status != 0 && diff.exit_status != 1) throw Error("diff: " + diff.output);
    patch += diff.output;
  }
  return patch;
}

Renewed renewed_patch(const fs::path& patch, const Sources& before, const Sources& now) {
  const TemporaryFolder folder("atelier-rebase");
  write_sources(before, folder.path() / "before");
  try {
    judge::make_patched(folder.path() / "before", patch, folder.path() / "changed");
  } catch (const Error&) {
    return {.state = Renewed::State::not_on_before, .text = {}};
  }
  const Sources changed = sources_of(folder.path() / "changed");
  Sources after = now;
  for (auto& [name, text] : after) {
    if (!before.contains(name)) continue;  // a file that the old solution did not have
    const auto both = merged(text, before.at(name), changed.at(name));
    if (!both) return {.state = Renewed::State::conflict, .text = {}};
    text = *both;
  }
  if (after == now) return {.state = Renewed::State::lost, .text = {}};
  if (makes(patch, now, after)) return {.state = Renewed::State::as_it_was, .text = {}};
  return {.state = Renewed::State::renewed, .text = patch_between(now, after)};
}

}  // namespace atelier
