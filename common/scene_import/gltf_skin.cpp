#include "scene_import/gltf_skin.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene_import/gltf_accessor.hpp"
#include "scene_import/scene_import.hpp"

namespace atelier::scene_import {
namespace {

constexpr int per_set = 4;    // joints of a vertex in JOINTS_n
constexpr int most_sets = 8;  // 32 joints for a vertex: 256 bytes

/// The inverse bind matrices of a skin's `count` joints; identities if it names none.
std::vector<glm::dmat4> inverse_bind_matrices(const GltfFile& file, const JsonField& skin, std::size_t count) {
  const auto accessor = skin.index_or_none("inverseBindMatrices", file.root().size_or_zero("accessors"));
  if (!accessor) return std::vector<glm::dmat4>(count, glm::dmat4(1));
  if (const std::size_t given = accessor_count(file, *accessor); given < count || given > max_import_nodes)
    file.root().at("accessors")[std::size_t(*accessor)].at("count").fail(
        fmt::format("{} inverse bind matrices for {} joints (allowed: {}..{})", given, count, count, max_import_nodes));

  std::vector<glm::dmat4> matrices = read_matrix_accessor(file, *accessor);
  matrices.resize(count);
  for (std::size_t i = 0; i < count; ++i)
    for (int column = 0; column < 4; ++column) {
      for (int row = 0; row < 4; ++row)
        if (!std::isfinite(matrices[i][column][row]))
          skin.at("inverseBindMatrices").fail(fmt::format("matrix {} is not finite", i));
      const double needed = column == 3 ? 1 : 0;
      if (std::abs(matrices[i][column][3] - needed) > 1e-4)
        file.notes->add(
            fmt::format("{}: accessors[{}]: the last row of an inverse bind matrix is not 0 0 0 1, and is "
                        "taken as that",
                        file.name, *accessor));
      matrices[i][column][3] = needed;
    }
  return matrices;
}

/// Writes v as a direction of length 1, or 0 if it has none.
void write_direction(float* to, const glm::dvec3& v) {
  const double size = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  const bool sound = size > 0 && std::isfinite(size);
  const glm::dvec3 direction = sound ? glm::normalize(v / size) : glm::dvec3(0);
  for (int i = 0; i < 3; ++i) to[i] = float(direction[i]);
}

bool mirrors(const glm::dmat4& m) {
  return glm::determinant(glm::dmat3(m)) < 0;
}

}  // namespace

std::optional<Skin> read_skin(const GltfFile& file, int index, const NodePlaces& places) {
  const JsonField field = file.root().at("skins")[std::size_t(index)], joints = field.at("joints");
  if (joints.size() == 0) joints.fail("0 joints (allowed: at least 1)");
  Skin skin{.index = index, .joints = inverse_bind_matrices(file, field, joints.size())};
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const int node = joints[i].index(file.root().size_or_zero("nodes"));
    const glm::dmat4* world = places(node);
    if (!world) {
      file.notes->add(
          fmt::format("{}: skins[{}] is left out: its joint nodes[{}] is not in the scene; shapes are as in "
                      "their meshes, placed by their nodes",
                      file.name, index, node));
      return {};
    }
    if (i == 0) skin.origin = glm::dvec3((*world)[3]);
    skin.joints[i] = *world * skin.joints[i];
  }
  return skin;
}

Skinning::Skinning(const GltfFile& file, const JsonField& primitive, std::size_t count, const SkinnedNode& node)
    : node_(node), count_(count) {
  const JsonField attributes = primitive.at("attributes");
  for (int n = 0; attributes.find(fmt::format("JOINTS_{}", n).c_str()); ++n) {
    if (n == most_sets) attributes.fail(fmt::format("more than {} sets of joints", most_sets));
    read_set(file, primitive, n);
  }
  check_weights(file, primitive);
}

void Skinning::read_set(const GltfFile& file, const JsonField& primitive, int n) {
  const std::string joints_name = fmt::format("JOINTS_{}", n), weights_name = fmt::format("WEIGHTS_{}", n);
  const auto joints = attribute(file, primitive, joints_name, count_);
  const auto weights = attribute(file, primitive, weights_name, count_);
  if (!joints || !weights) return;  // with a note of what is missing: of its length, or of vertices without weights
  const std::vector<std::uint32_t> joint = read_unsigned_accessor(file, *joints, per_set);
  const std::vector<float> weight = read_accessor(file, *weights, per_set);
  Set& set = sets_.emplace_back(joint.size());
  for (std::size_t i = 0; i < joint.size(); ++i) set[i] = {joint[i], weight[i]};
}

void Skinning::check_weights(const GltfFile& file, const JsonField& primitive) {
  // Four weights rounded to bytes sum to 1 within 0.008.
  constexpr double rounding = 0.01;
  std::size_t unsound = 0, unequal = 0, none = 0;
  for (std::size_t vertex = 0; vertex < count_; ++vertex) {
    double sum = 0;
    for (Set& set : sets_)
      for (std::size_t i = per_set * vertex; i < per_set * (vertex + 1); ++i) {
        auto& [joint, weight] = set[i];
        if (!(weight >= 0) || !std::isfinite(weight)) {
          ++unsound;
          weight = 0;
        }
        sum += weight;
        // A joint without weight may be any number: many programs leave there what they had.
        if (weight > 0 && joint >= node_.skin.joints.size())
          primitive.fail(fmt::format("vertex {} follows joint {} of {} (skins[{}].joints)", vertex, joint,
                                     node_.skin.joints.size(), node_.skin.index));
        if (weight == 0) joint = 0;
      }
    none += sum == 0;
    unequal += sum > 0 && std::abs(sum - 1) > rounding;
  }
  const auto note = [&](std::size_t vertices, const char* sentence) {
    if (vertices > 0) file.notes->add(fmt::format("{}: {}: {} {}", file.name, primitive.path(), vertices, sentence));
  };
  note(unsound, "weights of joints were negative or not finite and count as 0");
  note(unequal, "vertices had weights of joints that do not sum to 1 and were divided by their sum");
  note(none, "vertices have no weights of joints and are placed by the mesh's node");
}

glm::dmat4 Skinning::matrix(std::size_t vertex) const {
  glm::dmat4 sum(0);
  double weights = 0;
  for (const Set& set : sets_)
    for (std::size_t i = per_set * vertex; i < per_set * (vertex + 1); ++i) {
      if (set[i].weight == 0) continue;
      sum += double(set[i].weight) * node_.skin.joints[set[i].joint];
      weights += set[i].weight;
    }
  return weights == 0 ? node_.world : sum / weights;
}

void Skinning::move_positions(std::vector<float>& positions) const {
  for (std::size_t v = 0; v < count_; ++v) {
    float* p = &positions[3 * v];
    const glm::dvec3 moved = glm::dvec3(matrix(v) * glm::dvec4(p[0], p[1], p[2], 1)) - node_.skin.origin;
    for (int i = 0; i < 3; ++i) p[i] = float(moved[i]);
  }
}

void Skinning::turn_normals(std::vector<float>& normals) const {
  for (std::size_t v = 0; v < count_; ++v) {
    float* n = &normals[3 * v];
    // The matrix of cofactors is the inverse transpose times the determinant, and exists for every matrix.
    const glm::dmat3 m(matrix(v));
    const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    const double side = glm::determinant(m) < 0 ? -1 : 1;
    write_direction(n, side * (cofactors * glm::dvec3(n[0], n[1], n[2])));
  }
}

void Skinning::turn_tangents(std::vector<float>& tangents) const {
  for (std::size_t v = 0; v < count_; ++v) {
    float* t = &tangents[4 * v];
    const glm::dmat4 m = matrix(v);
    write_direction(t, glm::dmat3(m) * glm::dvec3(t[0], t[1], t[2]));
    if (mirrors(m)) t[3] = -t[3];
  }
}

void Skinning::turn_triangles(std::vector<std::uint32_t>& indices) const {
  std::vector<bool> mirrored(count_);
  for (std::size_t v = 0; v < count_; ++v) mirrored[v] = mirrors(matrix(v));
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
    if (mirrored[indices[i]] + mirrored[indices[i + 1]] + mirrored[indices[i + 2]] >= 2)
      std::swap(indices[i + 1], indices[i + 2]);
}

}  // namespace atelier::scene_import
