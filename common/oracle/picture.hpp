// A whole picture: many rays, on all processors.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "image/image.hpp"
#include "oracle/camera.hpp"
#include "oracle/shade.hpp"

namespace atelier::oracle {

/// What a pixel tells of the point that is seen there. Where nothing is seen: `colour` the scene's background, all
/// others zero.
enum class Output {
  colour,    ///< linear light
  diffuse,   ///< its ambient and diffuse part
  specular,  ///< its highlights
  normal,    ///< in world space, as n/2 + 1/2; a half where the surface has none
  depth,     ///< 0..1 as OpenGL stores it
  position,  ///< in world space, metres from PictureRequest::position_origin
  texcoord,  ///< (u, v, 0)
  thing,     ///< which node or shape (SurfacePoint::thing) plus one
};

std::vector<std::string> output_names();
/// Throws Error naming those that there are.
Output output_named(const std::string& name);

struct PictureRequest {
  Camera camera;
  glm::ivec2 size{256, 256};  ///< pixels, 1..Image::max_side a side
  Output output = Output::colour;
  int samples = 1;  ///< n x n a pixel on a regular grid, 1..64, averaged; 1: the pixel's middle, as OpenGL takes it
  Shading shading;
  bool reversed_depth = false;    ///< of Output::depth
  glm::dvec3 position_origin{0};  ///< of Output::position: far from the world's origin floats are too coarse
  int threads = 0;                ///< 0: one for each processor. The picture does not depend on it, to the last bit
  std::function<void(double)> progress;  ///< told now and then, by the calling thread: how much is done, 0..1
};

/// Traces a picture, row 0 on top, opacity 1. Each pixel is the mean of its samples. Throws Error where size, samples
/// or soft shadows are out of range, and what `shading.surface` or `progress` throws.
Image trace(const World& world, const PictureRequest& request);

}  // namespace atelier::oracle
