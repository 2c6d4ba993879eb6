// Reads JSON strictly: every value is checked when it is read, and nothing is silently ignored.
//
// `where` is the location that every error message begins with: "cases.json: case 'sphere': camera: eye".
// Include in .cpp files only: the JSON library is slow to compile.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace atelier::strict_json {

using Json = nlohmann::json;

inline constexpr int max_depth = 32;  ///< levels of nested arrays and objects

/// Parses a whole document. Throws Error, with line and column, if it is not JSON (RFC 8259; no comments). Also throws
/// Error if a member appears twice in one object or the nesting is deeper than max_depth.
Json parse(std::string_view text, const std::string& where);

/// Throws Error if `object` is not an object or has a member that is not in `known`; suggests the nearest known name.
void refuse_unknown(const Json& object, const std::vector<std::string>& known, const std::string& where);

/// The member. Throws Error if it is missing.
const Json& required(const Json& object, const char* name, const std::string& where);
/// The member, or nullptr.
const Json* optional(const Json& object, const char* name);

/// Throws Error "WHERE: VALUE is not allowed; it takes ALLOWED", the value shortened.
[[noreturn]] void refuse(const Json& value, const std::string& where, const std::string& allowed);

/// Each throws Error if the value has another type or is outside the closed range.
double number(const Json& value, const std::string& where, double low, double high);  ///< finite
int integer(const Json& value, const std::string& where, int low, int high);          ///< 2.0 is refused
bool boolean(const Json& value, const std::string& where);
std::string text(const Json& value, const std::string& where, std::size_t limit = 1000);  ///< one line, not empty
std::string one_of(const Json& value, const std::string& where, const std::vector<std::string>& choices);

/// A name of 1..64 characters: a-z, 0-9 and those in `also`.
std::string name(const Json& value, const std::string& where, std::string_view also = "-");
/// A list of such names without duplicates.
std::vector<std::string> names(const Json& value, const std::string& where, std::string_view also = "-");

/// A number, or one of the texts "nan", "inf" and "-inf", since JSON has no such numbers. true is 1 and false is 0.
double any_number(const Json& value, const std::string& where);
/// One any_number, or nested arrays of them, flattened in order; 1..`limit` numbers.
std::vector<double> numbers(const Json& value, const std::string& where, std::size_t limit = 65536);
/// Exactly `count` finite numbers.
std::vector<double> vector(const Json& value, const std::string& where, std::size_t count);

/// JSON that `numbers` reads back unchanged: -0 keeps its sign, non-finite numbers become texts.

Json from_number(double value);
Json from_numbers(const std::vector<double>& values);

}  // namespace atelier::strict_json
