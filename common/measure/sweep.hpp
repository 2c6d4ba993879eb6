// A plan, carried out: pictures, their truths, errors and costs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "measure/fit.hpp"
#include "measure/plan.hpp"
#include "measure/program.hpp"

namespace atelier::measure {

/// One picture of a sweep or a front.
struct Point {
  std::map<std::string, SettingValue> chosen;  ///< what is swept, by setting
  std::string curve;                           ///< the second setting's value as text; empty without one
  std::string value;                           ///< the swept value as text; of a front: all that is chosen
  double x = 0;                                ///< the value where it is a number, otherwise its place in the list
  double error = 0;                            ///< by the sweep's own metric
  std::optional<double> rmse, flip;            ///< beside it; none where the truth is a number, flip for colours only
  Cost cost;
};

struct SweepResult {
  Sweep plan;  ///< its values filled in
  bool numeric = false;
  std::vector<Point> points;  ///< curve by curve, values in their order
};

struct FrontResult {
  Front plan;
  std::vector<Point> points;
};

/// `repeats` frames to time each picture with; 0: no times.
struct SweepOptions {
  int repeats = 0;
};

SweepResult run_sweep(const Program& program, const Listing& listing, const Sweep& sweep, const SweepOptions& options);
FrontResult run_front(const Program& program, const Listing& listing, const Front& front, const SweepOptions& options);

/// The texts of the curves, in their order: "" alone where there is but one.
std::vector<std::string> curves_of(const SweepResult& result);
/// (x, error) of one curve.
std::vector<glm::dvec2> curve_points(const SweepResult& result, const std::string& curve);

/// The error that remains at the best value of all (noise_floor of every point); 0 where the errors are no errors but
/// means.
double floor_of(const SweepResult& result);

}  // namespace atelier::measure
