#include "05-normal-mapping/given/mapped_surface.hpp"

#include <algorithm>

#include "02-blinn-phong/given/scene_texture.hpp"
#include "05-normal-mapping/given/mesh_tangents.hpp"
#include "05-normal-mapping/normal_mapping.hpp"
#include "gl/compact_texture.hpp"

namespace atelier {

namespace {

/// Whether a map of normals or heights leaves every normal as it is.
bool changes_nothing(const Image& map, bool heights) {
  const auto pixels = map.pixels();
  return std::all_of(pixels.begin(), pixels.end(), [&](const Rgba& texel) {
    return heights ? texel.r == pixels.front().r : texel.r == 0.5f && texel.g == 0.5f && texel.b > 0.5f;
  });
}

}  // namespace

std::vector<SettingSpec> normal_mapping_settings() {
  return {
      {.name = "normal.maps", .fallback = true, .help = "whether normal maps are used"},
      {.name = "normal.source",
       .fallback = std::string("map"),
       .choices = {"map", "heights"},
       .help = "the material's normal map, or one made from its height map"},
      {.name = "normal.depth",
       .fallback = 0.02,
       .low = 0,
       .high = 0.2,
       .help = "with heights: the height of 1, as a fraction of the texture's side"},
      {.name = "normal.tangents",
       .fallback = std::string("vertex"),
       .choices = {"vertex", "derivative"},
       .help = "where tangents come from: computed once for every vertex, or for every pixel from derivatives"},
      {.name = "normal.space",
       .fallback = std::string("world"),
       .choices = {"world", "tangent"},
       .help = "where lighting is computed: the normal goes to world space, or the lights to tangent space"},
      {.name = "normal.format",
       .fallback = std::string("32"),
       .choices = {"32", "16", "8"},
       .help = "how maps are stored: floats of 32 or 16 bits, or 8 bits per channel"},
      {.name = "specular.filtered",
       .fallback = false,
       .help = "widen highlights where a filtered texel stands for many normals"},
  };
}

OutputSpec recorded_normal_output() {
  return {"recorded_normal", Encoding::data, "normals in view space as colours: a normal map of what is seen",
          Stage::aside};
}

void MappedSurface::configure(const Settings& settings) {
  enabled_ = settings.flag("normal.maps");
  from_heights_ = settings.choice("normal.source") == "heights";
  depth_ = float(settings.real("normal.depth"));
  derivatives_ = settings.choice("normal.tangents") == "derivative";
  in_tangent_space_ = settings.choice("normal.space") == "tangent";
  const std::string& format = settings.choice("normal.format");
  format_ = format == "8" ? Format::byte : format == "16" ? Format::float16 : Format::float32;
  filtered_ = settings.flag("specular.filtered");
  filter_ = settings.choice("texture.filter");
}

const TextureIndex& MappedSurface::texture_of(const Material& material) const {
  return from_heights_ ? material.height_texture : material.normal_texture;
}

bool MappedSurface::is_mapped(const Scene& scene, const Material& material) const {
  const TextureIndex& texture = texture_of(material);
  if (!enabled_ || !texture || (from_heights_ && depth_ == 0)) return false;
  return !changes_nothing(scene.textures[std::size_t(*texture)].pixels, from_heights_);
}

std::vector<glm::vec4> MappedSurface::tangents(const Scene& scene, int mesh) const {
  if (derivatives_) return {};
  return mesh_tangents(scene, mesh, [&](const Material& material) { return is_mapped(scene, material); });
}

GlTexture MappedSurface::map_of(Gl& gl, const Texture& texture) const {
  const Image base =
      from_heights_ ? normal_mapping::normals_from_heights(texture.pixels, depth_, texture.wrap) : texture.pixels;
  GlTexture map = upload_scene_texture(gl, texture, base, filter_);
  if (format_ == Format::byte) store_in_8_bits(gl, map.id(), Encoding::data);
  if (format_ == Format::float16) store_in_16_bits(gl, map.id());
  return map;
}

void MappedSurface::prepare(Gl& gl, const Scene& scene) {
  maps_.clear();
  for (const Node& node : scene.nodes) {
    const Material& material = scene.materials[std::size_t(node.material)];
    if (!node.mesh || !is_mapped(scene, material)) continue;
    const int texture = *texture_of(material);
    if (!maps_.contains(texture)) maps_.emplace(texture, map_of(gl, scene.textures[std::size_t(texture)]));
  }
}

Need MappedSurface::need(const Scene& scene, const View& view, const Node& node) const {
  const bool mapped = is_mapped(scene, scene.materials[std::size_t(node.material)]);
  const bool recorded = view.output == "recorded_normal";
  const bool shows_normals = view.output != "depth" && view.output != "position" && view.output != "texcoord";
  Need need{.wanted = (mapped && shows_normals) || recorded};
  Defines& d = need.structure;
  if (recorded) d["RECORDED_NORMALS"] = "1";
  if (!mapped || !need.wanted) return need;
  d["NORMAL_MAP"] = "1";
  d[derivatives_ ? "DERIVATIVE_TANGENTS" : "TANGENTS"] = "1";
  const bool lit = view.output != "normal" && !recorded;
  if (lit && in_tangent_space_) d["LIGHT_SPACE"] = "1";
  if (lit && filtered_) d["FILTERED_EXPONENT"] = "1";
  return need;
}

std::map<Slot, SlotCode> MappedSurface::slots() const {
  const std::string file = "05-normal-mapping/given/mapped_surface.glsl";
  return {{Slot::displace_texcoord, {file, "find_tangent"}}, {Slot::modify_surface, {file, "map_normal"}}};
}

std::map<std::string, std::string> MappedSurface::outputs() const {
  return {{"recorded_normal", "recorded_normal_of(surface)"}};
}

void MappedSurface::bind_material(Binder& binder, const Scene&, const Material& material) {
  const TextureIndex& texture = texture_of(material);
  if (!texture) return;
  if (const auto map = maps_.find(*texture); map != maps_.end()) binder.texture("u_normal_map", map->second.id());
}

}  // namespace atelier
