// JSON from an untrusted file: each value is read with its type and range and knows its path, so that an error reads
// "model.gltf: accessors[3].count: -4 (allowed: 1..50000000)".
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace atelier::scene_import {

/// A value inside a document, which must outlive it. All functions throw Error if the value has another type or is out
/// of range.
class JsonField {
 public:
  /// The document itself; `file` names it in messages and must outlive the field.
  JsonField(const nlohmann::json& value, const std::string& file) : value_(&value), file_(&file) {}

  /// A member of an object; none if it is missing.
  std::optional<JsonField> find(const char* key) const;
  /// A required member.
  JsonField at(const char* key) const;
  /// An element of an array, below size().
  JsonField operator[](std::size_t index) const;
  std::size_t size() const;  ///< of an array

  double number() const;                                            ///< finite
  std::int64_t integer(std::int64_t low, std::int64_t high) const;  ///< 3.0 counts as 3
  int index(std::size_t count) const;                               ///< 0 .. count - 1
  const std::string& text() const;
  bool flag() const;
  std::vector<double> numbers(std::size_t count) const;  ///< an array of exactly `count` finite numbers

  // The same for optional members.
  double number_or(const char* key, double fallback) const;
  std::int64_t integer_or(const char* key, std::int64_t low, std::int64_t high, std::int64_t fallback) const;
  bool flag_or(const char* key, bool fallback) const;
  std::string text_or(const char* key, const std::string& fallback) const;
  std::vector<double> numbers_or(const char* key, const std::vector<double>& fallback) const;  ///< as many as fallback
  std::optional<int> index_or_none(const char* key, std::size_t count) const;
  std::size_t size_or_zero(const char* key) const;  ///< of an array

  /// Where it is in the document: "accessors[3].count"; empty for the document itself.
  const std::string& path() const { return path_; }

  /// Throws Error "file: path: complaint".
  [[noreturn]] void fail(const std::string& complaint) const;

 private:
  JsonField(const nlohmann::json& value, const std::string& file, std::string path)
      : value_(&value), file_(&file), path_(std::move(path)) {}

  const nlohmann::json* value_;
  const std::string* file_;
  std::string path_;
};

/// Parses a document. Throws Error naming `file` if it is not JSON, or nested deeper than 64.
nlohmann::json parse_json(std::string_view text, const std::string& file);

}  // namespace atelier::scene_import
