// What is swept on a step: tests/cases/NN-name/measure.json, read and checked. Every member stands in
// tests/cases/README.md.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "case/case.hpp"
#include "image/error.hpp"

namespace atelier::measure {

/// What a picture is compared with.
struct Truth {
  enum class By {
    oracle,   ///< the step program's --truth: traced in double precision, without the approximation
    program,  ///< the step program itself, under other settings
    value     ///< one number: what the mean of the picture ought to be
  };
  By by = By::oracle;
  std::map<std::string, SettingValue> settings{};  ///< laid over those of the picture; equal truths are made once
  int samples = 1;                                 ///< oracle: n x n rays a pixel, 1..64; 1 goes through its centre
  double value = 0;
};

using Metric = ErrorMetric;

/// What theory says of a sweep, to be checked against what was measured.
struct Expectation {
  enum class Kind {
    slope,    ///< of log error on log value, within `tolerance`
    order,    ///< the errors of the `values` never fall along them
    at_most,  ///< no error is above `number`
    at        ///< the error of `values[0]` is `number`, within `tolerance`
  };
  Kind kind = Kind::slope;
  std::string curve{};  ///< the one curve that is meant, as its setting's text; empty: each
  double number = 0, tolerance = 0;
  std::optional<glm::dvec2> range{};  ///< slope: of values, closed; none: all above the noise floor
  std::vector<std::string> values{};  ///< as setting_text writes them
  std::string reason{};               ///< where the number comes from, and why the tolerance is what it is
};

/// One setting, swept on one scene; perhaps a curve for each value of a second setting.
struct Sweep {
  std::string name, title;
  Case ask;  ///< scene, size, camera, output, settings that stay
  std::string setting;
  std::vector<SettingValue> values;  ///< empty: as default_values says
  std::string curves_by;             ///< the second setting; empty: one curve
  std::vector<SettingValue> curves;  ///< its values, at least one where it is there
  Truth truth;
  Metric metric = Metric::rmse;
  std::string x_label, y_label;  ///< with units
  bool linear = false;           ///< whether the error's axis is linear; where it is not, errors are drawn by decades
  bool handout = false;          ///< whether the step's handout shows its plot
  std::vector<Expectation> expect;
};

/// Every combination of several settings' values on one scene, to find those worth having.
struct Front {
  std::string name, title;
  Case ask;
  std::vector<std::pair<std::string, std::vector<SettingValue>>> grid;  ///< at most 256 combinations
  Truth truth;
  Metric metric = Metric::flip;
};

struct Plan {
  std::string step;
  std::vector<Sweep> sweeps;
  std::vector<Front> fronts;
  std::map<std::string, std::string> not_measured;  ///< setting and why no sweep of it would say anything
};

/// Throws Error naming the file, the sweep and the member.
Plan read_plan(const std::filesystem::path& file);

/// The same from text; `where` stands in for the file's name.
Plan parse_plan(const std::string& text, const std::string& where);

/// Throws Error where a sweep, a front or `not_measured` names a setting, a value or an output that the program does
/// not list, and where a setting of the program is neither swept, nor on a front, nor explained.
void check_against(const Plan& plan, const std::vector<SettingSpec>& settings, const std::vector<std::string>& outputs);

/// What is swept where a plan names no values: all choices; off and on; of numbers nine from the least to the greatest,
/// evenly by factors. Where the least is zero or below, zero comes first and the factors begin at 1 (whole numbers) or
/// at a millionth of the greatest. Of a colour none: a plan must name them.
std::vector<SettingValue> default_values(const SettingSpec& setting);

}  // namespace atelier::measure
