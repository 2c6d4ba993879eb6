#include "scene_import/obj_materials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "base/error.hpp"
#include "base/file.hpp"
#include "scene_import/references.hpp"
#include "scene_import/text_lines.hpp"

namespace atelier::scene_import {
namespace {

/// A single number sets all three channels. Invalid colours become black: a material should not prevent loading a
/// model.
glm::vec3 read_colour(TextLines& lines, const glm::vec3& fallback) {
  const auto r = lines.number();
  if (!r) return fallback;
  const float g = lines.number().value_or(*r), b = lines.number().value_or(*r);
  const glm::vec3 colour(*r, g, b);
  return std::isfinite(glm::dot(colour, colour)) ? glm::max(colour, glm::vec3(0)) : glm::vec3(0);
}

/// Options come before the name, each with a known number of values (-s, -o and -t with one to three numbers). The name
/// is the rest of the line and may contain spaces.
MtlPicture read_picture(TextLines& lines) {
  MtlPicture picture;
  std::string_view rest = lines.rest();
  const auto take = [&] {
    const std::size_t end = std::min(rest.find_first_of(" \t"), rest.size());
    const std::string_view word = rest.substr(0, end);
    rest.remove_prefix(std::min(rest.find_first_not_of(" \t", end), rest.size()));
    return word;
  };
  const auto next_is_number = [&] {
    return !rest.empty() && (std::isdigit(static_cast<unsigned char>(rest[0])) || rest[0] == '.' ||
                             (rest.size() > 1 && (rest[0] == '-' || rest[0] == '+') &&
                              !std::isalpha(static_cast<unsigned char>(rest[1]))));
  };
  while (rest.size() > 1 && rest[0] == '-') {
    const std::string_view option = take();
    if (option == "-s" || option == "-o" || option == "-t") {
      for (int i = 0; i < 3 && next_is_number(); ++i) take();
      picture.placed = true;
    } else if (option == "-mm") {
      take(), take();
    } else {
      const std::string_view value = take();
      if (option == "-clamp") picture.clamp = value == "on";
    }
  }
  picture.file = rest;
  return picture;
}

/// One statement about a material; `keyword` in lower case.
void read_statement(const std::string& keyword, TextLines& lines, MtlMaterial& m) {
  if (keyword == "kd")
    m.kd = read_colour(lines, m.kd);
  else if (keyword == "ks")
    m.ks = read_colour(lines, m.ks);
  else if (keyword == "ke")
    m.ke = read_colour(lines, m.ke);
  else if (keyword == "ns")
    m.ns = lines.number().value_or(m.ns);
  else if (keyword == "illum")
    m.illum = int(std::clamp(lines.number().value_or(2), 0.0f, 10.0f));
  else if (keyword == "d")
    m.transparent = lines.number().value_or(1) < 1;
  else if (keyword == "tr")
    m.transparent = lines.number().value_or(0) > 0;
  else if (keyword == "map_kd")
    m.map_kd = read_picture(lines);
  else if (keyword == "map_ks")
    m.map_ks = read_picture(lines);
  else if (keyword == "map_bump" || keyword == "bump")
    m.bump = read_picture(lines);
  else if (keyword == "norm" || keyword == "map_kn")
    m.normal = read_picture(lines);
  else if (keyword == "disp" || keyword == "map_disp")
    m.displacement = read_picture(lines);
}

bool is_grey(const Image& image) {
  constexpr float step = 1.5f / 255;  // JPEG slightly tints grey pictures
  return std::ranges::all_of(image.pixels(),
                             [](const Rgba& p) { return std::abs(p.r - p.g) <= step && std::abs(p.g - p.b) <= step; });
}

/// Adds one material's textures; shares those that other materials use in the same way.
struct PictureLoader {
  const std::filesystem::path& folder;
  const std::string& folder_of_library;  ///< below it
  Scene& scene;
  std::map<std::string, int>& textures;
  Notes& notes;

  TextureIndex operator()(const MtlPicture& picture, Encoding encoding) const {
    if (picture.file.empty()) return {};
    // Beside the library that names it, or beside the model.
    const std::string beside = folder_of_library + "/" + picture.file;
    const std::string file = !folder_of_library.empty() && has_file(folder, beside) ? beside : picture.file;
    const std::string key = fmt::format("{}|{}|{}", int(encoding), picture.clamp, file);
    if (const auto found = textures.find(key); found != textures.end()) return found->second;
    auto pixels = read_model_picture(folder, file, encoding, notes);
    if (!pixels) return {};
    if (picture.placed)
      notes.add(
          fmt::format("the picture '{}' is scaled or moved by its material library: that is left out", picture.file));
    return textures[key] = add_limited_texture(scene, {.name = file,
                                                       .pixels = std::move(*pixels),
                                                       .wrap = picture.clamp ? Wrap::clamp_to_edge : Wrap::repeat});
  }
};

}  // namespace

bool has_file(const std::filesystem::path& folder, const std::string& name) {
  std::error_code ignored;
  try {
    return std::filesystem::is_regular_file(resolve_reference(folder, name), ignored);
  } catch (const Error&) {
    return false;
  }
}

void read_mtl(const std::filesystem::path& folder, const std::string& name,
              std::map<std::string, MtlMaterial>& materials, Notes& notes) {
  std::filesystem::path path;
  try {
    path = resolve_reference(folder, name);
  } catch (const Error& error) {
    notes.add(fmt::format("a material library is left out: {}", error.what()));
    return;
  }
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) {
    notes.add(fmt::format("a material library is left out: there is no file '{}'", path.string()));
    return;
  }
  const std::filesystem::path below = path.parent_path().lexically_relative(folder);
  const std::string folder_of_library = below == "." ? "" : below.generic_string();
  const std::string text = read_file(path);
  TextLines lines(text, path.string());
  MtlMaterial* material = nullptr;
  while (lines.next()) {
    std::string keyword(lines.word());
    std::ranges::transform(keyword, keyword.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    if (keyword == "newmtl") {
      material = &materials[std::string(lines.rest())];
      *material = {.folder = folder_of_library};
    } else if (material) {
      try {
        read_statement(keyword, lines, *material);
      } catch (const Error& error) {
        notes.add(fmt::format("{}; this line of a material is left out", error.what()));
      }
    }
  }
}

Material make_material(const std::string& name, const MtlMaterial& mtl, const std::filesystem::path& folder,
                       Scene& scene, std::map<std::string, int>& textures, Notes& notes) {
  const PictureLoader load{folder, mtl.folder, scene, textures, notes};
  if (mtl.transparent) notes.add(fmt::format("material '{}' is transparent: that is left out", name));
  Material material{.name = name, .diffuse = mtl.kd, .emission = mtl.ke, .two_sided = true};
  material.diffuse_texture = load(mtl.map_kd, Encoding::linear);
  if (material.diffuse_texture && mtl.kd == glm::vec3(0)) material.diffuse = glm::vec3(1);
  if (mtl.illum >= 2) {
    material.specular = mtl.ks;
    material.specular_texture = load(mtl.map_ks, Encoding::linear);
    material.exponent = std::isnan(mtl.ns) ? 0 : std::clamp(mtl.ns, 0.0f, 1e6f);
  }
  material.height_texture = load(mtl.displacement, Encoding::data);
  material.normal_texture = load(mtl.normal, Encoding::data);
  if (const TextureIndex bump = load(mtl.bump, Encoding::data)) {
    TextureIndex& use = is_grey(scene.textures[*bump].pixels) ? material.height_texture : material.normal_texture;
    if (!use) use = bump;
  }
  return material;
}

}  // namespace atelier::scene_import
