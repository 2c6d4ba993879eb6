// translation, rotation, scaling, compose.
#include "scene/box.hpp"
#include "stability/01-transforms/exact.hpp"
#include "stability/01-transforms/rows.hpp"

namespace atelier::stability {

using namespace transforms;

namespace {

glm::mat4 diagonal(float x, float y, float z) {
  glm::mat4 m(1.0f);
  m[0][0] = x, m[1][1] = y, m[2][2] = z;
  return m;
}

void add_translation_rows(Table& table) {
  Group group = table.of("translation");
  group.equals(
      "no offset",
      [] {
        return values(translation({0, 0, 0}));
      },
      values(glm::mat4(1.0f)));
  for (const float size : {denormal, 1e6f, largest_float}) {
    const glm::vec3 offset(size, -size, size);
    group.equals(
        fmt::format("an offset of {:.1e} m: the origin goes there", size),
        [=] { return values(translation(offset) * glm::vec4(0, 0, 0, 1)); }, values(glm::vec4(offset, 1)));
    group.equals(fmt::format("an offset of {:.1e} m: a direction stays", size),
                 [=] { return values(translation(offset) * glm::vec4(1, 2, 3, 0)); }, {1, 2, 3, 0});
  }
  group.nan("an offset of NaN", [] { return values(translation({not_a_number, 0, 0})); });
}

/// The largest error of an entry.
double rotation_error(const glm::vec3& axis, float angle) {
  return difference(values(glm::mat3(rotation(axis, angle))), values(exact::rotation(axis, angle)));
}

void add_rotation_rows(Table& table) {
  Group group = table.of("rotation");
  const Bound entry{6 * rounding_unit, "absolute",
                    "an entry, at most 1, comes of the unit axis (two roundings a component), a product and a sum"};
  group.equals(
      "an axis of length zero",
      [] {
        return values(rotation({0, 0, 0}, 1));
      },
      values(glm::mat4(1)));
  group.equals(
      "an angle of zero",
      [] {
        return values(rotation({1, 2, 3}, 0));
      },
      values(glm::mat4(1)));
  for (const float size : {1e-18f, 1e-10f, 1e10f, 1e18f})
    group.close(fmt::format("an axis {:.0e} m long", size), entry,
                [=] { return rotation_error(size * glm::vec3(0.36f, 0.48f, 0.8f), 1.25f); });
  group.close("an axis of (1, 1e-25, 0)", entry, [] { return rotation_error({1, 1e-25f, 0}, 1); });
  for (const float angle : {float(std::numbers::pi), -100.0f, 1e3f, 1e6f, 1e20f})
    group.close(fmt::format("an angle of {:g} rad", angle), entry, [=] { return rotation_error({1, 2, 3}, angle); });
  group.close("an angle of 1e-20 rad: its sine is not lost",
              {3 * rounding_unit, "relative", "the sine is the angle; the axis and a product are rounded"}, [] {
                return each_relative({rotation({0, 0, 2}, 1e-20f)[0][1]}, {double(1e-20f)});
              });
  group.nan("an infinite angle", [] { return values(rotation({0, 0, 1}, infinite)); });
  group.nan("an axis with a NaN", [] { return values(rotation({not_a_number, 0, 1}, 1)); });
  group.close("2000 random axes of 1e-15 to 1e15 m, and angles: rigid",
              {24 * rounding_unit, "absolute",
               "two columns whose entries are 6 roundings off each: 12 sqrt(3) at most, and the determinant likewise"},
              [] {
                return worst_of(2000, 1, [](Trial& t) {
                  const glm::dvec3 axis = t.size_between(1e-15, 1e15) * t.direction();
                  return not_rigid(rotation(axis, float(t.between(-10, 10))));
                });
              });
  group.close("2000 random axes and angles: there and back is the identity",
              {24 * rounding_unit, "absolute", "two rotations of 6 roundings an entry: 12 sqrt(3) at most"}, [] {
                return worst_of(2000, 2, [](Trial& t) {
                  const glm::vec3 axis(t.in_cube(2));
                  const float angle = float(t.between(-4, 4));
                  const glm::dmat4 there(rotation(axis, angle)), back(rotation(axis, -angle));
                  return difference(values(there * back), values(glm::dmat4(1)));
                });
              });
}

void add_scaling_rows(Table& table) {
  Group group = table.of("scaling");
  const std::pair<const char*, glm::vec3> extremes[] = {{"all factors zero", {0, 0, 0}},
                                                        {"one factor zero", {2, 0, 3}},
                                                        {"negative factors", {-1, -2, -3}},
                                                        {"a denormal factor", {denormal, 1, 1}},
                                                        {"the largest floats", glm::vec3(largest_float)}};
  for (const auto& [words, f] : extremes)
    group.equals(
        words, [f = f] { return values(scaling(f)); }, values(diagonal(f.x, f.y, f.z)));
  group.nan("a factor of NaN", [] { return values(scaling({1, not_a_number, 1})); });
}

/// Where compose takes the corners of a cube, held against scaling, turning and moving them one after the other. As a
/// share of how far they may go.
double compose_error(const glm::vec3& offset, const glm::vec3& axis, float angle, const glm::vec3& factors) {
  const glm::dmat4 m(compose(offset, axis, angle, factors));
  double worst = 0;
  for (const glm::dvec3& p : corners_of(Box3{glm::dvec3(-1), glm::dvec3(1)})) {
    const glm::dvec3 expected = exact::rotated(axis, angle, p * glm::dvec3(factors)) + glm::dvec3(offset);
    const glm::dvec3 size = glm::abs(glm::dvec3(offset)) + glm::length(glm::dvec3(factors));
    worst = std::max(worst, difference(values(glm::dvec3(m * glm::dvec4(p, 1)) / size), values(expected / size)));
  }
  return worst;
}

void add_compose_rows(Table& table) {
  Group group = table.of("compose");
  const Bound bound{12 * rounding_unit, "of |offset| + |factors|",
                    "three entries of 4 roundings each, scaled, in a sum; the offset is not rounded"};
  group.close("an offset of 1e6 m, factors of 1e-3", bound, [] {
    return compose_error({1e6f, -1e6f, 3}, {1, 2, 3}, 1, {1e-3f, 2e-3f, 3e-3f});
  });
  group.close("factors of 1e-20, 1 and 1e20", bound, [] {
    return compose_error({1, 2, 3}, {0, 1, 1}, 2, {1e-20f, 1, 1e20f});
  });
  group.close("negative factors", bound, [] { return compose_error({1, 2, 3}, {1, 0, 1}, 3, {-1, 1, -2}); });
  group.finite("all factors zero, no axis", [] { return values(compose({1, 2, 3}, {0, 0, 0}, 1, {0, 0, 0})); });
  group.close("2000 random placements: scale, then rotate, then translate", bound, [] {
    return worst_of(2000, 3, [](Trial& t) {
      const glm::dvec3 factors(t.sign() * t.size_between(1e-3, 1e3), t.sign() * t.size_between(1e-3, 1e3), 1);
      return compose_error(t.size_between(1e-3, 1e6) * t.direction(), t.direction(), float(t.between(-7, 7)), factors);
    });
  });
}

}  // namespace

void add_matrix_rows(Table& table) {
  add_translation_rows(table);
  add_rotation_rows(table);
  add_scaling_rows(table);
  add_compose_rows(table);
}

}  // namespace atelier::stability
