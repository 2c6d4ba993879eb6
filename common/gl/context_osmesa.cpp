// Mesa's off-screen renderer: OpenGL on the CPU, without display, device or server.
//
// The four functions that are used are declared here instead of including <GL/osmesa.h>: that header includes the old
// <GL/gl.h>, and newer systems have neither the header nor the library. Source: Mesa's documentation of the OSMesa
// interface, 11.2.
#include <dlfcn.h>

#include <array>
#include <type_traits>

#include "base/error.hpp"
#include "gl/context_kinds.hpp"
#include "gl/driver_library.hpp"

namespace atelier {
namespace {

struct OsMesaHandle;  // opaque

struct OsMesa {
  OsMesaHandle* (*create_context)(const int* attributes, OsMesaHandle* share) = nullptr;
  void (*destroy_context)(OsMesaHandle*) = nullptr;
  GLboolean (*make_current)(OsMesaHandle*, void* pixels, GLenum type, GLsizei width, GLsizei height) = nullptr;
  void* (*function_address)(const char* name) = nullptr;
};

// Attributes of OSMesaCreateContextAttribs.
constexpr int osmesa_format = 0x22, osmesa_profile = 0x33, osmesa_core_profile = 0x34, osmesa_major_version = 0x36,
              osmesa_minor_version = 0x37;

void* open_library() {
  for (const char* name : {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"})
    if (void* library = dlopen(name, RTLD_NOW | RTLD_LOCAL)) return library;
  throw Error("OSMesa, OpenGL in memory, is not installed: install the package libosmesa6, or use --context egl");
}

/// The library, loaded at the first call, so that a program with another context never loads it.
const OsMesa& osmesa() {
  static const OsMesa functions = [] {
    const DriverLibrary library = {open_library(), "OSMesa", "Mesa 12"};
    OsMesa found;
    library.find(found.create_context, "OSMesaCreateContextAttribs");
    library.find(found.destroy_context, "OSMesaDestroyContext");
    library.find(found.make_current, "OSMesaMakeCurrent");
    library.find(found.function_address, "OSMesaGetProcAddress");
    return found;
  }();
  return functions;
}

class OsMesaContext : public HeadlessContext {
 public:
  OsMesaContext() : context_(create()), gl_([](const char* name) { return osmesa().function_address(name); }) {}
  Gl& gl() override { return gl_; }
  ContextKind kind() const override { return ContextKind::osmesa; }

 private:
  struct Destroy {
    void operator()(OsMesaHandle* context) const {
      osmesa().make_current(nullptr, nullptr, 0, 0, 0);
      osmesa().destroy_context(context);
    }
  };
  using Handle = std::unique_ptr<OsMesaHandle, Destroy>;

  Handle create() {
    // No depth, stencil or accumulation: all drawing goes to targets.
    const int asked[] = {osmesa_format,
                         GL_RGBA,
                         osmesa_profile,
                         osmesa_core_profile,
                         osmesa_major_version,
                         3,
                         osmesa_minor_version,
                         3,
                         0};
    Handle context(osmesa().create_context(asked, nullptr));
    if (!context) throw Error("OSMesa gives no OpenGL 3.3 core context: install a newer Mesa, or use --context egl");
    if (!osmesa().make_current(context.get(), surface_.data(), GL_UNSIGNED_BYTE, side, side))
      throw Error("OSMesa cannot make its context current");
    return context;
  }

  static constexpr int side = 4;  ///< pixels
  CurrentContext current_;
  std::array<unsigned char, 4 * side * side> surface_{};  ///< the default framebuffer, which OSMesa requires
  Handle context_;
  Gl gl_;
};

}  // namespace

std::unique_ptr<HeadlessContext> make_osmesa_context() {
  return std::make_unique<OsMesaContext>();
}

}  // namespace atelier
