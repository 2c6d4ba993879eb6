#include "cli/author/mistake_list.hpp"

#include <fmt/format.h>

#include "base/error.hpp"

namespace atelier {

std::string with_entry(const std::string& text, const std::string& entry, const std::string& file) {
  if (text.empty()) return "[\n" + entry + "\n]\n";
  const std::size_t end = text.find_last_of(']'), last = end == text.npos ? end : text.find_last_of("}", end);
  if (last == text.npos) throw Error(fmt::format("{}: must be a list with at least one entry", file));
  return text.substr(0, last + 1) + ",\n" + entry + "\n]\n";
}

std::string mistake_entry(const std::string& name) {
  return fmt::format(
      "  {{\n"
      "    \"name\": \"{}\",\n"
      "    \"title\": \"{}a few words for tables\",\n"
      "    \"sentence\": \"{}what a student reads: It looks as if ...\",\n"
      "    \"hint\": \"{}a question or a fact that leads on, not the code\",\n"
      "    \"patch\": \"{}.patch\"\n"
      "  }}",
      name, to_be_written, to_be_written, to_be_written, name);
}

std::string variant_entry(const std::string& name) {
  return fmt::format("  {{\"name\": \"{}\", \"title\": \"{}what is done in another way\", \"patch\": \"{}.patch\"}}",
                     name, to_be_written, name);
}

std::string with_spelling(const std::string& text, const std::string& name, const std::string& spelling,
                          const std::string& file) {
  const std::string patch = fmt::format("\"patch\": \"{}.patch\"", name);
  const std::size_t at = text.find(patch);
  if (at == text.npos)
    throw Error(
        fmt::format("{}: there is no mistake with {}; make it first, by ./atelier mistake NN {}", file, patch, name));
  const std::string before = text.substr(0, at + patch.size()), after = text.substr(at + patch.size());
  const std::string list = ",\n    \"spellings\": [";
  if (!after.starts_with(list)) return fmt::format("{}{}\"{}\"]{}", before, list, spelling, after);
  const std::size_t end = after.find(']');
  if (end == after.npos) throw Error(fmt::format("{}: the list of spellings of '{}' does not end", file, name));
  return fmt::format("{}{}, \"{}\"{}", before, after.substr(0, end), spelling, after.substr(end));
}

}  // namespace atelier
