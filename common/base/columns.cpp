#include "base/columns.hpp"

#include <algorithm>

namespace atelier {

int columns(std::string_view text) {
  return int(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string padded(std::string text, int width) {
  return text + std::string(std::size_t(std::max(0, width - columns(text))), ' ');
}

std::string fitted(std::string_view text, int width) {
  if (columns(text) <= width) return std::string(text);
  std::size_t end = 0;
  for (int taken = 0; end < text.size(); ++end) {
    const bool starts_character = (text[end] & 0xC0) != 0x80;
    if (starts_character && taken++ == width - 3) break;
  }
  return std::string(text.substr(0, end)) + "...";
}

std::string wrapped(std::string_view text, int width, int indent) {
  std::string lines;
  int used = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (used > 0 && used + 1 + columns(word) > width) {
      lines += "\n" + std::string(std::size_t(indent), ' ');
      used = 0;
    } else if (used > 0) {
      lines += ' ', ++used;
    }
    lines += word;
    used += columns(word);
  }
  return lines;
}

std::string indented(std::string_view text, std::string_view indent) {
  std::string lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.append(indent).append(text.substr(0, end)).append("\n");
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

}  // namespace atelier
