#include "grade/step_places.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <system_error>

#include "base/printable.hpp"

namespace atelier::grade {
namespace {

namespace fs = std::filesystem;

constexpr int max_depth = 4;  // levels below the top
constexpr std::size_t max_entries = 10'000;
constexpr std::size_t max_found = 3;   // an error message is one line
constexpr std::size_t max_name = 100;  // bytes in a message

/// The parts of a path in an archive.
std::vector<std::string> parts_of(const std::string& path) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin < path.size();) {
    const std::size_t end = std::min(path.find('/', begin), path.size());
    if (end > begin) parts.push_back(path.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

}  // namespace

bool is_folder_of_tools(const std::string& name) {
  return name == "__MACOSX" || (name.starts_with(".") && name != "." && name != "..");
}

std::vector<std::string> list_folder(const fs::path& folder) {
  std::vector<std::string> paths;
  std::error_code error;
  auto entry = fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied, error);
  for (; !error && entry != fs::end(entry) && paths.size() < max_entries; entry.increment(error)) {
    paths.push_back(entry->path().lexically_relative(folder).string());
    if (entry.depth() + 1 >= max_depth) entry.disable_recursion_pending();
  }
  std::sort(paths.begin(), paths.end());  // the order of a folder's entries is unspecified
  return paths;
}

bool has_folders_of_steps(const judge::StepFlags& flags, const std::vector<std::string>& paths) {
  return std::ranges::any_of(paths, [&](const std::string& path) {
    return std::ranges::any_of(parts_of(path), [&](const std::string& part) { return flags.files.contains(part); });
  });
}

std::vector<std::string> stray_files(const judge::StepFlags& flags, const std::vector<std::string>& paths) {
  std::set<std::string> found;
  for (const std::string& path : paths) {
    const std::vector<std::string> parts = parts_of(path);
    for (const auto& [step, files] : flags.files) {
      const bool listed = !parts.empty() && std::find(files.begin(), files.end(), parts.back()) != files.end();
      const bool inside = parts.size() > 1 && flags.files.contains(parts[parts.size() - 2]);
      if (listed && !inside) found.insert(fmt::format("{} belongs in {}/", shorten(printable(path), max_name), step));
    }
    if (found.size() >= max_found) break;
  }
  return {found.begin(), found.end()};
}

}  // namespace atelier::grade
