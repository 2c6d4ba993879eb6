// light_view, light_projection, bias_matrix and depth_pass_position: straight down, far away, flat as paper.
#include "stability/03-shadow-mapping/rows.hpp"

namespace atelier::stability {

using namespace shadow_mapping;

namespace {

/// The light's way in its own space, which is -z.
double off_axis(const glm::vec3& eye, const glm::vec3& direction) {
  const glm::dvec3 seen(glm::dmat4(light_view({.eye = eye, .direction = direction})) *
                        glm::dvec4(glm::dvec3(direction), 0));
  return difference(values(seen), {0, 0, -1});
}

void add_view_rows(Group& group) {
  const Bound bound{16 * rounding_unit, "absolute", "axes of a cross product and two normalisations, multiplied"};
  for (const glm::vec3& direction : {glm::vec3(0, -1, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1), glm::vec3(1, 0, 0)})
    group.close(fmt::format("along ({:g}, {:g}, {:g}): rigid, and that way", direction.x, direction.y, direction.z),
                bound,
                [=] { return std::max(not_rigid(light_view({.direction = direction})), off_axis({}, direction)); });
  for (const float distance : {1e3f, 1e6f, 1e9f})
    group.close(fmt::format("a light {:g} m from the origin keeps its direction", distance), bound,
                [=] { return off_axis(glm::vec3(distance, 5, -distance), glm::normalize(glm::vec3(1, -3, 0.5f))); });
  group.close("a million metres from the origin: where the eye comes to lie",
              {8 * rounding_unit, "of its distance", "three products of an axis and the eye, summed"}, [] {
                const glm::vec3 eye(1e6f, 5, -1e6f);
                const LightFrustum frustum{.eye = eye, .direction = glm::normalize(glm::vec3(1, -3, 0.5f))};
                return glm::length(glm::dvec3(glm::dmat4(light_view(frustum)) * glm::dvec4(glm::dvec3(eye), 1))) /
                       glm::length(glm::dvec3(eye));
              });
}

/// Depth, -1 to 1, of a point this far before the light.
double depth_at(const LightFrustum& frustum, double distance) {
  const glm::dvec4 clip = glm::dmat4(light_projection(frustum)) * glm::dvec4(0, 0, -distance, 1);
  return clip.z / clip.w;
}

/// Where the edge of what the light sees comes to lie, which should be 1.
double edge_at(const LightFrustum& frustum, double distance) {
  const double half = frustum.orthographic ? double(frustum.extent) : distance * std::tan(double(frustum.extent));
  const glm::dvec4 clip = glm::dmat4(light_projection(frustum)) * glm::dvec4(half, -half, -distance, 1);
  return std::max(std::abs(clip.x / clip.w - 1), std::abs(clip.y / clip.w + 1));
}

void add_projection_rows(Group& group) {
  const struct {
    const char* words;
    LightFrustum frustum;
  } cases[] = {
      {"a spot of 0.001 rad", {.extent = 0.001f, .near = 1, .far = 2}},
      {"a spot of 1.5 rad", {.extent = 1.5f, .near = 0.01f, .far = 10}},
      {"a spot from a micrometre to a millimetre", {.extent = 0.5f, .near = 1e-6f, .far = 1e-3f}},
      {"a spot from 1 km to 1000 km", {.extent = 0.5f, .near = 1e3f, .far = 1e6f}},
      {"a sun over a micrometre", {.orthographic = true, .extent = 1e-6f, .near = 0, .far = 2e-6f}},
      {"a sun over 1000 km", {.orthographic = true, .extent = 1e6f, .near = 0, .far = 2e6f}},
  };
  for (const auto& [words, frustum] : cases) {
    group.close(fmt::format("{}: its planes at -1 and 1", words),
                {2e-4, "absolute", "at the near plane z/w is a difference of numbers a thousand times as large"},
                [frustum = frustum] {
                  return std::max(std::abs(depth_at(frustum, double(frustum.near)) + 1),
                                  std::abs(depth_at(frustum, double(frustum.far)) - 1));
                });
    group.close(fmt::format("{}: its edges at 1", words),
                {64 * rounding_unit, "absolute", "the tangent of 1.5 rad is fourteen times as steep as its angle"},
                [frustum = frustum] { return edge_at(frustum, (double(frustum.near) + double(frustum.far)) / 2); });
  }
  group.refuses("a spot whose planes are one, as around a sphere without size",
                [] { light_projection({.extent = 0.5f, .near = 4, .far = 4}); });
}

void add_depth_pass_rows(Group& group, ShaderFunctions& shaders) {
  const auto position = [&shaders](const glm::mat4& model, const glm::mat4& view, const glm::mat4& projection,
                                   const glm::vec3& at) {
    ShaderFunction function{text_including("03-shadow-mapping/depth_pass.glsl", {},
                                           "uniform mat4 u_model, u_light_view, u_light_projection;\n"),
                            {"position"},
                            "depth_pass_position(position.xyz)"};
    function.uniforms = {
        {"u_model", values(model)}, {"u_light_view", values(view)}, {"u_light_projection", values(projection)}};
    return values(shaders.evaluate(function, input_of(at)));
  };
  const glm::mat4 one(1);
  const LightFrustum spot{.eye = {0, 2, 0}, .extent = 0.5f, .near = 0.5f, .far = 4};
  group.equals("a corner upon the light: w = 0",
               [=] {
                 return Values{position(one, light_view(spot), light_projection(spot), {0, 2, 0})[3]};
               },
               {0});
  group.equals("a model flattened to a point",
               [=] {
                 return position(glm::mat4(0), one, one, {1, 2, 3});
               },
               {0, 0, 0, 0});
  group.finite("a corner 1e30 m away",
               [=] { return position(one, light_view(spot), light_projection(spot), glm::vec3(1e30f)); });
  group.close("model and light a million metres from the origin: the corner's place in the map",
              {0.0625, "metres at the corner",
               "floats lie 1/16 m apart there; what is between corner and light is a difference of them"},
              [=] {
                const glm::vec3 far(1e6f, 0, -1e6f);
                LightFrustum there = spot;
                there.eye += far;
                glm::mat4 model(1);
                model[3] = glm::vec4(far, 1);
                const Values p = position(model, light_view(there), light_projection(there), {0.5f, 0, 0});
                return std::abs(std::abs(p[1]) / p[3] * 2 * std::tan(0.5) - 0.5);
              });
}

}  // namespace

void add_matrix_rows(Table& table, ShaderFunctions& shaders) {
  Group view = table.of("light_view");
  add_view_rows(view);
  Group projection = table.of("light_projection");
  add_projection_rows(projection);
  Group bias = table.of("bias_matrix");
  bias.equals("the corners of the cube", [] { return values(bias_matrix() * glm::vec4(-1, 1, -1, 1)); }, {0, 1, 0, 1});
  bias.equals("before the division, w = 1e-6 and 1e6",
              [] {
                Values both = values(bias_matrix() * glm::vec4(-1e-6f, 1e-6f, 0, 1e-6f));
                for (const double v : values(bias_matrix() * glm::vec4(1e6f, -1e6f, 0, 1e6f))) both.push_back(v);
                return both;
              },
              {0, double(1e-6f), double(0.5f * 1e-6f), double(1e-6f), 1e6, 0, 5e5, 1e6});
  Group pass = table.of("depth_pass_position (GLSL)");
  add_depth_pass_rows(pass, shaders);
}

}  // namespace atelier::stability
