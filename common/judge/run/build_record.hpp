// What a product of a build was made of, so that the next build knows whether to make it again.
//
// Times alone do not tell: restoring yesterday's copy of a file makes it older, and copying it makes it newer, though
// the object at hand was made of neither or of both. So a record holds the command and a fingerprint of every input.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace atelier::judge {

/// One command that makes one file.
struct Recipe {
  std::vector<std::string> command;
  std::filesystem::path folder;   ///< where the command runs: relative inputs start here
  std::filesystem::path product;  ///< the record stands beside it, as PRODUCT.record
};

/// The inputs of a product by path, each with its fingerprint.
using Inputs = std::vector<std::pair<std::string, std::string>>;

/// Tells files of different content apart: a hash of the content, or, for what is too large to be read at every build
/// (a precompiled header), the size and time of change. Empty for what is no readable file.
std::string fingerprint(const std::filesystem::path& file);
Inputs fingerprints(const std::vector<std::string>& paths, const std::filesystem::path& folder);

/// What the command said when it made the product, where the product still stands and command and inputs are as they
/// were. Nothing otherwise, also where there is no record or none that can be read.
std::optional<std::string> recorded_log(const Recipe& recipe);

/// Throws Error where it cannot be written.
void write_record(const Recipe& recipe, const Inputs& inputs, const std::string& log);
void forget_record(const Recipe& recipe);

/// The inputs in a dependency file that the compiler wrote (-MMD -MF), all but the target: "x.o: a.cpp b\ c.hpp \".
std::vector<std::string> read_dependencies(const std::filesystem::path& file);

}  // namespace atelier::judge
