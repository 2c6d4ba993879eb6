// Runs a compiler or linker on a student's files.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace atelier::judge {

/// Runs it in `folder`, with an environment of its own: its messages are in English, whoever runs it. Its output goes
/// to `log`, at most log_limit bytes of it, after a reason if it took too long, crashed or failed without a word. True
/// if it succeeded.
bool run_tool(std::vector<std::string> arguments, const std::filesystem::path& folder, const std::string& task,
              std::chrono::milliseconds time_limit, std::string& log);

}  // namespace atelier::judge
