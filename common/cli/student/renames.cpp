#include "cli/student/renames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "base/error.hpp"
#include "base/file.hpp"
#include "cli/code_text.hpp"

namespace atelier {
namespace {

/// The end of the first token of `text`, which is not empty: an identifier, a quoted string on one line, or one
/// character.
std::size_t end_of_token(std::string_view text) {
  std::size_t end = 1;
  if (in_identifier(text[0])) {
    while (end < text.size() && in_identifier(text[end])) ++end;
  } else if (text[0] == '"') {
    const std::size_t close = text.find_first_of("\"\n", 1);
    if (close != std::string_view::npos && text[close] == '"') end = close + 1;
  }
  return end;
}

}  // namespace

std::vector<Rename> read_renames(const std::filesystem::path& file) {
  std::vector<Rename> renames;
  if (!std::filesystem::exists(file)) return renames;
  std::istringstream lines(read_file(file));
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    std::istringstream words(line);
    Rename rename;
    std::string more;
    words >> rename.step >> rename.from >> rename.to;
    if (rename.step.empty() || rename.step.starts_with('#')) continue;
    if (rename.to.empty() || words >> more)
      throw Error(fmt::format("{}:{}: write a step, an old and a new name, as in '03-shadow-mapping lit compare_depth'",
                              file.string(), number));
    renames.push_back(std::move(rename));
  }
  return renames;
}

std::vector<Rename> renames_to_do(const std::vector<Rename>& all, const std::vector<Rename>& done) {
  std::vector<Rename> left;
  for (const Rename& rename : all)
    if (std::find(done.begin(), done.end(), rename) == done.end()) left.push_back(rename);
  return left;
}

std::string renamed(std::string_view text, const std::string& step, const std::vector<Rename>& renames) {
  std::string out;
  while (!text.empty()) {
    const std::string_view token = text.substr(0, end_of_token(text));
    const auto found = std::find_if(renames.begin(), renames.end(),
                                    [&](const Rename& r) { return r.step == step && r.from == token; });
    out += found == renames.end() ? token : std::string_view(found->to);
    text.remove_prefix(token.size());
  }
  return out;
}

}  // namespace atelier
