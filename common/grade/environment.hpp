// With what a result was made: pictures depend on the driver, so every result says which.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "judge/compare/result.hpp"

namespace atelier::grade {

inline constexpr std::string_view no_driver = "none: ";  ///< what a driver's words begin with where there is none

/// "driver" (OpenGL's own words), "context", "compiler", "cpu", "system", "atelier" (version, and commit where the
/// project is a git checkout). A context of the kind (empty: the default) is made for it, which takes some 15 ms: ask
/// after the verdict. Where there is none the driver is "none: WHY", because a result must say even that.
judge::Environment describe_environment(const std::string& context, const std::filesystem::path& step_flags,
                                        const std::filesystem::path& project);

/// "OpenGL 4.5 (Core Profile) Mesa 22.3.6, llvmpipe (LLVM 15.0.6, 256 bits)", or "none: WHY"
std::string describe_driver(const std::string& context);

}  // namespace atelier::grade
