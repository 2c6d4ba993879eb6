// The known mistakes of a step, and its variants (other correct solutions): small patches on the solution.
//
//   tests/mistakes/NN-name/mistakes.json    [{"name": "rv-for-nh",
//                                             "title": "R.V in place of N.H",
//                                             "sentence": "The highlight follows the mirrored direction ...",
//                                             "hint": "Which vector does the contract ask the exponent of?",
//                                             "patch": "rv-for-nh.patch",
//                                             "spellings": ["rv-for-nh.other.patch"]}, ...]   (may be absent)
//   tests/variants/NN-name/variants.json    [{"name": "...", "title": "...", "patch": "....patch"}, ...]
//
// Releases for students (cli/grader/release.cpp) have no patches.
//
// A mistake proves that a case can fail, and lets a verdict name what is wrong. A variant proves that a case accepts
// other correct solutions.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace atelier::judge {

struct Mistake {
  std::string name;                              ///< [a-z0-9-]+, at most 64
  std::string title;                             ///< for tables
  std::string sentence;                          ///< what a student reads if an answer looks like this mistake
  std::string hint;                              ///< what to try next
  std::filesystem::path patch;                   ///< turns the solution into the mistake; empty if optional and absent
  std::vector<std::filesystem::path> spellings;  ///< the same mistake written differently, to recognise more forms
};

struct Variant {
  std::string name;
  std::string title;  ///< what it does differently
  std::filesystem::path patch;
};

/// Whether patches must exist: judging only names mistakes and needs none.
enum class Patches { needed, optional };

/// Each reads its whole file, which must have at least one entry; returned patch paths include the folder and exist.
/// Throws Error naming the file, the entry and the member for unknown or missing members, empty texts, invalid or
/// repeated names, and patches that are not NAME.patch files in the same folder.
std::vector<Mistake> read_mistakes(const std::filesystem::path& file, Patches patches = Patches::needed);
std::vector<Variant> read_variants(const std::filesystem::path& file);

/// Copies the regular files of the folder `solution`, without subfolders, to `folder`, which is created, and applies
/// `patch` there with `patch -p1`. Throws Error with patch's output if it does not apply, changes nothing, or adds
/// or removes files.
void make_patched(const std::filesystem::path& solution, const std::filesystem::path& patch,
                  const std::filesystem::path& folder);

}  // namespace atelier::judge
