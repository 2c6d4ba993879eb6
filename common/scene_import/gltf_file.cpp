#include "scene_import/gltf_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/file.hpp"
#include "scene_import/references.hpp"

namespace atelier::scene_import {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF's binary data is little-endian, and copied as it is");

constexpr std::size_t largest_document = std::size_t(512) << 20;  // of JSON text; needs about ten times as much memory

std::uint32_t word_at(std::string_view bytes, std::size_t offset) {
  std::uint32_t word;
  std::memcpy(&word, bytes.data() + offset, sizeof word);
  return word;
}

struct Container {
  std::string_view json, binary;
};

/// The chunks of a .glb file: 12 bytes of header, then chunks of length, kind and data (glTF 2.0, "Binary glTF
/// layout").
Container split_glb(const std::string& name, std::string_view bytes) {
  constexpr std::uint32_t json_kind = 0x4E4F534A, binary_kind = 0x004E4942;  // "JSON", "BIN\0"
  const auto fail = [&](const std::string& what) { throw Error(fmt::format("{}: {}", name, what)); };
  if (bytes.size() < 20) fail(fmt::format("a binary glTF file of {} bytes (at least 20 are needed)", bytes.size()));
  if (word_at(bytes, 4) != 2) fail(fmt::format("binary glTF of version {} (allowed: 2)", word_at(bytes, 4)));
  if (word_at(bytes, 8) > bytes.size())
    fail(fmt::format("the file is truncated: {} of {} bytes", bytes.size(), word_at(bytes, 8)));
  bytes = bytes.substr(0, word_at(bytes, 8));

  Container container;
  for (std::size_t at = 12; at + 8 <= bytes.size();) {
    const std::uint64_t length = word_at(bytes, at), kind = word_at(bytes, at + 4);
    if (at + 8 + length > bytes.size())
      fail(fmt::format("the chunk at byte {} reaches past the end of the file, byte {} by its header", at,
                       bytes.size()));
    const std::string_view data = bytes.substr(at + 8, length);
    if (kind == json_kind && container.json.empty()) container.json = data;
    if (kind == binary_kind && container.binary.empty()) container.binary = data;
    at += 8 + length;
  }
  if (container.json.empty()) fail("a binary glTF file without a JSON chunk");
  return container;
}

void check_version(const GltfFile& file) {
  const JsonField field = file.root().at("asset").at("version");
  if (const auto& number = file.document->at("asset").at("version"); number.is_number())  // as in early glTF 1.0
    field.fail(fmt::format("the number {} (allowed: \"2.x\", a text)", number.dump()));
  const std::string version = field.text();
  if (!version.starts_with("2.")) file.root().fail(fmt::format("glTF of version '{}' (allowed: 2.x)", version));
  const std::string least = file.root().at("asset").text_or("minVersion", "2.0");
  if (least != "2.0") file.root().fail(fmt::format("it needs glTF of version '{}' (here: 2.0)", least));
}

bool is_understood(const std::string& extension) {
  static constexpr const char* understood[] = {"KHR_lights_punctual", "KHR_materials_pbrSpecularGlossiness",
                                               "KHR_materials_emissive_strength", "KHR_texture_transform",
                                               "KHR_mesh_quantization"};
  return std::ranges::find(understood, extension) != std::end(understood);
}

/// Whether it is understood, or can be ignored without changing the shape of the model.
bool can_do_without(const std::string& extension) {
  return is_understood(extension) || extension.starts_with("KHR_materials_");
}

void check_extensions(const GltfFile& file) {
  const auto used = file.root().find("extensionsUsed");
  for (std::size_t i = 0; used && i < used->size(); ++i)
    if (const std::string& extension = (*used)[i].text(); !is_understood(extension))
      file.notes->add(fmt::format("{}: what the extension '{}' says is left out", file.name, extension));

  const auto required = file.root().find("extensionsRequired");
  for (std::size_t i = 0; required && i < required->size(); ++i) {
    const std::string& extension = (*required)[i].text();
    if (!can_do_without(extension))
      file.root().fail(fmt::format("the file needs the extension '{}', which is not supported", extension));
  }
}

std::string load_buffer(const GltfFile& file, const JsonField& buffer, std::size_t index, std::string_view binary) {
  const auto uri = buffer.find("uri");
  if (!uri) {
    // Only the first buffer may be the file's binary chunk. Others without data are placeholders for extensions.
    return index == 0 ? std::string(binary) : std::string();
  }
  try {
    if (auto bytes = decode_data_uri(uri->text())) return std::move(*bytes);
    return read_file(resolve_reference(file.folder, percent_decode(uri->text())));
  } catch (const Error& error) {
    uri->fail(error.what());
  }
}

void load_buffers(GltfFile& file, std::string_view binary) {
  const auto buffers = file.root().find("buffers");
  for (std::size_t i = 0; buffers && i < buffers->size(); ++i) {
    const JsonField buffer = (*buffers)[i];
    const std::int64_t length = buffer.at("byteLength").integer(1, std::int64_t(1) << 40);
    std::string bytes = load_buffer(file, buffer, i, binary);
    if (bytes.size() < std::size_t(length))
      buffer.fail(fmt::format("{} bytes of data where byteLength promises {}", bytes.size(), length));
    bytes.resize(length);
    file.buffers.push_back(std::move(bytes));
  }
}

}  // namespace

GltfFile open_gltf(const std::filesystem::path& path, Notes& notes) {
  GltfFile file{.path = path, .name = path.string(), .folder = path.parent_path(), .notes = &notes};
  const std::string bytes = read_file(path);
  if (bytes.empty()) throw Error(fmt::format("{}: the file is empty", file.name));
  Container container{bytes, {}};
  if (bytes.starts_with("glTF")) container = split_glb(file.name, bytes);
  if (container.json.size() > largest_document)
    throw Error(fmt::format("{}: {} bytes of JSON (allowed: {})", file.name, container.json.size(), largest_document));
  file.document = std::make_shared<const nlohmann::json>(parse_json(container.json, file.name));
  check_version(file);
  check_extensions(file);
  load_buffers(file, container.binary);
  return file;
}

std::string_view view_bytes(const GltfFile& file, int index) {
  constexpr std::int64_t most = std::int64_t(1) << 40;
  const JsonField view = file.root().at("bufferViews")[std::size_t(index)];
  const std::string& buffer = file.buffers[std::size_t(view.at("buffer").index(file.buffers.size()))];
  const auto offset = std::size_t(view.integer_or("byteOffset", 0, most, 0));
  const auto length = std::size_t(view.at("byteLength").integer(1, most));
  if (offset > buffer.size() || length > buffer.size() - offset)
    view.fail(fmt::format("bytes {}..{} of a buffer of {}", offset, offset + length, buffer.size()));
  return std::string_view(buffer).substr(offset, length);
}

}  // namespace atelier::scene_import
