// The files through which a step program answers a judge that does not trust it: fixed-size raw pixels, plain numbers.
//
//   DIR/NAME.pixels   "ATELIER1", width and height (32-bit little-endian), then width*height RGBA floats, row 0 on top
//   DIR/NAME.values   {"results": [[numbers of input 0], ...]}; non-finite ones as "nan", "inf", "-inf"
//   DIR/NAME.stats    only where --stats asks: what the picture has cost, as JSON (app/cost.hpp)
//   DIR/NAME.stats    {"counts": {"vertices": 1032, ...}}: what drawing has cost, where --stats asks for it
//   DIR/NAME.build_error   one sentence: the student's shader does not compile
//   DIR/NAME.error    one sentence: the program itself refused the case (it has no such scene, say)
//   DIR/NAME.exception   one sentence: what the student's function threw and nothing caught
//
// Each is written beside and renamed: what is there is whole.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "image/image.hpp"

namespace atelier {

void write_pixels(const std::filesystem::path& file, const Image& image);
void write_values(const std::filesystem::path& file, const std::vector<Numbers>& results);
void write_case_error(const std::filesystem::path& file, const std::string& sentence);

/// Reads what an untrusted program wrote: opens without following links or blocking, takes regular files only, and
/// exactly the size that `expected` pixels need. Throws Error saying which of these failed.
Image read_pixels(const std::filesystem::path& file, glm::ivec2 expected);

/// At most `limit` bytes of JSON in the shape above, opened as carefully. Throws Error.
std::vector<Numbers> read_values(const std::filesystem::path& file, std::size_t limit = 1 << 20);

/// The counts of a .stats file, opened as carefully: at most 64 names, each with a whole number from 0 on. Throws
/// Error.
std::map<std::string, std::int64_t> read_counts(const std::filesystem::path& file);

/// The first line, at most 500 bytes, printable (base/printable.hpp). Empty where there is no such file; where it
/// cannot be read as a regular file, the sentence says so. Never throws Error: what is read is an error already.
std::string read_case_error(const std::filesystem::path& file);

}  // namespace atelier
