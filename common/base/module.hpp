// Parts that are loaded only when something really needs them, because they are slow to start.
#pragma once

#include <string>

namespace atelier {

/// The address of `symbol` in the module lib<name>.so beside libatelier.so, loaded at the first call and kept.
/// OpenImageIO with its 200 libraries costs a quarter of a second: a program that draws without touching a picture file
/// must not pay for it. Throws Error naming the module, the place and the loader's reason.
void* module_symbol(const std::string& name, const char* symbol);

}  // namespace atelier
