#include "judge/compare/mistakes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/process.hpp"
#include "base/strict_json.hpp"

namespace atelier::judge {
namespace {

namespace fs = std::filesystem;
using strict_json::Json;

/// The patch that a member names: a .patch file in the list's folder.
fs::path patch_beside(const fs::path& list, const Json& value, const std::string& where) {
  const fs::path name = strict_json::text(value, where, 200);
  if (name.filename() != name || name.extension() != ".patch")
    strict_json::refuse(value, where, "the name of a .patch file beside the list");
  const fs::path path = list.parent_path() / name;
  if (!fs::is_regular_file(path)) throw Error(fmt::format("{}: there is no file {}", where, path.string()));
  return path;
}

std::vector<fs::path> patches_beside(const fs::path& list, const Json& value, const std::string& where) {
  if (!value.is_array()) strict_json::refuse(value, where, "a list of .patch files beside the list");
  std::vector<fs::path> patches;
  for (const Json& name : value) patches.push_back(patch_beside(list, name, where));
  return patches;
}

/// Reads every object of the list into an `Item`: checks its members, reads its unique name, its title and its patch,
/// then calls `read(item, object, where)` for the rest.
template <class Item, class Read>
std::vector<Item> read_list(const fs::path& file, const std::vector<std::string>& members, Patches patches, Read read) {
  const Json list = strict_json::parse(read_file(file, 1 << 20), file.string());
  if (!list.is_array() || list.empty()) throw Error(file.string() + ": must be a list with at least one entry");

  std::vector<Item> items;
  std::set<std::string> names;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string entry = fmt::format("{}: entry {}", file.string(), i + 1);
    strict_json::refuse_unknown(list[i], members, entry);
    Item item;
    item.name = strict_json::name(strict_json::required(list[i], "name", entry), entry + ": name");
    if (!names.insert(item.name).second)
      throw Error(fmt::format("{}: name: '{}' appears twice in the list; names must be unique", entry, item.name));
    const std::string where = fmt::format("{}: '{}'", file.string(), item.name);
    item.title = strict_json::text(strict_json::required(list[i], "title", where), where + ": title");
    if (patches == Patches::needed || list[i].contains("patch"))
      item.patch = patch_beside(file, strict_json::required(list[i], "patch", where), where + ": patch");
    read(item, list[i], where);
    items.push_back(std::move(item));
  }
  return items;
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
    throw Error(
        fmt::format("{}: does not apply to the solution; if the solution has changed, update its patches with "
                    "'./atelier mistake STEP --rebase REVISION', or delete this one and make it again: {}",
                    patch.string(), finished.output));
  return finished.output;
}

}  // namespace

std::vector<Mistake> read_mistakes(const fs::path& file, Patches patches) {
  const std::vector<std::string> members{"name", "title", "sentence", "hint", "patch", "spellings"};
  return read_list<Mistake>(
      file, members, patches, [&](Mistake& mistake, const Json& object, const std::string& where) {
        mistake.sentence = strict_json::text(strict_json::required(object, "sentence", where), where + ": sentence");
        mistake.hint = strict_json::text(strict_json::required(object, "hint", where), where + ": hint");
        if (const Json* spellings = strict_json::optional(object, "spellings"))
          mistake.spellings = patches_beside(file, *spellings, where + ": spellings");
      });
}

std::vector<Variant> read_variants(const fs::path& file) {
  return read_list<Variant>(file, {"name", "title", "patch"}, Patches::needed,
                            [](Variant&, const Json&, const std::string&) {});
}

void make_patched(const fs::path& solution, const fs::path& patch, const fs::path& folder) {
  if (!fs::is_directory(solution))
    throw Error(fmt::format("{}: there is no such folder, so {} cannot be applied", solution.string(),
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
