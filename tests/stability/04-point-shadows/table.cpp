// Step 04's table of extremes.
#include "03-shadow-mapping/given/shaders_alone.hpp"
#include "gl/depth_textures.hpp"
#include "stability/04-point-shadows/rows.hpp"
#include "stability/entry.hpp"

namespace atelier::stability {

OwnedCube::OwnedCube(Gl& gl, const point_shadows::CubeMap& made)
    : names(made), texture(gl, made.texture), framebuffer(gl, made.framebuffer) {}

OwnedCube filled_cube(Gl& gl, int resolution, GLenum format, bool compare, const std::array<float, 6>& faces) {
  OwnedCube cube(gl, point_shadows::make_cube_map(gl, resolution, format, compare));
  fill_depth_cube(gl, cube.names.texture, format, resolution, even_faces(resolution, faces));
  return cube;
}

ShaderFunction lookup_function(std::vector<std::string> parameters, std::string expression, const Lookup& lookup) {
  ShaderFunction function{text_including("04-point-shadows/point_shadows.glsl"), std::move(parameters),
                          std::move(expression), no_shadow_lights()};
  function.defines.merge(
      Defines{{"CUBES", "1"}, {"BIAS", fmt::to_string(lookup.bias)}, {"PCF", fmt::to_string(lookup.pcf)}});
  if (lookup.compare) function.defines.emplace("COMPARE", "1");
  return function;
}

std::vector<glm::vec3> directions_near_edges(float off) {
  std::vector<glm::vec3> places;
  for (int along = 0; along < 3; ++along)
    for (const float a : {-1.0f, 1.0f})
      for (const float b : {-1.0f, 1.0f})
        for (const float t : {-1.0f, -0.9f, -0.3f, 0.0f, 0.5f, 0.7f, 1.0f}) {
          glm::vec3 place(t);
          place[(along + 1) % 3] = a;
          place[(along + 2) % 3] = b;
          places.push_back(place);
        }
  std::vector<glm::vec3> directions;
  for (const glm::vec3& place : places)
    for (int i = 0; i < 9; ++i) {
      // Moves that part its components, one up and one down and the reverse.
      const glm::vec3 move(float(i % 3 - 1), float(i / 3 - 1), float((i + i / 3) % 3 - 1));
      directions.push_back(place + off * move);
    }
  return directions;
}

}  // namespace atelier::stability

void atelier_stability_table(atelier::stability::Table& table, atelier::stability::ShaderFunctions& shaders) {
  using namespace atelier::stability;
  add_face_rows(table);
  add_cone_rows(table);
  add_cube_rows(table, shaders);
  add_drawing_rows(table, shaders);
  add_lookup_rows(table, shaders);
  add_factor_rows(table, shaders);
}
