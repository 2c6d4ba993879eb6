// EGL without a surface: the desktop's drivers, software or GPU, without a display.
#define EGL_NO_X11  // keeps Xlib's macros (None, Status ...) out
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>
#include <fmt/core.h>

#include <array>
#include <cstring>
#include <string_view>
#include <type_traits>

#include "base/error.hpp"
#include "gl/context_kinds.hpp"
#include "gl/driver_library.hpp"

namespace atelier {
namespace {

/// The libEGL functions that are used, looked up at run time.
struct Egl {
  decltype(&eglBindAPI) bind_api = nullptr;
  decltype(&eglChooseConfig) choose_config = nullptr;
  decltype(&eglCreateContext) create_context = nullptr;
  decltype(&eglDestroyContext) destroy_context = nullptr;
  decltype(&eglGetError) get_error = nullptr;
  decltype(&eglGetProcAddress) function_address = nullptr;
  decltype(&eglInitialize) initialize = nullptr;
  decltype(&eglMakeCurrent) make_current = nullptr;
  decltype(&eglQueryString) query_string = nullptr;
  decltype(&eglReleaseThread) release_thread = nullptr;
};

const Egl& egl() {
  static const Egl functions = [] {
    const DriverLibrary library = {dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL), "EGL", "EGL 1.4"};
    if (!library.handle)
      throw Error("EGL is not installed: install the packages libegl1 and libegl-mesa0, or use --context osmesa");
    Egl found;
    library.find(found.bind_api, "eglBindAPI");
    library.find(found.choose_config, "eglChooseConfig");
    library.find(found.create_context, "eglCreateContext");
    library.find(found.destroy_context, "eglDestroyContext");
    library.find(found.get_error, "eglGetError");
    library.find(found.function_address, "eglGetProcAddress");
    library.find(found.initialize, "eglInitialize");
    library.find(found.make_current, "eglMakeCurrent");
    library.find(found.query_string, "eglQueryString");
    library.find(found.release_thread, "eglReleaseThread");
    return found;
  }();
  return functions;
}

template <class Function>
Function extension_function(const char* name) {
  return reinterpret_cast<Function>(egl().function_address(name));
}

/// Whether `name` is in the extension list of `display` (EGL_NO_DISPLAY: of the library itself).
bool has_extension(EGLDisplay display, std::string_view name) {
  const char* list = egl().query_string(display, EGL_EXTENSIONS);
  if (!list) return false;
  const std::string padded = " " + std::string(list) + " ";
  return padded.find(" " + std::string(name) + " ") != std::string::npos;
}

/// EGL_NO_DISPLAY if it cannot be initialised.
EGLDisplay initialised(EGLDisplay display) {
  return display != EGL_NO_DISPLAY && egl().initialize(display, nullptr, nullptr) ? display : EGL_NO_DISPLAY;
}

/// Mesa's platform without a window system (EGL_MESA_platform_surfaceless).
EGLDisplay surfaceless_display() {
  const auto get_display = extension_function<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  if (!get_display || !has_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) return EGL_NO_DISPLAY;
  return initialised(get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
}

/// The first graphics device that initialises (EGL_EXT_platform_device): for the GPU vendor's own driver.
EGLDisplay device_display() {
  const auto get_display = extension_function<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  const auto query_devices = extension_function<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  if (!get_display || !query_devices || !has_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device"))
    return EGL_NO_DISPLAY;
  std::array<EGLDeviceEXT, 16> devices{};
  EGLint count = 0;
  if (!query_devices(EGLint(devices.size()), devices.data(), &count)) return EGL_NO_DISPLAY;
  for (EGLint i = 0; i < count; ++i)
    if (EGLDisplay display = initialised(get_display(EGL_PLATFORM_DEVICE_EXT, devices[std::size_t(i)], nullptr));
        display != EGL_NO_DISPLAY)
      return display;
  return EGL_NO_DISPLAY;
}

/// One display for the whole process, opened at the first call and never terminated: EGL returns the same display to
/// all callers, so terminating it would break every other context.
EGLDisplay shared_display() {
  static const EGLDisplay display = [] {
    if (EGLDisplay surfaceless = surfaceless_display(); surfaceless != EGL_NO_DISPLAY) return surfaceless;
    if (EGLDisplay device = device_display(); device != EGL_NO_DISPLAY) return device;
    throw Error(
        "EGL finds no driver that draws without a display: install the packages libegl-mesa0 and "
        "libgl1-mesa-dri, or use --context osmesa");
  }();
  return display;
}

class EglContext : public HeadlessContext {
 public:
  EglContext()
      : display_(shared_display()),
        context_(create(display_), Destroy{display_}),
        gl_([](const char* name) { return reinterpret_cast<void*>(egl().function_address(name)); }) {}
  Gl& gl() override { return gl_; }
  ContextKind kind() const override { return ContextKind::egl; }

 private:
  struct Destroy {
    EGLDisplay display;
    void operator()(EGLContext context) const {
      egl().make_current(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
      egl().destroy_context(display, context);
      egl().release_thread();
    }
  };
  using Handle = std::unique_ptr<std::remove_pointer_t<EGLContext>, Destroy>;

  static EGLContext create(EGLDisplay display);

  CurrentContext current_;
  EGLDisplay display_;
  Handle context_;
  Gl gl_;
};

/// No surface is ever drawn to, so any configuration with OpenGL will do; none if the driver allows it.
EGLConfig any_config(EGLDisplay display) {
  if (has_extension(display, "EGL_KHR_no_config_context")) return EGL_NO_CONFIG_KHR;
  const EGLint asked[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!egl().choose_config(display, asked, &config, 1, &count) || count == 0)
    throw Error("EGL's driver offers no OpenGL: use --context osmesa");
  return config;
}

EGLContext EglContext::create(EGLDisplay display) {
  if (!has_extension(display, "EGL_KHR_surfaceless_context"))
    throw Error("EGL's driver draws to windows only (no EGL_KHR_surfaceless_context): use --context osmesa");
  if (!egl().bind_api(EGL_OPENGL_API)) throw Error("EGL's driver offers no OpenGL: use --context osmesa");
  const EGLint asked[] = {
      EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  const EGLContext context = egl().create_context(display, any_config(display), EGL_NO_CONTEXT, asked);
  if (context == EGL_NO_CONTEXT)
    throw Error(
        fmt::format("EGL gives no OpenGL 3.3 core context (EGL error 0x{:04x}): update the graphics driver, or "
                    "use --context osmesa",
                    egl().get_error()));
  if (!egl().make_current(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
    const EGLint reason = egl().get_error();
    egl().destroy_context(display, context);
    throw Error(fmt::format("EGL cannot make its context current (EGL error 0x{:04x})", reason));
  }
  return context;
}

}  // namespace

std::unique_ptr<HeadlessContext> make_egl_context() {
  return std::make_unique<EglContext>();
}

}  // namespace atelier
