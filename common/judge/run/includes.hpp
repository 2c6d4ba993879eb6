// Checks what a student's C++ file includes: allowed are its contract headers, <glm/glm.hpp> and parts of the standard
// library.
//
// A student must write look_at, for example, but <glm/gtc/matrix_transform.hpp> already has it. The check refuses such
// short cuts before the compiler runs, and says why. What the compiler opens is checked too (opened_files.hpp).
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace atelier::judge {

/// One #include as the compiler sees it: not in a comment, string or raw string; also with line splices and digraphs.
struct Include {
  int line = 0;        ///< of the '#', from 1
  std::string target;  ///< with its delimiters: "<cmath>" or "\"02-blinn-phong/blinn_phong.hpp\""; a macro as written
};

/// All includes of a source text in order, also #include_next, #import and #embed.
std::vector<Include> find_includes(std::string_view source);

/// A line "FILE:LINE: #include X is not allowed in a step: REASON" for every include of `source` that is neither one of
/// `contract_headers` ("02-blinn-phong/blinn_phong.hpp"; those of `step` also without the folder) nor an allowed
/// library header. Empty if all are allowed.
std::string refused_includes(std::string_view source, const std::string& file, const std::string& step,
                             const std::vector<std::string>& contract_headers);

/// A source text that includes every header that a step with these contract headers may use.
std::string text_with_all_headers(const std::vector<std::string>& contract_headers);

}  // namespace atelier::judge
