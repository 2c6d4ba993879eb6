// The files with which a step program answers the judge. The judge does not trust them.
//
//   DIR/NAME.pixels   "ATELIER1", width and height (32-bit little-endian), then width*height RGBA floats, row 0 on top
//   DIR/NAME.values   {"results": [[numbers of input 0], ...]}; non-finite numbers as "nan", "inf", "-inf"
//   DIR/NAME.stats    with --stats: {"counts": {"vertices": 1032, ...}, ...}, the cost of the picture (app/cost.hpp)
//   DIR/NAME.build_error   one sentence: the student's shader does not compile
//   DIR/NAME.error    one sentence: the program refused the case (because of an unknown scene, for example)
//   DIR/NAME.exception   one sentence: an exception that the student's function did not catch
//
// Each file is written atomically.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/held_folder.hpp"
#include "case/case.hpp"
#include "image/image.hpp"

namespace atelier {

void write_pixels(const std::filesystem::path& file, const Image& image);
void write_values(const std::filesystem::path& file, const std::vector<Numbers>& results);
void write_case_error(const std::filesystem::path& file, const std::string& sentence);

/// Reads a picture from an untrusted program: the file `name` of a folder that was opened before the program started.
/// Accepts only a regular file with no second name (a hard link could be to any file) and of exactly the size that
/// `expected` pixels need; does not follow links or block. Throws Error saying what is wrong.
Image read_pixels(const HeldFolder& folder, const std::string& name, glm::ivec2 expected);

/// At most `limit` bytes of JSON in the format above, with the same checks. Throws Error.
std::vector<Numbers> read_values(const HeldFolder& folder, const std::string& name, std::size_t limit = 1 << 20);

/// The counts of a .stats file, with the same checks: at most 64 names, each with a whole number, 0 or more. Throws
/// Error.
std::map<std::string, std::int64_t> read_counts(const HeldFolder& folder, const std::string& name);

/// The first line, at most 500 bytes, printable (base/printable.hpp). Empty if the file does not exist. If it cannot be
/// read as a regular file, returns a sentence that says so; does not throw Error.
std::string read_case_error(const HeldFolder& folder, const std::string& name);

}  // namespace atelier
