#include "grade/intake/version_names.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <optional>
#include <set>
#include <string_view>

#include "grade/intake/archive.hpp"
#include "grade/intake/listed_names.hpp"

namespace atelier::grade {
namespace {

constexpr std::string_view separators = " -_.";

bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

bool all_digits(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, is_digit);
}

/// The number of at most eight digits.
long long number_of(std::string_view digits) {
  long long number = 0;
  for (const char c : digits.substr(0, 8)) number = 10 * number + (c - '0');
  return number;
}

/// Of the newest and the oldest; above and below all numbers.
constexpr long long last_order = 1'000'000'000, first_order = -1;

/// Whether eight digits are a day from 1990 to 2099.
bool is_date(std::string_view digits) {
  if (digits.size() != 8 || !all_digits(digits)) return false;
  const long long date = number_of(digits), month = date / 100 % 100, day = date % 100;
  return date >= 19900101 && date < 21000000 && month >= 1 && month <= 12 && day >= 1 && day <= 31;
}

/// The order of a word that is a version; nothing for any other.
std::optional<long long> order_of(std::string_view word) {
  static const std::set<std::string_view> old = {"old", "older", "backup", "bak",     "orig",
                                                 "alt", "first", "draft",  "previous"};
  static const std::set<std::string_view> copies = {"copy", "kopie", "copie", "copia"};
  static const std::set<std::string_view> latest = {"new", "newer", "newest", "final",  "latest",    "last",
                                                    "neu", "fixed", "fix",    "update", "corrected", "resubmission"};
  if (old.contains(word)) return first_order;
  if (copies.contains(word)) return 1;
  if (latest.contains(word)) return last_order;
  for (const std::string_view letters : {"version", "ver", "rev", "v"})
    if (word.starts_with(letters) && all_digits(word.substr(letters.size())))
      return number_of(word.substr(letters.size()));
  if (word.size() > 2 && word.front() == '(' && word.back() == ')' && all_digits(word.substr(1, word.size() - 2)))
    return number_of(word.substr(1, word.size() - 2));
  if (is_date(word)) return number_of(word);
  return std::nullopt;
}

/// The date at the end of a text, as 2024-03-05 or 2024_03_05.
std::optional<long long> date_at_end(std::string_view text) {
  constexpr std::size_t length = 10;
  if (text.size() < length) return std::nullopt;
  const std::string_view date = text.substr(text.size() - length);
  if (separators.find(date[4]) == separators.npos || separators.find(date[7]) == separators.npos) return std::nullopt;
  const std::string digits =
      std::string(date.substr(0, 4)) + std::string(date.substr(5, 2)) + std::string(date.substr(8, 2));
  return is_date(digits) ? std::optional(number_of(digits)) : std::nullopt;
}

std::string_view without_separators_at_end(std::string_view text) {
  const auto last = text.find_last_not_of(separators);
  return last == text.npos ? std::string_view() : text.substr(0, last + 1);
}

/// Compares texts with their numbers by value.
bool sorts_before(std::string_view a, std::string_view b) {
  while (!a.empty() && !b.empty()) {
    if (is_digit(a[0]) && is_digit(b[0])) {
      const auto digits = [](std::string_view text) {
        const auto end = std::ranges::find_if_not(text, is_digit);
        return text.substr(0, std::size_t(end - text.begin()));
      };
      const auto value = [](std::string_view text) {
        return text.substr(std::min(text.find_first_not_of('0'), text.size()));
      };
      const std::string_view first = digits(a), second = digits(b);
      const std::string_view x = value(first), y = value(second);
      if (x.size() != y.size()) return x.size() < y.size();
      if (x != y) return x < y;
      a.remove_prefix(first.size()), b.remove_prefix(second.size());
    } else if (a[0] != b[0]) {
      return a[0] < b[0];
    } else {
      a.remove_prefix(1), b.remove_prefix(1);
    }
  }
  return a.empty() && !b.empty();
}

/// The name in lower case, without number and separators at the end: "hw" for "HW_02".
std::string word_of(const std::string& name) {
  std::string word = lower_case(name);
  while (!word.empty() && (is_digit(word.back()) || separators.find(word.back()) != separators.npos)) word.pop_back();
  return word;
}

}  // namespace

VersionedName split_version(const std::string& name) {
  const std::string whole = without_archive_endings(std::filesystem::path(name).filename().string());
  const std::string lower = lower_case(whole);
  VersionedName split;
  std::string_view rest = without_separators_at_end(lower);
  while (!rest.empty()) {
    std::optional<long long> order = date_at_end(rest);
    std::string_view before;
    if (order) {
      before = rest.substr(0, rest.size() - 10);
    } else {
      const auto at = rest.ends_with(')') ? rest.rfind('(') : rest.find_last_of(separators);
      const bool bracket = rest.ends_with(')') && at != rest.npos;
      const std::size_t begin = at == rest.npos ? 0 : bracket ? at : at + 1;
      order = order_of(rest.substr(begin));
      before = rest.substr(0, begin);
    }
    if (!order) break;
    split.order = split.versioned ? std::max(split.order, *order) : *order;
    split.versioned = true;
    rest = without_separators_at_end(before);
  }
  split.base = whole.substr(0, rest.size());
  return split;
}

bool is_older(const std::string& a, const std::string& b) {
  const VersionedName first = split_version(a), second = split_version(b);
  if (first.order != second.order) return first.order < second.order;
  return sorts_before(lower_case(a), lower_case(b)) || (lower_case(a) == lower_case(b) && a < b);
}

std::string without_copy_number(const std::string& stem) {
  const VersionedName split = split_version(stem);
  if (split.versioned) return split.base;
  const auto at = stem.find_last_of("-_ ");
  return at != stem.npos && at > 0 && stem.size() - at <= 4 && all_digits(std::string_view(stem).substr(at + 1))
             ? stem.substr(0, at)
             : stem;
}

bool is_name_of_work(const std::string& name) {
  static const std::set<std::string> words = {
      "hw",      "homework", "assignment", "exercise", "exercises", "task",   "lab",         "week",       "part",
      "step",    "steps",    "project",    "abgabe",   "aufgabe",   "uebung", "submission",  "src",        "source",
      "sources", "code",     "shader",     "shaders",  "include",   "lib",    "libs",        "doc",        "docs",
      "notes",   "note",     "report",     "readme",   "image",     "images", "img",         "picture",    "pictures",
      "media",   "assets",   "textures",   "models",   "misc",      "other",  "screenshots", "screenshot", "data",
      "results", "work",     "solution",   "vs",       "bin"};
  constexpr std::size_t digits_of_students = 4;  // a number with as many is a student's
  const VersionedName split = split_version(name);
  if (split.base.size() >= digits_of_students && all_digits(split.base)) return false;
  const std::string word = word_of(split.base);
  return word.empty() || words.contains(word) || is_name_of_given(split.base);
}

bool is_name_of_given(const std::string& name) {
  static const std::set<std::string> words = {"build",
                                              "out",
                                              "debug",
                                              "release",
                                              "x64",
                                              "x86",
                                              "obj",
                                              "cmakefiles",
                                              "ipch",
                                              "cmake-build-debug",
                                              "cmake-build-release",
                                              "node_modules"};
  return words.contains(lower_case(name)) || is_name_of_course(name);
}

bool is_name_of_course(const std::string& name) {
  static const std::set<std::string> words = {"cmake",     "tests",     "test",  "handouts",
                                              "skeletons", "solutions", "given", "common"};
  return words.contains(lower_case(name));
}

}  // namespace atelier::grade
