// The shader's clip_position and world_position, and the whole way from an object to its pixel far from the origin:
// with matrices of world space, and relative to the camera. Both are computed by the driver.
#include "stability/01-transforms/exact.hpp"
#include "stability/01-transforms/rows.hpp"

namespace atelier::stability {

namespace {

const std::string include = text_including("01-transforms/transforms.glsl");

const ShaderFunction clip_function{
    include,
    {"p0", "p1", "p2", "p3", "v0", "v1", "v2", "v3", "m0", "m1", "m2", "m3", "position"},
    "clip_position(mat4(p0, p1, p2, p3), mat4(v0, v1, v2, v3), mat4(m0, m1, m2, m3), position.xyz)"};

/// A camera like that of a game: 60 degrees, 640x480, looking at a still life of 64 corners within a metre.
constexpr glm::vec4 viewport(0, 0, 640, 480);
constexpr float fov_y = 1.0471976f, near = 0.1f, far = 100;
const glm::dvec3 eye_from_origin(1.5, 2.25, 4.125), target_from_origin(0.25, 0.5, -0.125);

std::vector<glm::vec3> corners() {
  std::vector<glm::vec3> out;
  for (int i = 0; i < 64; ++i) out.emplace_back(Trial(60, i).in_cube(1));
  return out;
}

/// Where a corner appears, in double precision, wherever the world stands.
glm::dvec2 exact_pixel(const glm::dvec3& corner) {
  const glm::dvec3 p = exact::in_view(eye_from_origin, target_from_origin, {0, 1, 0}, corner);
  const double top = std::tan(double(fov_y) / 2);
  const glm::dvec2 device(p.x / (-p.z * top * viewport.z / viewport.w), p.y / (-p.z * top));
  return (device + 1.0) / 2.0 * glm::dvec2(viewport.z, viewport.w);
}

}  // namespace

/// The largest error of a corner in pixels, with the whole scene moved by `offset` metres along x and z.
double world_offset_error(ShaderFunctions& shaders, double offset, bool relative) {
  const glm::dvec3 origin(offset, 0, offset), eye = eye_from_origin + origin;
  // Relative to the eye everything is near the origin before it becomes floats; otherwise it is rounded where it
  // stands.
  const auto as_float = [&](const glm::dvec3& p) {
    return relative ? transforms::relative_to_eye(p, eye) : glm::vec3(p);
  };
  const glm::mat4 projection = transforms::perspective(fov_y, viewport.z / viewport.w, near, far);
  const glm::mat4 view = transforms::look_at(as_float(eye), as_float(target_from_origin + origin), {0, 1, 0});
  const glm::mat4 model = transforms::translation(as_float(origin));
  std::vector<ShaderInput> inputs;
  for (const glm::vec3& corner : corners()) inputs.push_back(input_of(projection, view, model, corner));
  const std::vector<glm::vec4> clips = shaders.evaluate(clip_function, inputs);
  double worst = 0;
  for (std::size_t i = 0; i < clips.size(); ++i) {
    const glm::dvec2 pixel(transforms::window_position(clips[i], viewport));
    worst = std::max(worst, glm::length(pixel - exact_pixel(corners()[i])));
  }
  return worst;
}

namespace {

Sweep world_offset_sweep(ShaderFunctions& shaders) {
  Sweep sweep{.name = "world-offset",
              .title = "Where a pixel goes as the world moves away from its origin",
              .x_label = "distance of the scene from the origin, m",
              .y_label = "largest error on a picture of 640x480, pixels",
              .curves = {{"matrices of world space", {}}, {"relative to the camera", {}}}};
  for (int step = 0; step <= 28; ++step) {
    const double offset = std::pow(10.0, step / 4.0);
    for (const bool relative : {false, true})
      sweep.curves[relative].points.push_back({offset, world_offset_error(shaders, offset, relative)});
  }
  return sweep;
}

void add_offset_shader_rows(Table& table, ShaderFunctions& shaders) {
  Group clip = table.of("clip_position (GLSL)");
  const glm::mat4 one(1.0f);
  const auto with_model = [=, &shaders](const glm::mat4& model, const glm::vec3& p) {
    return values(shaders.evaluate(clip_function, input_of(one, one, model, p)));
  };
  clip.equals("a model flattened to a point",
              [=] {
                return with_model(transforms::scaling({0, 0, 0}), {1, 2, 3});
              },
              {0, 0, 0, 1});
  clip.equals("a position 1e30 m away, and nothing to do", [=] { return with_model(one, glm::vec3(1e30f)); },
              {double(1e30f), double(1e30f), double(1e30f), 1});
  clip.equals("a point on the eye: w = 0",
              [&shaders] {
                const glm::mat4 projection = transforms::perspective(1, 1, 0.1f, 10);
                return Values{double(
                    shaders.evaluate(clip_function, input_of(projection, glm::mat4(1), glm::mat4(1), glm::vec3(0))).w)};
              },
              {0});
  clip.nan("a model with a NaN", [=] { return with_model(glm::mat4(not_a_number), {1, 2, 3}); });

  Group world = table.of("world_position (GLSL)");
  const auto world_position = [&shaders](const glm::vec3& offset, const glm::vec3& p) {
    const ShaderFunction function{include,
                                  {"offset", "position"},
                                  "vec4(world_position(mat4(vec4(1, 0, 0, 0), vec4(0, 1, 0, 0), vec4(0, 0, 1, 0), "
                                  "vec4(offset.xyz, 1)), position.xyz), 0.0)"};
    return Values(values(glm::vec3(shaders.evaluate(function, input_of(offset, p)))));
  };
  world.equals("an offset of 1e6 m, steps of 1/16 m: all that floats hold there",
               [=] {
                 return world_position({1e6f, -1e6f, 0}, {0.0625f, 0.0625f, 0.0625f});
               },
               {1e6 + 0.0625, -1e6 + 0.0625, 0.0625});
  world.equals(
      "an offset of 1e30 m",
      [=] {
        return world_position(glm::vec3(1e30f), {1, 2, 3});
      },
      Values(3, double(1e30f)));
  world.nan("a position of NaN", [=] { return world_position({}, glm::vec3(not_a_number)); });
}

}  // namespace

void add_world_offset_rows(Table& table, ShaderFunctions& shaders) {
  add_offset_shader_rows(table, shaders);
  Group group = table.of("from object to pixel");
  for (const double offset : {0.0, 1.0, 1e3, 1e6, 1e7})
    group.close(
        fmt::format("{:g} m from the origin, relative to the camera", offset),
        {1e-3, "pixels", "640 pixels, and some twenty roundings on the way from the corner to its pixel: 0.0008"},
        [=, &shaders] { return world_offset_error(shaders, offset, true); });
  group.close("1e4 m from the origin, matrices of world space",
              {0.5, "pixels",
               "floats lie 0.001 m apart there, so each of eye, model, sum and view is off by 0.07 pixels of "
               "0.007 m, along two axes"},
              [&shaders] { return world_offset_error(shaders, 1e4, false); });
  group.equals("1e6 m from the origin, matrices of world space: the trouble is real",
               [&shaders] { return Values{double(world_offset_error(shaders, 1e6, false) > 0.5)}; }, {1});
  table.sweeps.push_back([&shaders] { return world_offset_sweep(shaders); });
}

}  // namespace atelier::stability
