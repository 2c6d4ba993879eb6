// Tables for spreadsheets, after RFC 4180.
#pragma once

#include <string>

namespace atelier {

/// The text as one field: quoted if it contains a comma, a quote or a line break; quotes are doubled.
std::string csv_field(const std::string& text);

}  // namespace atelier
