// The window of a step program: orbit camera, settings panel, hot reload. Is a module of its own, so that headless
// drawing starts without GLFW and Dear ImGui.
#pragma once

#include "app/command_line.hpp"
#include "app/load.hpp"
#include "app/step_program.hpp"

namespace atelier {

/// Opens a window and runs until it is closed; returns the exit status. Throws Error if there is no display.
int run_window(const StepIdentity& identity, const Implementations& implementations, const CommandLine& line);

}  // namespace atelier
