// 08-post-processing: the contract of post_processing.cpp: how a chain of passes runs, and which passes it has. You
// also write post_processing.glsl, what each pass does to a pixel; the contract of each function is the comment above
// it.
//
// The scene is drawn into a texture. Then passes follow: each draws one triangle over the whole picture, reads the
// picture so far from a texture, and writes the next one. All colours are linear light with the primaries of Rec. 709;
// the framework encodes the final picture to sRGB afterwards.
#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "gl/gl.hpp"

namespace atelier::post_processing {

// ---------------------------------------------------------------------------------------------------------------------
// Core 1: the chain. You also write `full_screen_corner` in post_processing.glsl.
// ---------------------------------------------------------------------------------------------------------------------

/// The target of a pass: 0 or 1, the two between which a chain alternates. `source` is the one that the pass reads, or
/// -1 for the picture of the scene, which is neither. A pass must not write what it reads. Handout, section 1.
int next_target(int source);

/// Draws one triangle, with the program in use, which reads no vertex attributes: its vertex shader gets gl_VertexID 0,
/// 1 and 2. A core profile draws only while a vertex array object is bound, even an empty one. Everything that it
/// creates is deleted, and afterwards no vertex array is bound, or the one that was. Handout, section 1.
void draw_full_screen(Gl& gl);

// ---------------------------------------------------------------------------------------------------------------------
// Core 2: which passes
// ---------------------------------------------------------------------------------------------------------------------

enum class Pass {
  bloom,    ///< adds light around bright places
  tone,     ///< exposure and tone mapping: from light of any amount to what a display can show
  adjust,   ///< hue, saturation, brightness
  table,    ///< looks colours up in a table
  overlay,  ///< lays another picture over this one
};

/// What a picture shall look like.
struct Look {
  float bloom = 0;       ///< the amount of bloom, at least 0; 0: none
  float exposure = 0;    ///< stops: each doubles the light
  int curve = 0;         ///< of tone mapping: 0 none, 1 Reinhard's, 2 filmic
  float hue = 0;         ///< turns; whole turns change nothing
  float saturation = 1;  ///< factor of the chroma, at least 0
  float brightness = 1;  ///< factor of the luma, at least 0
  bool table = false;    ///< whether there is a table
  float overlay = 0;     ///< how much of the other picture is seen, 0..1
};

/// The passes that this look needs, in the order in which they run: none that would leave every picture (with colours
/// of a display, where it corrects these) as it is, and each at most once. What spreads light works on the light of the
/// scene, before tone mapping; what corrects colours works on those of a display, after it; what is laid over the
/// picture is changed by no other pass. A table comes after hue, saturation and brightness. Handout, section 2.
std::vector<Pass> passes_for(const Look& look);

// ---------------------------------------------------------------------------------------------------------------------
// Further: bloom, tables
// ---------------------------------------------------------------------------------------------------------------------

/// (further) Half of a Gaussian filter: weights[k] is the weight of the pixels at a distance of k pixels, k = 0 ..
/// ceil(3 sigma), proportional to exp(-k^2 / (2 sigma^2)). All weights of the whole filter (k = 0 once, every other on
/// both sides) sum to 1. sigma is in pixels; throws std::invalid_argument unless it is above 0 and at most 20. Handout,
/// section 6.
std::vector<float> gaussian_weights(float sigma);

/// A table of colours: the colour that replaces each colour of a regular grid.
struct ColourTable {
  std::string title = {};
  int size = 2;                         ///< grid points along each axis, 2..256
  glm::vec3 low{0}, high{1};            ///< the colours of the first and the last grid point, by channel
  std::vector<glm::vec3> colours = {};  ///< size^3 of them; red runs fastest, then green, then blue
};

/// (further) Reads a table from the text of a .cube file (Adobe, "Cube LUT Specification 1.0", 2013). Lines end with LF
/// or CR LF; the last one may also end with the text. Words are separated by blanks or tabs, also before the first and
/// after the last. Lines without a word, and lines whose first word begins with '#', mean nothing. The keywords come
/// before the colours, in any order:
///   TITLE "text"            optional; the text has no quotes, and may be empty
///   LUT_3D_SIZE n           n is a whole number, 2..256
///   DOMAIN_MIN r g b        optional, otherwise 0 0 0
///   DOMAIN_MAX r g b        optional, otherwise 1 1 1; each above that of DOMAIN_MIN
/// Then n^3 lines of three numbers. A number is an optional minus sign, decimal digits with at most one point, and an
/// optional exponent. A plus sign before it may be accepted or refused, and so may a number that is not 0 but nearer to
/// it than any float.
/// Throws std::invalid_argument for everything else: another keyword (LUT_1D_SIZE too), a keyword twice, a number that
/// is none or is too large for a float, too few or too many numbers in a line, too few or too many lines, no size.
/// Handout, section 7.
ColourTable read_table(std::string_view text);

/// (further) The text of a .cube file from which read_table gives exactly this table: every float is written so that
/// reading gives the same float. DOMAIN_MIN and DOMAIN_MAX are left out where they say the default, TITLE where it is
/// empty. The title has no quotes and no line ends. Handout, section 7.
std::string write_table(const ColourTable& table);

}  // namespace atelier::post_processing
