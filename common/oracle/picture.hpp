// A whole picture, on all CPU cores.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "image/image.hpp"
#include "oracle/camera.hpp"
#include "oracle/shade.hpp"

namespace atelier::oracle {

/// What a pixel shows of the visible surface point. Without one: for `colour` the scene's sky or background, for all
/// others zero.
enum class Output {
  colour,    ///< linear light
  diffuse,   ///< its ambient and diffuse part
  specular,  ///< its highlights
  normal,    ///< in world space, as n/2 + 1/2; 1/2 if the surface has none
  depth,     ///< 0..1 as OpenGL stores it
  position,  ///< in world space, metres from PictureRequest::position_origin
  texcoord,  ///< (u, v, 0)
  thing,     ///< which node or shape (SurfacePoint::thing) plus one
};

std::vector<std::string> output_names();
/// Throws Error naming the existing outputs for an unknown name.
Output output_named(const std::string& name);

/// What a lens shows at a place of the picture, (0, 0) its upper left corner and (1, 1) the lower right one: the
/// direction in view space (x right, y up, -z ahead), or none: black. The near and far planes are at these multiples of
/// its length.
using Lens = std::function<std::optional<glm::dvec3>(const glm::dvec2& place)>;

struct PictureRequest {
  Camera camera;
  glm::ivec2 size{256, 256};  ///< pixels, 1..Image::max_side per side
  Output output = Output::colour;
  int samples = 1;  ///< n x n per pixel on a regular grid, 1..64, averaged; 1: the pixel's centre, as in OpenGL
  Shading shading;
  Lens lens = {};                        ///< if set, replaces the projection of the camera
  bool reversed_depth = false;           ///< of Output::depth
  glm::dvec3 position_origin{0};         ///< of Output::position: for scenes far from the world's origin
  int threads = 0;                       ///< 0: one per CPU core. The picture is bit-identical for any number
  std::function<void(double)> progress;  ///< called occasionally on the calling thread with the fraction done, 0..1
};

/// Traces a picture, row 0 on top, opacity 1. Each pixel is the mean of its samples. Throws Error if size, samples,
/// portal depth or soft shadows are out of range, for depths under a lens, and what `shading.surface` or `progress`
/// throws.
Image trace(const World& world, const PictureRequest& request);

}  // namespace atelier::oracle
