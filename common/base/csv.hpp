// Tables for spreadsheets, after RFC 4180.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace atelier {

/// The text as one field: quoted if it contains a comma, a quote or a line break; quotes are doubled.
std::string csv_field(const std::string& text);

struct CsvRow {
  int line = 1;  ///< in which it begins, from 1
  std::vector<std::string> fields;
};

/// The rows of a table, without empty lines and a byte order mark; a line ends with \n, \r\n or \r. A first line with a
/// semicolon and no comma: the fields are separated by semicolons, as spreadsheets write them where the comma is in
/// numbers. Throws Error "WHERE:LINE: ..." for a quote that is not closed, and text after one that is.
std::vector<CsvRow> parse_csv(std::string_view text, const std::string& where);

}  // namespace atelier
