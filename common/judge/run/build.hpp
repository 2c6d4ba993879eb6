// Makes a step library out of a student's C++: checked, compiled file by file, linked, and nothing done twice.
//
// CMake writes BUILD/step_flags.json, so that a student's file is compiled just as the rest of the project is:
//
//   {"compiler": "g++",
//    "compiler_version": "GNU 12.2.0",
//    "compile": ["-std=c++20", "-I...", "-include", "..."],                   of each file, the precompiled header too
//    "link":    ["-shared", "-fuse-ld=mold"],                                 behind the objects
//    "titles":  {"02-blinn-phong": "Light and materials"},
//    "files":   {"02-blinn-phong": ["blinn_phong.cpp", "blinn_phong.glsl"]},  what a student writes
//    "headers": {"02-blinn-phong": ["02-blinn-phong/blinn_phong.hpp"]},       what its C++ may include, below an -I
//    "uses":    {"02-blinn-phong": ["01-transforms"]}}                        the earlier steps that it calls
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "judge/run/source_file.hpp"

namespace atelier::judge {

struct StepFlags {
  std::string compiler, compiler_version;
  std::vector<std::string> compile, link;
  std::map<std::string, std::vector<std::string>> files;    ///< by step; plain names
  std::map<std::string, std::vector<std::string>> headers;  ///< by step
  std::map<std::string, std::vector<std::string>> uses;     ///< by step
  std::map<std::string, std::string> titles;                ///< by step
};

/// Throws Error naming the file, the member and what is allowed.
StepFlags read_step_flags(const std::filesystem::path& file);

struct Built {
  bool ok = false;
  bool fresh = false;  ///< something was compiled or linked; false where all stood there already
  std::string log;     ///< the compiler's and linker's words, warnings of earlier builds among them; at most log_limit
  NotTaken not_taken;  ///< listed files without which nothing was compiled; `log` then says the same in words
};

inline constexpr std::size_t log_limit = 20'000;  ///< bytes

/// What comes of a step of which these files cannot be taken.
Built not_built(const NotTaken& files);

/// Builds the step's listed .cpp files in `sources` into OUT/NN-name/libstep.so, which appears whole or not at all, and
/// is taken away where the files do not build. A step without C++ needs no library and is ok as it stands.
///
/// Not ok, with the reason in `log`: a listed file (shaders too) that cannot be taken (judge/run/source_file.hpp); an
/// include that is not open to a step (judge/run/includes.hpp); what the compiler or linker refuses, or cannot do
/// within `time_limit` for one file.
///
/// An object is made again when its source, a header that it includes, or a flag differs from what it was made of.
/// Throws Error for an unknown step and where `out` cannot be written.
Built build_step(const StepFlags& flags, const std::string& step, const std::filesystem::path& sources,
                 const std::filesystem::path& out, std::chrono::milliseconds time_limit = std::chrono::seconds(60));

/// Copies just the step's listed files from `sources` to `folder`, so that nothing else of a submission is ever read.
/// Returns those that cannot be taken: they are left out.
NotTaken take_step_files(const StepFlags& flags, const std::string& step, const std::filesystem::path& sources,
                         const std::filesystem::path& folder);

}  // namespace atelier::judge
