// The life of a window: hears what the user does, looks whether files have changed, draws when there is something new.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>

#include "app/window/display.hpp"
#include "app/window/module.hpp"
#include "app/window/panel.hpp"
#include "app/window/presenter.hpp"
#include "app/window/restart.hpp"
#include "app/window/viewer.hpp"

namespace atelier {

/// What the environment asks (see module.hpp).
struct WindowWishes {
  std::optional<int> frames;
  std::filesystem::path save;
  std::optional<glm::ivec2> place;
};

/// Throws Error naming the variable where one cannot be understood.
WindowWishes wishes_of_environment();

class Window {
 public:
  Window(const WindowRequest& request, const WindowWishes& wishes);

  /// Until it is closed. Nothing: the user is done. A command line: the code has changed, start the program again so.
  std::optional<CommandLine> run();
  glm::ivec2 place() const { return display_.place(); }

 private:
  using Clock = std::chrono::steady_clock;

  double waiting_time() const;
  void hear(const std::vector<Event>& events);
  void obey(const Gesture& gesture);
  void obey(Action action, int number);
  void look_at_files();
  void look_at_code();
  void let_time_pass();
  void draw_round();
  void retitle();
  void save_picture();
  void notify(const std::string& words);
  glm::ivec2 picture_pixels(glm::ivec2 window) const;
  CommandLine line_to_return_by() const;

  const WindowRequest& request_;
  const WindowWishes wishes_;
  const std::filesystem::path program_file_;

  // Made in this order and ended in the reverse: nothing of OpenGL may outlive its context.
  Display display_;
  std::unique_ptr<StepProgram> program_;
  Viewer viewer_;
  Presenter presenter_;
  std::unique_ptr<Panel> panel_;

  PanelState state_;
  Controls controls_;
  Watch libraries_, shaders_;
  bool quit_ = false;
  bool restart_ = false;
  int rounds_left_ = 0;  ///< to be drawn without waiting
  int frames_ = 0;       ///< presented so far
  std::string title_;
  Clock::time_point last_round_ = Clock::now(), last_look_ = Clock::now(), notice_end_;
};

}  // namespace atelier
