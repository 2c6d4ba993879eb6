// Runs a measurement plan: draws pictures and their truths, and computes errors and costs.
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
  std::map<std::string, SettingValue> chosen;  ///< the swept settings' values
  std::string curve;                           ///< the second setting's value as text; empty without one
  std::string value;                           ///< the swept value as text; of a front: all chosen values
  double x = 0;                                ///< the value if it is a number, otherwise its index
  double error = 0;                            ///< in the plan's metric; the count if the plan measures one
  std::optional<double> rmse, flip;            ///< none without a true picture; flip for colours only
  Cost cost;
};

struct SweepResult {
  Sweep plan;  ///< with its default values filled in
  bool numeric = false;
  std::vector<Point> points;  ///< curve by curve, values in their order
};

struct FrontResult {
  Front plan;
  std::vector<Point> points;
};

struct SweepOptions {
  int repeats = 0;  ///< frames to time each picture with; 0: no times
};

SweepResult run_sweep(const Program& program, const Listing& listing, const Sweep& sweep, const SweepOptions& options);
FrontResult run_front(const Program& program, const Listing& listing, const Front& front, const SweepOptions& options);

/// The texts of the curves in order; only "" for a sweep without a second setting.
std::vector<std::string> curves_of(const SweepResult& result);
/// (x, error) of one curve.
std::vector<glm::dvec2> curve_points(const SweepResult& result, const std::string& curve);

/// The name of what a sweep measures: "rmse", "draws".
std::string quantity_of(const Sweep& sweep);

/// The noise_floor of all points; 0 for the metric `mean` and for counts, whose values are not errors.
double floor_of(const SweepResult& result);

}  // namespace atelier::measure
