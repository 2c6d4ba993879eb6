// Figures in a student's words.
#pragma once

#include <string>

#include "image/image.hpp"
#include "judge/compare/judged_case.hpp"
#include "judge/compare/measure.hpp"

namespace atelier::judge {

/// "37 %", "0.4 %", "under 0.01 %" for a share 0..1.
std::string percent(double share);

/// "65 536": groups of three, a narrow space of plain ASCII between them.
std::string grouped(long long number);

/// Where most failing pixels are: "all over the picture", "most of them in the upper left", "in the middle", "along the
/// lower edge" ..., or empty where they are few or nowhere in particular.
std::string place_of(const Mask& over);

/// What was seen in a picture that fails: how much of it, in which direction, by how much, where, and in which form.
std::string describe_failure(const Measurement& measured, const Image& yours, const Image& reference,
                             const JudgedCase& c);

/// What was seen in a picture that passes: its margin.
std::string describe_pass(const Measurement& measured, const JudgedCase& c);

/// "3/255", "2 degrees", "0.001" in the unit of a case.
std::string amount(double value, Unit unit);

/// "pi", "1/2", "180/pi" ... for a factor that somebody may have forgotten, where it is so to `within` of its size; or
/// empty.
std::string factor_name(double factor, double within);

/// "black", "white", "grey", "mid red" ...: a name for one encoded colour.
std::string colour_name(const Rgba& encoded);

}  // namespace atelier::judge
