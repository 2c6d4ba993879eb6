#include "grade/intake/student_id.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "base/printable.hpp"
#include "grade/intake/listed_names.hpp"

namespace atelier::grade {
namespace {

constexpr std::size_t most_bytes = 60;

/// The letters from U+00C0 to U+017F without their accents; '-' for the two signs among them.
constexpr std::array<std::string_view, 0x180 - 0xC0> latin = {
    "a", "a", "a",  "a",  "ae", "a", "ae", "c", "e", "e", "e", "e", "i",  "i", "i",  "i",   // U+00C0
    "d", "n", "o",  "o",  "o",  "o", "oe", "-", "o", "u", "u", "u", "ue", "y", "th", "ss",  // U+00D0
    "a", "a", "a",  "a",  "ae", "a", "ae", "c", "e", "e", "e", "e", "i",  "i", "i",  "i",   // U+00E0
    "d", "n", "o",  "o",  "o",  "o", "oe", "-", "o", "u", "u", "u", "ue", "y", "th", "y",   // U+00F0
    "a", "a", "a",  "a",  "a",  "a", "c",  "c", "c", "c", "c", "c", "c",  "c", "d",  "d",   // U+0100
    "d", "d", "e",  "e",  "e",  "e", "e",  "e", "e", "e", "e", "e", "g",  "g", "g",  "g",   // U+0110
    "g", "g", "g",  "g",  "h",  "h", "h",  "h", "i", "i", "i", "i", "i",  "i", "i",  "i",   // U+0120
    "i", "i", "ij", "ij", "j",  "j", "k",  "k", "k", "l", "l", "l", "l",  "l", "l",  "l",   // U+0130
    "l", "l", "l",  "n",  "n",  "n", "n",  "n", "n", "n", "n", "n", "o",  "o", "o",  "o",   // U+0140
    "o", "o", "oe", "oe", "r",  "r", "r",  "r", "r", "r", "s", "s", "s",  "s", "s",  "s",   // U+0150
    "s", "s", "t",  "t",  "t",  "t", "t",  "t", "u", "u", "u", "u", "u",  "u", "u",  "u",   // U+0160
    "u", "u", "u",  "u",  "w",  "w", "y",  "y", "y", "z", "z", "z", "z",  "z", "z",  "s"};  // U+0170

/// What stands for a character; empty: nothing, '-' for one that only separates.
std::string plain_letters(char32_t c) {
  if (c < 0x80) {
    const char lower = lower_case(std::string(1, char(c)))[0];
    const bool kept = (lower >= 'a' && lower <= 'z') || (lower >= '0' && lower <= '9') || lower == '.';
    return std::string(1, kept ? lower : '-');
  }
  if (c >= 0xC0 && c < 0x180) return std::string(latin[c - 0xC0]);
  if (c >= 0x300 && c < 0x370) return "";  // accents that follow their letters, as Macs write them
  return "-";
}

/// Without '-' and '.' at the ends.
std::string without_marks_at_ends(const std::string& text) {
  const auto begin = text.find_first_not_of("-."), end = text.find_last_not_of("-.");
  return begin == text.npos ? "" : text.substr(begin, end - begin + 1);
}

/// Whether Windows takes a file name, with any ending, for a device.
bool is_reserved(const std::string& name) {
  const std::string stem = name.substr(0, name.find('.'));
  static const std::set<std::string> devices = {"con", "prn", "aux", "nul"};
  const bool numbered =
      stem.size() == 4 && (stem.starts_with("com") || stem.starts_with("lpt")) && stem[3] >= '0' && stem[3] <= '9';
  return devices.contains(stem) || numbered;
}

}  // namespace

std::string file_name_of(const std::string& text) {
  std::string name;
  for (std::string_view rest = text; !rest.empty() && name.size() < most_bytes;) {
    const CodePoint c = first_code_point(rest);
    for (const char letter : plain_letters(c.value)) {
      const bool mark = letter == '-' || letter == '.';
      if (!(mark && !name.empty() && (name.back() == '-' || name.back() == '.'))) name += letter;
    }
    rest.remove_prefix(c.bytes);
  }
  name = without_marks_at_ends(name.substr(0, most_bytes));
  return is_reserved(name) ? "student-" + name : name;
}

std::string new_student_id(const std::string& name, const std::string& identifier, std::set<std::string>& used) {
  constexpr std::size_t most_of_name = 40;  // leaves room for the identifier, which tells students apart
  const std::string first = without_marks_at_ends(file_name_of(name).substr(0, most_of_name));
  const std::string second = file_name_of(identifier);
  std::string id = file_name_of(first.empty() || second.empty() || first == second ? (first.empty() ? second : first)
                                                                                   : first + "-" + second);
  if (id.empty()) id = "student";
  const std::string wanted = id;
  for (int number = 2; !used.insert(id).second; ++number) id = wanted + "-" + std::to_string(number);
  return id;
}

}  // namespace atelier::grade
