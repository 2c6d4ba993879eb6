// Files that a model file names: found below the model's own folder, or refused.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "image_io/image_io.hpp"
#include "scene/scene.hpp"
#include "scene_import/notes.hpp"

namespace atelier::scene_import {

/// The path behind a relative reference ("textures/wood.png", backslashes allowed). Throws Error without naming the
/// model file where it is empty, absolute, climbs with "..", has a scheme ("https:"), or leaves the folder by a link.
/// The file itself need not exist.
std::filesystem::path resolve_reference(const std::filesystem::path& folder, const std::string& reference);

/// "%20" to a blank and so on, as URIs write what they may not contain. What is no escape stays.
std::string percent_decode(const std::string& text);

/// The bytes of a "data:...;base64,..." URI, or nothing where it is no data URI. Throws Error where it is one without
/// base64 or with broken base64.
std::optional<std::string> decode_data_uri(const std::string& uri);

/// Base64 after RFC 4648; padding may be left out. Throws Error at any other character.
std::string decode_base64(std::string_view text);

/// A picture beside the model. Nothing, and a note, where it is missing or lies outside the folder: a model is worth
/// seeing without one picture. Throws Error, naming it, where it is there but cannot be read.
std::optional<Image> read_model_picture(const std::filesystem::path& folder, const std::string& reference,
                                        Encoding encoding, Notes& notes);

/// Adds a texture and returns its index. Throws Error where all textures of the scene together pass
/// max_import_texels.
int add_limited_texture(Scene& scene, Texture texture);

}  // namespace atelier::scene_import
