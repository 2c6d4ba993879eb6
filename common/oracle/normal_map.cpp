#include "oracle/normal_map.hpp"

#include "oracle/texture.hpp"

namespace atelier::oracle {

SurfacePoint under_normal_map(const Scene& scene, SurfacePoint point) {
  const TextureIndex& map = scene.materials[std::size_t(point.material)].normal_texture;
  const glm::dvec3 tangent(point.tangent);
  if (!map || tangent == glm::dvec3(0)) return point;
  glm::dvec3 stored = 2.0 * texel_colour(scene.textures[std::size_t(*map)], point.texcoord) - 1.0;
  // Too short to have a direction. 1e-4 as in the contract; the scenes of the course have no texel near it.
  stored = glm::length(stored) < 1e-4 ? glm::dvec3(0, 0, 1) : glm::normalize(stored);
  const glm::dvec3 normal = point.normal_length * point.normal;
  const glm::dvec3 bitangent = (point.tangent.w < 0 ? -1.0 : 1.0) * glm::cross(normal, tangent);
  const glm::dvec3 mapped = stored.x * tangent + stored.y * bitangent + stored.z * normal;
  if (mapped == glm::dvec3(0)) return point;
  point.normal = glm::normalize(mapped);
  point.normal_length = 1;
  return point;
}

}  // namespace atelier::oracle
