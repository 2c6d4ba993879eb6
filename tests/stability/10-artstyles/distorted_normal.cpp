// distorted_normal: lenses that change nothing, stretch or shrink a thousand times, turn, mirror; grazing normals.
#include "stability/10-artstyles/rows.hpp"

namespace atelier::stability {

namespace {

/// A call: the normal, then the derivatives of the source by x and by y.
ShaderInput normal_call(const glm::vec3& normal, const glm::dvec2& by_x, const glm::dvec2& by_y) {
  return input_of(normal, glm::vec2(by_x), glm::vec2(by_y));
}

/// By the slopes of the height: those of the distorted one are sums of products with the derivatives of the source.
glm::dvec3 exact_normal(const ShaderInput& in) {
  const glm::dvec3 n(in[0]);
  const glm::dvec2 slope = -glm::dvec2(n) / n.z;
  const double along = slope.x * double(in[1].x) + slope.y * double(in[1].y);
  const double up = slope.x * double(in[2].x) + slope.y * double(in[2].y);
  return glm::normalize(glm::dvec3(-along, -up, 1));
}

/// As a share of what roundings allow: where the products cancel, theirs count more.
double normal_error(const ShaderInput& in, const glm::vec4& out) {
  const glm::dvec3 n(in[0]);
  const glm::dmat2 jacobian{glm::dvec2(glm::vec2(in[1])), glm::dvec2(glm::vec2(in[2]))};
  const glm::dvec2 sums(glm::dot(glm::abs(glm::dvec2(n)), glm::abs(jacobian[0])),
                        glm::dot(glm::abs(glm::dvec2(n)), glm::abs(jacobian[1])));
  const double length = glm::length(glm::dvec3(glm::dvec2(n) * jacobian, n.z));
  const double allowed = rounding_unit * (3 * glm::length(sums) / length + 8);
  return glm::length(glm::dvec3(out) - exact_normal(in)) / allowed;
}

glm::vec3 random_normal(Trial& t) {
  glm::dvec3 n = t.direction();
  n.z = std::abs(n.z);
  return glm::vec3(n.z > 1e-6 ? n : glm::dvec3(0, 0, 1));
}

/// A grazing one: z as given.
glm::vec3 grazing_normal(Trial& t, double z) {
  const double a = t.between(0, 2 * std::numbers::pi), across = std::sqrt(1 - z * z);
  return glm::vec3(across * std::cos(a), across * std::sin(a), z);
}

/// Turned, stretched along two axes by up to `most` or 1 / most, turned again, half of them mirrored.
std::array<glm::dvec2, 2> random_jacobian(Trial& t, double most) {
  const double a = t.between(0, 2 * std::numbers::pi), b = t.between(0, 2 * std::numbers::pi);
  const auto turn = [](double angle) {
    return glm::dmat2{glm::dvec2(std::cos(angle), std::sin(angle)), glm::dvec2(-std::sin(angle), std::cos(angle))};
  };
  const double x = t.size_between(1 / most, most) * t.sign(), y = t.size_between(1 / most, most);
  const glm::dmat2 jacobian = turn(a) * glm::dmat2{glm::dvec2(x, 0), glm::dvec2(0, y)} * turn(b);
  return {jacobian[0], jacobian[1]};
}

}  // namespace

void add_distorted_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("distorted_normal (GLSL)");
  const ShaderFunction function =
      style_function({"n", "by_x", "by_y"}, "vec4(distorted_normal(n.xyz, mat2(by_x.xy, by_y.xy)), 0.0)");
  const auto of = [=, &shaders](const ShaderInput& in) { return values(glm::vec3(shaders.evaluate(function, in))); };
  const Bound bound{1, "of what roundings allow",
                    "two products and their sum, of which each may be larger than the result where they cancel, and a "
                    "length and its inverse, good to a few of their last places"};
  const Bound length_bound{6 * rounding_unit, "absolute",
                           "a length and its inverse, good to a few of their last places"};
  for (const double size : {1e-3, 1.0, 1e3})
    group.equals(fmt::format("a flat relief, a lens that stretches by {:g} or turns or mirrors: flat", size),
                 [=] {
                   Values all = of(normal_call({0, 0, 1}, {size, 0}, {0, size}));
                   for (const double v : of(normal_call({0, 0, 1}, {0, -size}, {size, 0}))) all.push_back(v);
                   for (const double v : of(normal_call({0, 0, 1}, {size, size}, {-size, size}))) all.push_back(v);
                   return all;
                 },
                 {0, 0, 1, 0, 0, 1, 0, 0, 1});
  group.equals("a source that does not change: flat",
               [=] {
                 return of(normal_call({0.6f, 0, 0.8f}, {0, 0}, {0, 0}));
               },
               {0, 0, 1});
  group.close("no distortion: 10000 random normals are themselves", length_bound, [=, &shaders] {
    return worst_of_calls(
        shaders, function, 10'000, 1190,
        [](Trial& t) {
          return normal_call(random_normal(t), {1, 0}, {0, 1});
        },
        [](const ShaderInput& in, const glm::vec4& out) {
          const glm::dvec3 n(in[0]);
          return glm::length(glm::dvec3(out) - glm::normalize(n));
        });
  });
  for (const double most : {1.0, 10.0, 1e3}) {
    group.close(fmt::format("10000 random normals, lenses that stretch or shrink up to {:g} times", most), bound,
                [=, &shaders] {
                  return worst_of_calls(
                      shaders, function, 10'000, 1191,
                      [=](Trial& t) {
                        const glm::vec3 n = random_normal(t);
                        const auto [by_x, by_y] = random_jacobian(t, most);
                        return normal_call(n, by_x, by_y);
                      },
                      normal_error);
                });
    group.close(fmt::format("the same, normals of z = 1e-6 and 1e-3: up to {:g} times", most), bound, [=, &shaders] {
      return worst_of_calls(
          shaders, function, 10'000, 1192,
          [=](Trial& t) {
            const glm::vec3 n = grazing_normal(t, t.sign() > 0 ? 1e-6 : 1e-3);
            const auto [by_x, by_y] = random_jacobian(t, most);
            return normal_call(n, by_x, by_y);
          },
          normal_error);
    });
    group.close(fmt::format("the lengths of these normals: up to {:g} times", most), length_bound, [=, &shaders] {
      return worst_of_calls(
          shaders, function, 10'000, 1193,
          [=](Trial& t) {
            const glm::vec3 n = t.sign() > 0 ? random_normal(t) : grazing_normal(t, 1e-6);
            const auto [by_x, by_y] = random_jacobian(t, most);
            return normal_call(n, by_x, by_y);
          },
          [](const ShaderInput&, const glm::vec4& out) {
            return out.z >= 0 ? std::abs(glm::length(glm::dvec3(out)) - 1) : double(INFINITY);
          });
    });
  }
  group.close("x and y changed for each other, and mirrored", length_bound, [=] {
    double worst =
        difference(of(normal_call({0.48f, 0.6f, 0.64f}, {0, 1}, {1, 0})), {double(0.6f), double(0.48f), 0.64});
    worst = worse_of(worst, difference(of(normal_call({0.48f, 0.6f, 0.64f}, {-1, 0}, {0, 1})), {-0.48, 0.6, 0.64}));
    return worse_of(worst, difference(of(normal_call({0.48f, 0.6f, 0.64f}, {0, -1}, {1, 0})), {-0.6, 0.48, 0.64}));
  });
  add_nan_row(group, shaders, function, normal_call({0.48f, 0.6f, 0.64f}, {1.5, 0.2}, {-0.3, 2}));
}

}  // namespace atelier::stability
