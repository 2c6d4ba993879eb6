// The mutants of a step's solution: which there are, and which are known to change nothing.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "cli/layout.hpp"

namespace atelier {

struct Mutant {
  std::string id;             ///< the same as long as its line, and what is changed in it, stay as they are
  std::string file;           ///< one of the step's
  int line = 1;               ///< of the solution
  std::string kind;           ///< as in Edit
  std::string before, after;  ///< the lines that change
  std::string function;       ///< of those that cases name; empty: none of them
  std::string text;           ///< of the whole file
};

/// All mutants of a step's solution, in an order drawn from `seed`. `functions` are those that its cases name.
std::vector<Mutant> mutants_of(const ProjectFolders& folders, const CourseStep& step,
                               const std::set<std::string>& functions, std::uint64_t seed);

/// Why mutants change nothing that a contract promises, by their ids: tests/mutants/NN-name/equivalent.json, a list of
/// {"id", "line", "reason"}. None where there is no such file. Throws Error naming the file for anything else.
std::map<std::string, std::string> read_equivalents(const std::filesystem::path& file);

}  // namespace atelier
