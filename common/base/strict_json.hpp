// JSON held to a schema: every value is checked as it is taken out, and nothing is silently ignored.
//
// `where` is the place in words that starts every error sentence: "cases.json: case 'sphere': camera: eye".
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

inline constexpr int max_depth = 32;  ///< levels of arrays and objects inside each other

/// Parses a whole document. Throws Error with the line and column where it is not JSON (RFC 8259; no comments), where a
/// member stands twice in one object, or where it is nested deeper than max_depth.
Json parse(std::string_view text, const std::string& where);

/// Throws Error where `object` is no object or has a member that is not among `known`, naming the nearest known one.
void refuse_unknown(const Json& object, const std::vector<std::string>& known, const std::string& where);

/// The member, or an Error saying that it is missing.
const Json& required(const Json& object, const char* name, const std::string& where);
/// The member, or nullptr.
const Json* optional(const Json& object, const char* name);

/// Throws Error "WHERE: VALUE is not allowed; it takes ALLOWED", the value shortened.
[[noreturn]] void refuse(const Json& value, const std::string& where, const std::string& allowed);

/// Each throws Error where the value has another type or lies outside the closed range.
double number(const Json& value, const std::string& where, double low, double high);  ///< finite
int whole(const Json& value, const std::string& where, int low, int high);            ///< 2.0 is no whole number
bool flag(const Json& value, const std::string& where);
std::string text(const Json& value, const std::string& where, std::size_t limit = 1000);  ///< one line, not empty
std::string one_of(const Json& value, const std::string& where, const std::vector<std::string>& choices);

/// A name of [a-z0-9] and the `also` characters, 1..64 long.
std::string name(const Json& value, const std::string& where, std::string_view also = "-");
/// A list of such names, none twice.
std::vector<std::string> names(const Json& value, const std::string& where, std::string_view also = "-");

/// A finite number, or the non-finite ones that JSON cannot write as "nan", "inf", "-inf"; true and false are 1 and 0.
double any_number(const Json& value, const std::string& where);
/// One any_number, or arrays of them inside each other, flattened in order; 1..`limit` of them.
std::vector<double> numbers(const Json& value, const std::string& where, std::size_t limit = 65536);
/// Exactly `count` finite numbers.
std::vector<double> vector(const Json& value, const std::string& where, std::size_t count);

/// What `numbers` reads back: -0 stays negative, the non-finite become their names.
Json from_number(double value);
Json from_numbers(const std::vector<double>& values);

}  // namespace atelier::strict_json
