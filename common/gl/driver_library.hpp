// A driver's library that is opened while the program runs, so that a machine without it can still draw with another.
#pragma once

#include <dlfcn.h>
#include <fmt/core.h>

#include "base/error.hpp"

namespace atelier {

struct DriverLibrary {
  void* handle;       ///< from dlopen; never closed: a driver may not be unloaded under its own threads
  const char* name;   ///< in words: "EGL"
  const char* needs;  ///< the oldest that has all of its functions: "EGL 1.4"

  /// Sets `function` to the library's `symbol`. Throws Error naming what is lacking and what is needed.
  template <class Function>
  void find(Function& function, const char* symbol) const {
    function = reinterpret_cast<Function>(dlsym(handle, symbol));
    if (!function) throw Error(fmt::format("the installed {} lacks {}: {} or newer is needed", name, symbol, needs));
  }
};

}  // namespace atelier
