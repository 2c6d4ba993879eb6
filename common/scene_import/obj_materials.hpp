// Materials of Wavefront MTL files.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "scene_import/notes.hpp"

namespace atelier::scene_import {

/// A texture reference in an MTL file.
struct MtlPicture {
  std::string file;  ///< empty: none
  bool clamp = false;
};

/// A material in an MTL file. Colours are assumed to be linear.
struct MtlMaterial {
  glm::vec3 kd{0.8f}, ks{0}, ke{0};
  float ns = 0;
  int illum = 2;  ///< 0 and 1: no highlight
  MtlPicture map_kd, map_ks, bump, normal, displacement;
};

/// Reads a library below `folder` into `materials`, by name. Adds a note if it is missing; throws Error "file:line:
/// ..." if it is invalid.
void read_mtl(const std::filesystem::path& folder, const std::string& name,
              std::map<std::string, MtlMaterial>& materials, Notes& notes);

/// As Blinn-Phong: kd, ks and ns as MTL defines them (illum 0 and 1 have no highlight). A black kd with a texture is
/// treated as white: exporters write it, and viewers show the texture. A bump texture is used as heights if it is grey,
/// otherwise as normals: exporters write both. Materials are two-sided, since OBJ does not define the front.
Material make_material(const std::string& name, const MtlMaterial& mtl, const std::filesystem::path& folder,
                       Scene& scene, std::map<std::string, int>& textures, Notes& notes);

}  // namespace atelier::scene_import
