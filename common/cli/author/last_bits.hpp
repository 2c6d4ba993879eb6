// A solution whose results differ in their last bits.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace atelier {

/// C++ in which every float, vector and matrix that a function returns is moved by at most one unit in the last place,
/// by random numbers that depend on `seed` and on the calls before. Zero and values that are not finite stay.
std::string with_moved_last_bits(std::string_view code, std::uint64_t seed);

}  // namespace atelier
