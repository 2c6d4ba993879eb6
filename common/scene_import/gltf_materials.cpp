#include "scene_import/gltf_materials.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "base/printable.hpp"
#include "image_io/image_io.hpp"
#include "scene_import/blinn_phong_of.hpp"
#include "scene_import/references.hpp"

namespace atelier::scene_import {
namespace {

glm::vec3 colour(const std::vector<double>& numbers) {
  // glTF allows only 0..1; clamp negative values.
  return glm::max(glm::vec3(numbers[0], numbers[1], numbers[2]), glm::vec3(0));
}

std::optional<JsonField> extension(const JsonField& field, const char* name) {
  const auto extensions = field.find("extensions");
  return extensions ? extensions->find(name) : std::nullopt;
}

Wrap wrap_of(const JsonField& sampler, const char* key) {
  switch (sampler.integer_or(key, 0, 1 << 16, 10497)) {  // glTF uses OpenGL's constants
    case 33071:
      return Wrap::clamp_to_edge;
    case 33648:
      return Wrap::mirrored_repeat;
    default:
      return Wrap::repeat;
  }
}

Filter filter_of(const JsonField& sampler) {
  constexpr std::int64_t nearest = 9728, linear = 9729, linear_mipmap_linear = 9987;
  if (sampler.integer_or("magFilter", 0, 1 << 16, linear) == nearest) return Filter::nearest;
  const std::int64_t shrunk = sampler.integer_or("minFilter", 0, 1 << 16, linear_mipmap_linear);
  return shrunk == nearest || shrunk == linear ? Filter::linear : Filter::mipmap;
}

Image white() {
  return Image(1, 1, {1, 1, 1, 1});
}

}  // namespace

int GltfMaterials::material(std::optional<int> index) {
  const int key = index.value_or(-1);
  if (const auto found = made_.find(key); found != made_.end()) return found->second;
  Material material;
  if (index) {
    material = make(file_.root().at("materials")[std::size_t(*index)]);
  } else {
    const auto [diffuse, specular] = of_metallic(glm::vec3(0.8f), 0);  // the standard's white would be too bright
    material = {.name = "default", .diffuse = diffuse, .specular = specular, .exponent = exponent_of_roughness(0.7)};
  }
  scene_.materials.push_back(std::move(material));
  return made_[key] = int(scene_.materials.size()) - 1;
}

Material GltfMaterials::make(const JsonField& field) {
  Material material{.name = field.text_or("name", "")};
  if (const auto glossy = extension(field, "KHR_materials_pbrSpecularGlossiness"))
    read_specular_glossiness(material, *glossy);
  else
    read_metallic_roughness(material, field);
  material.normal_texture = normal_texture(field);

  double strength = 1;
  if (const auto stronger = extension(field, "KHR_materials_emissive_strength"))
    strength = std::max(stronger->number_or("emissiveStrength", 1), 0.0);
  material.emission = float(strength) * colour(field.numbers_or("emissiveFactor", {0, 0, 0}));
  if (const auto info = field.find("emissiveTexture"); info && material.emission != glm::vec3(0)) {
    // A material here has no emission texture: its mean keeps the total emitted light.
    file_.notes->add(fmt::format("{}: pictures of emitted light are replaced by their mean colours", file_.name));
    if (const auto glow = picture(*info, Encoding::linear))
      material.emission *= glm::vec3(mean_of_channel(*glow, 0), mean_of_channel(*glow, 1), mean_of_channel(*glow, 2));
  }
  if (const std::string mode = field.text_or("alphaMode", "OPAQUE"); mode != "OPAQUE")
    file_.notes->add(fmt::format("{}: transparency is left out (alphaMode {})", file_.name, printable(mode)));
  material.two_sided = field.flag_or("doubleSided", false);
  return material;
}

void GltfMaterials::read_metallic_roughness(Material& material, const JsonField& field) {
  glm::vec3 base(1);
  float metallic = 1;
  double roughness = 1;
  std::optional<Image> base_picture, rough_picture;
  std::optional<JsonField> base_info, rough_info;
  if (const auto pbr = field.find("pbrMetallicRoughness")) {
    base = colour(pbr->numbers_or("baseColorFactor", {1, 1, 1, 1}));
    metallic = float(std::clamp(pbr->number_or("metallicFactor", 1), 0.0, 1.0));
    roughness = pbr->number_or("roughnessFactor", 1);
    base_info = pbr->find("baseColorTexture");
    rough_info = pbr->find("metallicRoughnessTexture");
  }
  if (rough_info) rough_picture = picture(*rough_info, Encoding::data);
  if (rough_picture) roughness *= mean_of_channel(*rough_picture, 1);
  material.exponent = exponent_of_roughness(roughness);

  if (metallic > 0.5f)
    file_.notes->add(fmt::format("{}: metals are approximations: nothing is mirrored in them", file_.name));
  const bool metal_varies = rough_picture && metallic > 0;
  if (!metal_varies && (metallic == 0 || !base_info)) {
    // The metallic value is constant: apply it to the factors, so that the texture can be shared.
    const auto [diffuse, specular] = of_metallic(base, metallic);
    material.diffuse = diffuse;
    material.specular = specular;
    if (base_info)
      material.diffuse_texture = texture(*field.find("pbrMetallicRoughness"), "baseColorTexture", Encoding::linear);
    return;
  }
  if (base_info) base_picture = picture(*base_info, Encoding::linear);
  if (!base_picture && !metal_varies) base_picture = white();
  BlinnPhongPictures pictures = of_metallic_pictures(base_picture ? &*base_picture : nullptr, base,
                                                     metal_varies ? &*rough_picture : nullptr, metallic);
  const JsonField& info = base_picture && base_info ? *base_info : *rough_info;
  material.diffuse = material.specular = glm::vec3(1);
  material.diffuse_texture = add_texture(info, std::move(pictures.diffuse));
  material.specular_texture = add_texture(info, std::move(pictures.specular));
}

void GltfMaterials::read_specular_glossiness(Material& material, const JsonField& field) {
  material.specular = colour(field.numbers_or("specularFactor", {1, 1, 1}));
  const float largest = std::max({material.specular.x, material.specular.y, material.specular.z});
  material.diffuse = colour(field.numbers_or("diffuseFactor", {1, 1, 1, 1}));
  double glossiness = field.number_or("glossinessFactor", 1);
  double mirrored = largest;
  material.diffuse_texture = texture(field, "diffuseTexture", Encoding::linear);
  if (const auto info = field.find("specularGlossinessTexture")) {
    if (auto shine = picture(*info, Encoding::linear)) {
      glossiness *= mean_of_channel(*shine, 3);
      mirrored *= std::max({mean_of_channel(*shine, 0), mean_of_channel(*shine, 1), mean_of_channel(*shine, 2)});
      material.specular_texture = add_texture(*info, std::move(*shine));
    }
  }
  material.diffuse *= float(std::max(1 - mirrored, 0.0));
  material.exponent = exponent_of_roughness(1 - glossiness);
}

std::optional<Image> GltfMaterials::picture(const JsonField& texture_info, Encoding encoding) {
  const int index = texture_info.at("index").index(file_.root().size_or_zero("textures"));
  const JsonField texture = file_.root().at("textures")[std::size_t(index)];
  const auto source = texture.index_or_none("source", file_.root().size_or_zero("images"));
  if (!source) {
    file_.notes->add(
        fmt::format("{}: textures[{}] is left out: it has no picture in a supported format", file_.name, index));
    return {};
  }
  const JsonField image = file_.root().at("images")[std::size_t(*source)];
  const auto read_bytes = [&](std::string_view bytes) {
    return read_image_bytes(std::as_bytes(std::span(bytes)), fmt::format("{}: images[{}]", file_.name, *source),
                            encoding);
  };
  if (const auto view = image.index_or_none("bufferView", file_.root().size_or_zero("bufferViews")))
    return read_bytes(view_bytes(file_, *view));
  const JsonField uri = image.at("uri");
  std::optional<std::string> embedded;
  try {
    embedded = decode_data_uri(uri.text());
  } catch (const Error& error) {
    uri.fail(error.what());
  }
  if (embedded) return read_bytes(*embedded);
  return read_model_picture(file_.folder, percent_decode(uri.text()), encoding, *file_.notes);
}

TextureIndex GltfMaterials::add_texture(const JsonField& texture_info, Image pixels) {
  const int index = texture_info.at("index").index(file_.root().size_or_zero("textures"));
  const JsonField field = file_.root().at("textures")[std::size_t(index)];
  Texture texture{.name = field.text_or("name", fmt::format("texture {}", index)), .pixels = std::move(pixels)};
  if (const auto sampler = field.index_or_none("sampler", file_.root().size_or_zero("samplers"))) {
    const JsonField how = file_.root().at("samplers")[std::size_t(*sampler)];
    texture.wrap = wrap_of(how, "wrapS");
    texture.filter = filter_of(how);
    if (wrap_of(how, "wrapT") != texture.wrap)
      file_.notes->add(
          fmt::format("{}: samplers[{}] wraps differently along u and v; the mode of u is used", file_.name, *sampler));
  }
  if (texture_info.integer_or("texCoord", 0, 1 << 16, 0) != 0)
    file_.notes->add(fmt::format("{}: textures[{}] needs a second set of texture coordinates; the first is used",
                                 file_.name, index));
  return add_limited_texture(scene_, std::move(texture));
}

TextureIndex GltfMaterials::texture(const JsonField& holder, const char* key, Encoding encoding) {
  const auto info = holder.find(key);
  if (!info) return {};
  const int index = info->at("index").index(file_.root().size_or_zero("textures"));
  if (const auto found = shared_textures_.find({index, encoding}); found != shared_textures_.end())
    return found->second;
  auto pixels = picture(*info, encoding);
  if (!pixels) return {};
  const TextureIndex added = add_texture(*info, std::move(*pixels));
  shared_textures_[{index, encoding}] = *added;
  return added;
}

TextureIndex GltfMaterials::normal_texture(const JsonField& material) {
  const TextureIndex map = texture(material, "normalTexture", Encoding::data);
  const double scale = map ? material.find("normalTexture")->number_or("scale", 1) : 1;
  if (scale == 1) return map;
  Texture scaled = scene_.textures[std::size_t(*map)];
  for (Rgba& p : scaled.pixels.pixels()) {
    const glm::dvec3 n = (glm::dvec3(p.r, p.g, p.b) * 2.0 - 1.0) * glm::dvec3(scale, scale, 1);
    const double length = glm::length(n);
    if (length == 0) continue;
    const glm::vec3 stored(n / length * 0.5 + 0.5);
    p = {stored.x, stored.y, stored.z, p.a};
  }
  scene_.textures.push_back(std::move(scaled));
  return int(scene_.textures.size()) - 1;
}

TexcoordTransform GltfMaterials::transform(std::optional<int> index) const {
  if (!index) return {};
  const JsonField field = file_.root().at("materials")[std::size_t(*index)];
  std::optional<JsonField> info;
  if (const auto glossy = extension(field, "KHR_materials_pbrSpecularGlossiness"))
    info = glossy->find("diffuseTexture");
  else if (const auto pbr = field.find("pbrMetallicRoughness"))
    info = pbr->find("baseColorTexture");
  const auto transform = info ? extension(*info, "KHR_texture_transform") : std::nullopt;
  if (!transform) return {};
  const auto offset = transform->numbers_or("offset", {0, 0}), scale = transform->numbers_or("scale", {1, 1});
  return {{offset[0], offset[1]}, {scale[0], scale[1]}, transform->number_or("rotation", 0)};
}

}  // namespace atelier::scene_import
