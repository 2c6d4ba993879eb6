// Six targets that are the faces of one cube map: what is visible in all directions from a point.
#pragma once

#include <vector>

#include "gl/target.hpp"

namespace atelier {

struct CubeTargetSpec {
  int edge = 256;  ///< pixels
  ColourFormat colour = ColourFormat::rgba32f;
  DepthFormat depth = DepthFormat::depth24;
  int samples = 1;
  bool operator==(const CubeTargetSpec&) const = default;
};

class CubeTarget {
 public:
  /// Linear filtering, clamped. Throws Error as Target does if the driver does not support it.
  CubeTarget(Gl& gl, const CubeTargetSpec& spec);
  const CubeTargetSpec& spec() const { return spec_; }
  GLuint texture() const { return texture_.id(); }  ///< a GL_TEXTURE_CUBE_MAP

  /// The target of one face, 0..5: +x, -x, +y, -y, +z, -z. Rows are in the order of OpenGL's cube maps: the picture's
  /// lowest row is the face's first.
  const Target& face(int side) const { return faces_.at(std::size_t(side)); }

 private:
  CubeTargetSpec spec_;
  GlTexture texture_;
  std::vector<Target> faces_;
};

}  // namespace atelier
