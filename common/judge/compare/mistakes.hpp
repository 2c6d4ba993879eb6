// The known wrong solutions of a step, and the different but right ones: small patches on the solution.
//
//   tests/mistakes/NN-name/mistakes.json    [{"name": "rv-for-nh",
//                                             "title": "R.V in place of N.H",
//                                             "sentence": "The highlight follows the mirrored direction ...",
//                                             "hint": "Which vector does the contract ask the exponent of?",
//                                             "patch": "rv-for-nh.patch",
//                                             "spelling": "rv-for-nh.other.patch"}, ...]   ("spelling" may be absent)
//   tests/variants/NN-name/variants.json    [{"name": "...", "title": "...", "patch": "....patch"}, ...]
//
// What students get (cli/grader/release.cpp) has the names and sentences of the mistakes alone: no patches.
//
// A mistake proves that a case can fail, and gives a verdict a name to say. A variant proves that a case does not
// refuse what is right.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace atelier::judge {

struct Mistake {
  std::string name;                               ///< [a-z0-9-]+, at most 64
  std::string title;                              ///< for tables
  std::string sentence;                           ///< what a student reads when an answer looks like this mistake
  std::string hint;                               ///< what to try next
  std::filesystem::path patch;                    ///< makes the mistake out of the solution; empty where not needed
  std::optional<std::filesystem::path> spelling;  ///< the same mistake written in another way: proves the naming
};

struct Variant {
  std::string name;
  std::string title;  ///< what is done in another way
  std::filesystem::path patch;
};

/// Who gives a mistake its name in a verdict needs no patch; who makes the mistake does.
enum class Patches { needed, optional };

/// Each reads its whole file, at least one entry; patch paths come back joined to the file's folder, and exist. Throws
/// Error naming the file, the entry and the member: unknown or missing members, empty texts, bad or repeated names,
/// patches that are not plain NAME.patch files beside it.
std::vector<Mistake> read_mistakes(const std::filesystem::path& file, Patches patches = Patches::needed);
std::vector<Variant> read_variants(const std::filesystem::path& file);

/// Copies the files of `solution` (the regular files of one step's folder, not what is below it) to `folder`, which is
/// made, and applies `patch` there with `patch -p1`. Throws Error with the words of patch where it does not apply, and
/// where it changes nothing or leaves other files than the solution has: such a patch would test nothing.
void make_patched(const std::filesystem::path& solution, const std::filesystem::path& patch,
                  const std::filesystem::path& folder);

}  // namespace atelier::judge
