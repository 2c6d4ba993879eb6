// Describes measurements in words for students.
#pragma once

#include <string>

#include "image/image.hpp"
#include "judge/compare/judged_case.hpp"
#include "judge/compare/measure.hpp"

namespace atelier::judge {

/// "37 %", "0.4 %", "under 0.01 %" for a fraction 0..1.
std::string percent(double fraction);

/// "65 536": groups of three digits, separated by spaces.
std::string grouped(long long number);

/// Where most failing pixels are: "all over the picture", "most of them in the upper left", "in the left half" ..., or
/// empty if there is no such place.
std::string place_of(const Mask& over);

/// Describes a failing picture: how many pixels, in which direction, by how much, where, and in which form.
std::string describe_failure(const Measurement& measured, const Image& yours, const Image& reference,
                             const JudgedCase& c);

/// Describes a passing picture: its margin.
std::string describe_pass(const Measurement& measured, const JudgedCase& c);

/// "3/255", "2 degrees", "0.001" in the unit of a case.
std::string amount(double value, Unit unit);

/// "pi", "1/2", "180/pi" ... for a commonly forgotten factor, within the relative error `within`; otherwise empty.
std::string factor_name(double factor, double within);

/// "black", "white", "grey", "dark red" ...: a name for an encoded colour.
std::string colour_name(const Rgba& encoded);

}  // namespace atelier::judge
