#include "02-blinn-phong/given/lit_surface.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "02-blinn-phong/blinn_phong.hpp"
#include "02-blinn-phong/given/scene_texture.hpp"
#include "app/frame_settings.hpp"
#include "gl/compact_texture.hpp"
#include "gl/debug.hpp"
#include "image/colour.hpp"
#include "scene/depth_range.hpp"
#include "scene/light_reach.hpp"

namespace atelier {

namespace {

bool has_specular(const Material& material) {
  return material.specular != glm::vec3(0);
}

/// The height of a highlight's lobe for the setting specular.normalisation: 1, or the factors of the contract.
double peak(int normalisation, double n) {
  if (normalisation == 1) return (n + 8) / 8;
  if (normalisation == 2) return (n + 2) * (n + 4) / (8 * (std::exp2(-n / 2) + n));
  return 1;
}

/// A picture encoded to sRGB with 8 bits, like a file. The student's srgb_decode decodes it.
Image encoded(Image image) {
  const auto stored = [](float linear) { return float(srgb_code(linear)) / 255; };
  for (Rgba& p : image.pixels()) p = {stored(p.r), stored(p.g), stored(p.b), p.a};
  return image;
}

/// Decodes encoded() with the student's function, called once for each of the 256 codes.
Image decoded(Image image) {
  std::array<float, 256> linear{};
  for (std::size_t code = 0; code < linear.size(); ++code) linear[code] = blinn_phong::srgb_decode(float(code) / 255);
  const auto of = [&](float stored) { return linear[std::size_t(stored * 255 + 0.5f)]; };
  for (Rgba& p : image.pixels()) p = {of(p.r), of(p.g), of(p.b), p.a};
  return image;
}

}  // namespace

SettingSpec shading_setting() {
  return {.name = "shading",
          .fallback = std::string("pixel"),
          .choices = {"pixel", "vertex"},
          .help = "where lighting is computed: at every pixel, or at every vertex and then interpolated (Gouraud)"};
}

std::vector<SettingSpec> lit_surface_settings() {
  return {
      {.name = "specular.normalisation",
       .fallback = std::string("none"),
       .choices = {"none", "n+8", "exact"},
       .help = "the factor that keeps the energy of a highlight constant when the exponent changes"},
      {.name = "specular.power",
       .fallback = std::string("direct"),
       .choices = {"direct", "stable", "table"},
       .help = "how the power of the cosine is computed"},
      {.name = "specular.table_size", .fallback = 256, .low = 2, .high = 4096, .help = "entries of the power table"},
      {.name = "light.count",
       .fallback = 64,
       .low = 0,
       .high = 64,
       .help = "how many of the scene's lights are on, in their order"},
      {.name = "light.cull",
       .fallback = true,
       .help = "leave out lights that together are too weak to change a pixel by 1/255"},
      {.name = "texture.filter",
       .fallback = std::string("scene"),
       .choices = {"scene", "nearest", "linear", "mipmap"},
       .help = "how texels are filtered; scene: as each texture says"},
      {.name = "texture.decode",
       .fallback = std::string("before"),
       .choices = {"before", "after"},
       .help = "when texels are decoded from sRGB: before filtering (right), or after it (cheaper to store)"},
      texture_format_setting(),
  };
}

std::string glsl_list(std::span<const int> lights, const std::function<int(int)>& number) {
  std::string list;
  for (const int light : lights) list += fmt::format("{}{}", list.empty() ? "" : ", ", number(light));
  return list;
}

void LitSurface::configure(const Settings& settings) {
  // Programs with shadows do not have this setting, since shadows need per-pixel lighting.
  per_vertex_ = settings.has("shading") && settings.choice("shading") == "vertex";
  const std::string& normalisation = settings.choice("specular.normalisation");
  normalisation_ = normalisation == "n+8" ? 1 : normalisation == "exact" ? 2 : 0;
  const std::string& power = settings.choice("specular.power");
  power_ = power == "stable" ? Power::stable : power == "table" ? Power::table : Power::direct;
  table_size_ = settings.integer("specular.table_size");
  light_limit_ = settings.integer("light.count");
  cull_lights_ = settings.flag("light.cull");
  filter_ = settings.choice("texture.filter");
  decode_after_filter_ = settings.choice("texture.decode") == "after";
  compact_textures_ = settings.choice("texture.format") == "8";
}

/// Sorts the lights that are on by type. Lights to leave out are chosen once per scene, for all viewpoints.
void LitSurface::choose_lights(const Scene& scene) {
  std::vector<int> shining;
  std::vector<Light> lights;
  for (int i = 0; i < int(lights_.all.size()); ++i) {
    const Light& light = lights_.light(i);
    if ((light.passage ? light.image_of : i) >= light_limit_) continue;
    shining.push_back(i);
    lights.push_back(light);
  }
  std::vector<int> kept(shining.size());
  std::iota(kept.begin(), kept.end(), 0);
  const std::vector<Box3> boxes = node_boxes(scene);
  if (cull_lights_) kept = lights_that_matter(lights, most_given_back(scene.materials, lobe()), box_of_drawn(boxes));
  lights_.together = {kept};
  set_of_node_.assign(scene.nodes.size(), 0);
  if (cull_lights_) choose_for_nodes(scene, boxes, lights, kept);
  for (std::vector<int>& set : lights_.together)
    for (int& i : set) i = shining[std::size_t(i)];
  for (auto* list : {&lights_.points, &lights_.spots, &lights_.directional}) list->clear();
  for (const int i : kept) {
    const int number = shining[std::size_t(i)];
    const LightType type = lights_.light(number).type;
    (type == LightType::point  ? lights_.points
     : type == LightType::spot ? lights_.spots
                               : lights_.directional)
        .push_back(number);
  }
  lights_left_out_ = int(shining.size() - kept.size());
  find_reach(boxes);
}

/// Each set of lights needs programs of its own: where there are many sets, each node has all lights that are kept.
void LitSurface::choose_for_nodes(const Scene& scene, std::span<const Box3> boxes, const std::vector<Light>& lights,
                                  const std::vector<int>& kept) {
  constexpr std::size_t most_sets = 4;
  std::vector<std::vector<int>> sets;
  std::vector<int> set_of_node(scene.nodes.size(), 0);
  for (std::size_t i = 0; i < scene.nodes.size() && sets.size() <= most_sets; ++i) {
    if (boxes[i].empty()) continue;
    const Material& material = scene.materials[std::size_t(scene.nodes[i].material)];
    const std::vector<int> here = lights_that_matter(lights, most_given_back({material}, lobe()), boxes[i], kept);
    const auto found = std::ranges::find(sets, here);
    set_of_node[i] = int(found - sets.begin());
    if (found == sets.end()) sets.push_back(here);
  }
  if (sets.empty() || sets.size() > most_sets) return;
  lights_.together = std::move(sets);
  set_of_node_ = std::move(set_of_node);
}

void LitSurface::find_reach(std::span<const Box3> boxes) {
  lights_.reach.assign(lights_.all.size(), std::numeric_limits<double>::infinity());
  for (const int i : lights_.points) {
    double& reach = lights_.reach[std::size_t(i)] = 0;
    for (std::size_t node = 0; node < boxes.size(); ++node) {
      if (boxes[node].empty() || !shines_on(i, node)) continue;
      const glm::dvec3 from = lights_.light(i).position;
      reach =
          std::max(reach, glm::length(glm::max(glm::abs(boxes[node].low - from), glm::abs(boxes[node].high - from))));
    }
  }
}

bool LitSurface::shines_on(int light, std::size_t node) const {
  return std::ranges::binary_search(lights_.together[std::size_t(set_of_node_[node])], light);
}

std::function<double(double)> LitSurface::lobe() const {
  return [this](double exponent) { return peak(normalisation_, exponent); };
}

void LitSurface::count(SceneCounts& counts) const {
  std::size_t most = 0;
  for (const std::vector<int>& set : lights_.together) most = std::max(most, set.size());
  counts.lights += std::int64_t(most);
  counts.lights_culled += lights_left_out_;
}

void LitSurface::prepare(Gl& gl, const Scene& scene) {
  gl_ = &gl;
  choose_lights(scene);
  power_tables_.clear();
  textures_.clear();
  textures_.resize(scene.textures.size());
  for (const Material& material : scene.materials)
    for (const TextureIndex& index : {material.diffuse_texture, material.specular_texture}) {
      if (!index || textures_[std::size_t(*index)]) continue;
      const Texture& texture = scene.textures[std::size_t(*index)];
      const Image stored = encoded(texture.pixels);
      const Image base = decode_after_filter_ ? stored : decoded(stored);
      textures_[std::size_t(*index)] = upload_scene_texture(gl, texture, base, filter_);
      if (compact_textures_)
        store_in_8_bits(gl, textures_[std::size_t(*index)].id(),
                        decode_after_filter_ ? Encoding::srgb : Encoding::linear);
    }
  // Here and not at first use: creating a texture changes the texture binding.
  if (power_ == Power::table)
    for (const Material& material : scene.materials)
      if (has_specular(material)) power_table_for(material.exponent);
}

Need LitSurface::need(const Scene& scene, const View& view, const Node& node) const {
  const Material& material = scene.materials[std::size_t(node.material)];
  Need need{.wanted = true};
  Defines& d = need.structure;
  d["POINT_LIGHTS"] = std::to_string(lights_.points.size());
  d["SPOT_LIGHTS"] = std::to_string(lights_.spots.size());
  d["DIRECTIONAL_LIGHTS"] = std::to_string(lights_.directional.size());
  const auto node_index = std::size_t(&node - scene.nodes.data());
  for (const auto& [name, list] : {std::pair("POINT_LIGHTS_HERE", &lights_.points),
                                   {"SPOT_LIGHTS_HERE", &lights_.spots},
                                   {"DIRECTIONAL_LIGHTS_HERE", &lights_.directional}}) {
    const auto here = [&](int light) { return shines_on(light, node_index); };
    if (!std::ranges::all_of(*list, here)) d[name] = glsl_list(*list, here);
  }
  if (has_specular(material)) {
    d["SPECULAR"] = "1";
    d["NORMALISATION"] = std::to_string(normalisation_);
    d["POWER"] = std::to_string(int(power_));
    if (material.specular_texture) d["SPECULAR_MAP"] = "1";
  }
  if (material.diffuse_texture) d["DIFFUSE_MAP"] = "1";
  if (material.emission != glm::vec3(0)) d["EMISSION"] = "1";
  if (decode_after_filter_ && (material.diffuse_texture || material.specular_texture)) d["DECODE_AFTER_FILTER"] = "1";
  if (per_vertex_ && view.output == "colour") d["PER_VERTEX"] = "1";
  return need;
}

std::map<Slot, SlotCode> LitSurface::slots() const {
  return {{Slot::shade, {"02-blinn-phong/given/surface_lighting.glsl", "shade_surface"}}};
}

std::map<std::string, std::string> LitSurface::outputs() const {
  return {{"diffuse", "shade_diffuse_only(surface)"},
          {"specular", "shade_specular_only(surface)"},
          {"encoded", "srgb_encode(shaded)"}};
}

std::vector<DrawConstant> LitSurface::draw_constants() const {
  return {
      {"vec3", "u_diffuse"},
      {"vec3", "u_specular"},
      {"float", "u_exponent"},
      {"vec3", "u_ambient"},
      {"DirectionalLight", "u_directional_lights", "DIRECTIONAL_LIGHTS", {{"vec3", "direction"}, {"vec3", "colour"}}},
      {"SpotLight",
       "u_spot_lights",
       "SPOT_LIGHTS",
       {{"vec3", "position"}, {"vec3", "direction"}, {"vec3", "colour"}, {"vec3", "attenuation"}, {"vec2", "cosines"}}},
      {"PointLight",
       "u_point_lights",
       "POINT_LIGHTS",
       {{"vec3", "position"}, {"vec3", "colour"}, {"vec3", "attenuation"}}}};
}

void LitSurface::bind_view(Binder& binder, const Scene& scene, const Viewpoint& viewpoint) {
  binder.set("u_ambient", scene.ambient);
  const auto place = [&](const Light& light) { return glm::vec3(light.position - viewpoint.origin); };
  for (std::size_t i = 0; i < lights_.points.size(); ++i) {
    const Light& light = lights_.light(lights_.points[i]);
    const std::string name = fmt::format("u_point_lights[{}].", i);
    binder.set(name + "position", place(light));
    binder.set(name + "colour", light.colour);
    binder.set(name + "attenuation", light.attenuation);
  }
  for (std::size_t i = 0; i < lights_.spots.size(); ++i) {
    const Light& light = lights_.light(lights_.spots[i]);
    const std::string name = fmt::format("u_spot_lights[{}].", i);
    binder.set(name + "position", place(light));
    binder.set(name + "direction", glm::normalize(light.direction));
    binder.set(name + "colour", light.colour);
    binder.set(name + "attenuation", light.attenuation);
    binder.set(name + "cosines", blinn_phong::cone_cosines(light.inner_angle, light.outer_angle));
  }
  for (std::size_t i = 0; i < lights_.directional.size(); ++i) {
    const Light& light = lights_.light(lights_.directional[i]);
    const std::string name = fmt::format("u_directional_lights[{}].", i);
    binder.set(name + "direction", glm::normalize(light.direction));
    binder.set(name + "colour", light.colour);
  }
}

GLuint LitSurface::power_table_for(float exponent) {
  auto found = power_tables_.find(exponent);
  if (found == power_tables_.end()) {
    Image row(table_size_, 1);
    const std::vector<float> table = blinn_phong::power_table(exponent, table_size_);
    for (int i = 0; i < table_size_; ++i) row.at(i, 0).r = table[std::size_t(i)];
    const GLuint texture = blinn_phong::upload_texture(*gl_, std::span(&row, 1), Wrap::clamp_to_edge, Filter::linear);
    label(*gl_, GL_TEXTURE, texture, fmt::format("power table of {}", exponent));
    found = power_tables_.emplace(exponent, GlTexture(*gl_, texture)).first;
  }
  return found->second.id();
}

void LitSurface::bind_material(Binder& binder, const Scene&, const Material& material) {
  binder.set("u_diffuse", material.diffuse);
  binder.set("u_emission", material.emission);
  if (material.diffuse_texture) binder.texture("u_diffuse_map", textures_[std::size_t(*material.diffuse_texture)].id());
  if (!has_specular(material)) return;
  binder.set("u_specular", material.specular);
  binder.set("u_exponent", material.exponent);
  if (material.specular_texture)
    binder.texture("u_specular_map", textures_[std::size_t(*material.specular_texture)].id());
  if (power_ == Power::table) binder.texture("u_power_table", power_table_for(material.exponent));
}

}  // namespace atelier
