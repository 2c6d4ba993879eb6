#include "scene_import/references.hpp"

#include <fmt/format.h>

#include <cctype>
#include <system_error>

#include "base/error.hpp"
#include "scene_import/scene_import.hpp"

namespace atelier::scene_import {
namespace {

/// Shortens long paths in messages.
std::string quoted(const std::string& reference) {
  constexpr std::size_t longest = 200;
  return fmt::format("'{}{}'", reference.substr(0, longest), reference.size() > longest ? "..." : "");
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

bool has_scheme(const std::string& reference) {
  // "https:..." and "C:..."; a later colon may be part of a name.
  const std::size_t colon = reference.find(':');
  if (colon == std::string::npos || colon == 0) return false;
  for (std::size_t i = 0; i < colon; ++i)
    if (!std::isalnum(static_cast<unsigned char>(reference[i])) && reference[i] != '+' && reference[i] != '.')
      return false;
  return true;
}

}  // namespace

std::filesystem::path resolve_reference(const std::filesystem::path& folder, const std::string& reference) {
  std::string slashes = reference;
  for (char& c : slashes)
    if (c == '\\') c = '/';
  const std::filesystem::path path(slashes);
  if (path.empty() || slashes.find('\0') != std::string::npos) throw Error("it names a file by an empty path");
  if (path.is_absolute() || has_scheme(slashes))
    throw Error(
        fmt::format("it names {}, and only files in the model's own folder and below are read", quoted(reference)));
  for (const auto& part : path)
    if (part == "..")
      throw Error(fmt::format("it names {}, which is outside the model's own folder", quoted(reference)));

  // A symbolic link must not lead out of the folder either.
  std::error_code error;
  const auto home = std::filesystem::weakly_canonical(folder.empty() ? "." : folder, error);
  const auto target = error ? home : std::filesystem::weakly_canonical(home / path, error);
  if (error) throw Error(fmt::format("it names {}, which is not a path: {}", quoted(reference), error.message()));
  const auto relative = target.lexically_relative(home);
  if (relative.empty() || *relative.begin() == "..")
    throw Error(fmt::format("it names {}, a link that leads out of the model's own folder", quoted(reference)));
  return folder / path;
}

std::string percent_decode(const std::string& text) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool escape = text[i] == '%' && i + 2 < text.size();
    const int high = escape ? hex_digit(text[i + 1]) : -1, low = escape ? hex_digit(text[i + 2]) : -1;
    if (high >= 0 && low >= 0) {
      decoded += char(high * 16 + low);
      i += 2;
    } else {
      decoded += text[i];
    }
  }
  return decoded;
}

std::string decode_base64(std::string_view text) {
  while (!text.empty() && text.back() == '=') text.remove_suffix(1);
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  unsigned bits = 0;
  int count = 0;  // of bits that do not fill a byte yet
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    int value = -1;
    if (c >= 'A' && c <= 'Z')
      value = c - 'A';
    else if (c >= 'a' && c <= 'z')
      value = c - 'a' + 26;
    else if (c >= '0' && c <= '9')
      value = c - '0' + 52;
    else if (c == '+')
      value = 62;
    else if (c == '/')
      value = 63;
    else
      throw Error(fmt::format("broken base64 data: {} after {} characters (allowed: A-Z, a-z, 0-9, +, /, = at the end)",
                              c == '\n' || c == '\r'
                                  ? "a line break"
                                  : fmt::format("a byte of value {}", int(static_cast<unsigned char>(c))),
                              i));
    bits = bits << 6 | unsigned(value);
    count += 6;
    if (count >= 8) {
      count -= 8;
      bytes += char(bits >> count & 0xff);
    }
  }
  return bytes;
}

std::optional<std::string> decode_data_uri(const std::string& uri) {
  if (!uri.starts_with("data:")) return {};
  const std::size_t comma = uri.find(',');
  if (comma == std::string::npos || !std::string_view(uri).substr(0, comma).ends_with(";base64"))
    throw Error("a data URI without ';base64,'");
  return decode_base64(std::string_view(uri).substr(comma + 1));
}

std::optional<Image> read_model_picture(const std::filesystem::path& folder, const std::string& reference,
                                        Encoding encoding, Notes& notes) {
  std::filesystem::path path;
  try {
    path = resolve_reference(folder, reference);
  } catch (const Error& error) {
    notes.add(fmt::format("a picture is left out: {}", error.what()));
    return {};
  }
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) {
    notes.add(fmt::format("a picture is left out: there is no file {}", quoted(path.string())));
    return {};
  }
  return read_image(path, encoding);
}

int add_limited_texture(Scene& scene, Texture texture) {
  std::size_t texels = texture.pixels.pixels().size();
  for (const Texture& other : scene.textures) texels += other.pixels.pixels().size();
  if (texels > max_import_texels)
    throw Error(
        fmt::format("texture '{}': more than {} texels in all pictures together", texture.name, max_import_texels));
  scene.textures.push_back(std::move(texture));
  return int(scene.textures.size()) - 1;
}

}  // namespace atelier::scene_import
