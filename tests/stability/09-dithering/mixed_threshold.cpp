// mixed_threshold: parts of 0, 1, a half and the floats beside them; all pairs of 128 thresholds.
#include "stability/09-dithering/rows.hpp"

namespace atelier::stability {

namespace {

constexpr int thresholds_a_side = 128;

float grid_threshold(int i) {
  return (float(i) + 0.5f) / thresholds_a_side;
}

/// A call: (a, b, part).
ShaderInput mixing_call(double a, double b, double part) {
  return input_of(glm::vec3(a, b, part));
}

ShaderInput some_mixture(Trial& t) {
  const double a = t.between(0, 1), b = t.between(0, 1);
  return mixing_call(a, b, t.between(0, 1));
}

/// Calls for all pairs, b fastest.
std::vector<ShaderInput> all_pairs(float part) {
  std::vector<ShaderInput> calls;
  for (int a = 0; a < thresholds_a_side; ++a)
    for (int b = 0; b < thresholds_a_side; ++b)
      calls.push_back(mixing_call(double(grid_threshold(a)), double(grid_threshold(b)), double(part)));
  return calls;
}

/// How often (1 - part) * a + part * b is below this one: the area of the unit square below a line. That of a half
/// plane from a corner is a triangle; two of them reach beyond the sides.
double exact_mixture(const ShaderInput& in) {
  const double a = double(in[0].x), b = double(in[0].y), part = double(in[0].z), rest = 1 - part;
  const double mean = rest * a + part * b;
  if (std::min(part, rest) < 1e-9) return mean;
  const auto triangle = [](double side) { return side > 0 ? side * side : 0.0; };
  return (triangle(mean) - triangle(mean - part) - triangle(mean - rest) + triangle(mean - 1)) / (2 * part * rest);
}

/// How far the thresholds of all pairs are from being even over 0..1.
double uneven_by(Values thresholds) {
  if (has_nan(thresholds)) return double(INFINITY);
  std::ranges::sort(thresholds);
  double worst = 0;
  for (std::size_t i = 0; i < thresholds.size(); ++i)
    worst = std::max(worst, std::abs(thresholds[i] - (double(i) + 0.5) / double(thresholds.size())));
  return worst;
}

/// By how much the threshold falls, at most, where b, or a, takes the next value of the grid.
double largest_fall(const Values& thresholds, std::size_t step) {
  double fall = 0;
  for (std::size_t i = step; i < thresholds.size(); ++i)
    if (step > 1 || i % thresholds_a_side != 0) fall = worse_of(fall, thresholds[i - step] - thresholds[i]);
  return fall;
}

}  // namespace

void add_mixed_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("mixed_threshold (GLSL)");
  const ShaderFunction function = dither_function({"s"}, "vec4(mixed_threshold(s.x, s.y, s.z))");
  const Bound bound{8 * rounding_unit, "absolute",
                    "the mean's three roundings count up to twice; a square, two products, and a quotient, which "
                    "drivers round to 2.5 of its last places"};
  const auto error = [](const ShaderInput& in, const glm::vec4& out) {
    return std::abs(double(out.x) - exact_mixture(in));
  };
  for (const float part : {0.0f, denormal, 1e-30f, 1e-7f, 1e-3f, 0.1f, 0.25f, 1.0f / 3, 0.5f - 0x1p-25f, 0.5f,
                           0.5f + 0x1p-24f, 0.75f, 0.9f, 0.999f, 1 - 1e-6f, 1 - 0x1p-24f, 1.0f}) {
    const auto words = [=](const char* what) { return fmt::format("a part of {:.9g}: {}", part, what); };
    const auto pairs = [=, &shaders] { return shaders.numbers(function, all_pairs(part)); };
    group.close(words("16384 pairs, even over 0..1"),
                {1.0 / thresholds_a_side, "absolute",
                 "128 values of each stand for all; equal means come up to 128 times, in steps of up to 1/128"},
                [=] { return uneven_by(pairs()); });
    group.close(words("16384 pairs, by areas in the unit square"), bound, [=] {
      const std::vector<ShaderInput> calls = all_pairs(part);
      Values expected;
      for (const ShaderInput& in : calls) expected.push_back(exact_mixture(in));
      return difference(pairs(), expected);
    });
    group.equals(words("16384 pairs, those outside of 0..1"), [=] { return Values{count_outside(pairs(), 0, 1)}; },
                 {0});
    group.close(words("by how much it falls where a or b grows by 1/128"), bound, [=] {
      const Values found = pairs();
      return std::max(largest_fall(found, 1), largest_fall(found, thresholds_a_side));
    });
  }
  for (const bool whole : {false, true})
    group.close(fmt::format("a part of {}: 10000 pairs give {}", whole ? 1 : 0, whole ? "b" : "a"),
                {2 * rounding_unit, "absolute", "drivers may mix as a + part * (b - a)"}, [=, &shaders] {
                  return worst_of_calls(
                      shaders, function, 10'000, 1040,
                      [=](Trial& t) {
                        const double a = t.between(0, 1), b = t.between(0, 1);
                        return mixing_call(a, b, whole ? 1 : 0);
                      },
                      [=](const ShaderInput& in, const glm::vec4& out) {
                        return std::abs(double(out.x) - double(whole ? in[0].y : in[0].x));
                      });
                });
  group.close("10000 random pairs and parts", bound,
              [=, &shaders] { return worst_of_calls(shaders, function, 10'000, 1041, some_mixture, error); });
  group.close("10000 random pairs, parts of 1e-30 to 1e-3", bound, [=, &shaders] {
    return worst_of_calls(
        shaders, function, 10'000, 1042,
        [](Trial& t) {
          const double a = t.between(0, 1), b = t.between(0, 1);
          return mixing_call(a, b, t.size_between(1e-30, 1e-3));
        },
        error);
  });
  group.close("10000 random pairs of 1e-30 to 1e-3, and as far below 1", bound, [=, &shaders] {
    return worst_of_calls(
        shaders, function, 10'000, 1043,
        [](Trial& t) {
          const double a = t.size_between(1e-30, 1e-3), b = t.size_between(1e-30, 1e-3);
          const bool high = t.between(0, 1) < 0.5;
          return mixing_call(high ? 1 - a : a, high ? 1 - b : b, t.between(0, 1));
        },
        error);
  });
  const auto against = [=, &shaders](auto other, auto expected) {
    std::vector<ShaderInput> calls, others;
    for (int i = 0; i < 10'000; ++i) {
      Trial t(1044, i);
      calls.push_back(some_mixture(t));
      others.push_back(other(calls.back()[0]));
    }
    const Values found = shaders.numbers(function, calls), found_others = shaders.numbers(function, others);
    double worst = 0;
    for (std::size_t i = 0; i < calls.size(); ++i)
      worst = worse_of(worst, std::abs(found_others[i] - expected(found[i])));
    return worst;
  };
  const Bound twice{2 * bound.value, "absolute", "two thresholds, with the bound of the others each"};
  group.close("10000 random calls, a and b exchanged, the part that of a: the same", twice, [=] {
    return against([](const glm::vec4& s) { return mixing_call(double(s.y), double(s.x), 1 - double(s.z)); },
                   [](double found) { return found; });
  });
  group.close("10000 random calls, 1 - a and 1 - b: 1 less the threshold", twice, [=] {
    return against([](const glm::vec4& s) { return mixing_call(1 - double(s.x), 1 - double(s.y), double(s.z)); },
                   [](double found) { return 1 - found; });
  });
  group.close("10000 random calls, other pairs of the same mean: the same", twice, [=] {
    return against(
        [](const glm::vec4& s) {
          const double part = double(s.z), mean = (1 - part) * double(s.x) + part * double(s.y);
          return mixing_call(mean, mean, part);
        },
        [](double found) { return found; });
  });
  add_nan_row(group, shaders, function, mixing_call(0.3, 0.8, 0.4));
}

}  // namespace atelier::stability
