// From a driver's log to source file and line.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <iterator>
#include <sstream>

#include "gl/shader.hpp"

namespace atelier {
namespace {

/// One driver's format of a location: a scanf format that skips the source string's number, reads the line, and stores
/// with %n where the message begins. `severity` is put before the message if the format consumes it.
struct LogForm {
  const char* format;
  const char* severity;
};

constexpr std::array<LogForm, 4> log_forms = {{
    {"%*u:%u(%*u): %n", ""},           // Mesa:           0:12(5): error: `x' undeclared
    {"%*u(%u) : %n", ""},              // NVIDIA:         0(12) : error C1503: undefined variable "x"
    {"ERROR: %*u:%u: %n", "error: "},  // Apple, Intel, AMD, ANGLE:  ERROR: 0:12: 'x' : undeclared identifier
    {"WARNING: %*u:%u: %n", "warning: "},
}};

/// What drivers say of a name that is defined twice.
constexpr const char* words_for_twice[] = {"redeclared", "redefined", "redefinition", "redeclaration", "already"};

/// "file:line" for a line of the assembled text. Beyond its end, where drivers report missing tokens, that of the last
/// line.
std::string author_place(unsigned number, const ShaderSource& source) {
  if (source.lines.empty()) return fmt::format("line {}", number);
  const std::size_t index = std::clamp<std::size_t>(number, 1, source.lines.size()) - 1;
  const auto [file, line] = source.lines[index];
  return fmt::format("{}:{}", file < 0 ? "(defines)" : source.names[std::size_t(file)], line);
}

/// The name that a message calls defined twice; empty if it does not.
std::string name_defined_twice(const std::string& message) {
  const bool twice = std::any_of(std::begin(words_for_twice), std::end(words_for_twice),
                                 [&](const char* word) { return message.find(word) != message.npos; });
  const std::size_t open = message.find_first_of("`'\"");
  if (!twice || open == message.npos) return {};
  return message.substr(open + 1, message.find_first_of("'\"", open + 1) - open - 1);
}

bool in_a_name(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

bool contains_word(const std::string& line, const std::string& word) {
  for (std::size_t at = line.find(word); at != line.npos; at = line.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || !in_a_name(line[at - 1])) && (end == line.size() || !in_a_name(line[end]))) return true;
  }
  return false;
}

/// Where else a name stands outside of all braces, before line `number`; empty if nowhere.
std::string other_definition(const std::string& name, unsigned number, const ShaderSource& source) {
  std::istringstream text(source.text);
  int depth = 0;
  unsigned line_number = 0;
  for (std::string line; std::getline(text, line) && ++line_number < number;) {
    if (depth == 0 && !line.starts_with("//") && contains_word(line, name)) return author_place(line_number, source);
    depth += int(std::count(line.begin(), line.end(), '{') - std::count(line.begin(), line.end(), '}'));
  }
  return {};
}

/// " (also defined in FILE:LINE ...)" for a message about a name that is defined twice: the files of several steps, and
/// given ones, are parts of one shader.
std::string clash_words(const std::string& message, unsigned number, const ShaderSource& source) {
  const std::string name = name_defined_twice(message);
  const bool plain = !name.empty() && std::all_of(name.begin(), name.end(), in_a_name);
  const std::string other = plain ? other_definition(name, number, source) : "";
  return other.empty() ? "" : fmt::format(" (also in {}: both are parts of one shader, so rename yours)", other);
}

std::string translate_line(const std::string& line, const ShaderSource& source) {
  for (const LogForm& form : log_forms) {
    unsigned number = 0;
    int message = 0;  // stays 0 if the line does not match the whole format
    std::sscanf(line.c_str(), form.format, &number, &message);
    if (message == 0) continue;
    const std::string words = line.substr(std::size_t(message));
    return fmt::format("{}: {}{}{}", author_place(number, source), form.severity, words,
                       clash_words(words, number, source));
  }
  return line;
}

}  // namespace

std::string translate_shader_log(const std::string& log, const ShaderSource& source) {
  constexpr std::size_t most_lines = 30;
  std::vector<std::string> lines;
  std::size_t dropped = 0;
  for (std::size_t begin = 0; begin < log.size();) {
    const std::size_t end = std::min(log.find('\n', begin), log.size());
    std::string line = log.substr(begin, end - begin);
    begin = end + 1;
    line.erase(line.find_last_not_of(std::string_view(" \t\r\0", 4)) + 1);
    if (line.empty()) continue;
    line = translate_line(line, source);
    if (std::find(lines.begin(), lines.end(), line) != lines.end()) continue;
    if (lines.size() == most_lines)
      ++dropped;
    else
      lines.push_back(std::move(line));
  }
  if (dropped > 0) lines.push_back(fmt::format("({} lines more)", dropped));

  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : "\n") + line;
  return text;
}

}  // namespace atelier
