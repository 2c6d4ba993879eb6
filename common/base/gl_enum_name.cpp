#include "judge/compare/gl_enum_name.hpp"

#include <GL/glcorearb.h>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

namespace atelier::judge {
namespace {

#define NAMED(name)                \
  std::pair<GLenum, const char*> { \
    name, #name                    \
  }
constexpr std::array known_enums = {
    // filters and wraps of textures
    NAMED(GL_NEAREST), NAMED(GL_LINEAR), NAMED(GL_NEAREST_MIPMAP_NEAREST), NAMED(GL_LINEAR_MIPMAP_NEAREST),
    NAMED(GL_NEAREST_MIPMAP_LINEAR), NAMED(GL_LINEAR_MIPMAP_LINEAR), NAMED(GL_REPEAT), NAMED(GL_MIRRORED_REPEAT),
    NAMED(GL_CLAMP_TO_EDGE), NAMED(GL_CLAMP_TO_BORDER), NAMED(GL_MIRROR_CLAMP_TO_EDGE),
    // formats
    NAMED(GL_RED), NAMED(GL_RGB), NAMED(GL_RGBA), NAMED(GL_R8), NAMED(GL_RGB8), NAMED(GL_RGBA8), NAMED(GL_SRGB8),
    NAMED(GL_SRGB8_ALPHA8), NAMED(GL_R16F), NAMED(GL_RGB16F), NAMED(GL_RGBA16F), NAMED(GL_R32F), NAMED(GL_RGB32F),
    NAMED(GL_RGBA32F), NAMED(GL_DEPTH_COMPONENT), NAMED(GL_DEPTH_COMPONENT16), NAMED(GL_DEPTH_COMPONENT24),
    NAMED(GL_DEPTH_COMPONENT32), NAMED(GL_DEPTH_COMPONENT32F), NAMED(GL_DEPTH24_STENCIL8), NAMED(GL_DEPTH32F_STENCIL8),
    // comparisons, culling, polygons
    NAMED(GL_NEVER), NAMED(GL_LESS), NAMED(GL_EQUAL), NAMED(GL_LEQUAL), NAMED(GL_GREATER), NAMED(GL_NOTEQUAL),
    NAMED(GL_GEQUAL), NAMED(GL_ALWAYS), NAMED(GL_COMPARE_REF_TO_TEXTURE), NAMED(GL_FRONT), NAMED(GL_BACK),
    NAMED(GL_FRONT_AND_BACK), NAMED(GL_CW), NAMED(GL_CCW), NAMED(GL_POINT), NAMED(GL_LINE), NAMED(GL_FILL),
    // types, buffers, attachments
    NAMED(GL_BYTE), NAMED(GL_UNSIGNED_BYTE), NAMED(GL_SHORT), NAMED(GL_UNSIGNED_SHORT), NAMED(GL_INT),
    NAMED(GL_UNSIGNED_INT), NAMED(GL_FLOAT), NAMED(GL_HALF_FLOAT), NAMED(GL_DOUBLE), NAMED(GL_COLOR_ATTACHMENT0)};
#undef NAMED

}  // namespace

std::string gl_enum_name(double value) {
  if (!(value >= 0 && value <= 0xffff) || value != std::floor(value)) return fmt::format("{:.7g}", value);
  if (value == GL_NONE) return "GL_NONE";
  for (const auto& [number, name] : known_enums)
    if (number == GLenum(value)) return name;
  return fmt::format("0x{:X}", GLenum(value));
}

}  // namespace atelier::judge
