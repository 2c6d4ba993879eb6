// The one source of truth: the solution, with marks round what a student is to write. The skeleton is cut from it.
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
// The part behind "--- skeleton" may be absent. Its lines stand in comments, so that the solution still compiles, and
// keep the indentation of their own line. C++ and GLSL are marked alike.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace atelier {

/// The skeleton of a marked text. `file` is how errors call it, `step` goes into the TODO lines. Throws Error with
/// FILE:LINE for a block that is not closed, closed without being open, or inside another; for a task that is empty;
/// for a skeleton line that is no "// |" comment; and for a line that looks like a mark and is none.
std::string cut_skeleton(std::string_view marked, const std::string& file, const std::string& step);

/// The finished text without its marks and without the skeleton's lines. Throws as cut_skeleton does.
std::string finished_text(std::string_view marked, const std::string& file);

/// The lines that the skeleton leaves out, without the blanks round them: what a student is to find out. Throws as
/// cut_skeleton does.
std::vector<std::string> solution_lines(std::string_view marked, const std::string& file);

/// The number of blocks that a student is to write: 0 for a text without marks. Throws as cut_skeleton does.
int count_tasks(std::string_view marked, const std::string& file);

}  // namespace atelier
