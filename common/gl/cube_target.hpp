// Six targets that are the sides of one cube map: what is seen all round a point.
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
  /// Linear filtering, clamped. Throws Error where the driver cannot have it, as Target does.
  CubeTarget(Gl& gl, const CubeTargetSpec& spec);
  const CubeTargetSpec& spec() const { return spec_; }
  GLuint texture() const { return texture_.id(); }  ///< a GL_TEXTURE_CUBE_MAP

  /// What is drawn into one side, 0..5: +x, -x, +y, -y, +z, -z. Its rows run as OpenGL's cube maps have them: the first
  /// row of the picture (the lowest) is the side's first.
  const Target& face(int side) const { return faces_.at(std::size_t(side)); }

 private:
  CubeTargetSpec spec_;
  GlTexture texture_;
  std::vector<Target> faces_;
};

}  // namespace atelier
