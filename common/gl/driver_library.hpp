// A driver's library that is loaded at run time, so that a machine without it can use another.
#pragma once

#include <dlfcn.h>
#include <fmt/core.h>

#include "base/error.hpp"

namespace atelier {

struct DriverLibrary {
  void* handle;       ///< from dlopen; never closed: a driver with running threads must not be unloaded
  const char* name;   ///< for messages: "EGL"
  const char* needs;  ///< the oldest version with all functions: "EGL 1.4"

  /// Sets `function` to the library's `symbol`. Throws Error naming the missing symbol and the version that is needed.
  template <class Function>
  void find(Function& function, const char* symbol) const {
    function = reinterpret_cast<Function>(dlsym(handle, symbol));
    if (!function) throw Error(fmt::format("the installed {} lacks {}: {} or newer is needed", name, symbol, needs));
  }
};

}  // namespace atelier
