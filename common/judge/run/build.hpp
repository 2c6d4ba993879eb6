// Builds a step library from a student's C++: checks includes, compiles changed files and links.
//
// The flags come from BUILD/step_flags.json, which CMake writes:
//
//   {"compiler": "g++",
//    "compiler_version": "GNU 12.2.0",
//    "compile": ["-std=c++20", "-I...", "-include", "..."],                   for each file
//    "link":    ["-shared", "-fuse-ld=mold"],                                 after the objects
//    "titles":  {"02-blinn-phong": "Light and materials"},
//    "files":   {"02-blinn-phong": ["blinn_phong.cpp", "blinn_phong.glsl"]},  what a student writes
//    "headers": {"02-blinn-phong": ["02-blinn-phong/blinn_phong.hpp"]},       what its C++ may include
//    "uses":    {"02-blinn-phong": ["01-transforms"]}}                        the earlier steps that it calls
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "judge/run/run_tool.hpp"
#include "judge/run/source_file.hpp"

namespace atelier::judge {

struct StepFlags {
  std::string compiler, compiler_version;
  std::vector<std::string> compile, link;
  std::map<std::string, std::vector<std::string>> files;    ///< by step; names without a folder
  std::map<std::string, std::vector<std::string>> headers;  ///< by step
  std::map<std::string, std::vector<std::string>> uses;     ///< by step
  std::map<std::string, std::string> titles;                ///< by step

  /// What the C++ of a step may include of the project; nothing for a step without any.
  const std::vector<std::string>& headers_of(const std::string& step) const;
};

/// Throws Error naming the file, the member and what is allowed.
StepFlags read_step_flags(const std::filesystem::path& file);

struct Built {
  bool ok = false;
  bool fresh = false;      ///< something was compiled or linked; false if all was up to date
  std::string log;         ///< compiler and linker output, with the warnings of earlier builds; at most log_limit
  UnusableFiles unusable;  ///< unusable files, because of which nothing was compiled; `log` says the same in words
};

inline constexpr std::size_t log_limit = 20'000;  ///< bytes

/// Whether a step can be judged without this listed file: choices.txt, without which its own cases alone fail.
bool may_miss(const std::string& file);

/// The result for a step with these unusable files.
Built not_built(const UnusableFiles& files);

/// Builds the step's listed .cpp files in `sources` to OUT/NN-name/libstep.so, which is replaced atomically, and
/// deleted if the build fails. A step without C++ needs no library, so it is ok.
///
/// Not ok, with the reason in `log`: a listed file (including shaders) is unusable (judge/run/source_file.hpp); an
/// include is not allowed (judge/run/includes.hpp); the compiler or linker fails, or exceeds tools.time_limit for one
/// file.
///
/// Recompiles a file if its source, an included header or a flag has changed. Throws Error for an unknown step and if
/// `out` cannot be written.
Built build_step(const StepFlags& flags, const std::string& step, const std::filesystem::path& sources,
                 const std::filesystem::path& out, const ToolSettings& tools = {});

/// Copies only the step's listed files from `sources` to `folder`, so that no other file of a submission is ever read.
/// Returns the unusable files, which are not copied; one that is missing and may_miss is none of them.
UnusableFiles take_step_files(const StepFlags& flags, const std::string& step, const std::filesystem::path& sources,
                              const std::filesystem::path& folder);

}  // namespace atelier::judge
