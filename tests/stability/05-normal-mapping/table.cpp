// Step 05's table of extremes.
#include "05-normal-mapping/normal_mapping.hpp"
#include "oracle/tangents.hpp"
#include "scene/shapes.hpp"
#include "stability/entry.hpp"
#include "stability/rows.hpp"

namespace atelier::stability {

namespace {

using normal_mapping::Corner;
using normal_mapping::triangle_tangent;
using normal_mapping::vertex_tangents;

constexpr double unit_vector = 8 * rounding_unit;
const Bound roundings{unit_vector, "absolute", "a unit vector after some eight roundings"};

// ---- Triangles

struct Triangle {
  Corner a, b, c;
};

Values of(const Triangle& t) {
  return values(triangle_tangent(t.a, t.b, t.c));
}

/// A right-angled triangle along +x and +y with these lengths, in space and in the texture.
Triangle right_angled(float edge, float side) {
  return {{{0, 0, 0}, {0, 0}}, {{edge, 0, 0}, {side, 0}}, {{0, edge, 0}, {0, side}}};
}

void add_triangle_rows(Table& table) {
  Group group = table.of("triangle_tangent");
  const auto none = [&](const char* what, const Triangle& t) {
    group.equals(what, [=] { return of(t); }, {0, 0, 0, 0});
  };
  none("one texture coordinate at two corners", {{{0, 0, 0}, {0, 0}}, {{1, 0, 0}, {1, 1}}, {{0, 1, 0}, {1, 1}}});
  none("one texture coordinate at all corners", {{{0, 0, 0}, {1, 1}}, {{1, 0, 0}, {1, 1}}, {{0, 1, 0}, {1, 1}}});
  none("texture coordinates on a line", {{{0, 0, 0}, {0, 0}}, {{1, 0, 0}, {1, 2}}, {{0, 1, 0}, {2, 4}}});
  none("positions on a line", {{{0, 0, 0}, {0, 0}}, {{1, 1, 1}, {1, 0}}, {{3, 3, 3}, {0, 1}}});
  none("one position at two corners", {{{1, 2, 3}, {0, 0}}, {{1, 2, 3}, {1, 0}}, {{0, 1, 0}, {0, 1}}});
  none("one position at all corners", {{{1, 2, 3}, {0, 0}}, {{1, 2, 3}, {1, 0}}, {{1, 2, 3}, {0, 1}}});
  for (const float edge : {1e-18f, 1e-9f, 1.0f, 1e9f, 1e18f})
    for (const float side : {1e-18f, 1.0f, 1e18f})
      group.equals(fmt::format("edges of {:g} m and {:g} of the texture", edge, side),
                   [=] { return of(right_angled(edge, side)); }, {1, 0, 0, 1});
  group.equals("a mirrored texture",
               [] {
                 return of({{{0, 0, 0}, {0, 0}}, {{1, 0, 0}, {0, 1}}, {{0, 1, 0}, {1, 0}}});
               },
               {0, 1, 0, -1});
  group.close("a texture a thousand times narrower than high", roundings, [] {
    return difference(of({{{0, 0, 0}, {0, 0}}, {{1, 0, 0}, {1e-3f, 0}}, {{0, 1, 0}, {0, 1}}}), {1, 0, 0, 1});
  });
  group.close("a million metres from the origin", roundings, [] {
    return difference(of({{{1e6f, 1e6f, 0}, {0, 0}}, {{1e6f + 1, 1e6f, 0}, {1, 0}}, {{1e6f, 1e6f + 1, 0}, {0, 1}}}),
                      {1, 0, 0, 1});
  });
}

// ---- Meshes

/// The largest angle, degrees, from the truth in double precision, over all vertices; infinite where only one of both
/// has a tangent, or the signs differ.
double degrees_off(const Mesh& mesh) {
  const auto found = vertex_tangents(mesh);
  const auto truth = oracle::tangents_of(mesh);
  double worst = 0;
  for (std::size_t v = 0; v < truth.size(); ++v) {
    if (truth[v] == glm::dvec4(0) && found[v] == glm::vec4(0)) continue;
    if (double(found[v].w) != truth[v].w) return infinite;
    worst = std::max(worst, degrees_between(glm::dvec3(found[v]), glm::dvec3(truth[v])));
  }
  return worst;
}

/// The largest |cosine| between tangent and normal.
double off_perpendicular(const Mesh& mesh) {
  const auto found = vertex_tangents(mesh);
  double worst = 0;
  for (std::size_t v = 0; v < found.size(); ++v)
    worst = std::max(worst, std::abs(double(glm::dot(glm::vec3(found[v]), mesh.vertices[v].normal))));
  return worst;
}

Mesh in_other_order(Mesh mesh) {
  std::vector<std::uint32_t> indices;
  for (std::size_t at = mesh.indices.size(); at >= 3; at -= 3)
    for (const std::size_t k : {2, 0, 1}) indices.push_back(mesh.indices[at - 3 + k]);
  mesh.indices = indices;
  return mesh;
}

/// With a triangle without area at every triangle, and one without texture area.
Mesh with_degenerate(Mesh mesh) {
  const std::vector<std::uint32_t> indices = mesh.indices;
  for (std::size_t at = 0; at + 2 < indices.size(); at += 3)
    mesh.indices.insert(mesh.indices.end(), {indices[at], indices[at + 1], indices[at + 1]});
  return mesh;
}

double largest_change(const Mesh& mesh, const Mesh& other) {
  return difference(all_values(vertex_tangents(mesh)), all_values(vertex_tangents(other)));
}

void add_mesh_rows(Table& table) {
  Group group = table.of("vertex_tangents");
  struct Named {
    const char* name;
    Mesh mesh;
  };
  const std::vector<Named> meshes = {{"a sphere with its poles and seam", make_sphere({.segments = 24, .rings = 12})},
                                     {"a torus", make_torus({.segments = 24, .sides = 12})},
                                     {"a cone with its tip", make_cone({.segments = 7})},
                                     {"a teapot", make_teapot({.subdivisions = 4})}};
  for (const auto& [name, mesh] : meshes) {
    group.close(fmt::format("{}: the direction", name),
                {1e-4, "degrees", "sums of unit vectors with a few roundings each"},
                [mesh = mesh] { return degrees_off(mesh); });
    group.close(fmt::format("{}: perpendicular to the normal", name), roundings,
                [mesh = mesh] { return off_perpendicular(mesh); });
    group.close(fmt::format("{}: triangles in another order", name),
                {2e-6, "absolute", "the same sums in another order"},
                [mesh = mesh] { return largest_change(mesh, in_other_order(mesh)); });
    group.close(fmt::format("{}: with degenerate triangles", name), {1e-30, "absolute", "they take no part"},
                [mesh = mesh] { return largest_change(mesh, with_degenerate(mesh)); });
  }
  group.equals("no triangles", [] { return all_values(vertex_tangents(Mesh{.vertices = {Vertex{}}})); }, {0, 0, 0, 0});
  group.equals("no vertices", [] { return all_values(vertex_tangents(Mesh{})); }, {});
  group.equals("a zero normal",
               [] {
                 return all_values(vertex_tangents({.vertices = {{{0, 0, 0}, {0, 0, 0}, {0, 0}},
                                                                 {{1, 0, 0}, {0, 0, 1}, {1, 0}},
                                                                 {{0, 1, 0}, {0, 0, 1}, {0, 1}}},
                                                    .indices = {0, 1, 2}}));
               },
               {0, 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1});
}

// ---- Height maps

Values normals_of(const Image& heights, float depth, Wrap wrap) {
  Values out;
  const Image normals = normal_mapping::normals_from_heights(heights, depth, wrap);
  for (const Rgba& p : normals.pixels())
    for (const float x : {p.r, p.g, p.b}) out.push_back(x);
  return out;
}

Image ramp(int width, int height, float step) {
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) image.at(x, y).r = step * float(x);
  return image;
}

void add_height_rows(Table& table) {
  Group group = table.of("normals_from_heights");
  for (const Wrap wrap : {Wrap::repeat, Wrap::mirrored_repeat, Wrap::clamp_to_edge})
    group.equals(fmt::format("one texel, wrap {}", int(wrap)), [=] { return normals_of(Image(1, 1), 0.1f, wrap); },
                 {0.5, 0.5, 1});
  group.equals("depth 0", [] { return normals_of(ramp(2, 1, 0.5f), 0, Wrap::clamp_to_edge); },
               {0.5, 0.5, 1, 0.5, 0.5, 1});
  group.close("a cliff of slope 1000", {2 * rounding_unit, "absolute", "n/2 + 1/2 of nearly (-1, 0, 0)"}, [] {
    const double z = 1 / std::sqrt(1 + 1e6);
    const Values all = normals_of(ramp(3, 1, 1), 1000.0f / 3, Wrap::clamp_to_edge);
    return difference({all.begin() + 3, all.begin() + 6}, {0.5 - 500 * z, 0.5, 0.5 + 0.5 * z});
  });
  group.finite("heights of 1e18 m", [] { return normals_of(ramp(3, 2, 1), 1e18f, Wrap::repeat); });
}

// ---- GLSL

const std::string glsl = "05-normal-mapping/normal_mapping.glsl";

void add_decode_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("decode_normal (GLSL)");
  const ShaderFunction function{text_including(glsl), {"c"}, "vec4(decode_normal(c.xyz), 0.0)"};
  const auto of = [=, &shaders](glm::vec3 c) { return values(glm::vec3(shaders.evaluate(function, input_of(c)))); };
  group.equals("a texel that stores no direction", [=] { return of(glm::vec3(0.5f)); }, {0, 0, 1});
  group.equals("a vector of length 0.00002", [=] { return of({0.50001f, 0.5f, 0.5f}); }, {0, 0, 1});
  for (const glm::vec3 c :
       {glm::vec3(0, 0, 0), glm::vec3(1, 1, 1), glm::vec3(0.5f, 0.5f, 0.501f), glm::vec3(0.2f, 0.9f, 0.6f)})
    group.close(fmt::format("({:g}, {:g}, {:g})", c.x, c.y, c.z),
                {4e-6, "absolute", "the driver's square root and quotient"},
                [=] { return difference(of(c), values(glm::normalize(2.0 * glm::dvec3(c) - 1.0))); });
}

void add_frame_rows(Table& table, ShaderFunctions& shaders) {
  const ShaderFunction frame{text_including(glsl), {"n", "t", "s"}, "vec4(tangent_frame(n.xyz, t) * s.xyz, 0.0)"};
  const ShaderFunction mapped{text_including(glsl), {"n", "t", "s"}, "vec4(mapped_normal(n.xyz, t, s.xyz), 0.0)"};
  Group frames = table.of("tangent_frame (GLSL)");
  const auto in_frame = [=, &shaders](glm::vec3 n, glm::vec4 t, glm::vec3 s) {
    return values(glm::vec3(shaders.evaluate(frame, input_of(n, t, s))));
  };
  frames.equals("a sign of 0", [=] { return in_frame({0, 0, 1}, {1, 0, 0, 0}, {0, 1, 0}); }, {0, 1, 0});
  frames.equals("a sign of -0.1", [=] { return in_frame({0, 0, 1}, {1, 0, 0, -0.1f}, {0, 1, 0}); }, {0, -1, 0});
  frames.equals("short vectors",
                [=] {
                  return in_frame({0, 0, 0.5f}, {0.25f, 0, 0, 1}, {1, 1, 1});
                },
                {0.25, 0.125, 0.5});

  Group group = table.of("mapped_normal (GLSL)");
  const auto of = [=, &shaders](glm::vec3 n, glm::vec4 t, glm::vec3 s) {
    return values(glm::vec3(shaders.evaluate(mapped, input_of(n, t, s))));
  };
  group.equals("no tangent: the very normal",
               [=] {
                 return of({0.3f, 0.4f, 0.1f}, glm::vec4(0), {0.6f, 0, 0.8f});
               },
               {double(0.3f), double(0.4f), double(0.1f)});
  group.equals("no tangent, no normal", [=] { return of(glm::vec3(0), glm::vec4(0), {0, 0, 1}); }, {0, 0, 0});
  group.finite("no normal, but a tangent", [=] { return of(glm::vec3(0), {1, 0, 0, 1}, {0, 0, 1}); });
  group.close("a tangent that has nearly vanished", {4e-6, "absolute", "the driver's square root"}, [=] {
    return difference(of({0, 0, 1}, {1e-10f, 0, 0, 1}, {0.6f, 0, 0.8f}), {0.75e-10, 0, 1});
  });
}

void add_recorded_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("recorded_normal (GLSL)");
  const ShaderFunction function{text_including(glsl), {"n"}, "vec4(recorded_normal(mat3(1.0), n.xyz), 0.0)"};
  const auto of = [=, &shaders](glm::vec3 n) { return values(glm::vec3(shaders.evaluate(function, input_of(n)))); };
  group.equals("no normal", [=] { return of(glm::vec3(0)); }, {0.5, 0.5, 1});
  for (const float size : {1e-12f, 1.0f, 1e12f})
    group.equals(fmt::format("a normal of length {:g}", size), [=] { return of({0, 0, -size}); }, {0.5, 0.5, 0});
}

void add_derivative_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("derivative_tangent (GLSL)");
  const ShaderFunction function{
      text_including(glsl), {"n", "px", "py", "tx", "ty"}, "derivative_tangent(n.xyz, px.xyz, py.xyz, tx.xy, ty.xy)"};
  const auto of = [=, &shaders](glm::vec3 n, float metres, glm::vec2 tx, glm::vec2 ty) {
    return values(shaders.evaluate(function, input_of(n, glm::vec3(metres, 0, 0), glm::vec3(0, metres, 0), tx, ty)));
  };
  const glm::vec3 up(0, 0, 1);
  group.equals("no change of the texture coordinate", [=] { return of(up, 1, {0, 0}, {0, 0}); }, {0, 0, 0, 0});
  group.equals("it changes along one line", [=] { return of(up, 1, {1, 2}, {2, 4}); }, {0, 0, 0, 0});
  group.equals("no normal", [=] { return of(glm::vec3(0), 1, {1, 0}, {0, 1}); }, {0, 0, 0, 0});
  group.equals("a normal along u", [=] { return of({1, 0, 0}, 1, {1, 0}, {0, 1}); }, {0, 0, 0, 0});
  for (const float metres : {1e-6f, 1.0f, 1e6f})
    for (const float texture : {1e-6f, 1.0f, 1e3f})
      group.close(fmt::format("{:g} m and {:g} of the texture a pixel", metres, texture),
                  {4e-6, "absolute", "the driver's square root"}, [=] {
                    return difference(of(up, metres, {texture, 0}, {0, texture}), {1, 0, 0, 1});
                  });
}

void add_space_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("to_tangent_space (GLSL)");
  const ShaderFunction function{text_including(glsl), {"n", "t", "v"}, "vec4(to_tangent_space(n.xyz, t, v.xyz), 0.0)"};
  const auto of = [=, &shaders](glm::vec3 n, glm::vec4 t, glm::vec3 v) {
    return values(glm::vec3(shaders.evaluate(function, input_of(n, t, v))));
  };
  group.equals("no vector", [=] { return of({0, 0, 1}, {1, 0, 0, 1}, {0, 0, 0}); }, {0, 0, 0});
  for (const float size : {1e-6f, 1.0f, 1e6f})
    group.close(fmt::format("vectors of length {:g}: lengths stay", size),
                {8e-6, "relative", "the driver's square root"}, [=] {
                  const Values out = of({0, size, 0}, {size, size, 0, -1}, {1, 2, 3});
                  return std::abs(std::hypot(out[0], out[1], out[2]) / std::sqrt(14.0) - 1);
                });
}

void add_exponent_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("filtered_exponent (GLSL)");
  const ShaderFunction function{text_including(glsl), {"n", "c"}, "vec4(filtered_exponent(n.x, c.xyz))"};
  const auto of = [=, &shaders](float n, glm::vec3 c) { return Values{shaders.number(function, input_of(n, c))}; };
  group.equals("a mean of length 1", [=] { return of(1e6f, {0.5f, 0.5f, 1}); }, {1e6});
  group.equals("a mean of length 0", [=] { return of(50, glm::vec3(0.5f)); }, {0});
  group.equals("a mean that rounding has made longer than 1", [=] { return of(50, {0.5f, 0.501f, 1}); }, {50});
  group.equals("an exponent of 0", [=] { return of(0, {0.5f, 0.5f, 0.9f}); }, {0});
}

}  // namespace

}  // namespace atelier::stability

void atelier_stability_table(atelier::stability::Table& table, atelier::stability::ShaderFunctions& shaders) {
  using namespace atelier::stability;
  add_triangle_rows(table);
  add_mesh_rows(table);
  add_height_rows(table);
  add_decode_rows(table, shaders);
  add_frame_rows(table, shaders);
  add_recorded_rows(table, shaders);
  add_derivative_rows(table, shaders);
  add_space_rows(table, shaders);
  add_exponent_rows(table, shaders);
}
