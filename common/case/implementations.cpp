#include "case/implementations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "base/error.hpp"
#include "base/printable.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;

/// "DIR", "NN-name=DIR", "NN-name/file=DIR" or "NN-name/folder=DIR". A folder with '=' in its name needs a prefix.
Implementations::Root parse_root(const std::string& text) {
  const std::size_t equals = text.find('=');
  Implementations::Root root;
  if (equals != std::string::npos) root.only = text.substr(0, equals);
  root.folder = equals == std::string::npos ? text : text.substr(equals + 1);
  if (equals == 0) throw Error(fmt::format("implementations: '{}' names no step before '='", printable(text)));
  if (std::ranges::count(root.only, '/') > 1 || root.only.starts_with('/') || root.only.ends_with('/'))
    throw Error(
        fmt::format("implementations: '{}' is neither a step nor a file of a step (names like 03-shadow-mapping and "
                    "03-shadow-mapping/given)",
                    printable(root.only)));
  std::error_code ignored;
  if (!fs::is_directory(root.folder, ignored)) {
    throw Error(fmt::format("implementations: there is no folder '{}'", printable(root.folder.string())));
  }
  return root;
}

/// Whether a name stays below its root: it is relative and has no "..".
bool stays_below(const fs::path& name) {
  if (name.empty() || name.is_absolute()) return false;
  for (const fs::path& part : name) {
    if (part == "..") return false;
  }
  return true;
}

}  // namespace

bool Implementations::Root::applies_to(const std::string& name) const {
  return only.empty() || name == only || (name.starts_with(only) && name[only.size()] == '/');
}

Implementations Implementations::parse(const std::string& text) {
  std::vector<Root> roots;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(':', begin), text.size());
    if (end > begin) roots.push_back(parse_root(text.substr(begin, end - begin)));
    begin = end + 1;
  }
  return Implementations(std::move(roots));
}

std::string Implementations::to_string() const {
  std::string text;
  for (const Root& root : roots_) {
    if (!text.empty()) text += ':';
    if (!root.only.empty()) text += root.only + '=';
    text += root.folder.string();
  }
  return text;
}

fs::path Implementations::find(const std::string& name) const {
  const fs::path relative = name;
  if (!stays_below(relative)) return {};
  for (const Root& root : roots_) {
    if (!root.applies_to(name)) continue;
    const fs::path candidate = root.folder / relative;
    std::error_code ignored;
    if (fs::is_regular_file(candidate, ignored)) return candidate;
  }
  return {};
}

}  // namespace atelier
