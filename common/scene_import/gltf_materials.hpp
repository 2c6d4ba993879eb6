// glTF's materials, textures, samplers and pictures.
#pragma once

#include <map>
#include <optional>
#include <utility>

#include "image/colour.hpp"
#include "scene/scene.hpp"
#include "scene_import/gltf_file.hpp"

namespace atelier::scene_import {

/// A transform of texture coordinates: KHR_texture_transform.
struct TexcoordTransform {
  glm::dvec2 offset{0}, scale{1};
  double rotation = 0;  ///< radians, counter-clockwise in glTF's coordinates, where v runs down
};

/// Turns materials into Blinn-Phong (see blinn_phong_of.hpp), adding each texture to the scene once per use.
class GltfMaterials {
 public:
  GltfMaterials(const GltfFile& file, Scene& scene) : file_(file), scene_(scene) {}

  /// The scene's index of materials[index], or of glTF's default material. Created at the first call.
  int material(std::optional<int> index);

  /// The transform of the material's colour texture; it is used for all of its textures.
  TexcoordTransform transform(std::optional<int> index) const;

 private:
  Material make(const JsonField& field);
  void read_metallic_roughness(Material& material, const JsonField& field);
  void read_specular_glossiness(Material& material, const JsonField& field);
  std::optional<Image> picture(const JsonField& texture_info, Encoding encoding);
  TextureIndex add_texture(const JsonField& texture_info, Image pixels);
  TextureIndex texture(const JsonField& holder, const char* key, Encoding encoding);
  /// x and y of its normals are multiplied by the file's "scale".
  TextureIndex normal_texture(const JsonField& material);

  const GltfFile& file_;
  Scene& scene_;
  std::map<int, int> made_;                                  ///< materials[] -> Scene::materials
  std::map<std::pair<int, Encoding>, int> shared_textures_;  ///< unmodified textures[] -> Scene::textures
};

}  // namespace atelier::scene_import
