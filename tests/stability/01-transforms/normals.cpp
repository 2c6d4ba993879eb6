// normal_matrix and the shader's world_normal: flattened, mirrored, tiny and enormous models.
#include "stability/01-transforms/exact.hpp"
#include "stability/01-transforms/rows.hpp"

namespace atelier::stability {

using transforms::normal_matrix;

namespace {

glm::mat4 scaled(const glm::vec3& f) {
  return {f.x, 0, 0, 0, 0, f.y, 0, 0, 0, 0, f.z, 0, 0, 0, 0, 1};
}

/// Degrees between the normal of the moved surface and what the matrix makes of the normal of the one that stood still.
double normal_error(const glm::mat4& model, const glm::dvec3& t1, const glm::dvec3& t2) {
  const glm::dvec3 by_matrix = glm::dmat3(normal_matrix(model)) * glm::cross(t1, t2);
  return degrees_between(by_matrix, exact::normal(glm::dmat3(model), t1, t2));
}

/// The worst over surfaces that face along the diagonals.
double normal_error(const glm::mat4& model) {
  double worst = 0;
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0}) worst = std::max(worst, normal_error(model, {1, 0, -x}, {0, 1, -y}));
  return worst;
}

const Bound angle_bound{2e-5, "degrees",
                        "three roundings of an entry are 2e-7 rad, 1e-5 degrees, at most twice that across"};

void add_matrix_rows_of_normals(Table& table) {
  Group group = table.of("normal_matrix");
  for (const float size : {denormal, 1e-30f, 1e-10f, 1e10f, 1e30f, largest_float / 2})
    group.close(
        fmt::format("a model scaled by {:.0e}", size),
        size == denormal ? Bound{1e-2, "degrees", "1e-40 is 71 362 of the smallest floats: five digits"} : angle_bound,
        [=] { return normal_error(scaled(size * glm::vec3(1, 2, 0.5f))); });
  group.close("mirrored along x", angle_bound, [] { return normal_error(scaled({-1, 1, 1})); });
  group.close("mirrored along all three", angle_bound, [] { return normal_error(scaled({-2, -1, -3})); });
  group.close("factors of 1e-6, 1 and 1e6", angle_bound, [] { return normal_error(scaled({1e-6f, 1, 1e6f})); });
  group.close("mirrored, with factors of -1, 1e-10 and 1e-10", angle_bound, [] {
    return normal_error(scaled({-1, 1e-10f, 1e-10f}), {0, 1, 0}, {0, 0, 1});
  });
  group.close("sheared by 1e4", {2e-5, "degrees", "as without shear: no entry cancels"}, [] {
    glm::mat4 m(1.0f);
    m[1][0] = 1e4f;
    return normal_error(m, {0, 1, 0}, {0, 0, 1});
  });
  group.same(
      "the offset has no part in it",
      [] {
        glm::mat4 m = scaled({1, 2, 3});
        m[3] = glm::vec4(1e30f, -1e30f, 1e30f, 1);
        return values(normal_matrix(m));
      },
      [] {
        return values(normal_matrix(scaled({1, 2, 3})));
      });
  group.close("flattened along y: the plane's own normal is left", angle_bound, [] {
    return normal_error(scaled({2, 0, 3}), {1, 0, 0}, {0, 0, 1});
  });
  group.equals("a determinant of zero counts as +",
               [] {
                 const glm::vec3 up = normal_matrix(scaled({1, 0, 1})) * glm::vec3(0, 1, 0);
                 return Values{double(up.x), double(up.y > 0), double(up.z)};
               },
               {0, 1, 0});
  group.equals(
      "two factors zero: nothing is left",
      [] {
        return values(normal_matrix(scaled({5, 0, 0})));
      },
      values(glm::mat3(0.0f)));
  group.equals(
      "all factors zero",
      [] {
        return values(normal_matrix(scaled({0, 0, 0})));
      },
      values(glm::mat3(0.0f)));
  group.finite("factors of 1e38, 1 and 1e-38", [] { return values(normal_matrix(scaled({1e38f, 1, 1e-38f}))); });
  group.nan("an entry of NaN", [] { return values(normal_matrix(scaled({not_a_number, 1, 1}))); });
  group.close("3000 random models: square to the moved tangents",
              {3e-3, "degrees",
               "three factors of 1/30 to 30 and two turns: entries cancel to a 900th of themselves; "
               "900 times three roundings are 1.6e-4 rad at the very worst, a third of that among 3000"},
              [] {
                return worst_of(3000, 40, [](Trial& t) {
                  const auto factor = [&] { return t.sign() * t.size_between(1.0 / 30, 30); };
                  const glm::dvec3 factors(factor(), factor(), factor());
                  glm::dmat3 m = exact::rotation(t.direction(), t.between(-3, 3));
                  for (int i = 0; i < 3; ++i) m[i] *= factors[i];
                  m = exact::rotation(t.direction(), t.between(-3, 3)) * m;
                  return normal_error(glm::mat4(glm::mat3(m)), t.direction(), t.direction());
                });
              });
}

void add_normal_shader_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("world_normal (GLSL)");
  const auto world_normal = [&shaders](const glm::mat3& m, const glm::vec3& normal) {
    const ShaderFunction function{text_including("01-transforms/transforms.glsl"),
                                  {"m0", "m1", "m2", "normal"},
                                  "vec4(world_normal(mat3(m0.xyz, m1.xyz, m2.xyz), normal.xyz), 0.0)"};
    return glm::vec3(shaders.evaluate(function, input_of(m, normal)));
  };
  const glm::vec3 oblique(0.36f, 0.48f, 0.8f);
  const Bound unit{1e-6, "absolute", "inversesqrt is good to 2 ulp on every driver seen, 2.4e-7, beside 4 roundings"};
  group.equals(
      "a matrix of zeros: the normal stays", [=] { return values(world_normal(glm::mat3(0.0f), oblique)); },
      values(oblique));
  group.equals("nothing is left of just this normal: it stays",
               [=] {
                 return values(world_normal(glm::mat3(0, 0, 0, 0, 1, 0, 0, 0, 1), {1, 0, 0}));
               },
               {1, 0, 0});
  group.equals("a normal of zero", [=] { return values(world_normal(glm::mat3(1.0f), {0, 0, 0})); }, {0, 0, 0});
  for (const float size : {1e-15f, 1e-6f, 1e6f, 1e15f})
    group.close(fmt::format("a matrix scaled by {:.0e}", size), unit,
                [=] { return difference(values(world_normal(glm::mat3(size), oblique)), values(oblique)); });
  for (const float size : {1e-22f, 1e-30f, denormal})
    group.close(fmt::format("a matrix scaled by {:.0e}, whose square is no float: still a unit vector", size), unit,
                [=] { return std::abs(glm::length(glm::dvec3(world_normal(glm::mat3(size), oblique))) - 1); });
}

}  // namespace

void add_normal_rows(Table& table, ShaderFunctions& shaders) {
  add_matrix_rows_of_normals(table);
  add_normal_shader_rows(table, shaders);
}

}  // namespace atelier::stability
