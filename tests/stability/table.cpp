#include "stability/table.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "base/error.hpp"

namespace atelier::stability {

namespace {

constexpr double broken = std::numeric_limits<double>::infinity();

/// How many of the numbers differ; infinite where there are more or fewer of them than expected.
double count_different(const Values& actual, const Values& expected) {
  if (actual.size() != expected.size()) return broken;
  double count = 0;
  for (std::size_t i = 0; i < actual.size(); ++i) count += actual[i] != expected[i];
  return count;
}

double error_of_refusal(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::invalid_argument&) {
    return 0;
  } catch (const Error&) {
    return 0;
  }
  return broken;
}

}  // namespace

std::string to_string(Demand demand) {
  switch (demand) {
    case Demand::close:
      return "close";
    case Demand::equals:
      return "equals";
    case Demand::finite:
      return "finite";
    case Demand::refuses:
      return "refuses";
    case Demand::nan:
      return "NaN";
  }
  return {};
}

Result try_row(const Row& row) {
  Result result;
  try {
    result.error = row.error();
    result.held = result.error <= row.bound.value;  // false for NaN
  } catch (const std::exception& thrown) {
    result = {.error = broken, .held = false, .words = thrown.what()};
  }
  return result;
}

Group Table::of(std::string function) {
  return Group(*this, std::move(function));
}

void Group::add(std::string extreme, Demand demand, Bound bound, std::function<double()> error) {
  table_->rows.push_back({function_, std::move(extreme), demand, std::move(bound), std::move(error)});
}

void Group::close(std::string extreme, Bound bound, std::function<double()> error) {
  add(std::move(extreme), Demand::close, std::move(bound), std::move(error));
}

void Group::same(std::string extreme, std::function<Values()> actual, std::function<Values()> expected) {
  add(std::move(extreme), Demand::equals, {},
      [actual = std::move(actual), expected = std::move(expected)] { return count_different(actual(), expected()); });
}

void Group::equals(std::string extreme, std::function<Values()> actual, Values expected) {
  same(std::move(extreme), std::move(actual), [expected = std::move(expected)] { return expected; });
}

void Group::finite(std::string extreme, std::function<Values()> actual) {
  add(std::move(extreme), Demand::finite, {},
      [actual = std::move(actual)] { return double(count_non_finite(actual())); });
}

void Group::refuses(std::string extreme, std::function<void()> call) {
  add(std::move(extreme), Demand::refuses, {}, [call = std::move(call)] { return error_of_refusal(call); });
}

void Group::nan(std::string extreme, std::function<Values()> actual) {
  add(std::move(extreme), Demand::nan, {}, [actual = std::move(actual)] { return has_nan(actual()) ? 0 : broken; });
}

}  // namespace atelier::stability
