// Pareto fronts, and the recommended point on them.
#include "measure/pareto.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include "catch.hpp"

namespace atelier::measure {
namespace {

using Points = std::vector<glm::dvec2>;
using Indices = std::vector<std::size_t>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("the Pareto front has the points that no other dominates") {
  struct Row {
    const char* name;
    Points points;
    Indices front;
  };
  const std::vector<Row> rows = {
      {"none", {}, {}},
      {"one", {{1, 1}}, {0}},
      {"a trade", {{2, 1}, {1, 2}}, {1, 0}},
      {"beaten in both", {{1, 1}, {2, 2}}, {0}},
      {"as dear, and worse", {{1, 1}, {1, 2}}, {0}},
      {"as good, and dearer", {{2, 1}, {1, 1}}, {1}},
      {"equal: the first", {{1, 1}, {1, 1}}, {0}},
      {"beaten in the middle of a front", {{1, 8}, {2, 4}, {3, 5}, {4, 1}}, {0, 1, 3}},
      {"no numbers", {{nan, 0}, {0, nan}, {infinity, 0}, {1, 1}}, {3}},
      {"an error of zero ends it", {{1, 1}, {2, 0}, {3, 0}}, {0, 1}},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    CHECK(pareto_front(row.points) == row.front);
  }
}

TEST_CASE("no point of a front is dominated, and all others are") {
  // 200 points of a fixed sequence with low discrepancy: no two alike in any coordinate.
  Points points;
  for (int i = 1; i <= 200; ++i) points.emplace_back(std::fmod(i * 0.754877666, 1), std::fmod(i * 0.569840291, 1));
  const Indices front = pareto_front(points);
  CHECK(front.size() > 2);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool beaten = std::any_of(points.begin(), points.end(), [&](const glm::dvec2& p) {
      return p != points[i] && p.x <= points[i].x && p.y <= points[i].y;
    });
    CHECK(beaten == (std::find(front.begin(), front.end(), i) == front.end()));
  }
}

TEST_CASE("the knee is the point farthest below the chord of the logarithms") {
  struct Row {
    const char* name;
    Points front;
    std::size_t knee;
  };
  const std::vector<Row> rows = {
      {"one", {{1, 1}}, 0},
      {"two: the cheaper", {{1, 1}, {2, 0.5}}, 0},
      {"an elbow", {{1, 1}, {2, 0.01}, {100, 0.009}}, 1},
      // In logarithms (0,0), (1,-1), (2,-1.2), (3,-1.3): scaled (0,0), (.33,.77), (.67,.92), (1,1).
      {"by factors, not by differences", {{1, 1}, {10, 0.1}, {100, 0.063}, {1000, 0.05}}, 1},
      {"a straight line has none: the first", {{1, 8}, {2, 4}, {4, 2}, {8, 1}}, 0},
      {"bent the other way: the first", {{1, 1}, {10, 0.9}, {11, 0.01}}, 0},
      {"an error of zero at the end", {{1, 1}, {2, 1e-3}, {50, 0}}, 1},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    CHECK(knee(row.front) == row.knee);
  }
  CHECK_FALSE(knee(Points{}));
}

}  // namespace atelier::measure
