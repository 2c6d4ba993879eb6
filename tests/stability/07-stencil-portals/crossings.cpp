// How far from their place visitors are who have gone through a portal and back many times: in double precision, as the
// contract has it, and with passages and positions that are rounded to floats.
#include "stability/07-stencil-portals/rows.hpp"

namespace atelier::stability {

namespace {

using namespace stencil_portals;

enum class Precision { floats, doubles };

/// Carries the eye once through the portal and back.
glm::dvec3 back_again(const glm::dvec3& eye, const glm::dmat4& there, const glm::dmat4& back, Precision precision) {
  if (precision == Precision::doubles) return carried(carried({.eye = eye}, there), back).eye;
  const glm::vec3 arrived(glm::mat4(there) * glm::vec4(glm::vec3(eye), 1));
  return glm::dvec3(glm::vec3(glm::mat4(back) * glm::vec4(arrived, 1)));
}

/// Metres from where they were, after each number of crossings (even numbers, rising): the largest of 8 visitors 2 m
/// from portals so many metres from the origin.
Values drift(double distance, const std::vector<int>& crossings, Precision precision) {
  Values largest(crossings.size(), 0);
  for (int visitor = 0; visitor < 8; ++visitor) {
    Trial t(790, visitor);
    const glm::dmat4 entry = odd_frame(t, distance), exit = odd_frame(t, distance);
    const glm::dmat4 there = portal_passage(entry, exit), back = portal_passage(exit, entry);
    const glm::dvec3 start = glm::dvec3(entry[3]) + 2.0 * t.direction();
    glm::dvec3 eye = start;
    int done = 0;
    for (std::size_t i = 0; i < crossings.size(); ++i) {
      for (; done < crossings[i]; done += 2) eye = back_again(eye, there, back, precision);
      largest[i] = std::max(largest[i], glm::length(eye - start));
    }
  }
  return largest;
}

double drift(double distance, int crossings, Precision precision) {
  return drift(distance, std::vector{crossings}, precision).front();
}

Sweep drift_by_crossings() {
  Sweep sweep{.name = "portal-crossings",
              .title = "How far visitors are from their place who go to and fro through a portal",
              .x_label = "crossings",
              .y_label = "largest distance of 8 visitors, m"};
  std::vector<int> crossings;
  for (int step = 0; step <= 16; ++step) crossings.push_back(2 * int(std::lround(std::pow(10.0, step / 4.0))));
  for (const Precision precision : {Precision::floats, Precision::doubles})
    for (const double distance : {10.0, million}) {
      const bool rounded = precision == Precision::floats;
      Curve curve{fmt::format("{}, {:g} m from the origin", rounded ? "floats" : "doubles", distance), {}};
      const Values distances = drift(distance, crossings, precision);
      for (std::size_t i = 0; i < crossings.size(); ++i) curve.points.push_back({double(crossings[i]), distances[i]});
      sweep.curves.push_back(std::move(curve));
    }
  return sweep;
}

Sweep drift_by_distance() {
  Sweep sweep{.name = "portal-offset",
              .title = "How far they are from their place, by the distance of the portals from the origin",
              .x_label = "distance of the portals from the origin, m",
              .y_label = "largest distance of 8 visitors, m"};
  for (const Precision precision : {Precision::floats, Precision::doubles})
    for (const int crossings : {2, 10'000}) {
      const bool rounded = precision == Precision::floats;
      Curve curve{fmt::format("{}, {} crossings", rounded ? "floats" : "doubles", crossings), {}};
      for (int step = 0; step <= 14; ++step) {
        const double distance = std::pow(10.0, step / 2.0);
        curve.points.push_back({distance, drift(distance, crossings, precision)});
      }
      sweep.curves.push_back(std::move(curve));
    }
  return sweep;
}

}  // namespace

void add_crossing_rows(Table& table) {
  table.of("carried, if all were floats")
      .equals("100 crossings 1e6 m from the origin, by more than half a metre: the trouble is real",
              [] { return Values{double(drift(million, 100, Precision::floats) > 0.5)}; }, {1});
  table.sweeps.push_back(drift_by_crossings);
  table.sweeps.push_back(drift_by_distance);
}

}  // namespace atelier::stability
