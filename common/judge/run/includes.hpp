// What a student's C++ file may include: its contract headers, <glm/glm.hpp> and the plain parts of the standard
// library.
//
// A step asks for look_at to be written; <glm/gtc/matrix_transform.hpp> has it ready. The list keeps such short cuts
// out, and says so before the compiler runs. It is a rule of the course, not a wall: the wall is the sandbox.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace atelier::judge {

/// One #include as a compiler would see it: not in a comment, a string or a raw string, found through line splices and
/// digraphs.
struct Include {
  int line = 0;        ///< of the '#', from 1
  std::string target;  ///< with its delimiters: "<cmath>" or "\"02-blinn-phong/blinn_phong.hpp\""; a macro as written
};

/// All includes of a source text, #include_next and #import among them, in order.
std::vector<Include> find_includes(std::string_view source);

/// One line "FILE:LINE: #include X is not open to a step: why" for every include of `source` that is not among
/// `contract_headers` ("02-blinn-phong/blinn_phong.hpp"; those of `step` itself also without the folder) nor on the
/// list; empty where all are.
std::string refused_includes(std::string_view source, const std::string& file, const std::string& step,
                             const std::vector<std::string>& contract_headers);

}  // namespace atelier::judge
