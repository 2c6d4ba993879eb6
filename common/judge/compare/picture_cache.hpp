// Decoded reference pictures, kept as raw floats: opening an EXR costs a quarter of a second of start-up for the
// picture library alone, which a student who waits for a verdict should pay once and not at every save.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "image/image.hpp"

namespace atelier::judge {

/// The pixels of `picture`, from `folder` where they were kept before, otherwise from `decode()`, and then kept.
///
/// An entry is found by the picture's absolute path, size in bytes, time of last change and `fingerprint`, so that a
/// changed picture or sidecar never meets an old entry. Entries are written beside and renamed, and carry a checksum:
/// the folder may be deleted, filled with rubbish or shared by several processes at any time, and a folder that cannot
/// be written costs speed only. An empty `folder` means no cache. Throws Error where `picture` is missing, and what
/// `decode` throws.
Image cached_picture(const std::filesystem::path& folder, const std::filesystem::path& picture,
                     const std::string& fingerprint, const std::function<Image()>& decode);

}  // namespace atelier::judge
