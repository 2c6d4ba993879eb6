// What people write about submissions: comments.csv in the folder of the results, for spreadsheets.
//
//   id,points,comment
//   ada-lovelace,+1.5,"Late because of an operation, as agreed."
//
// Grading creates it with its headings if it is absent, and never writes it again.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace atelier::grade {

struct Comment {
  std::string text;   ///< printable, one line; may be empty
  double points = 0;  ///< added to the total, -10 000..10 000
  int line = 1;       ///< of the file
};

using Comments = std::map<std::string, Comment>;  ///< by a student's id

/// Columns may be in any order; points and comment may be missing or empty. Points may have a decimal comma. Throws
/// Error "FILE:LINE: ..." naming the value and what is allowed: for another encoding than UTF-8, unknown or repeated
/// headings, ids that are empty or appear twice, points that are no number. A missing file has no comments.
Comments read_comments(const std::filesystem::path& file);

/// Creates the file with headings only, unless there is one.
void create_comments(const std::filesystem::path& file);

/// A sentence for each comment whose id is not in `ids`, with the nearest.
std::vector<std::string> misplaced_comments(const Comments& comments, const std::vector<std::string>& ids,
                                            const std::filesystem::path& file);

}  // namespace atelier::grade
