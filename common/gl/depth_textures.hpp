// Depth textures that hold given numbers, and the numbers that they hold: for probes and tables of extremes, which try
// what reads or draws a shadow map without a scene.
//
// Depths are 0 to 1, image by image, each row by row from t = 0. An image is square: `edge` texels a side. What is
// bound to texture unit 0 of the kind at hand is unbound afterwards.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "gl/objects.hpp"

namespace atelier {

/// A GL_TEXTURE_2D_ARRAY of 32-bit floats, of as many layers as there are depths for; 1 beside them. It is read as
/// stored, the nearest texel; with `compare` it compares (lit where less or equal) and mixes the four nearest answers.
/// Throws Error where a layer would not be full.
GlTexture make_depth_layers(Gl& gl, int edge, std::span<const float> depths, bool compare = false);

/// A GL_TEXTURE_CUBE_MAP of 32-bit floats, read likewise; clamped to its edges. Faces +x, -x, +y, -y, +z, -z. Throws
/// Error where these are not the depths of six faces.
GlTexture make_depth_cube(Gl& gl, int edge, std::span<const float> depths, bool compare = false);

/// Gives a cube its six faces, in a format of depth; how it is read stays. Throws Error as make_depth_cube does.
void fill_depth_cube(Gl& gl, GLuint cube, GLenum format, int edge, std::span<const float> depths);

/// Depths of six faces of which each has one all over.
std::vector<float> even_faces(int edge, const std::array<float, 6>& depths);

/// All depths of a GL_TEXTURE_2D_ARRAY, or of a GL_TEXTURE_CUBE_MAP.
std::vector<float> read_depth_layers(Gl& gl, GLuint layers);
std::vector<float> read_depth_cube(Gl& gl, GLuint cube);

/// A framebuffer without colour, to which nothing is attached yet; it is not bound.
GlFramebuffer make_depth_framebuffer(Gl& gl);

}  // namespace atelier
