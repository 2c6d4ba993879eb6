// Materials of Wavefront MTL files.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "scene_import/notes.hpp"

namespace atelier::scene_import {

/// A picture as an MTL file names it.
struct MtlPicture {
  std::string file;  ///< empty: none
  bool clamp = false;
};

/// A material as an MTL file has it. Colours count as linear.
struct MtlMaterial {
  glm::vec3 kd{0.8f}, ks{0}, ke{0};
  float ns = 0;
  int illum = 2;  ///< 0 and 1: no highlight
  MtlPicture map_kd, map_ks, bump, normal, displacement;
};

/// Reads a library below `folder` into `materials`, by name. A library that is not there is noted; throws Error
/// "file:line: ..." where it is there and broken.
void read_mtl(const std::filesystem::path& folder, const std::string& name,
              std::map<std::string, MtlMaterial>& materials, Notes& notes);

/// As Blinn-Phong: kd, ks and ns are what MTL means by them (illum 0 and 1 have no highlight). A black kd under a
/// picture counts as white: exporters write it, and viewers show the picture. A bump picture counts as heights where it
/// is grey, otherwise as normals: exporters write both. Both sides are drawn: OBJ does not say which is the front.
Material make_material(const std::string& name, const MtlMaterial& mtl, const std::filesystem::path& folder,
                       Scene& scene, std::map<std::string, int>& textures, Notes& notes);

}  // namespace atelier::scene_import
