// Results made by hand, for tests of what follows from them.
#pragma once

#include <cmath>

#include "measure/tables.hpp"

namespace atelier::measure {

/// Two curves over 2, 4 ... 256: "fine" falls with the square from 1, "coarse" stays at 0.5. With times 1 ms and up.
inline SweepResult sample_sweep() {
  SweepResult result;
  result.plan.name = "wall", result.plan.title = "How round";
  result.plan.setting = "pieces", result.plan.curves_by = "kind";
  result.plan.x_label = "pieces", result.plan.y_label = "error, m";
  result.plan.ask.scene = "hall";
  result.numeric = true;
  for (const char* curve : {"fine", "coarse"})
    for (int pieces = 2; pieces <= 256; pieces *= 2) {
      Point point{.curve = curve, .value = std::to_string(pieces), .x = double(pieces)};
      point.error = point.curve == "fine" ? 4.0 / (pieces * pieces) : 0.5;
      point.rmse = point.error / 2;
      point.cost = {
          .counts = {{"draws", 3}, {"triangles", 2.0 * pieces}},
          .times = FrameTimes{.count = 15, .median = 1e-3 * pieces, .least = 9e-4 * pieces, .most = 2e-3 * pieces}};
      result.points.push_back(point);
      result.plan.values.emplace_back(pieces);
    }
  result.plan.values.resize(8);
  return result;
}

/// Four choices; "c" is beaten by "b".
inline FrontResult sample_front() {
  FrontResult result;
  result.plan.name = "all", result.plan.title = "All";
  const auto add = [&](const char* value, double seconds, double error) {
    Point point{.value = value, .error = error};
    point.cost.times = FrameTimes{.count = 15, .median = seconds, .least = seconds, .most = seconds};
    result.points.push_back(point);
  };
  add("a", 1e-3, 1), add("b", 2e-3, 1e-2), add("c", 3e-3, 1e-1), add("d", 1e-1, 9e-3);
  return result;
}

}  // namespace atelier::measure
