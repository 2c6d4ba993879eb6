// A table of extremes: for each function what comes in, what must happen there, and how far from that it was.
//
// A row measures one error, a number that is 0 where all is perfect, and holds it against its bound. Four demands need
// no bound of their own: what must be refused, stay finite, come out exactly, or stay NaN has an error of 0 or else is
// broken. All others are distances from a computation in double precision that takes another way to the same number.
//
//   Group rotation = table.of("rotation");
//   rotation.close("an axis 1e-30 m long", rounding(4, "..."), [] { return difference(...); });
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "stability/values.hpp"

namespace atelier::stability {

enum class Demand {
  close,    ///< the error is at most the bound
  equals,   ///< the very number
  finite,   ///< no NaN and no infinity
  refuses,  ///< throws what the contract says, and nothing else
  nan,      ///< what came in broken is seen to be broken
};
std::string to_string(Demand demand);

/// How large an error may be, and why just so.
struct Bound {
  double value = 0;    ///< above 0
  std::string unit;    ///< of error and bound: "relative", "pixels", "degrees"
  std::string reason;  ///< one sentence
};

struct Row {
  std::string function;  ///< the function of the contract, or what else is tried
  std::string extreme;   ///< what comes in, in words
  Demand demand = Demand::close;
  Bound bound;                    ///< value 0 but for `close`
  std::function<double()> error;  ///< measures; infinite or NaN where nothing sensible came out
};

/// A row that was tried.
struct Result {
  double error = 0;
  bool held = false;
  std::string words;  ///< what was thrown, where it should not have been
};

/// Measures a row. Whatever `error` throws is caught: the row is broken then.
Result try_row(const Row& row);

/// Error over a range of one input, for a plot: the curve on which the rows' extremes are points.
struct Curve {
  std::string name;
  std::vector<glm::dvec2> points;  ///< (input, error)
};
struct Sweep {
  std::string name;  ///< of its files: "world-offset"
  std::string title, x_label, y_label;
  bool log_x = true, log_y = true;
  std::vector<Curve> curves;
};

class Group;

struct Table {
  std::vector<Row> rows;
  std::vector<std::function<Sweep()>> sweeps;
  Group of(std::string function);
};

/// Adds the rows of one function.
class Group {
 public:
  Group(Table& table, std::string function) : table_(&table), function_(std::move(function)) {}

  void close(std::string extreme, Bound bound, std::function<double()> error);
  /// The very numbers; 0 and -0 are equal.
  void equals(std::string extreme, std::function<Values()> actual, Values expected);
  /// The same from two calls.
  void same(std::string extreme, std::function<Values()> actual, std::function<Values()> expected);
  void finite(std::string extreme, std::function<Values()> actual);
  /// `call` throws std::invalid_argument, as the contracts of steps say, or atelier::Error, as those of common/ do.
  void refuses(std::string extreme, std::function<void()> call);
  /// At least one of the numbers is NaN.
  void nan(std::string extreme, std::function<Values()> actual);

 private:
  void add(std::string extreme, Demand demand, Bound bound, std::function<double()> error);
  Table* table_;
  std::string function_;
};

}  // namespace atelier::stability
