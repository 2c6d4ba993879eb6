// A glTF file of one triangle, small enough to break in every place.
#pragma once

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/file.hpp"
#include "catch.hpp"
#include "scene_import/scene_import.hpp"

namespace atelier::test {

/// Bytes of numbers, as they lie in a buffer.
template <class T>
std::string bytes_of(std::initializer_list<T> values) {
  std::string bytes(values.size() * sizeof(T), '\0');
  std::memcpy(bytes.data(), std::data(values), bytes.size());
  return bytes;
}

/// Positions (36 bytes), normals (36), texture coordinates (24), indices (6, padded to 8).
inline std::string triangle_buffer() {
  return bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}) + bytes_of<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}) +
         bytes_of<float>({0, 1, 1, 1, 0, 0}) + bytes_of<std::uint16_t>({0, 1, 2, 0});
}

inline nlohmann::json triangle_document() {
  return nlohmann::json::parse(R"({
    "asset": {"version": "2.0"},
    "scene": 0,
    "scenes": [{"nodes": [0]}],
    "nodes": [{"mesh": 0, "name": "corner"}],
    "meshes": [{"name": "tri", "primitives": [
      {"attributes": {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2}, "indices": 3, "material": 0}]}],
    "materials": [{"name": "paint", "pbrMetallicRoughness":
      {"baseColorFactor": [1, 0.5, 0.25, 1], "metallicFactor": 0, "roughnessFactor": 0.5}}],
    "accessors": [
      {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
      {"bufferView": 0, "byteOffset": 36, "componentType": 5126, "count": 3, "type": "VEC3"},
      {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2"},
      {"bufferView": 2, "componentType": 5123, "count": 3, "type": "SCALAR"}],
    "bufferViews": [
      {"buffer": 0, "byteLength": 72},
      {"buffer": 0, "byteOffset": 72, "byteLength": 24},
      {"buffer": 0, "byteOffset": 96, "byteLength": 6}],
    "buffers": [{"byteLength": 104, "uri": "triangle.bin"}]
  })");
}

/// Writes DIR/triangle.gltf with triangle.bin beside it; returns the path of the former.
inline std::filesystem::path write_gltf(const std::filesystem::path& folder, const nlohmann::json& document,
                                        const std::string& buffer = triangle_buffer()) {
  write_file(folder / "triangle.bin", buffer);
  write_file(folder / "triangle.gltf", document.dump());
  return folder / "triangle.gltf";
}

/// The same as one binary file.
inline std::string glb_bytes(nlohmann::json document, const std::string& buffer = triangle_buffer()) {
  document["buffers"][0].erase("uri");
  std::string json = document.dump();
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const auto words = [](std::initializer_list<std::size_t> values) {
    std::string bytes;
    for (const std::size_t value : values) bytes += bytes_of({std::uint32_t(value)});
    return bytes;
  };
  return "glTF" + words({2, 12 + 8 + json.size() + 8 + buffer.size()}) + words({json.size()}) + "JSON" + json +
         words({buffer.size()}) + std::string("BIN\0", 4) + buffer;
}

inline Scene import_document(const nlohmann::json& document, const std::string& buffer = triangle_buffer(),
                             std::vector<std::string>* notes = nullptr) {
  const TemporaryFolder folder;
  return import_scene(write_gltf(folder.path(), document, buffer), notes);
}

/// The document with something in it changed.
inline nlohmann::json changed(const std::function<void(nlohmann::json&)>& change) {
  nlohmann::json document = triangle_document();
  change(document);
  return document;
}

/// Where a point of a node, by its name, lies in the world.
inline glm::dvec3 at(const Scene& scene, const char* node, const glm::dvec3& p) {
  const auto world = world_matrices_exact(scene.nodes);
  for (std::size_t i = 0; i < scene.nodes.size(); ++i)
    if (scene.nodes[i].name == node) return glm::dvec3(world[i] * glm::dvec4(p, 1));
  FAIL("no node " << node);
  return {};
}

}  // namespace atelier::test
