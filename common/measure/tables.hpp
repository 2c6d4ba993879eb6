// Results for other programs: as CSV for spreadsheets, and as JSON.
#pragma once

#include <string>
#include <vector>

#include "measure/sweep.hpp"

namespace atelier::measure {

struct StepMeasured {
  std::string step;                                ///< "02-blinn-phong"
  std::map<std::string, std::string> environment;  ///< driver, processor ...: where the times were measured
  std::vector<SweepResult> sweeps;
  std::vector<FrontResult> fronts;
};

/// A line for each point of every sweep and front: sweep, curve, value, metric, error, rmse, flip, times in seconds,
/// and a column for each count. Missing values are empty. RFC 4180.
std::string as_csv(const StepMeasured& measured);

/// Sweeps with fits, noise floors and findings; fronts with their Pareto fronts and knees.
std::string as_json(const StepMeasured& measured);

/// The numbers of a handout's plot, which do not depend on the machine's speed: a line "curve,value,error" per point,
/// with six digits.
std::string errors_as_csv(const SweepResult& result);

/// Describes the first difference between two such tables; empty if they agree. Processors of different makers draw
/// colours up to 3/255 apart (CONTRIBUTING.md, Determinism), so an error may differ by a tenth of itself or by a
/// hundredth of the largest error in the table.
std::string difference(const std::string& ours, const std::string& stored);

/// The points of a front as (time, error), and the indices of its Pareto front and knee. Empty if there are no times.
struct Ranking {
  std::vector<glm::dvec2> points;  ///< (median seconds, error)
  std::vector<std::size_t> front;  ///< from the fastest to the most accurate

  std::optional<std::size_t> knee;  ///< the recommended default
};
Ranking rank(const FrontResult& front);

}  // namespace atelier::measure
