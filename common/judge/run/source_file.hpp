// Checks a student's file before it is read.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>

namespace atelier::judge {

inline constexpr std::size_t source_limit = 1'000'000;  ///< bytes of one file of a student

/// Why a file is unusable; completes a sentence that begins with its name.
inline constexpr const char* is_missing = "is missing";
inline constexpr const char* is_link = "is a symbolic link, which is not followed";
inline constexpr const char* is_empty = "is empty (0 bytes)";
inline constexpr const char* is_of_a_solution = "is a sealed part of a solution, not work of yours";
std::string is_too_large(std::size_t limit = source_limit);

/// Why the file at this path is unusable: is_missing, is_link, is_too_large(), is_empty (unless it ends in ".txt":
/// no code is in it), is_of_a_solution, "is a FIFO, not a regular file", "cannot be read: ...". Empty if it is usable.
/// Opens only regular files, so it cannot block.
std::string why_unusable(const std::filesystem::path& path);

/// Unusable files by name, and why.
using UnusableFiles = std::map<std::string, std::string>;

/// "a.cpp is missing; a.glsl is a symbolic link, which is not followed"
std::string in_words(const UnusableFiles& files);

}  // namespace atelier::judge
