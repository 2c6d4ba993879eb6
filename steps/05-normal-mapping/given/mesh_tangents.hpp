// The tangents of a mesh that is drawn with some materials. Given.
#pragma once

#include <functional>
#include <vector>

#include "scene/scene.hpp"

namespace atelier {

/// The mesh's own tangents, or those of the student's vertex_tangents; none if no node shows the mesh with a material
/// that `needs` them.
std::vector<glm::vec4> mesh_tangents(const Scene& scene, int mesh, const std::function<bool(const Material&)>& needs);

}  // namespace atelier
