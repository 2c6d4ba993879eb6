// Reads and checks the measurement plan of a step, tests/cases/NN-name/measure.json. tests/cases/README.md describes
// its members.
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
    program,  ///< the step program itself, with other settings
    value,    ///< one number: the right mean of the picture
    none      ///< nothing: a count is measured, not an error
  };
  By by = By::oracle;
  std::map<std::string, SettingValue> settings{};  ///< override those of the picture
  int samples = 1;                                 ///< oracle: n x n rays per pixel, 1..64; 1 is through its centre
  double value = 0;
};

using Metric = ErrorMetric;

/// What theory predicts for a sweep, to be compared with the measurement. If the sweep measures a count, the counts
/// take the place of the errors.
struct Expectation {
  enum class Kind {
    slope,    ///< of log error on log value, within `tolerance`
    order,    ///< the errors at `values`, in their order, never fall
    at_most,  ///< no error is above `number`
    at        ///< the error at `values[0]` is `number`, within `tolerance`
  };
  Kind kind = Kind::slope;
  std::string curve{};  ///< the curve that it applies to, as its setting's text; empty: each
  double number = 0, tolerance = 0;
  std::optional<glm::dvec2> range{};  ///< slope: of values, closed; none: all above the noise floor
  std::vector<std::string> values{};  ///< as setting_text writes them
  std::string reason{};               ///< where the number comes from, and why the tolerance is what it is
};

/// One setting, swept on one scene; optionally with a curve for each value of a second setting.
struct Sweep {
  std::string name, title;
  Case ask;  ///< scene, size, camera, output, fixed settings
  std::string setting;
  std::vector<SettingValue> values;  ///< empty: those of default_values
  std::string curves_by;             ///< the second setting; empty: one curve
  std::vector<SettingValue> curves;  ///< its values; not empty if curves_by is set
  Truth truth;
  Metric metric = Metric::rmse;
  std::string count;             ///< measured instead of an error: "draws", as --stats names it; empty: the error
  std::string x_label, y_label;  ///< with units
  bool linear = false;           ///< whether the error axis is linear instead of logarithmic
  bool handout = false;          ///< whether the step's handout shows its plot
  std::vector<Expectation> expect;
};

/// Every combination of several settings' values on one scene, to find the Pareto front.
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
  std::map<std::string, std::string> not_measured;  ///< by setting: why there is nothing to measure
};

/// Throws Error naming the file, the sweep and the member.
Plan read_plan(const std::filesystem::path& file);

/// The same from text; `where` replaces the file's name in messages.
Plan parse_plan(const std::string& text, const std::string& where);

/// Throws Error if a sweep, a front or `not_measured` names a setting, value or output that the program does not list,
/// and if a setting of the program is in none of them.
void check_against(const Plan& plan, const std::vector<SettingSpec>& settings, const std::vector<std::string>& outputs);

/// The values of a sweep whose plan names none: all choices; off and on; for numbers, nine in geometric progression
/// from the smallest to the largest. If the smallest is zero or less, zero comes first and the progression begins at 1
/// (int) or at a millionth of the largest. For a colour none: a plan must name them.
std::vector<SettingValue> default_values(const SettingSpec& setting);

}  // namespace atelier::measure
