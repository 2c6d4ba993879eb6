// A file that a student writes, before anything is done with it: whether it is one that can be taken.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>

namespace atelier::judge {

inline constexpr std::size_t source_limit = 1'000'000;  ///< bytes of one file of a student

/// Why a file is not taken, to be put behind its name.
inline constexpr const char* is_missing = "is missing";
inline constexpr const char* is_link = "is a symbolic link, which is not followed";
std::string is_too_large(std::size_t limit = source_limit);

/// Why the file at this path is not taken: is_missing, is_link, is_too_large(), "is a FIFO, not a regular file",
/// "cannot be read: ...". Empty where it can be. Nothing is opened, so nothing can hang.
std::string why_not_taken(const std::filesystem::path& path);

/// Files that are not taken, by name, and why.
using NotTaken = std::map<std::string, std::string>;

/// "a.cpp is missing; a.glsl is a symbolic link, which is not followed"
std::string in_words(const NotTaken& files);

}  // namespace atelier::judge
