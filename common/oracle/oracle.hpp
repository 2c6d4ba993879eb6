// Ground truth: a ray tracer in double precision over a Scene. What it says is what a picture ought to be; what a
// step's renderer says is measured against it. It therefore shares nothing with the renderer, the steps or their
// shaders: no matrix of theirs, no shading, no rounding. What both stand on are the plain data of scene/ and the
// conventions that the contracts fix (which way is up in a texture, what a camera straight above its target takes for
// "up").
//
//   const oracle::World world(scene);
//   const Image truth = oracle::trace(world, {.camera = scene.camera, .size = {640, 480}, .samples = 4});
//
// The parts, in the order in which a picture is made; each stands in a file of its own:
//
//   ray.hpp          a ray and the stretch of it that counts
//   frame.hpp        which way is right and which is up for who looks along a direction
//   camera.hpp       which ray belongs to which point of the picture, and how deep a point lies
//   triangle.hpp     ray and triangle, without gaps between neighbours
//   shape.hpp        ray and sphere, cylinder wall, rectangle: shapes that triangles only approximate
//   bvh.hpp          a tree of boxes, so that a ray meets few of many
//   beam.hpp         a pyramid of rays, and what it certainly misses
//   world.hpp        a scene made ready: everything in world space; what a ray sees, what blocks a light
//   texture.hpp      the colour of a texture at a point
//   light.hpp        the light that arrives
//   blinn_phong.hpp  the light that leaves, and how much of it there is in all
//   shading.hpp      what is asked for: which part of the light, which shadows
//   shadow.hpp       how much of a light a point sees
//   shade.hpp        all of it together: the colour of a point of a surface
//   picture.hpp      many rays: a whole picture on all processors
//
// There are no mipmaps and there is no filter beyond the box of n x n samples a pixel: supersampling *is* the truth
// that mipmaps and anti-aliasing approximate. All settings of a step that trade accuracy for speed therefore have no
// meaning here; those that change what is asked for (which light shines, which normalisation) do.
//
// Where later steps come in:
//   shadow factors         shading.hpp: a SurfaceColour that says what `visibility` does of one light
//   normal maps            shade.hpp: the normal is replaced after World::seen has found the point, before it is lit
//   height fields          shape.hpp: one more member of `Surface`, a bilinear patch a cell (a quadratic in t)
//   portals                picture.hpp: what a ray sees may be a frame; the ray is carried through and traced again
//   light in texture space picture.hpp: the same shading, asked for points of a texture instead of pixels
//   quadrature             blinn_phong.hpp: `albedo` shows the way
#pragma once

#include "oracle/beam.hpp"
#include "oracle/blinn_phong.hpp"
#include "oracle/bvh.hpp"
#include "oracle/camera.hpp"
#include "oracle/frame.hpp"
#include "oracle/light.hpp"
#include "oracle/picture.hpp"
#include "oracle/ray.hpp"
#include "oracle/shade.hpp"
#include "oracle/shading.hpp"
#include "oracle/shadow.hpp"
#include "oracle/shape.hpp"
#include "oracle/texture.hpp"
#include "oracle/triangle.hpp"
#include "oracle/world.hpp"
