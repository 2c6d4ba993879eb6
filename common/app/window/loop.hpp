// The window's main loop: handles input, checks whether files have changed, draws if something is new.
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

/// Options from environment variables (see module.hpp).
struct WindowOptions {
  std::optional<int> frames;
  std::filesystem::path save;
  std::optional<glm::ivec2> place;
};

/// Throws Error naming a variable that is invalid.
WindowOptions options_from_environment();

class Window {
 public:
  Window(const WindowRequest& request, const WindowOptions& options);

  /// Runs until the window is closed. None: the user has quit. A command line: the code has changed, restart the
  /// program with it.
  std::optional<CommandLine> run();
  glm::ivec2 place() const { return display_.place(); }

 private:
  using Clock = std::chrono::steady_clock;

  double waiting_time() const;
  void handle(const std::vector<Event>& events);
  void execute(const Gesture& gesture);
  void execute(Action action, int number);
  void look_at_files();
  void look_at_code();
  void let_time_pass();
  void draw_round();
  void retitle();
  void save_picture();
  void notify(const std::string& words);
  glm::ivec2 picture_pixels(glm::ivec2 window) const;
  CommandLine restart_command_line() const;

  const WindowRequest& request_;
  const WindowOptions options_;
  const std::filesystem::path program_file_;

  // Destroyed in reverse order: OpenGL objects must not outlive their context.
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
  int rounds_left_ = 0;  ///< frames to draw without waiting
  int frames_ = 0;       ///< presented so far
  std::string title_;
  Clock::time_point last_round_ = Clock::now(), last_look_ = Clock::now(), notice_end_;
};

}  // namespace atelier
