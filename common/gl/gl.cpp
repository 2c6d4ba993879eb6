#include "gl/gl.hpp"

#include <fmt/core.h>

#include <cstring>

#include "base/error.hpp"
#include "gl/meter.hpp"
#include "gl/texel.hpp"

namespace atelier {
namespace {

template <class Function>
bool resolve_into(Function& function, Gl::Resolver resolve, const char* name, GlMeter& meter, GlCallErrors& errors) {
  function.call = reinterpret_cast<decltype(function.call)>(resolve(name));
  function.meter = &meter;
  function.errors = &errors;
  function.name = name + 2;  // without "gl"
  return function.call != nullptr;
}

std::string text_of(const GLubyte* text) {
  return text ? reinterpret_cast<const char*>(text) : "unknown";
}

const char* error_name(GLenum error) {
  switch (error) {
    case GL_INVALID_ENUM:
      return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
      return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
      return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
      return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY:
      return "GL_OUT_OF_MEMORY";
    default:
      return "an unknown error";
  }
}

}  // namespace

Gl::Gl(Resolver resolve) : meter_(std::make_unique<GlMeter>(*this)), errors_(std::make_unique<GlCallErrors>(*this)) {
#define ATELIER_GL_LOAD(type, name)                                \
  if (!resolve_into(name, resolve, "gl" #name, *meter_, *errors_)) \
    throw Error("this OpenGL context lacks gl" #name               \
                ", and 3.3 core is needed: update the graphics driver, or draw with --context osmesa or egl");
  ATELIER_GL_FUNCTIONS(ATELIER_GL_LOAD)
#undef ATELIER_GL_LOAD
  count_calls(*this);

  GLint major = 0, minor = 0;
  GetIntegerv(GL_MAJOR_VERSION, &major);
  GetIntegerv(GL_MINOR_VERSION, &minor);
  version_ = 10 * major + minor;
  if (version_ < 33)
    throw Error(fmt::format("this OpenGL context is {}.{} ({}), and 3.3 core is needed", major, minor,
                            text_of(GetString(GL_RENDERER))));

  // Check version or extension first: some resolvers return an address for any name.
  if (version_ >= 45 || has_extension("GL_ARB_clip_control"))
    resolve_into(ClipControl, resolve, "glClipControl", *meter_, *errors_);
  if (version_ >= 43 || has_extension("GL_KHR_debug")) {
#define ATELIER_GL_LOAD(type, name) resolve_into(name, resolve, "gl" #name, *meter_, *errors_);
    ATELIER_GL_DEBUG_FUNCTIONS(ATELIER_GL_LOAD)
#undef ATELIER_GL_LOAD
    GetIntegerv(GL_MAX_LABEL_LENGTH, &debug_limits_.label);
    GetIntegerv(GL_MAX_DEBUG_MESSAGE_LENGTH, &debug_limits_.message);
    GetIntegerv(GL_MAX_DEBUG_GROUP_STACK_DEPTH, &debug_limits_.group_depth);
    errors_->listen();
  }
}

Gl::~Gl() = default;

GlCounts Gl::counts() {
  return meter_->counts();
}

std::vector<GlGroup> Gl::groups() {
  return meter_->groups();
}

void Gl::restart_counts() {
  meter_->restart();
}

void Gl::count_fragments(bool wanted) {
  meter_->count_fragments(wanted);
}

int Gl::begin_group(std::string_view name) {
  return meter_->begin_group(name);
}

void Gl::end_group() {
  meter_->end_group();
}

bool Gl::has_extension(const char* name) const {
  GLint extensions = 0;
  GetIntegerv(GL_NUM_EXTENSIONS, &extensions);
  for (GLint i = 0; i < extensions; ++i)
    if (std::strcmp(text_of(GetStringi(GL_EXTENSIONS, GLuint(i))).c_str(), name) == 0) return true;
  return false;
}

std::string Gl::description() const {
  return text_of(GetString(GL_RENDERER)) + ", " + text_of(GetString(GL_VERSION));
}

void check_gl_error(const Gl& gl, const char* doing) {
  std::string names;
  // There is one flag per kind of error; a lost context may report errors forever.
  for (int flags = 0; flags < 8; ++flags) {
    const GLenum error = gl.GetError();
    if (error == GL_NO_ERROR) break;
    names += fmt::format("{}{} (0x{:04x})", names.empty() ? "" : ", ", error_name(error), error);
  }
  // Taken also without a flag: then someone has read the flag of this call, and knows.
  const std::string call = gl.call_errors().take();
  if (names.empty()) return;
  throw Error(fmt::format("OpenGL reports {} while {}{}{}", names, doing, call.empty() ? "" : ": ", call));
}

std::int64_t texel_bytes(GLenum internal_format) {
  switch (internal_format) {
    case GL_R8:
    case GL_STENCIL_INDEX8:
      return 1;
    case GL_RG8:
    case GL_R16F:
    case GL_DEPTH_COMPONENT16:
      return 2;
    case GL_RG16F:
      return 4;
    case GL_RG32F:
    case GL_RGB16F:
    case GL_RGBA16F:
    case GL_DEPTH32F_STENCIL8:
      return 8;
    case GL_RGB32F:
    case GL_RGBA32F:
      return 16;
    default:
      return 4;  // RGB8, RGBA8, their sRGB forms, R32F, R11F_G11F_B10F, 24 and 32 bits of depth, 24 + 8
  }
}

}  // namespace atelier
