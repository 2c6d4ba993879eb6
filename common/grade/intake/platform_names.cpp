#include "grade/intake/platform_names.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <string_view>
#include <vector>

#include "base/file.hpp"
#include "base/trimmed.hpp"
#include "grade/intake/listed_names.hpp"

namespace atelier::grade {
namespace {

bool is_number(std::string_view text) {
  constexpr std::size_t most_digits = 18;  // fits 64 bits
  return !text.empty() && text.size() <= most_digits &&
         std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

std::uint64_t value_of(std::string_view digits) {
  std::uint64_t value = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return value;
}

/// Takes the text in front of the next '_' off `rest`; all of it if there is none.
std::string_view take_word(std::string_view& rest) {
  const auto end = std::min(rest.find('_'), rest.size());
  const std::string_view word = rest.substr(0, end);
  rest.remove_prefix(std::min(end + 1, rest.size()));
  return word;
}

/// A value of YAML on one line, without its quotes.
std::string yaml_value(std::string_view text) {
  text = trimmed(text);
  const bool quoted = text.size() >= 2 && text.front() == text.back() && (text.front() == '"' || text.front() == '\'');
  if (!quoted) return std::string(text);
  const char quote = text.front();
  std::string value;
  for (text = text.substr(1, text.size() - 2); !text.empty(); text.remove_prefix(1)) {
    if (quote == '\'' && text.starts_with("''")) text.remove_prefix(1);
    if (quote == '"' && text.size() > 1 && text.front() == '\\') text.remove_prefix(1);
    value += text.front();
  }
  return value;
}

/// "2024-03-05 22:14:22.123 Z", or with "+01:00", in seconds since 1970.
std::optional<std::int64_t> seconds_of(std::string_view text) {
  const auto number = [&](std::size_t at, std::size_t digits) -> int {
    return at + digits <= text.size() && is_number(text.substr(at, digits)) ? int(value_of(text.substr(at, digits)))
                                                                            : -1;
  };
  const int year = number(0, 4), month = number(5, 2), day = number(8, 2);
  const int hour = number(11, 2), minute = number(14, 2), second = number(17, 2);
  if (year < 0 || month < 0 || day < 0 || hour < 0 || minute < 0 || second < 0) return std::nullopt;
  const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(unsigned(month)),
                                         std::chrono::day(unsigned(day))};
  if (!date.ok() || hour > 23 || minute > 59 || second > 60) return std::nullopt;
  std::int64_t offset = 0;
  if (const auto sign = text.find_first_of("+-", 19); sign != text.npos) {
    const int hours = number(sign + 1, 2), minutes = std::max(number(sign + 4, 2), number(sign + 3, 2));
    if (hours < 0) return std::nullopt;
    offset = (text[sign] == '-' ? -1 : 1) * (hours * 3600 + std::max(minutes, 0) * 60);
  }
  const auto days = std::chrono::sys_days(date).time_since_epoch().count();
  return std::int64_t(days) * 86400 + hour * 3600 + minute * 60 + second - offset;
}

}  // namespace

std::optional<PlatformName> moodle_name(const std::string& entry) {
  constexpr std::string_view mark = "_assignsubmission_";
  const auto at = entry.find(mark);
  if (at == entry.npos) return std::nullopt;
  const auto before = entry.rfind('_', at - 1);
  if (at == 0 || before == entry.npos || !is_number(std::string_view(entry).substr(before + 1, at - before - 1)))
    return std::nullopt;
  PlatformName found;
  found.name = entry.substr(0, before);
  found.identifier = entry.substr(before + 1, at - before - 1);
  std::string_view rest = std::string_view(entry).substr(at + mark.size());
  found.is_text = take_word(rest) == "onlinetext";
  found.file = rest;
  return found;
}

std::optional<PlatformName> canvas_name(const std::string& entry) {
  std::string_view rest = entry;
  PlatformName found;
  found.name = take_word(rest);
  std::string_view word = take_word(rest);
  if (lower_case(std::string(word)) == "late") {
    found.late = true;
    word = take_word(rest);
  }
  const std::string_view file_number = take_word(rest);
  if (found.name.empty() || !is_number(word) || !is_number(file_number) || rest.empty()) return std::nullopt;
  found.identifier = word;
  found.order = value_of(file_number);
  found.file = rest;
  return found;
}

std::optional<PlatformName> gradescope_name(const std::string& entry) {
  constexpr std::string_view begin = "submission_";
  if (!entry.starts_with(begin) || !is_number(std::string_view(entry).substr(begin.size()))) return std::nullopt;
  PlatformName found;
  found.identifier = entry.substr(begin.size());
  return found;
}

std::string uploaded_name(const std::string& entry) {
  const auto moodle = moodle_name(entry);
  if (moodle && !moodle->file.empty()) return moodle->file;
  const auto canvas = canvas_name(entry);
  return canvas ? canvas->file : entry;
}

std::vector<std::string> names_for_sentences(const std::vector<std::string>& entries) {
  std::vector<std::string> names;
  for (const std::string& entry : entries) {
    const auto moodle = moodle_name(entry);
    names.push_back(moodle && moodle->file.empty() && !moodle->name.empty() ? moodle->name : uploaded_name(entry));
  }
  std::vector<std::string> sorted = names;
  std::ranges::sort(sorted);
  return std::ranges::adjacent_find(sorted) == sorted.end() ? names : entries;
}

std::map<std::string, GradescopeSubmission> read_gradescope_metadata(const std::filesystem::path& file) {
  constexpr std::size_t most_bytes = 64 << 20;
  const std::string text = read_file(file, most_bytes);
  std::map<std::string, GradescopeSubmission> found;
  GradescopeSubmission* current = nullptr;
  bool in_submitters = false;  // members of earlier submissions, in :history:, are indented further
  for (std::string_view rest = text; !rest.empty();) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    const auto value = [&](std::string_view key) -> std::optional<std::string> {
      return line.starts_with(key) ? std::optional(yaml_value(line.substr(key.size()))) : std::nullopt;
    };
    if (line.starts_with("submission_")) {
      const std::string name(line.substr(0, line.find(':')));
      current = gradescope_name(name) ? &found[name] : nullptr;
      in_submitters = false;
    } else if (!current) {
      continue;
    } else if (line.starts_with("  :")) {
      in_submitters = line.starts_with("  :submitters:");
      if (const auto created = value("  :created_at:")) current->created = seconds_of(*created);
    } else if (in_submitters) {
      auto name = value("  - :name:"), number = value("    :sid:"), address = value("    :email:");
      auto& submitters = current->submitters;
      if (line.starts_with("  - ") || submitters.empty()) submitters.emplace_back();
      if (name) submitters.back().name = *name;
      if (number && !number->empty()) submitters.back().identifier = *number;
      if (address && submitters.back().identifier.empty()) submitters.back().identifier = *address;
    }
  }
  return found;
}

}  // namespace atelier::grade
