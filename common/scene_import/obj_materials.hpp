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
  bool placed = false;  ///< has options that scale or move it, which are not used
};

/// A material in an MTL file. Colours are assumed to be linear.
struct MtlMaterial {
  std::string folder = {};  ///< of its library, below the model's; empty: the model's own
  glm::vec3 kd{0.8f}, ks{0}, ke{0};
  float ns = 0;
  int illum = 2;             ///< 0 and 1: no highlight
  bool transparent = false;  ///< not used
  MtlPicture map_kd, map_ks, bump, normal, displacement;
};

/// Whether there is such a file below `folder`.
bool has_file(const std::filesystem::path& folder, const std::string& name);

/// Reads a library below `folder` into `materials`, by name. Adds a note if it is missing, and for each statement that
/// cannot be read: a material is no reason to refuse a model.
void read_mtl(const std::filesystem::path& folder, const std::string& name,
              std::map<std::string, MtlMaterial>& materials, Notes& notes);

/// As Blinn-Phong: kd, ks and ns as MTL defines them (illum 0 and 1 have no highlight). A black kd with a texture is
/// treated as white: exporters write it, and viewers show the texture. A bump texture is used as heights if it is grey,
/// otherwise as normals: exporters write both. Materials are two-sided, since OBJ does not define the front.
Material make_material(const std::string& name, const MtlMaterial& mtl, const std::filesystem::path& folder,
                       Scene& scene, std::map<std::string, int>& textures, Notes& notes);

}  // namespace atelier::scene_import
