#include "02-blinn-phong/given/probes.hpp"

#include <fmt/format.h>

#include "02-blinn-phong/blinn_phong.hpp"
#include "app/probe_texture.hpp"
#include "gl/query.hpp"

namespace atelier {

namespace {

const Defines one_light_of_each_type{
    {"POINT_LIGHTS", "1"}, {"SPOT_LIGHTS", "1"}, {"DIRECTIONAL_LIGHTS", "1"}, {"SPECULAR", "1"}};

/// The student's GLSL with one light of each type, highlights, and the given variants of power and normalisation.
std::string glsl(int normalisation = 0, int power = 0, const std::string& before = "") {
  Defines defines{{"NORMALISATION", fmt::to_string(normalisation)}, {"POWER", fmt::to_string(power)}};
  defines.insert(one_light_of_each_type.begin(), one_light_of_each_type.end());
  return text_including("02-blinn-phong/blinn_phong.glsl", defines, before);
}

/// For a probe with the argument u_ambient: the uniform gets another name.
std::string ambient_as_argument() {
  Defines defines = one_light_of_each_type;
  defines["u_ambient"] = "u_other_ambient";
  return text_including("02-blinn-phong/given/lights.glsl", defines) + "#undef u_ambient\n";
}

/// A grey ramp with a mark in its upper left corner, as a picture of the asked size; alpha from 0.5 to 1.
Image test_picture(int width, int height) {
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const float value = float(y * width + x + 1) / float(width * height);
      image.at(x, y) = {value, 1 - value, x == 0 && y == 0 ? 1.0f : 0.0f, 0.5f + 0.5f * value};
    }
  return image;
}

/// Width, height and the mean of red and green of every level, then the last level's pixel.
Numbers probe_mipmaps(ProbeContext&, const Arguments& in) {
  Numbers out;
  const std::vector<Image> levels = blinn_phong::mipmaps(test_picture(in.integer("width"), in.integer("height")));
  for (const Image& level : levels) {
    double red = 0, green = 0;
    for (const Rgba& p : level.pixels()) red += p.r, green += p.g;
    const double count = double(level.width()) * level.height();
    for (const double x : {double(level.width()), double(level.height()), red / count, green / count}) out.push_back(x);
  }
  const Rgba last = levels.back().at(0, 0);
  out.insert(out.end(), {last.r, last.g, last.b, last.a});
  return out;
}

Filter filter_of(int code) {
  return code == 0 ? Filter::nearest : code == 1 ? Filter::linear : Filter::mipmap;
}

/// What OpenGL remembers of a texture of 4x2 pixels: filters, wraps, highest level, size and format of level 0, whether
/// it was left bound, its lower left texel, and its upper right one.
Numbers probe_upload_texture(ProbeContext& context, const Arguments& in) {
  Gl& gl = context.gl;
  const Filter filter = filter_of(in.integer("filter"));
  const Image base = test_picture(4, 2);
  std::vector<Image> levels = {base};
  if (filter == Filter::mipmap) levels = {base, Image(2, 1), Image(1, 1)};
  const GlTexture texture(gl, blinn_phong::upload_texture(gl, levels, wrap_of(in.integer("wrap")), filter));
  const bool left_bound = integer_of(gl, GL_TEXTURE_BINDING_2D) != 0;
  gl.BindTexture(GL_TEXTURE_2D, texture.id());
  Numbers out;
  append(out, texture_parameters(gl, GL_TEXTURE_2D,
                                 {GL_TEXTURE_MAG_FILTER, GL_TEXTURE_MIN_FILTER, GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T,
                                  GL_TEXTURE_MAX_LEVEL}));
  append(out, level_parameters(gl, GL_TEXTURE_2D, {GL_TEXTURE_WIDTH, GL_TEXTURE_HEIGHT, GL_TEXTURE_INTERNAL_FORMAT}));
  std::vector<Rgba> texels(std::size_t(std::max(8.0, out[5] * out[6])));
  gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, texels.data());
  gl.BindTexture(GL_TEXTURE_2D, 0);
  out.push_back(left_bound);
  for (const Rgba& texel : {texels[0], texels[7]}) out.insert(out.end(), {texel.r, texel.g, texel.b, texel.a});
  return out;
}

Numbers probe_balance(ProbeContext&, const Arguments& in) {
  glm::vec3 diffuse(in.vec3("diffuse")), specular(in.vec3("specular"));
  blinn_phong::balance(diffuse, specular);
  return {diffuse.r, diffuse.g, diffuse.b, specular.r, specular.g, specular.b};
}

/// The table at five evenly spaced places, and its size.
Numbers probe_power_table(ProbeContext&, const Arguments& in) {
  const int size = in.integer("size");
  const std::vector<float> table = blinn_phong::power_table(float(in.number("exponent")), size);
  Numbers out{double(table.size())};
  for (int i = 0; i < 5; ++i) out.push_back(table.at(std::size_t(i * (size - 1) / 4)));
  return out;
}

}  // namespace

std::map<std::string, Probe> blinn_phong_probes() {
  std::map<std::string, Probe> probes = {
      {"srgb_encode",
       [](ProbeContext&, const Arguments& in) { return Numbers{blinn_phong::srgb_encode(float(in.number("x")))}; }},
      {"srgb_decode",
       [](ProbeContext&, const Arguments& in) { return Numbers{blinn_phong::srgb_decode(float(in.number("x")))}; }},
      {"glsl_srgb_encode", shader_probe(glsl(), "vec4(srgb_encode(colour), 0.0)", 3)},
      {"glsl_srgb_decode", shader_probe(glsl(), "vec4(srgb_decode(colour), 0.0)", 3)},
      {"mipmaps", probe_mipmaps},
      {"upload_texture", probe_upload_texture},
      {"cone_cosines",
       [](ProbeContext&, const Arguments& in) {
         return numbers_of(blinn_phong::cone_cosines(float(in.number("inner")), float(in.number("outer"))));
       }},
      {"balance", probe_balance},
      {"power_table", probe_power_table},
      {"attenuation", shader_probe(glsl(), "vec4(attenuation(distance_to_light, coefficients))", 1)},
      {"spot_cone", shader_probe(glsl(), "vec4(spot_cone(to_light, axis, cos_inner, cos_outer))", 1)},
      {"reflected",
       shader_probe(glsl(), "vec4(reflected(normal, to_eye, to_light, Material(diffuse, specular, exponent)), 0.0)",
                    3)},
      {"shade", shader_probe(glsl(0, 0, ambient_as_argument()),
                             "vec4(shade(position, normal, eye, Material(diffuse, specular, exponent)), 0.0)", 3)},
      {"highlight", shader_probe(glsl(0, 0), "vec4(highlight(normal, half_vector, exponent))", 1)},
      {"highlight_stable", shader_probe(glsl(0, 1), "vec4(highlight(normal, half_vector, exponent))", 1)},
      {"normalisation_none", shader_probe(glsl(0), "vec4(specular_normalisation(exponent))", 1)},
      {"normalisation_n8", shader_probe(glsl(1), "vec4(specular_normalisation(exponent))", 1)},
      {"normalisation_exact", shader_probe(glsl(2), "vec4(specular_normalisation(exponent))", 1)},
  };
  // A light that arrives: rgb is its colour; the direction has a probe of its own.
  const std::string to_light = glsl() + "vec3 to_light;\n";
  const std::string point = "PointLight(light_position, light_colour, coefficients)";
  const std::string spot = "SpotLight(light_position, axis, light_colour, coefficients, cosines)";
  const std::string directional = "DirectionalLight(axis, light_colour)";
  for (const auto& [name, light] : {std::pair{"point", point}, {"spot", spot}, {"direction", directional}}) {
    const std::string call = fmt::format("arriving_from_{}({}, position, to_light)", name, light);
    probes[fmt::format("arriving_from_{}", name)] = shader_probe(to_light, "vec4(" + call + ", 0.0)", 3);
    probes[fmt::format("to_{}_light", name)] = shader_probe(to_light, "vec4(" + call + " * 0.0 + to_light, 0.0)", 3);
  }
  probes["point_light_red_and_length"] =
      shader_probe(to_light + "vec4 red_and_length(vec3 light) { return vec4(light.r, length(to_light), 0.0, 0.0); }\n",
                   "red_and_length(arriving_from_point(" + point + ", position, to_light))", 2);
  return probes;
}

}  // namespace atelier
