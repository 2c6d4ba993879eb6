// Solutions with marks around what a student must write. Skeletons are generated from them.
//
//   vec3 hello_colour(vec3 weights) {
//     // >>> student: let the left corner be red, the right one green and the top one blue
//     return weights;
//     // --- skeleton
//     // | return vec3(0.5);
//     // <<< student
//   }
//
// becomes, in steps/00-hello,
//
//   vec3 hello_colour(vec3 weights) {
//     // TODO(00-hello): let the left corner be red, the right one green and the top one blue
//     return vec3(0.5);
//   }
//
// The part after "--- skeleton" is optional. Its lines are comments, so that the solution still compiles, and keep the
// comment's indentation. The same marks work in C++ and GLSL.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace atelier {

/// The skeleton of a marked text. `file` is its name in errors, `step` is used in the TODO lines. Throws Error with
/// FILE:LINE for a block that is not closed, not opened, or inside another; for an empty task; for a skeleton line that
/// is not a "// |" comment; and for a line that looks like a mark but is not one.
std::string cut_skeleton(std::string_view marked, const std::string& file, const std::string& step);

/// The finished text, without marks and skeleton lines. Throws as cut_skeleton does.
std::string finished_text(std::string_view marked, const std::string& file);

/// The lines that the skeleton leaves out, trimmed: the secret part of the solution. Throws as cut_skeleton does.
std::vector<std::string> solution_lines(std::string_view marked, const std::string& file);

/// Where a student writes, as [begin, end) of the text: each block without the skeleton's lines. The text must have
/// passed one of the functions above.
std::vector<std::pair<std::size_t, std::size_t>> student_parts(std::string_view marked);

/// The number of blocks that a student must write: 0 for a text without marks. Throws as cut_skeleton does.
int count_tasks(std::string_view marked, const std::string& file);

}  // namespace atelier
