// Tables for spreadsheets, after RFC 4180.
#pragma once

#include <string>

namespace atelier {

/// The text as one field: in quotes where it holds what would end one (a comma, a quote, a line's end), quotes doubled.
std::string csv_field(const std::string& text);

}  // namespace atelier
