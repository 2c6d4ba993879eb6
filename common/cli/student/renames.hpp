// Renamed identifiers that students call or write: steps/renames.txt.
//
//   # A comment
//   03-shadow-mapping lit compare_depth
//
// A line has the step whose files are changed, the old token and the new one. A token is an identifier, or a quoted
// path as in #include.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace atelier {

struct Rename {
  std::string step, from, to;
  bool operator==(const Rename&) const = default;
};

/// The lines of the file; none if there is no such file. Throws Error naming the file and a line that does not have
/// three words.
std::vector<Rename> read_renames(const std::filesystem::path& file);

/// Those of `all` that are not in `done`.
std::vector<Rename> renames_to_do(const std::vector<Rename>& all, const std::vector<Rename>& done);

/// The text of a file of `step` with its renames applied: whole tokens, each once.
std::string renamed(std::string_view text, const std::string& step, const std::vector<Rename>& renames);

}  // namespace atelier
