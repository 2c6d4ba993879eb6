// A window on the screen with OpenGL 3.3 in it: what of it this project needs from GLFW, with an owner.
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
  /// Opens a window whose content is `size` in its own units (pixels on a plain screen), hidden until `show`. Throws
  /// Error where there is no display or no OpenGL 3.3, saying what can be done instead. One at a time.
  Display(glm::ivec2 size, const std::string& title, std::optional<glm::ivec2> place = {});
  ~Display();
  Display(const Display&) = delete;
  Display& operator=(const Display&) = delete;

  Gl& gl() { return *gl_; }
  GLFWwindow* handle() { return window_; }

  void show();
  void set_title(const std::string& title);
  bool wants_to_close() const;

  glm::ivec2 size() const;    ///< of the content, in the window's own units: those of cursor positions
  glm::ivec2 pixels() const;  ///< of the content: those of viewports; 0 where the window is iconified
  glm::ivec2 place() const;   ///< of its upper left corner on the desktop, as the constructor takes it
  double text_scale() const;  ///< window units that a unit of text design should take: 1 on a plain screen

  /// What has happened since the last call; waits up to `seconds` for the first event, not at all for 0.
  std::vector<Event> wait(double seconds);

  /// Binds the window's own framebuffer for drawing colours that are encoded already.
  void bind();
  /// Brings what was drawn onto the screen, in step with its refreshes.
  void present();

 private:
  struct Library {  // GLFW itself: started before the window, ended after it
    Library();
    ~Library();
  };
  Library library_;
  GLFWwindow* window_ = nullptr;
  std::unique_ptr<Gl> gl_;
  std::vector<Event> events_;
};

}  // namespace atelier
