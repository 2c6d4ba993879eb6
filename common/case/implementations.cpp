#include "case/implementations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "base/error.hpp"
#include "case/printable.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;

/// "DIR" or "NN-name=DIR"; a folder that has '=' in its own name needs the step in front of it.
Implementations::Root parse_root(const std::string& text) {
  const std::size_t equals = text.find('=');
  Implementations::Root root;
  if (equals != std::string::npos) root.only_step = text.substr(0, equals);
  root.folder = equals == std::string::npos ? text : text.substr(equals + 1);
  if (equals == 0) throw Error(fmt::format("implementations: '{}' names no step before '='", printable(text)));
  if (root.only_step.find('/') != std::string::npos) {
    throw Error(
        fmt::format("implementations: '{}' is no step (a name like 03-shadow-mapping)", printable(root.only_step)));
  }
  std::error_code ignored;
  if (!fs::is_directory(root.folder, ignored)) {
    throw Error(fmt::format("implementations: no folder '{}'", printable(root.folder.string())));
  }
  return root;
}

/// Names that stay below their root: relative, without "..".
bool stays_below(const fs::path& name) {
  if (name.empty() || name.is_absolute()) return false;
  for (const fs::path& part : name) {
    if (part == "..") return false;
  }
  return true;
}

}  // namespace

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
    if (!root.only_step.empty()) text += root.only_step + '=';
    text += root.folder.string();
  }
  return text;
}

fs::path Implementations::find(const std::string& name) const {
  const fs::path relative = name;
  if (!stays_below(relative)) return {};
  const std::string step = relative.begin()->string();
  for (const Root& root : roots_) {
    if (!root.only_step.empty() && root.only_step != step) continue;
    const fs::path candidate = root.folder / relative;
    std::error_code ignored;
    if (fs::is_regular_file(candidate, ignored)) return candidate;
  }
  return {};
}

}  // namespace atelier
