// A window with an OpenGL 3.3 context: an RAII wrapper of GLFW.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/window/controls.hpp"
#include "gl/gl.hpp"

struct GLFWwindow;

namespace atelier {

class Display {
 public:
  /// Opens a window whose content has `size` in window units (pixels on a standard screen), hidden until `show`. Throws
  /// Error with an alternative if there is no display or no OpenGL 3.3. Only one at a time.
  Display(glm::ivec2 size, const std::string& title, std::optional<glm::ivec2> place = {});
  ~Display();
  Display(const Display&) = delete;
  Display& operator=(const Display&) = delete;

  Gl& gl() { return *gl_; }
  GLFWwindow* handle() { return window_; }

  void show();
  void set_title(const std::string& title);
  bool wants_to_close() const;

  glm::ivec2 size() const;    ///< of the content, in window units, like cursor positions
  glm::ivec2 pixels() const;  ///< of the content in pixels, for viewports; 0 if the window is iconified
  glm::ivec2 place() const;   ///< of its upper left corner on the desktop, as the constructor takes it
  double text_scale() const;  ///< scale factor of text: 1 on a standard screen

  /// Events since the last call; waits up to `seconds` for the first event, not at all for 0.
  std::vector<Event> wait(double seconds);

  /// Binds the window's framebuffer for drawing already encoded colours.
  void bind();
  /// Swaps buffers, synchronised with the screen's refresh.
  void present();

 private:
  struct Library {  // GLFW: initialised before the window, terminated after it
    Library();
    ~Library();
  };
  Library library_;
  GLFWwindow* window_ = nullptr;
  std::unique_ptr<Gl> gl_;
  std::vector<Event> events_;
};

}  // namespace atelier
