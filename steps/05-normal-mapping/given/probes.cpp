#include "05-normal-mapping/given/probes.hpp"

#include <algorithm>

#include "05-normal-mapping/normal_mapping.hpp"
#include "app/probe_texture.hpp"
#include "base/error.hpp"

namespace atelier {

namespace {

using normal_mapping::Corner;

constexpr std::size_t numbers_a_corner = 5, numbers_a_vertex = 8;

/// Corner k of "corners": x, y, z, u, v each.
Corner corner(const Arguments& in, std::size_t k) {
  const auto& flat = in.numbers("corners");
  if (flat.size() != 3 * numbers_a_corner) throw Error("corners: three corners of x, y, z, u, v are expected");
  const double* at = flat.data() + numbers_a_corner * k;
  return {glm::vec3(at[0], at[1], at[2]), glm::vec2(at[3], at[4])};
}

/// The mesh of "vertices" (position, normal, texture coordinate) and "triangles".
Mesh mesh(const Arguments& in) {
  const auto& flat = in.numbers("vertices");
  Mesh made;
  for (std::size_t at = 0; at + numbers_a_vertex <= flat.size(); at += numbers_a_vertex) {
    const double* v = flat.data() + at;
    made.vertices.push_back({glm::vec3(v[0], v[1], v[2]), glm::vec3(v[3], v[4], v[5]), glm::vec2(v[6], v[7])});
  }
  for (const double index : in.numbers("triangles")) made.indices.push_back(std::uint32_t(index));
  return made;
}

Numbers probe_vertex_tangents(ProbeContext&, const Arguments& in) {
  const Mesh made = mesh(in);
  const std::vector<glm::vec4> tangents = normal_mapping::vertex_tangents(made);
  Numbers out;
  for (const glm::vec4& tangent : tangents) append(out, numbers_of(tangent));
  return out;
}

/// "heights" has `width` numbers a row, from the top row down.
Numbers probe_heights(ProbeContext&, const Arguments& in) {
  const auto& flat = in.numbers("heights");
  const int width = in.integer("width"), height = int(flat.size()) / std::max(width, 1);
  // Green and blue are no heights: only red is.
  Image heights(width, height, {0, 0.3f, 0.7f, 1});
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) heights.at(x, y).r = float(flat[std::size_t(y * width + x)]);
  const Image normals =
      normal_mapping::normals_from_heights(heights, float(in.number("depth")), wrap_of(in.integer("wrap")));
  Numbers out{double(normals.width()), double(normals.height())};
  for (const Rgba& texel : normals.pixels()) append(out, Numbers{texel.r, texel.g, texel.b, texel.a});
  return out;
}

}  // namespace

std::map<std::string, Probe> normal_mapping_probes() {
  const std::string glsl = text_including("05-normal-mapping/normal_mapping.glsl");
  return {
      {"triangle_tangent",
       [](ProbeContext&, const Arguments& in) {
         return numbers_of(normal_mapping::triangle_tangent(corner(in, 0), corner(in, 1), corner(in, 2)));
       }},
      {"vertex_tangents", probe_vertex_tangents},
      {"normals_from_heights", probe_heights},
      {"decode_normal", shader_probe(glsl, "vec4(decode_normal(texel), 0.0)", 3)},
      {"tangent_frame", shader_probe(glsl, "vec4(tangent_frame(normal, tangent) * stored, 0.0)", 3)},
      {"mapped_normal", shader_probe(glsl, "vec4(mapped_normal(normal, tangent, stored), 0.0)", 3)},
      {"recorded_normal", shader_probe(glsl, "vec4(recorded_normal(world_to_view, normal), 0.0)", 3)},
      {"derivative_tangent",
       shader_probe(glsl, "derivative_tangent(normal, position_dx, position_dy, texcoord_dx, texcoord_dy)", 4)},
      {"to_tangent_space", shader_probe(glsl, "vec4(to_tangent_space(normal, tangent, v), 0.0)", 3)},
      {"filtered_exponent", shader_probe(glsl, "vec4(filtered_exponent(exponent, texel))", 1)},
  };
}

}  // namespace atelier
