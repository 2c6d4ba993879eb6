// The normal of a surface point under its material's normal map.
#pragma once

#include "oracle/world.hpp"

namespace atelier::oracle {

/// The point with the normal that its material's normal texture stores there, of unit length; unchanged if the material
/// has no such texture, or the point no tangent. The axes of tangent space are the interpolated tangent T, w cross(N,
/// T) and the interpolated normal N, none of them normalised (Mikkelsen 2008).
SurfacePoint under_normal_map(const Scene& scene, SurfacePoint point);

}  // namespace atelier::oracle
