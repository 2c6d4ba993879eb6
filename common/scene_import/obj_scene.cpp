#include "scene_import/obj_scene.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <map>
#include <sstream>
#include <unordered_map>

#include "base/error.hpp"
#include "scene_import/normals.hpp"
#include "scene_import/obj_file.hpp"
#include "scene_import/obj_materials.hpp"
#include "scene_import/polygon.hpp"
#include "scene_import/scene_import.hpp"
#include "scene_import/tangents.hpp"

namespace atelier::scene_import {
namespace {

/// A triangle of a face: indices into ObjFile::corners, and the face that it belongs to.
struct Triangle {
  std::array<std::size_t, 3> corners;
  std::size_t face;
};

std::vector<Triangle> cut_faces(const ObjFile& obj) {
  std::vector<Triangle> triangles;
  std::vector<glm::vec3> outline;
  for (std::size_t f = 0; f < obj.faces.size(); ++f) {
    const ObjFace& face = obj.faces[f];
    outline.clear();
    for (int i = 0; i < face.count; ++i) outline.push_back(obj.positions[obj.corners[face.first + i].position]);
    for (const auto& [a, b, c] : triangulate(outline))
      triangles.push_back({{face.first + a, face.first + b, face.first + c}, f});
  }
  return triangles;
}

bool is_direction(const glm::vec3& n) {
  const float size = glm::dot(n, n);
  return std::isfinite(size) && size > 1e-12f;
}

/// A normal for each corner of each triangle: the file's if it is valid, otherwise computed by smoothing.
std::vector<std::array<glm::vec3, 3>> corner_normals(const ObjFile& obj, const std::vector<Triangle>& triangles,
                                                     Notes& notes, const std::string& name) {
  std::size_t broken = 0, missing = 0;
  for (const Triangle& triangle : triangles)
    for (const std::size_t c : triangle.corners) {
      if (obj.corners[c].normal < 0)
        ++missing;
      else if (!is_direction(obj.normals[obj.corners[c].normal]))
        ++broken;
    }
  if (broken > 0)
    notes.add(fmt::format("{}: {} normals had no direction and were computed from the triangles", name, broken));

  std::vector<std::array<glm::vec3, 3>> normals(triangles.size());
  if (missing + broken > 0) {
    std::vector<Facet> facets;
    for (const Triangle& t : triangles) {
      const auto position = [&](int i) { return std::uint32_t(obj.corners[t.corners[i]].position); };
      facets.push_back({{position(0), position(1), position(2)}, obj.faces[t.face].smoothing});
    }
    normals = facet_normals(obj.positions, facets);
  }
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      const int given = obj.corners[triangles[t].corners[i]].normal;
      if (given >= 0 && is_direction(obj.normals[given])) normals[t][i] = glm::normalize(obj.normals[given]);
    }
  return normals;
}

/// Corners with equal keys share a vertex: the same position and texture coordinate in the file, and the same normal.
struct VertexKey {
  int position, texcoord;
  glm::vec3 normal;
  bool operator==(const VertexKey&) const = default;
};

struct VertexKeyHash {
  std::size_t operator()(const VertexKey& key) const {
    std::uint64_t h = 0xcbf29ce484222325u;  // FNV-1a over 32-bit words
    for (const std::uint32_t word :
         {std::uint32_t(key.position), std::uint32_t(key.texcoord), std::bit_cast<std::uint32_t>(key.normal.x + 0.0f),
          std::bit_cast<std::uint32_t>(key.normal.y + 0.0f), std::bit_cast<std::uint32_t>(key.normal.z + 0.0f)})
      h = (h ^ word) * 0x100000001b3u;
    return h ^ h >> 32;
  }
};

/// Collects the triangles of one object and material.
struct Group {
  Mesh mesh;
  std::unordered_map<VertexKey, std::uint32_t, VertexKeyHash> vertices;

  void add(const ObjFile& obj, const ObjCorner& corner, const glm::vec3& normal) {
    const auto next = std::uint32_t(mesh.vertices.size());
    const auto [place, added] = vertices.try_emplace({corner.position, corner.texcoord, normal}, next);
    if (added)
      mesh.vertices.push_back({obj.positions[corner.position], normal,
                               corner.texcoord < 0 ? glm::vec2(0) : obj.texcoords[corner.texcoord]});
    mesh.indices.push_back(place->second);
  }
};

/// The scene's material for each name in the file, and last the default for faces without a name.
std::vector<int> add_materials(const ObjFile& obj, const std::filesystem::path& path, Scene& scene, Notes& notes) {
  if (obj.missing_attributes > 0)
    notes.add(fmt::format("{}: {} numbers of texture coordinates or normals name nothing and count as absent",
                          path.string(), obj.missing_attributes));
  std::map<std::string, MtlMaterial> library;
  for (const std::string& line : obj.libraries) {
    // One name, which may contain blanks, or several.
    std::istringstream words(line);
    if (has_file(path.parent_path(), line) || line.empty())
      read_mtl(path.parent_path(), line, library, notes);
    else
      for (std::string name; words >> name;) read_mtl(path.parent_path(), name, library, notes);
  }
  std::map<std::string, int> textures;
  std::vector<int> places;
  for (const std::string& name : obj.materials) {
    auto found = library.find(name);
    if (found == library.end()) found = library.find(name.substr(0, name.find(" #")));  // with a comment
    if (found == library.end())
      notes.add(
          fmt::format("{}: material '{}' is in none of its libraries; grey is used instead", path.string(), name));
    const MtlMaterial mtl = found == library.end() ? MtlMaterial{} : found->second;
    scene.materials.push_back(make_material(name, mtl, path.parent_path(), scene, textures, notes));
    places.push_back(int(scene.materials.size()) - 1);
  }
  scene.materials.push_back(make_material("default", {}, path.parent_path(), scene, textures, notes));
  places.push_back(int(scene.materials.size()) - 1);
  return places;
}

}  // namespace

Imported read_obj(const std::filesystem::path& path, Notes& notes) {
  const ObjFile obj = read_obj_file(path);
  const std::vector<Triangle> triangles = cut_faces(obj);
  const auto normals = corner_normals(obj, triangles, notes, path.string());

  std::map<std::pair<int, int>, Group> groups;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const ObjFace& face = obj.faces[triangles[t].face];
    Group& group = groups[{face.object, face.material}];
    for (int i = 0; i < 3; ++i) group.add(obj, obj.corners[triangles[t].corners[i]], normals[t][i]);
  }
  if (groups.size() > max_import_nodes)
    throw Error(fmt::format("{}: more than {} groups", path.string(), max_import_nodes));

  Imported result;
  const std::vector<int> materials = add_materials(obj, path, result.scene, notes);
  for (auto& [key, group] : groups) {
    const auto [object, material] = key;
    const int used = material < 0 ? materials.back() : materials[material];
    group.mesh.name = obj.objects[object];
    if (result.scene.materials[used].normal_texture) add_standard_tangents(group.mesh);
    result.scene.meshes.push_back(std::move(group.mesh));
    result.scene.nodes.push_back(
        {.name = obj.objects[object], .mesh = int(result.scene.meshes.size()) - 1, .material = used});
  }
  return result;
}

}  // namespace atelier::scene_import
