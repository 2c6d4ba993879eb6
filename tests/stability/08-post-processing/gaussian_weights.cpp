// gaussian_weights: widths from the smallest float to 20 pixels.
#include "stability/08-post-processing/rows.hpp"

namespace atelier::stability {

using post_processing::gaussian_weights;

namespace {

Values weights_of(float sigma) {
  const std::vector<float> weights = gaussian_weights(sigma);
  return Values(weights.begin(), weights.end());
}

/// By successive quotients: each weight is the last one times q^(2k-1), where q = exp(-1 / (2 sigma^2)).
Values exact_weights(float sigma, std::size_t count) {
  const long double ratio = std::exp(-0.5L / (static_cast<long double>(sigma) * static_cast<long double>(sigma)));
  std::vector<long double> bell{1};
  long double factor = ratio, sum = 1;
  while (bell.size() < count) {
    bell.push_back(bell.back() * factor);
    factor *= ratio * ratio;
    sum += 2 * bell.back();
  }
  Values weights;
  for (const long double weight : bell) weights.push_back(double(weight / sum));
  return weights;
}

double sum_of_filter(const Values& weights) {
  double sum = weights.at(0);
  for (std::size_t k = 1; k < weights.size(); ++k) sum += 2 * weights[k];
  return sum;
}

/// 400 widths between these, each a float.
template <class Error>
double worst_of_widths(double low, double high, Error error) {
  return worst_of(400, 890, [=](Trial& t) { return error(float(t.size_between(low, high))); });
}

}  // namespace

void add_weights_rows(Table& table) {
  Group group = table.of("gaussian_weights");
  for (const float bad :
       {0.0f, -0.0f, -denormal, -6.0f, std::nextafter(20.0f, 30.0f), 1e30f, infinite, -infinite, not_a_number})
    group.refuses(fmt::format("a width of {:.9g}", bad), [=] { gaussian_weights(bad); });
  for (const float tiny : {denormal, 1e-30f, 1e-3f, 0.01f})
    group.equals(fmt::format("a width of {:g}: one pixel alone", tiny), [=] { return weights_of(tiny); }, {1, 0});
  for (const auto& [sigma, count] : {std::pair{0.3f, 2}, {0.34f, 3}, {0.5f, 3}, {6.0f, 19}, {6.1f, 20}, {20.0f, 61}})
    group.equals(fmt::format("a width of {:g}: the number of weights", sigma),
                 [sigma = sigma] { return Values{double(weights_of(sigma).size())}; }, {double(count)});
  group.close("400 widths of 0.3 to 20: each weight",
              {4 * rounding_unit, "relative", "exponential and quotient in double precision, rounded to a float"}, [] {
                return worst_of_widths(0.3, 20, [](float sigma) {
                  const Values weights = weights_of(sigma);
                  return each_relative(weights, exact_weights(sigma, weights.size()));
                });
              });
  group.close("400 widths of 0.001 to 0.3: each weight",
              {2 * rounding_unit, "absolute", "one rounding of numbers up to 1"}, [] {
                return worst_of_widths(1e-3, 0.3, [](float sigma) {
                  const Values weights = weights_of(sigma);
                  return difference(weights, exact_weights(sigma, weights.size()));
                });
              });
  group.close(
      "400 widths of 0.001 to 20: the sum of the whole filter",
      {2 * rounding_unit, "absolute", "each weight is rounded once, so their sum is off by no more than that"}, [] {
        return worst_of_widths(1e-3, 20, [](float sigma) { return std::abs(sum_of_filter(weights_of(sigma)) - 1); });
      });
  group.equals("400 widths of 0.001 to 20: weights that are negative, or larger than the one before",
               [] {
                 return Values{worst_of_widths(1e-3, 20, [](float sigma) {
                   const Values weights = weights_of(sigma);
                   double wrong = count_outside(weights, 0, 1);
                   for (std::size_t k = 1; k < weights.size(); ++k) wrong += !(weights[k] <= weights[k - 1]);
                   return wrong;
                 })};
               },
               {0});
}

}  // namespace atelier::stability
