// Tangents of a mesh in double precision, as step 05's contract defines them: the ground truth for its tangents.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "scene/scene.hpp"

namespace atelier::oracle {

/// One per vertex, object space: xyz of unit length along +u, w the sign of the bitangent w cross(N, T); 0 where there
/// is none. The mesh's own tangents if it has some.
std::vector<glm::dvec4> tangents_of(const Mesh& mesh);

}  // namespace atelier::oracle
