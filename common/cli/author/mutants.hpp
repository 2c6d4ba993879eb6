// Small changes of a solution: those that must be caught, and those that change nothing but the last bits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace atelier {

/// One change of a text.
struct Edit {
  std::size_t begin = 0, end = 0;  ///< what it replaces
  std::string text;                ///< by what
  std::string kind;                ///< "operator", "constant", "call" ...
};

/// Every single change, in what a student writes of a marked solution, that another mistake may look like: a sign
/// turned, an operator or a comparison exchanged, a constant changed, arguments, swizzles or matrices exchanged, a
/// term, a factor, a call, a statement or a guard left out, min for max, sine for cosine, one OpenGL enum for its
/// sibling. Some of them change nothing, and some do not compile.
std::vector<Edit> mutations_of(std::string_view marked);

/// Changes in another form of the same meaning: operands exchanged, comparisons turned round, a - b as a + (-b), a / b
/// as a product (GLSL), normalize(v) as v / length(v), x += y written out, guards with an else, results in a temporary.
/// `glsl` says which language it is. Any set of them that do not overlap may be made at once.
std::vector<Edit> rewritings_of(std::string_view marked, bool glsl);

/// The text with these changes, which must not overlap.
std::string edited(std::string_view text, std::vector<Edit> edits);

/// As many of them as possible, at most `count`, that do not overlap: drawn from `seed`, the same everywhere.
std::vector<Edit> drawn(std::vector<Edit> edits, std::size_t count, std::uint64_t seed);

/// The text of C++ in which every float that the student's functions return is moved by at most one unit in the last
/// place, by numbers drawn from `seed` and the calls before.
std::string with_moved_last_bits(std::string_view marked, std::uint64_t seed);

}  // namespace atelier
