// A glTF 2.0 file in memory: its JSON document and its buffers, checked.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "scene_import/json_field.hpp"
#include "scene_import/notes.hpp"

namespace atelier::scene_import {

struct GltfFile {
  std::filesystem::path path;
  std::string name;  ///< the path as text, for messages
  std::filesystem::path folder;
  std::shared_ptr<const nlohmann::json> document;
  std::vector<std::string> buffers;  ///< bytes, each at least as long as its byteLength
  Notes* notes = nullptr;

  JsonField root() const { return {*document, name}; }
};

/// Reads and parses a .gltf or .glb file (distinguished by its first bytes) and loads its buffers. Throws Error if it
/// is not glTF 2.x, needs an unsupported extension, or a buffer is missing or too short.
GltfFile open_gltf(const std::filesystem::path& path, Notes& notes);

/// The bytes of bufferViews[index]. Throws Error naming the view if it exceeds its buffer.
std::string_view view_bytes(const GltfFile& file, int index);

}  // namespace atelier::scene_import
