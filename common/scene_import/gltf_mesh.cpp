#include "scene_import/gltf_mesh.hpp"

#include <fmt/format.h>

#include <cmath>

#include "scene_import/gltf_accessor.hpp"
#include "scene_import/normals.hpp"
#include "scene_import/scene_import.hpp"

namespace atelier::scene_import {
namespace {

enum class Mode { points, lines, line_loop, line_strip, triangles, strip, fan };

/// Converts indices of strips and fans to three per triangle, with OpenGL's winding.
std::vector<std::uint32_t> take_apart(Mode mode, std::vector<std::uint32_t> corners) {
  if (mode == Mode::triangles) {
    corners.resize(corners.size() / 3 * 3);
    return corners;
  }
  std::vector<std::uint32_t> triangles;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const bool turned = mode == Mode::strip && i % 2 == 1;
    const std::uint32_t first = mode == Mode::fan ? corners[0] : corners[turned ? i - 1 : i - 2];
    const std::uint32_t second = mode == Mode::fan || !turned ? corners[i - 1] : corners[i - 2];
    triangles.insert(triangles.end(), {first, second, corners[i]});
  }
  return triangles;
}

void read_positions(Mesh& mesh, const JsonField& primitive, const std::vector<float>& values) {
  for (std::size_t i = 0; i < values.size() / 3; ++i) {
    const glm::vec3 p(values[3 * i], values[3 * i + 1], values[3 * i + 2]);
    if (!(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)))
      primitive.fail(fmt::format("the position of vertex {} is not finite ({}, {}, {})", i, p.x, p.y, p.z));
    mesh.vertices.push_back({.position = p});
  }
}

/// KHR_texture_transform's matrix: translation * rotation * scale. Then v is flipped.
glm::vec2 transformed(const TexcoordTransform& t, const glm::dvec2& uv) {
  const glm::dvec2 scaled = uv * t.scale;
  const double s = std::sin(t.rotation), c = std::cos(t.rotation);
  const glm::dvec2 turned(c * scaled.x + s * scaled.y, -s * scaled.x + c * scaled.y);
  return {turned.x + t.offset.x, 1 - (turned.y + t.offset.y)};
}

void read_texcoords(Mesh& mesh, const GltfFile& file, const std::vector<float>& values,
                    const TexcoordTransform& transform) {
  std::size_t broken = 0;
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const glm::vec2 uv = transformed(transform, {values[2 * i], values[2 * i + 1]});
    const bool sound = std::isfinite(uv.x) && std::isfinite(uv.y);
    broken += !sound;
    mesh.vertices[i].texcoord = sound ? uv : glm::vec2(0);
  }
  if (broken > 0)
    file.notes->add(fmt::format("{}: {} texture coordinates were not finite and became 0", file.name, broken));
}

/// Keeps either all tangents or none: a few invalid ones would give unexplainable lighting.
void read_tangents(Mesh& mesh, const GltfFile& file, const std::vector<float>& values) {
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const glm::vec3 t(values[4 * i], values[4 * i + 1], values[4 * i + 2]);
    const float length = glm::length(t);
    if (!(length > 1e-6f) || !std::isfinite(length)) {
      mesh.tangents.clear();
      file.notes->add(
          fmt::format("{}: tangents are left out: the tangent of vertex {} has no direction", file.name, i));
      return;
    }
    mesh.tangents.emplace_back(t / length, values[4 * i + 3] < 0 ? -1.0f : 1.0f);
  }
}

void read_indices(Mesh& mesh, const GltfFile& file, const JsonField& primitive, Mode mode) {
  std::vector<std::uint32_t> corners;
  if (const auto index = primitive.index_or_none("indices", file.root().size_or_zero("accessors"))) {
    corners = read_unsigned_accessor(file, *index, 1);
  } else {
    corners.resize(mesh.vertices.size());
    for (std::size_t i = 0; i < corners.size(); ++i) corners[i] = std::uint32_t(i);
  }
  for (const std::uint32_t corner : corners)
    if (corner >= mesh.vertices.size())
      primitive.fail(fmt::format("index {} of {} vertices", corner, mesh.vertices.size()));
  mesh.indices = take_apart(mode, std::move(corners));
}

}  // namespace

void Budget::use(const JsonField& where, std::size_t more_vertices, std::size_t more_triangles) {
  vertices += more_vertices;
  triangles += more_triangles;
  if (vertices > max_import_vertices || triangles > max_import_triangles)
    where.fail(fmt::format("more than {} vertices or triangles in all", max_import_vertices));
}

std::optional<Mesh> read_primitive(const GltfFile& file, const JsonField& primitive, const TexcoordTransform& transform,
                                   const SkinnedNode* skinned, Budget& budget) {
  const auto mode = Mode(primitive.integer_or("mode", 0, 6, int(Mode::triangles)));
  const std::size_t accessors = file.root().size_or_zero("accessors");
  const auto position = primitive.at("attributes").index_or_none("POSITION", accessors);
  if (mode < Mode::triangles || !position) {
    file.notes->add(
        fmt::format("{}: {} are left out", file.name, position ? "points and lines" : "shapes without positions"));
    return {};
  }
  const auto extensions = primitive.find("extensions");
  const JsonField positions = file.root().at("accessors")[std::size_t(*position)];
  if (extensions && extensions->find("KHR_draco_mesh_compression") && !positions.find("bufferView"))
    primitive.fail("its data is compressed (KHR_draco_mesh_compression), which is not supported");
  if (primitive.at("attributes").find("COLOR_0"))
    file.notes->add(fmt::format("{}: colours of vertices are left out", file.name));
  if (primitive.size_or_zero("targets") > 0)
    file.notes->add(fmt::format("{}: morph targets are left out: shapes are as without them", file.name));
  // Check the limits on the file's counts before allocating.
  const std::size_t count = accessor_count(file, *position);
  const auto indices = primitive.index_or_none("indices", accessors);
  const std::size_t corners = indices ? accessor_count(file, *indices) : count;
  budget.use(primitive, count, mode == Mode::triangles ? corners / 3 : corners);

  std::optional<Skinning> skinning;
  if (skinned) skinning.emplace(file, primitive, count, *skinned);
  Mesh mesh;
  std::vector<float> places = read_accessor(file, *position, 3);
  if (skinning) skinning->move_positions(places);
  read_positions(mesh, primitive, places);
  if (const auto texcoord = attribute(file, primitive, "TEXCOORD_0", count))
    read_texcoords(mesh, file, read_accessor(file, *texcoord, 2), transform);
  read_indices(mesh, file, primitive, mode);
  if (mesh.indices.empty()) return {};
  if (skinning) skinning->turn_triangles(mesh.indices);

  const auto normal = attribute(file, primitive, "NORMAL", count);
  if (!normal) {
    make_flat(mesh);
    return mesh;
  }
  std::vector<float> normals = read_accessor(file, *normal, 3);
  if (skinning) skinning->turn_normals(normals);
  for (std::size_t i = 0; i < count; ++i)
    mesh.vertices[i].normal = {normals[3 * i], normals[3 * i + 1], normals[3 * i + 2]};
  if (const std::size_t fixed = fix_normals(mesh))
    file.notes->add(
        fmt::format("{}: {} normals had no direction and were computed from the triangles", file.name, fixed));
  if (const auto tangent = attribute(file, primitive, "TANGENT", count)) {
    std::vector<float> tangents = read_accessor(file, *tangent, 4);
    if (skinning) skinning->turn_tangents(tangents);
    read_tangents(mesh, file, tangents);
  }
  return mesh;
}

}  // namespace atelier::scene_import
