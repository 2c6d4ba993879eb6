#include "app/window/display.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "base/error.hpp"

namespace atelier {
namespace {

/// GLFW's last error message; reading clears it.
std::string glfw_words() {
  const char* words = nullptr;
  glfwGetError(&words);
  return words ? words : "no reason given";
}

std::vector<Event>& queue_of(GLFWwindow* window) {
  return *static_cast<std::vector<Event>*>(glfwGetWindowUserPointer(window));
}

glm::dvec2 cursor_of(GLFWwindow* window) {
  glm::dvec2 position;
  glfwGetCursorPos(window, &position.x, &position.y);
  return position;
}

std::optional<Typed> typed(int key) {
  if (key >= GLFW_KEY_1 && key <= GLFW_KEY_9) return Typed{Key::digit, key - GLFW_KEY_0};
  if (key >= GLFW_KEY_KP_1 && key <= GLFW_KEY_KP_9) return Typed{Key::digit, key - GLFW_KEY_KP_0};
  switch (key) {
    case GLFW_KEY_ESCAPE:
      return Typed{Key::escape};
    case GLFW_KEY_TAB:
      return Typed{Key::tab};
    case GLFW_KEY_SPACE:
      return Typed{Key::space};
    case GLFW_KEY_LEFT:
      return Typed{Key::left};
    case GLFW_KEY_RIGHT:
      return Typed{Key::right};
    case GLFW_KEY_UP:
      return Typed{Key::up};
    case GLFW_KEY_DOWN:
      return Typed{Key::down};
    default:
      return {};
  }
}

/// Letters by the keyboard layout, not by position: Y and Z differ between layouts.
std::optional<Typed> typed_character(unsigned character) {
  switch (character) {
    case '+':
    case '=':
      return Typed{Key::plus};
    case '-':
      return Typed{Key::minus};
    case 'h':
    case 'H':
      return Typed{Key::h};
    case 'r':
    case 'R':
      return Typed{Key::r};
    case 's':
    case 'S':
      return Typed{Key::s};
    default:
      return {};
  }
}

std::optional<Button> button_of(int number) {
  switch (number) {
    case GLFW_MOUSE_BUTTON_LEFT:
      return Button::left;
    case GLFW_MOUSE_BUTTON_MIDDLE:
      return Button::middle;
    case GLFW_MOUSE_BUTTON_RIGHT:
      return Button::right;
    default:
      return {};
  }
}

void listen(GLFWwindow* window) {
  glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int modifiers) {
    if (action == GLFW_RELEASE || (modifiers & (GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER))) return;
    if (const auto event = typed(key)) queue_of(w).push_back(*event);
  });
  glfwSetCharCallback(window, [](GLFWwindow* w, unsigned character) {
    if (const auto event = typed_character(character)) queue_of(w).push_back(*event);
  });
  glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int number, int action, int) {
    const auto button = button_of(number);
    if (!button) return;
    if (action == GLFW_PRESS)
      queue_of(w).push_back(Pressed{*button, cursor_of(w), glfwGetTime()});
    else
      queue_of(w).push_back(Released{*button});
  });
  glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) { queue_of(w).push_back(Moved{{x, y}}); });
  glfwSetScrollCallback(window, [](GLFWwindow* w, double, double y) { queue_of(w).push_back(Scrolled{y}); });
  glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { queue_of(w).push_back(Exposed{}); });
  glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { queue_of(w).push_back(Exposed{}); });
  glfwSetWindowContentScaleCallback(window, [](GLFWwindow* w, float, float) { queue_of(w).push_back(Exposed{}); });
}

}  // namespace

Display::Library::Library() {
  glfwInitHint(GLFW_COCOA_CHDIR_RESOURCES,
               GLFW_FALSE);  // keep the working directory: paths on the command line are relative to it
  if (!glfwInit())
    throw Error(
        fmt::format("no window can be opened ({}): draw into a file instead, with --out FILE.png", glfw_words()));
}

Display::Library::~Library() {
  glfwTerminate();
}

Display::Display(glm::ivec2 size, const std::string& title, std::optional<glm::ivec2> place) {
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);  // required on macOS
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);  // scenes are drawn into their own targets
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  window_ = glfwCreateWindow(size.x, size.y, title.c_str(), nullptr, nullptr);
  if (!window_)
    throw Error(
        fmt::format("no window of {}x{} with OpenGL 3.3 can be opened ({}): draw into a file instead, with --out "
                    "FILE.png",
                    size.x, size.y, glfw_words()));
  try {
    if (place) glfwSetWindowPos(window_, place->x, place->y);
    glfwSetWindowUserPointer(window_, &events_);
    listen(window_);
    glfwMakeContextCurrent(window_);
    gl_ = std::make_unique<Gl>([](const char* name) { return reinterpret_cast<void*>(glfwGetProcAddress(name)); });
    glfwSwapInterval(1);
  } catch (...) {
    glfwDestroyWindow(window_);
    throw;
  }
}

Display::~Display() {
  glfwDestroyWindow(window_);
}

void Display::show() {
  glfwShowWindow(window_);
}
void Display::set_title(const std::string& title) {
  glfwSetWindowTitle(window_, title.c_str());
}
bool Display::wants_to_close() const {
  return glfwWindowShouldClose(window_);
}

glm::ivec2 Display::size() const {
  glm::ivec2 size;
  glfwGetWindowSize(window_, &size.x, &size.y);
  return size;
}

glm::ivec2 Display::pixels() const {
  glm::ivec2 pixels;
  glfwGetFramebufferSize(window_, &pixels.x, &pixels.y);
  return pixels;
}

glm::ivec2 Display::place() const {
  glm::ivec2 place;
  glfwGetWindowPos(window_, &place.x, &place.y);
  return place;
}

double Display::text_scale() const {
  // On macOS a window unit is two pixels on a high-DPI screen, so text needs no scaling; on X11 it is one pixel, so it
  // does.
  float scale = 1, unused = 1;
  glfwGetWindowContentScale(window_, &scale, &unused);
  const int width = size().x;
  const double pixels_a_unit = width > 0 && pixels().x > 0 ? double(pixels().x) / width : 1;
  return std::max(1.0, double(scale) / pixels_a_unit);
}

std::vector<Event> Display::wait(double seconds) {
  if (seconds > 0)
    glfwWaitEventsTimeout(seconds);
  else
    glfwPollEvents();
  return std::exchange(events_, {});
}

void Display::bind() {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, 0);
  gl_->Disable(GL_FRAMEBUFFER_SRGB);
}
void Display::present() {
  glfwSwapBuffers(window_);
}

}  // namespace atelier
