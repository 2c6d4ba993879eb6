// The module atelier-window-context: the only headless context that needs a window system. It draws with the driver of
// the user's own screen.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "base/error.hpp"
#include "gl/context_kinds.hpp"

namespace atelier {
namespace {

/// GLFW's message about the last error.
std::string glfw_reason() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text ? text : "no reason given";
}

class GlfwLibrary {
 public:
  GlfwLibrary() {
    glfwInitHint(GLFW_COCOA_CHDIR_RESOURCES, GLFW_FALSE);  // macOS: do not change the working directory
    if (!glfwInit())
      throw Error("no window can be opened (" + glfw_reason() +
                  "): start from a desktop or under xvfb-run, or use --context osmesa or egl");
  }
  ~GlfwLibrary() { glfwTerminate(); }
  GlfwLibrary(const GlfwLibrary&) = delete;
  GlfwLibrary& operator=(const GlfwLibrary&) = delete;
};

class WindowContext : public HeadlessContext {
 public:
  WindowContext()
      : window_(open()), gl_([](const char* name) { return reinterpret_cast<void*>(glfwGetProcAddress(name)); }) {}
  Gl& gl() override { return gl_; }
  ContextKind kind() const override { return ContextKind::window; }

 private:
  struct Close {
    void operator()(GLFWwindow* window) const { glfwDestroyWindow(window); }
  };
  using Window = std::unique_ptr<GLFWwindow, Close>;

  static Window open() {
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);  // required for 3.3 on macOS
    Window window(glfwCreateWindow(16, 16, "atelier", nullptr, nullptr));
    if (!window)
      throw Error("the window system gives no OpenGL 3.3 core context (" + glfw_reason() +
                  "): update the graphics driver, or use --context osmesa or egl");
    glfwMakeContextCurrent(window.get());
    return window;
  }

  CurrentContext current_;
  GlfwLibrary library_;
  Window window_;
  Gl gl_;
};

}  // namespace
}  // namespace atelier

extern "C" atelier::HeadlessContext* atelier_make_window_context() {
  return new atelier::WindowContext;
}

extern "C" float atelier_window_content_scale() {
  GLFWwindow* const window = glfwGetCurrentContext();
  if (!window) throw atelier::Error("no window's context is current, so the scale of its screen is unknown");
  float horizontal = 1, vertical = 1;
  glfwGetWindowContentScale(window, &horizontal, &vertical);
  return horizontal;
}
