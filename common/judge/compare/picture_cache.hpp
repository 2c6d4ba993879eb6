// A cache of decoded reference pictures as raw floats: starting the picture library takes a quarter of a second, which
// a student should not wait for at every save.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "image/image.hpp"

namespace atelier::judge {

/// The pixels of `picture`, from the cache in `folder` if it has them, otherwise from `decode()`, which is then cached.
///
/// The key of an entry is the picture's absolute path, size in bytes, time of last change and `fingerprint`, so a
/// changed picture or sidecar never matches an old entry. Entries are written atomically and have a checksum, so the
/// folder may be deleted, damaged or shared by several processes at any time. If it cannot be written, only speed is
/// lost. An empty `folder` means no cache. Throws Error if `picture` is missing, and whatever `decode` throws.
Image cached_picture(const std::filesystem::path& folder, const std::filesystem::path& picture,
                     const std::string& fingerprint, const std::function<Image()>& decode);

}  // namespace atelier::judge
