// The environment of a run. Pictures depend on the driver, so every result names it.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "judge/compare/result.hpp"

namespace atelier::grade {

inline constexpr std::string_view no_driver = "none: ";  ///< prefix of a driver's description if there is no driver

/// "driver" (as OpenGL names it), "context", "compiler", "cpu", "system", "atelier" (version, and the commit in a git
/// checkout). Creates a context of the given kind (empty: the default), which takes about 15 ms. If that fails,
/// "driver" is "none: REASON".
judge::Environment describe_environment(const std::string& context, const std::filesystem::path& step_flags,
                                        const std::filesystem::path& project);

/// "OpenGL 4.5 (Core Profile) Mesa 22.3.6, llvmpipe (LLVM 15.0.6, 256 bits)", or "none: REASON".
std::string describe_driver(const std::string& context);

}  // namespace atelier::grade
