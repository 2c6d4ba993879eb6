// Records how a product of a build was made, so that the next build knows whether it is up to date.
//
// Times alone are not enough: restoring an old copy of a file changes its content and makes it older than the object.
// So a record holds the command and a fingerprint of every input.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace atelier::judge {

/// A command and the file that it makes.
struct Recipe {
  std::vector<std::string> command;
  std::filesystem::path folder;   ///< working directory of the command; relative inputs start here
  std::filesystem::path product;  ///< the record is PRODUCT.record
};

/// The inputs of a product by path, each with its fingerprint.
using Inputs = std::vector<std::pair<std::string, std::string>>;

/// Identifies a file's content: by its hash, or for files too large to read at every build (a precompiled header), by
/// size and time of change. Empty if the file is not readable.
std::string fingerprint(const std::filesystem::path& file);
Inputs fingerprints(const std::vector<std::string>& paths, const std::filesystem::path& folder);

/// If the product is up to date (it exists, and command and inputs are unchanged): the command's output when it made
/// the product. Otherwise nothing, also if the record is missing or unreadable.
std::optional<std::string> recorded_log(const Recipe& recipe);

/// Throws Error if the record cannot be written.
void write_record(const Recipe& recipe, const Inputs& inputs, const std::string& log);
void forget_record(const Recipe& recipe);

/// The inputs in a dependency file of the compiler (-MMD -MF), without the target: "x.o: a.cpp b\ c.hpp \".
std::vector<std::string> read_dependencies(const std::filesystem::path& file);

}  // namespace atelier::judge
