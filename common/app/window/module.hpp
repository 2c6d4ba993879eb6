// The module atelier-window: all code that needs GLFW and Dear ImGui, loaded when a window is opened.
//
// Three environment variables are used by tests and by the program's own restart:
//   ATELIER_WINDOW_FRAMES=N    redraw without waiting, and quit after N frames
//   ATELIER_WINDOW_SAVE=FILE   write what the whole window shows, panel included, when it quits
//   ATELIER_WINDOW_PLACE=X,Y   where on the desktop its upper left corner stands
#pragma once

#include <functional>
#include <memory>

#include "app/command_line.hpp"
#include "app/load.hpp"

namespace atelier {

struct WindowRequest {
  const StepIdentity& identity;
  const Implementations& implementations;
  const CommandLine& line;
  std::function<std::unique_ptr<StepProgram>()> make;  ///< called once, when there is a context
};

}  // namespace atelier

/// Opens the window, runs until it is closed, returns the exit status. Throws Error if it cannot be opened.
extern "C" int atelier_show_window(const atelier::WindowRequest& request);
