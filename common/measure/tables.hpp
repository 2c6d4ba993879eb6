// Results as text for other programs: CSV for a spreadsheet, JSON for everything.
#pragma once

#include <string>
#include <vector>

#include "measure/sweep.hpp"

namespace atelier::measure {

struct StepMeasured {
  std::string step;                                ///< "02-blinn-phong"
  std::map<std::string, std::string> environment;  ///< driver, processor: what the times belong to
  std::vector<SweepResult> sweeps;
  std::vector<FrontResult> fronts;
};

/// A line for each point of every sweep and front: sweep, curve, value, metric, error, rmse, flip, times in seconds,
/// and a column for each count. What is not there is empty. RFC 4180.
std::string as_csv(const StepMeasured& measured);

/// Sweeps with fits, floors and findings, fronts with their Pareto fronts and knees.
std::string as_json(const StepMeasured& measured);

/// What a handout's plot shows, without what depends on the machine's speed: "curve,value,error" a line. Six digits.
std::string errors_as_csv(const SweepResult& result);

/// The first place where two such tables differ, in words; empty where they agree. Processors of different makers draw
/// colours that are up to 3/255 apart (CONTRIBUTING.md, Determinism), which moves an error by a part of itself, so an
/// error may be off by a tenth, or by a hundredth of the largest in the table.
std::string difference(const std::string& ours, const std::string& stored);

/// The median time and the error of a front's points, those on its Pareto front, and its knee, as places among its
/// points. No times: nothing.
struct Ranking {
  std::vector<glm::dvec2> points;   ///< (seconds, error)
  std::vector<std::size_t> front;   ///< from the fastest to the most exact
  std::optional<std::size_t> knee;  ///< the recommended default
};
Ranking rank(const FrontResult& front);

}  // namespace atelier::measure
