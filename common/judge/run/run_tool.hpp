// Runs a compiler or linker on a student's files.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "sandbox/sandbox.hpp"

namespace atelier::judge {

/// How the tools run.
struct ToolSettings {
  std::chrono::milliseconds time_limit{60'000};  ///< for one file
  const sandbox::Sandbox* sandbox = nullptr;     ///< null: with our own rights
};

/// What a tool with these options uses besides its working directory: the folders of headers, and `objects`, where it
/// writes.
sandbox::Room room_of_tools(const std::vector<std::string>& options, const std::filesystem::path& objects);

/// Runs it in `folder`, with an environment of its own: its messages are in English, whoever runs it. In a sandbox it
/// sees `room` besides `folder`. Its output goes to `log`, at most log_limit bytes of it, after a reason if it took too
/// long, crashed or failed without a word. True if it succeeded. Throws Error if the sandbox failed.
bool run_tool(std::vector<std::string> arguments, const std::filesystem::path& folder, const std::string& task,
              const ToolSettings& settings, sandbox::Room room, std::string& log);

}  // namespace atelier::judge
