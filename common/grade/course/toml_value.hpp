// TOML as plain values that know their lines. toml++ is slow to compile, so only toml_value.cpp includes it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace atelier::grade {

struct TomlValue {
  enum class Kind { text, integer, number, boolean, date, list, table };
  Kind kind = Kind::table;
  std::string key;                     ///< of a table's member
  std::string text;                    ///< as in the file, for messages; of a text without its quotes
  double number = 0;                   ///< of an integer or a number; of a boolean 0 or 1
  std::optional<std::int64_t> moment;  ///< of a date with a time and an offset: seconds since 1970, UTC
  std::vector<TomlValue> elements;     ///< of a list or a table, in the order of the file
  int line = 1;                        ///< in which it begins, from 1

  /// The member of a table; nullptr if it has none of that key.
  const TomlValue* find(std::string_view member) const;
};

/// Parses a whole document (TOML 1.0), which is a table. Throws Error "WHERE:LINE: REASON" if it is none.
TomlValue parse_toml(std::string_view text, const std::string& where);

}  // namespace atelier::grade
