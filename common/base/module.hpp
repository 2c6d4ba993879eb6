// Modules that are loaded on first use, because they are slow to start.
#pragma once

#include <string>

namespace atelier {

/// The address of `symbol` in the module lib<name>.so in the folder of libatelier.so. The first call loads the module;
/// it is never unloaded. OpenImageIO and its 200 libraries take a quarter of a second to load, which a program that
/// uses no picture file must not pay. Throws Error naming the module, the folder and the loader's reason.
void* module_symbol(const std::string& name, const char* symbol);

}  // namespace atelier
