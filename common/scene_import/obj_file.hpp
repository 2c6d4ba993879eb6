// The content of a Wavefront OBJ file: lists of numbers, and faces that index them.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace atelier::scene_import {

/// A corner of a face: indices into ObjFile's lists, -1 for none.
struct ObjCorner {
  int position = -1, texcoord = -1, normal = -1;
};

struct ObjFace {
  std::size_t first = 0;  ///< its corners are ObjFile::corners[first .. first + count)
  int count = 0;          ///< 3 or more
  int object = 0;         ///< index into ObjFile::objects
  int material = -1;      ///< index into ObjFile::materials, -1 before the first usemtl
  int smoothing = -1;     ///< 0 off, 1 and above a group, -1 before the first s
};

struct ObjFile {
  std::vector<glm::vec3> positions;  ///< all finite
  std::vector<glm::vec3> normals;    ///< unchecked: may be zero or not finite
  std::vector<glm::vec2> texcoords;
  std::vector<ObjCorner> corners;
  std::vector<ObjFace> faces;
  std::vector<std::string> objects;    ///< names of o and g; the first is the file's name
  std::vector<std::string> materials;  ///< names of usemtl
  std::vector<std::string> libraries;  ///< the rests of the lines of mtllib: one name, or several
  std::size_t missing_attributes = 0;  ///< numbers of texture coordinates and normals that there are not
};

/// Parses the file; skips faces with fewer than three corners, points, lines and free-form surfaces. Throws Error
/// "file:line: ..." for an invalid number, a position that is not finite, a vertex number out of range, a face of more
/// than 10 000 corners, text that is not UTF-8 or ASCII, or if the limits of scene_import.hpp are exceeded.
ObjFile read_obj_file(const std::filesystem::path& path);

}  // namespace atelier::scene_import
