#include "06-parallax-mapping/given/probes.hpp"

#include "app/probe_texture.hpp"

namespace atelier {

namespace {

/// Heights of 8 x 4 texels, interpolated, that repeat: heights() in the order of the texture, from the bottom row up.
constexpr int width = 8, height = 4;
GlTexture height_map(Gl& gl) {
  constexpr float h[width * height] = {0.9f, 0.7f, 0.2f, 0.1f, 0.3f, 0.8f, 1.0f, 0.6f,  //
                                       0.5f, 0.4f, 0.1f, 0.0f, 0.2f, 0.9f, 0.7f, 0.5f,  //
                                       0.2f, 0.3f, 0.6f, 0.5f, 0.4f, 0.3f, 0.2f, 0.1f,  //
                                       1.0f, 0.9f, 0.8f, 0.7f, 0.6f, 0.5f, 0.4f, 0.3f};
  GlTexture map(gl);
  gl.BindTexture(GL_TEXTURE_2D, map.id());
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_R32F, width, height, 0, GL_RED, GL_FLOAT, h);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.BindTexture(GL_TEXTURE_2D, 0);
  return map;
}

/// A probe of a GLSL expression that reads this map.
Probe relief_probe(const std::string& expression, int numbers) {
  return with_texture(GL_TEXTURE_2D, height_map,
                      shader_probe(text_including("06-parallax-mapping/parallax_mapping.glsl"), expression, numbers));
}

}  // namespace

std::map<std::string, Probe> parallax_mapping_probes() {
  return {
      {"parallax_span", relief_probe("vec4(parallax_span(to_eye, depth), 0.0, 0.0)", 2)},
      {"offset_hit", relief_probe("vec4(offset_hit(texcoord))", 1)},
      {"first_step_below", relief_probe("vec4(first_step_below(texcoord, span, int(layers)), 0.0, 0.0)", 2)},
      {"secant_hit", relief_probe("vec4(secant_hit(texcoord, span, interval))", 1)},
      {"bisected_hit", relief_probe("vec4(bisected_hit(texcoord, span, interval, int(bisections)))", 1)},
      {"layers_needed", relief_probe("vec4(layers_needed(span, dx, dy, int(most)))", 1)},
      {"relief_visibility", relief_probe("vec4(relief_visibility(texcoord, height, light_span, int(samples)))", 1)},
      {"relief_position", relief_probe("vec4(relief_position(position, eye, to_eye, depth, t), 0.0)", 3)},
      {"depth_of", relief_probe("vec4(depth_of(world_to_clip, position))", 1)},
      {"beyond_edges", relief_probe("vec4(beyond_edges(texcoord, low, high))", 1)},
      {"ray_bend", relief_probe("vec4(ray_bend(span, depth, metres, curvature))", 1)},
      {"ray_end", relief_probe("vec4(ray_end(bend))", 1)},
      {"curved_hit", relief_probe("vec4(curved_hit(texcoord, span, bend, int(layers)))", 1)},
      {"recorded_height", relief_probe("vec4(recorded_height(position, nearest, farthest))", 1)},
  };
}

}  // namespace atelier
