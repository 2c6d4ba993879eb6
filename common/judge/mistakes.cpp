#include "judge/mistakes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/process.hpp"
#include "case/suggest.hpp"

namespace atelier::judge {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// One object of the list, with where it stands for messages: "mistakes.json: entry 2".
struct Entry {
  const json& object;
  std::string where;
  fs::path folder;
};

[[noreturn]] void refuse(const Entry& entry, const std::string& member, const std::string& what) {
  throw Error(fmt::format("{}: {}: {}", entry.where, member, what));
}

std::string text_of(const Entry& entry, const std::string& member) {
  const auto found = entry.object.find(member);
  if (found == entry.object.end()) refuse(entry, member, "is missing");
  if (!found->is_string() || found->get_ref<const std::string&>().empty())
    refuse(entry, member, fmt::format("must be a text that is not empty, not {}", found->dump()));
  return *found;
}

std::string name_of(const Entry& entry, std::set<std::string>& taken) {
  const std::string name = text_of(entry, "name");
  const bool clean = std::all_of(name.begin(), name.end(),
                                 [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; });
  if (!clean || name.size() > 64)
    refuse(entry, "name", fmt::format("'{}' must be at most 64 of the characters a-z, 0-9 and -", name));
  if (!taken.insert(name).second) refuse(entry, "name", fmt::format("'{}' is there twice", name));
  return name;
}

fs::path patch_of(const Entry& entry, const std::string& member) {
  const fs::path name = text_of(entry, member);
  if (name.filename() != name || name.extension() != ".patch")
    refuse(entry, member, fmt::format("'{}' must be the name of a .patch file beside the list", name.string()));
  const fs::path path = entry.folder / name;
  if (!fs::is_regular_file(path)) refuse(entry, member, fmt::format("there is no file {}", path.string()));
  return path;
}

/// Calls `read` on every entry of the list in `file`, after checking that it has no member beside `known`.
template <class Read>
auto read_list(const fs::path& file, const std::vector<std::string>& known, Read read) {
  json list;
  try {
    list = json::parse(read_file(file, 1 << 20));
  } catch (const json::exception& error) {
    throw Error(fmt::format("{}: this is not JSON: {}", file.string(), error.what()));
  }
  if (!list.is_array() || list.empty())
    throw Error(fmt::format("{}: must be a list with at least one entry", file.string()));

  std::vector<decltype(read(std::declval<const Entry&>()))> entries;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Entry entry{list[i], fmt::format("{}: entry {}", file.string(), i + 1), file.parent_path()};
    if (!entry.object.is_object()) throw Error(entry.where + ": must be an object");
    for (const auto& [member, value] : entry.object.items())
      if (std::find(known.begin(), known.end(), member) == known.end())
        refuse(entry, member, "is not known" + suggestion(member, known));
    entries.push_back(read(entry));
  }
  return entries;
}

/// The regular files of a folder, by name.
std::map<std::string, std::string> contents(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& file : fs::directory_iterator(folder))
    if (file.is_regular_file()) files[file.path().filename().string()] = read_file(file.path());
  return files;
}

std::string run_patch(const fs::path& patch, const fs::path& folder) {
  const Finished finished = run_process({
      .arguments = {"patch", "-p1", "--forward", "--batch", "--no-backup-if-mismatch", "--reject-file=-", "-i",
                    fs::absolute(patch).string()},
      .folder = folder,
      .time_limit = std::chrono::seconds(10),
  });
  if (!finished.ok())
    throw Error(fmt::format("{}: does not apply to the solution: {}", patch.string(), finished.output));
  return finished.output;
}

}  // namespace

std::vector<Mistake> read_mistakes(const fs::path& file) {
  std::set<std::string> names;
  return read_list(file, {"name", "title", "sentence", "hint", "patch", "spelling"}, [&](const Entry& entry) {
    Mistake mistake{.name = name_of(entry, names),
                    .title = text_of(entry, "title"),
                    .sentence = text_of(entry, "sentence"),
                    .hint = text_of(entry, "hint"),
                    .patch = patch_of(entry, "patch"),
                    .spelling = {}};
    if (entry.object.contains("spelling")) mistake.spelling = patch_of(entry, "spelling");
    return mistake;
  });
}

std::vector<Variant> read_variants(const fs::path& file) {
  std::set<std::string> names;
  return read_list(file, {"name", "title", "patch"}, [&](const Entry& entry) {
    return Variant{.name = name_of(entry, names), .title = text_of(entry, "title"), .patch = patch_of(entry, "patch")};
  });
}

void make_patched(const fs::path& solution, const fs::path& patch, const fs::path& folder) {
  if (!fs::is_directory(solution))
    throw Error(fmt::format("{}: there is no such folder, so {} has nothing to change", solution.string(),
                            patch.filename().string()));
  const auto before = contents(solution);
  for (const auto& [name, bytes] : before) write_file(folder / name, bytes);
  run_patch(patch, folder);

  const auto after = contents(folder);
  if (after == before) throw Error(patch.string() + ": changes nothing in the solution");
  const auto same_name = [](const auto& a, const auto& b) { return a.first == b.first; };
  if (!std::equal(before.begin(), before.end(), after.begin(), after.end(), same_name))
    throw Error(patch.string() + ": must change the solution's files, not add or remove any");
}

}  // namespace atelier::judge
