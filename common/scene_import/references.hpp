// Files that a model file references: allowed only below the model's own folder.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "image_io/image_io.hpp"
#include "scene/scene.hpp"
#include "scene_import/notes.hpp"

namespace atelier::scene_import {

/// The path of a relative reference ("textures/wood.png", backslashes allowed). Throws Error, without naming the model
/// file, if it is empty, absolute, contains "..", has a scheme ("https:"), or leaves the folder through a link. The
/// file need not exist.
std::filesystem::path resolve_reference(const std::filesystem::path& folder, const std::string& reference);

/// Decodes URI escapes: "%20" to a space and so on. Invalid escapes do not change.
std::string percent_decode(const std::string& text);

/// The bytes of a "data:...;base64,..." URI; none if it is not a data URI. Throws Error if it has no base64 or invalid
/// base64.
std::optional<std::string> decode_data_uri(const std::string& uri);

/// Base64 of RFC 4648; padding may be left out. Throws Error for any other character.
std::string decode_base64(std::string_view text);

/// A picture in the model's folder. None, with a note, if it is missing or outside the folder: the model is shown
/// without it. Throws Error, naming it, if it exists but cannot be read.
std::optional<Image> read_model_picture(const std::filesystem::path& folder, const std::string& reference,
                                        Encoding encoding, Notes& notes);

/// Adds a texture and returns its index. Throws Error if all textures of the scene together exceed max_import_texels.
int add_limited_texture(Scene& scene, Texture texture);

}  // namespace atelier::scene_import
