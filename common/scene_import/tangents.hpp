// Tangents for meshes with a normal map but without tangents in the file.
#pragma once

#include "scene/scene.hpp"

namespace atelier::scene_import {

/// Fills mesh.tangents with standard_tangents(). A vertex whose corners have different tangents is split: it keeps the
/// first of them, and a copy for each further one is appended, in the order of the corners; all else keeps its place.
/// Nothing is filled in if no triangle has an area in the texture: there is no direction of +u, and the standard's
/// default would be as good as any.
void add_standard_tangents(Mesh& mesh);

}  // namespace atelier::scene_import
