// Ground truth: a double-precision ray tracer for a Scene. The pictures of the steps are compared with it. It therefore
// shares no code with the renderer, the steps or their shaders: no matrices, no shading, no rounding. Both use only the
// plain data of scene/ and the conventions of the contracts (which way is up in a texture, which up direction a camera
// straight above its target uses).
//
//   const oracle::World world(scene);
//   const Image truth = oracle::trace(world, {.camera = scene.camera, .size = {640, 480}, .samples = 4});
//
// The parts, in the order in which a picture is computed, each in its own file:
//
//   ray.hpp          a ray and its interval
//   frame.hpp        the right and up directions of a view
//   camera.hpp       camera rays and depth values
//   triangle.hpp     ray and triangle, without gaps between neighbours
//   shape.hpp        ray and sphere, cylinder wall, rectangle, height field: shapes that triangles only approximate
//   height_field.hpp ray and height field, a bilinear patch a cell
//   bvh.hpp          a bounding volume hierarchy
//   beam.hpp         a pyramid of rays, for conservative culling
//   world.hpp        a scene in world space; what a ray sees, what blocks a light
//   texture.hpp      the colour of a texture at a point
//   tangents.hpp     tangents of a mesh
//   normal_map.hpp   the normal under a normal map
//   light.hpp        incident light
//   light_image.hpp  images of lights in portals and mirrors
//   blinn_phong.hpp  reflected light, and the albedo
//   shading.hpp      options: which part of the light, which shadows
//   shadow.hpp       the visible fraction of a light
//   shade.hpp        the colour of a surface point
//   portal.hpp       rays through portals and mirrors
//   sky.hpp          the colour of the sky in a direction
//   picture.hpp      a whole picture, on all CPU cores
//
// There are no mipmaps and no filter except the box filter over n x n samples per pixel: supersampling is the truth
// that mipmaps and anti-aliasing approximate. Settings of a step that trade accuracy for speed therefore have no effect
// here; settings that change the picture (which lights are on, which normalisation) do.
//
// Extension points for later steps:
//   shadow factors         shading.hpp: a SurfaceColour that returns the `visibility` of one light
//   light in texture space picture.hpp: the same shading, at points of a texture instead of pixels
//   quadrature             blinn_phong.hpp: `albedo` is an example
#pragma once

#include "oracle/beam.hpp"
#include "oracle/blinn_phong.hpp"
#include "oracle/bvh.hpp"
#include "oracle/camera.hpp"
#include "oracle/frame.hpp"
#include "oracle/height_field.hpp"
#include "oracle/light.hpp"
#include "oracle/light_image.hpp"
#include "oracle/normal_map.hpp"
#include "oracle/picture.hpp"
#include "oracle/portal.hpp"
#include "oracle/ray.hpp"
#include "oracle/shade.hpp"
#include "oracle/shading.hpp"
#include "oracle/shadow.hpp"
#include "oracle/shape.hpp"
#include "oracle/sky.hpp"
#include "oracle/tangents.hpp"
#include "oracle/texture.hpp"
#include "oracle/triangle.hpp"
#include "oracle/world.hpp"
