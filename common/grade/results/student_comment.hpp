// Puts a person's comment into a student's report, which grading has written before.
#pragma once

#include <filesystem>
#include <string>

namespace atelier::grade {

/// Shows `text` and how many points were added at the top of the report `file`; both may be empty or 0. Replaces what
/// an earlier call has written; does nothing if that is the same, or there is no such file. Throws Error naming the
/// file if it cannot be written.
void set_comment(const std::filesystem::path& file, const std::string& text, double points);

}  // namespace atelier::grade
