#include "gl/call_parameters.hpp"

#include <array>

#include "base/gl_enum_name.hpp"

namespace atelier {
namespace {

namespace lists {

constexpr GLenum textures[] = {GL_TEXTURE_2D,        GL_TEXTURE_2D_ARRAY,
                               GL_TEXTURE_CUBE_MAP,  GL_TEXTURE_3D,
                               GL_TEXTURE_1D,        GL_TEXTURE_2D_MULTISAMPLE,
                               GL_TEXTURE_RECTANGLE, GL_TEXTURE_BUFFER,
                               GL_TEXTURE_1D_ARRAY,  GL_TEXTURE_2D_MULTISAMPLE_ARRAY};
constexpr GLenum images[] = {GL_TEXTURE_2D,
                             GL_TEXTURE_CUBE_MAP_POSITIVE_X,
                             GL_TEXTURE_CUBE_MAP_NEGATIVE_X,
                             GL_TEXTURE_CUBE_MAP_POSITIVE_Y,
                             GL_TEXTURE_CUBE_MAP_NEGATIVE_Y,
                             GL_TEXTURE_CUBE_MAP_POSITIVE_Z,
                             GL_TEXTURE_CUBE_MAP_NEGATIVE_Z,
                             GL_TEXTURE_RECTANGLE,
                             GL_TEXTURE_1D_ARRAY,
                             GL_PROXY_TEXTURE_2D,
                             GL_TEXTURE_2D_MULTISAMPLE};
constexpr GLenum volumes[] = {GL_TEXTURE_2D_ARRAY, GL_TEXTURE_3D};
constexpr GLenum texture_parameters[] = {
    GL_TEXTURE_MIN_FILTER,   GL_TEXTURE_MAG_FILTER,   GL_TEXTURE_WRAP_S,        GL_TEXTURE_WRAP_T,
    GL_TEXTURE_WRAP_R,       GL_TEXTURE_MAX_LEVEL,    GL_TEXTURE_BASE_LEVEL,    GL_TEXTURE_COMPARE_MODE,
    GL_TEXTURE_COMPARE_FUNC, GL_TEXTURE_LOD_BIAS,     GL_TEXTURE_BORDER_COLOR,  GL_TEXTURE_MIN_LOD,
    GL_TEXTURE_MAX_LOD,      GL_TEXTURE_SWIZZLE_R,    GL_TEXTURE_SWIZZLE_G,     GL_TEXTURE_SWIZZLE_B,
    GL_TEXTURE_SWIZZLE_A,    GL_TEXTURE_SWIZZLE_RGBA, GL_TEXTURE_MAX_ANISOTROPY};
constexpr GLenum magnification[] = {GL_NEAREST, GL_LINEAR};
constexpr GLenum minification[] = {GL_NEAREST,
                                   GL_LINEAR,
                                   GL_NEAREST_MIPMAP_NEAREST,
                                   GL_LINEAR_MIPMAP_NEAREST,
                                   GL_NEAREST_MIPMAP_LINEAR,
                                   GL_LINEAR_MIPMAP_LINEAR};
constexpr GLenum wraps[] = {GL_REPEAT, GL_MIRRORED_REPEAT, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER};
constexpr GLenum comparison_modes[] = {GL_COMPARE_REF_TO_TEXTURE, GL_NONE};
constexpr GLenum comparisons[] = {GL_NEVER,   GL_LESS,     GL_EQUAL,  GL_LEQUAL,
                                  GL_GREATER, GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS};
constexpr GLenum stencil_operations[] = {GL_KEEP,      GL_ZERO, GL_REPLACE,   GL_INCR,
                                         GL_INCR_WRAP, GL_DECR, GL_DECR_WRAP, GL_INVERT};
constexpr GLenum capabilities[] = {GL_BLEND,
                                   GL_CULL_FACE,
                                   GL_DEPTH_TEST,
                                   GL_STENCIL_TEST,
                                   GL_SCISSOR_TEST,
                                   GL_FRAMEBUFFER_SRGB,
                                   GL_MULTISAMPLE,
                                   GL_POLYGON_OFFSET_FILL,
                                   GL_DEPTH_CLAMP,
                                   GL_TEXTURE_CUBE_MAP_SEAMLESS,
                                   GL_PROGRAM_POINT_SIZE,
                                   GL_CLIP_DISTANCE0,
                                   GL_CLIP_DISTANCE1,
                                   GL_CLIP_DISTANCE2,
                                   GL_CLIP_DISTANCE3,
                                   GL_CLIP_DISTANCE4,
                                   GL_CLIP_DISTANCE5,
                                   GL_CLIP_DISTANCE6,
                                   GL_CLIP_DISTANCE7,
                                   GL_POLYGON_OFFSET_LINE,
                                   GL_POLYGON_OFFSET_POINT,
                                   GL_PRIMITIVE_RESTART,
                                   GL_RASTERIZER_DISCARD,
                                   GL_LINE_SMOOTH,
                                   GL_POLYGON_SMOOTH,
                                   GL_DITHER,
                                   GL_COLOR_LOGIC_OP,
                                   GL_SAMPLE_ALPHA_TO_COVERAGE,
                                   GL_SAMPLE_ALPHA_TO_ONE,
                                   GL_SAMPLE_COVERAGE,
                                   GL_SAMPLE_MASK,
                                   GL_DEBUG_OUTPUT,
                                   GL_DEBUG_OUTPUT_SYNCHRONOUS};
constexpr GLenum primitives[] = {GL_TRIANGLES,
                                 GL_TRIANGLE_STRIP,
                                 GL_TRIANGLE_FAN,
                                 GL_LINES,
                                 GL_LINE_STRIP,
                                 GL_LINE_LOOP,
                                 GL_POINTS,
                                 GL_LINES_ADJACENCY,
                                 GL_LINE_STRIP_ADJACENCY,
                                 GL_TRIANGLES_ADJACENCY,
                                 GL_TRIANGLE_STRIP_ADJACENCY};
constexpr GLenum index_types[] = {GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_UNSIGNED_INT};
constexpr GLenum attribute_types[] = {GL_FLOAT,
                                      GL_HALF_FLOAT,
                                      GL_DOUBLE,
                                      GL_BYTE,
                                      GL_UNSIGNED_BYTE,
                                      GL_SHORT,
                                      GL_UNSIGNED_SHORT,
                                      GL_INT,
                                      GL_UNSIGNED_INT,
                                      GL_INT_2_10_10_10_REV,
                                      GL_UNSIGNED_INT_2_10_10_10_REV,
                                      GL_FIXED};
constexpr GLenum internal_formats[] = {GL_RGBA8,
                                       GL_RGBA16F,
                                       GL_RGBA32F,
                                       GL_SRGB8_ALPHA8,
                                       GL_R32F,
                                       GL_DEPTH_COMPONENT24,
                                       GL_DEPTH_COMPONENT32F,
                                       GL_DEPTH24_STENCIL8,
                                       GL_DEPTH32F_STENCIL8,
                                       GL_DEPTH_COMPONENT16,
                                       GL_DEPTH_COMPONENT32,
                                       GL_DEPTH_COMPONENT,
                                       GL_DEPTH_STENCIL,
                                       GL_RED,
                                       GL_RG,
                                       GL_RGB,
                                       GL_RGBA,
                                       GL_R8,
                                       GL_RG8,
                                       GL_RGB8,
                                       GL_SRGB8,
                                       GL_R16F,
                                       GL_RG16F,
                                       GL_RGB16F,
                                       GL_RG32F,
                                       GL_RGB32F,
                                       GL_R11F_G11F_B10F,
                                       GL_R8UI,
                                       GL_R32UI,
                                       GL_R32I,
                                       GL_RGBA8UI,
                                       GL_RGB10_A2,
                                       GL_RGBA16};
constexpr GLenum pixel_formats[] = {GL_RGBA,          GL_RGB,  GL_RG,  GL_RED,         GL_DEPTH_COMPONENT,
                                    GL_DEPTH_STENCIL, GL_BGRA, GL_BGR, GL_RED_INTEGER, GL_RGBA_INTEGER,
                                    GL_STENCIL_INDEX};
constexpr GLenum pixel_types[] = {GL_UNSIGNED_BYTE,
                                  GL_FLOAT,
                                  GL_HALF_FLOAT,
                                  GL_UNSIGNED_INT,
                                  GL_UNSIGNED_SHORT,
                                  GL_BYTE,
                                  GL_SHORT,
                                  GL_INT,
                                  GL_UNSIGNED_INT_24_8,
                                  GL_FLOAT_32_UNSIGNED_INT_24_8_REV,
                                  GL_UNSIGNED_INT_2_10_10_10_REV};
constexpr GLenum buffers[] = {GL_ARRAY_BUFFER,     GL_ELEMENT_ARRAY_BUFFER, GL_UNIFORM_BUFFER,
                              GL_TEXTURE_BUFFER,   GL_PIXEL_PACK_BUFFER,    GL_PIXEL_UNPACK_BUFFER,
                              GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER,    GL_TRANSFORM_FEEDBACK_BUFFER};
constexpr GLenum usages[] = {GL_STATIC_DRAW,  GL_DYNAMIC_DRAW, GL_STREAM_DRAW, GL_STATIC_READ, GL_STATIC_COPY,
                             GL_DYNAMIC_READ, GL_DYNAMIC_COPY, GL_STREAM_READ, GL_STREAM_COPY};
constexpr GLenum framebuffers[] = {GL_FRAMEBUFFER, GL_DRAW_FRAMEBUFFER, GL_READ_FRAMEBUFFER};
constexpr GLenum renderbuffers[] = {GL_RENDERBUFFER};
constexpr GLenum attachments[] = {GL_COLOR_ATTACHMENT0,        GL_DEPTH_ATTACHMENT,  GL_STENCIL_ATTACHMENT,
                                  GL_DEPTH_STENCIL_ATTACHMENT, GL_COLOR_ATTACHMENT1, GL_COLOR_ATTACHMENT2,
                                  GL_COLOR_ATTACHMENT3,        GL_COLOR_ATTACHMENT4, GL_COLOR_ATTACHMENT5,
                                  GL_COLOR_ATTACHMENT6,        GL_COLOR_ATTACHMENT7};
constexpr GLenum drawn_buffers[] = {GL_COLOR_ATTACHMENT0,
                                    GL_NONE,
                                    GL_COLOR_ATTACHMENT1,
                                    GL_COLOR_ATTACHMENT2,
                                    GL_COLOR_ATTACHMENT3,
                                    GL_COLOR_ATTACHMENT4,
                                    GL_COLOR_ATTACHMENT5,
                                    GL_COLOR_ATTACHMENT6,
                                    GL_COLOR_ATTACHMENT7,
                                    GL_FRONT,
                                    GL_BACK,
                                    GL_FRONT_AND_BACK};
constexpr GLenum faces[] = {GL_FRONT, GL_BACK, GL_FRONT_AND_BACK};
constexpr GLenum both_faces[] = {GL_FRONT_AND_BACK};
constexpr GLenum windings[] = {GL_CCW, GL_CW};
constexpr GLenum polygon_modes[] = {GL_FILL, GL_LINE, GL_POINT};
constexpr GLenum factors[] = {GL_ONE,
                              GL_ZERO,
                              GL_SRC_ALPHA,
                              GL_ONE_MINUS_SRC_ALPHA,
                              GL_DST_COLOR,
                              GL_SRC_COLOR,
                              GL_ONE_MINUS_SRC_COLOR,
                              GL_ONE_MINUS_DST_COLOR,
                              GL_DST_ALPHA,
                              GL_ONE_MINUS_DST_ALPHA,
                              GL_SRC_ALPHA_SATURATE,
                              GL_CONSTANT_COLOR,
                              GL_CONSTANT_ALPHA};
constexpr GLenum shaders[] = {GL_VERTEX_SHADER, GL_FRAGMENT_SHADER, GL_GEOMETRY_SHADER};

}  // namespace lists

struct Row {
  std::string_view function;
  std::size_t place;
  const char* name;
  std::span<const GLenum> allowed;
};

constexpr Row rows[] = {
    {"BindBuffer", 0, "target", lists::buffers},
    {"BindFramebuffer", 0, "target", lists::framebuffers},
    {"BindRenderbuffer", 0, "target", lists::renderbuffers},
    {"BindTexture", 0, "target", lists::textures},
    {"BlendFunc", 0, "factor", lists::factors},
    {"BlendFunc", 1, "factor", lists::factors},
    {"BufferData", 0, "target", lists::buffers},
    {"BufferData", 3, "usage", lists::usages},
    {"BufferSubData", 0, "target", lists::buffers},
    {"CheckFramebufferStatus", 0, "target", lists::framebuffers},
    {"CreateShader", 0, "kind of shader", lists::shaders},
    {"CullFace", 0, "face", lists::faces},
    {"DepthFunc", 0, "comparison", lists::comparisons},
    {"Disable", 0, "capability", lists::capabilities},
    {"DrawArrays", 0, "mode", lists::primitives},
    {"DrawBuffer", 0, "buffer", lists::drawn_buffers},
    {"DrawElements", 0, "mode", lists::primitives},
    {"DrawElements", 2, "type of index", lists::index_types},
    {"Enable", 0, "capability", lists::capabilities},
    {"FramebufferRenderbuffer", 0, "target", lists::framebuffers},
    {"FramebufferRenderbuffer", 1, "attachment", lists::attachments},
    {"FramebufferRenderbuffer", 2, "target of a renderbuffer", lists::renderbuffers},
    {"FramebufferTexture", 0, "target", lists::framebuffers},
    {"FramebufferTexture", 1, "attachment", lists::attachments},
    {"FramebufferTexture2D", 0, "target", lists::framebuffers},
    {"FramebufferTexture2D", 1, "attachment", lists::attachments},
    {"FramebufferTexture2D", 2, "target of an image", lists::images},
    {"FramebufferTextureLayer", 0, "target", lists::framebuffers},
    {"FramebufferTextureLayer", 1, "attachment", lists::attachments},
    {"FrontFace", 0, "winding", lists::windings},
    {"GenerateMipmap", 0, "target", lists::textures},
    {"PolygonMode", 0, "face", lists::both_faces},
    {"PolygonMode", 1, "mode", lists::polygon_modes},
    {"ReadBuffer", 0, "buffer", lists::drawn_buffers},
    {"RenderbufferStorage", 0, "target", lists::renderbuffers},
    {"RenderbufferStorage", 1, "internal format", lists::internal_formats},
    {"StencilFunc", 0, "comparison", lists::comparisons},
    {"StencilOp", 0, "operation", lists::stencil_operations},
    {"StencilOp", 1, "operation", lists::stencil_operations},
    {"StencilOp", 2, "operation", lists::stencil_operations},
    {"TexImage2D", 0, "target", lists::images},
    {"TexImage2D", 2, "internal format", lists::internal_formats},
    {"TexImage2D", 6, "format", lists::pixel_formats},
    {"TexImage2D", 7, "type", lists::pixel_types},
    {"TexImage3D", 0, "target", lists::volumes},
    {"TexImage3D", 2, "internal format", lists::internal_formats},
    {"TexImage3D", 7, "format", lists::pixel_formats},
    {"TexImage3D", 8, "type", lists::pixel_types},
    {"TexParameterf", 0, "target", lists::textures},
    {"TexParameterf", 1, "parameter", lists::texture_parameters},
    {"TexParameterfv", 0, "target", lists::textures},
    {"TexParameterfv", 1, "parameter", lists::texture_parameters},
    {"TexParameteri", 0, "target", lists::textures},
    {"TexParameteri", 1, "parameter", lists::texture_parameters},
    {"TexSubImage2D", 0, "target", lists::images},
    {"TexSubImage2D", 6, "format", lists::pixel_formats},
    {"TexSubImage2D", 7, "type", lists::pixel_types},
    {"VertexAttribPointer", 2, "type", lists::attribute_types},
};

/// What the value of a texture's parameter may be; none if it is a number.
std::span<const GLenum> values_of(GLenum texture_parameter) {
  switch (texture_parameter) {
    case GL_TEXTURE_MIN_FILTER:
      return lists::minification;
    case GL_TEXTURE_MAG_FILTER:
      return lists::magnification;
    case GL_TEXTURE_WRAP_S:
    case GL_TEXTURE_WRAP_T:
    case GL_TEXTURE_WRAP_R:
      return lists::wraps;
    case GL_TEXTURE_COMPARE_MODE:
      return lists::comparison_modes;
    case GL_TEXTURE_COMPARE_FUNC:
      return lists::comparisons;
    default:
      return {};
  }
}

constexpr std::array primitive_names = {"GL_POINTS",
                                        "GL_LINES",
                                        "GL_LINE_LOOP",
                                        "GL_LINE_STRIP",
                                        "GL_TRIANGLES",
                                        "GL_TRIANGLE_STRIP",
                                        "GL_TRIANGLE_FAN",
                                        "GL_QUADS",
                                        "GL_QUAD_STRIP",
                                        "GL_POLYGON",
                                        "GL_LINES_ADJACENCY",
                                        "GL_LINE_STRIP_ADJACENCY",
                                        "GL_TRIANGLES_ADJACENCY",
                                        "GL_TRIANGLE_STRIP_ADJACENCY"};

}  // namespace

std::vector<GlParameter> enum_parameters(std::string_view function, std::span<const GlArgument> arguments) {
  std::vector<GlParameter> parameters;
  for (const Row& row : rows)
    if (row.function == function) parameters.push_back({row.place, row.name, row.allowed});
  if ((function == "TexParameteri" || function == "TexParameterf") && arguments.size() == 3) {
    const auto values = values_of(GLenum(arguments[1].value));
    if (!values.empty()) parameters.push_back({2, gl_enum_name(arguments[1].value), values});
  }
  return parameters;
}

std::string enum_in_words(const GlParameter& parameter, double value) {
  if (parameter.allowed.data() == lists::primitives && value >= 0 && value < double(primitive_names.size()))
    return primitive_names[std::size_t(value)];
  const bool zero = parameter.allowed.data() == lists::factors || parameter.allowed.data() == lists::stencil_operations;
  if (zero && value == GL_ZERO) return "GL_ZERO";
  if (parameter.allowed.data() == lists::factors && value == GL_ONE) return "GL_ONE";
  return gl_enum_name(value);
}

std::string allowed_in_words(const GlParameter& parameter) {
  constexpr std::size_t most = 8, beginning = 6;
  const std::size_t all = parameter.allowed.size(), shown = all > most ? beginning : all;
  std::string words;
  for (std::size_t i = 0; i < shown; ++i) {
    if (i > 0) words += i + 1 == all ? " or " : ", ";
    words += enum_in_words(parameter, parameter.allowed[i]);
  }
  return shown < all ? words + ", ..." : words;
}

}  // namespace atelier
