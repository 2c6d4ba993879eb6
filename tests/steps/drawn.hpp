// Pictures that a step's program draws by the solutions, with what they cost, for tests of what a scene requires.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "image/image.hpp"

namespace atelier::test {

struct Drawn {
  Image picture;
  std::map<std::string, std::int64_t> counts;
};

/// Has a step's program draw pictures by the solutions, all in one process, and tell what each has cost. The names of
/// the cases are their places: "0", "1" ...
std::vector<Drawn> drawn(const std::string& step, std::vector<Case> pictures);

/// A picture, and what some of its counts must be.
struct Priced {
  std::string name;
  Case picture;
  std::map<std::string, std::int64_t> costs;
};

/// Draws all of them and checks each cost that is given.
void check_costs(const std::string& step, const std::vector<Priced>& rows);

/// What the same picture costs once it has been drawn before.
std::map<std::string, std::int64_t> counts_at_rest(const std::string& step, const Case& picture);

/// 160 x 120 pixels.
Case picture(const std::string& scene, std::map<std::string, SettingValue> settings = {},
             const std::string& output = "colour");
/// A choice as a setting's value: a literal alone would be a flag.
inline std::string text(const char* choice) {
  return choice;
}

inline constexpr std::int64_t picture_bytes = 160 * 120 * (16 + 4);  ///< of its target: floats, 24 bits of depth in 32

/// The largest difference of two pictures after encoding, in units of 1/255.
double codes_apart(const Image& a, const Image& b);

/// How many pixels differ by 1/255 and more after encoding.
int pixels_a_code_apart(const Image& a, const Image& b);

/// How many pixels are not the same to the last bit.
int pixels_apart(const Image& a, const Image& b);

}  // namespace atelier::test
