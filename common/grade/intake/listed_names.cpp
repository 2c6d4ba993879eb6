#include "grade/intake/listed_names.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "grade/intake/version_names.hpp"

namespace atelier::grade {

std::string lower_case(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return c < 0x80 ? char(std::tolower(c)) : char(c); });
  return text;
}

ListedNames::ListedNames(const judge::StepFlags& flags) {
  for (const auto& [step, files] : flags.files)
    for (const std::string& file : files) {
      steps_[file].insert(step);
      by_lower_.emplace(lower_case(file), file);
    }
}

std::string ListedNames::find(const std::string& name) const {
  if (steps_.contains(name)) return name;
  const auto known = [&](const std::string& candidate) {
    const auto found = by_lower_.find(lower_case(candidate));
    return found == by_lower_.end() ? std::string() : found->second;
  };
  if (std::string found = known(name); !found.empty()) return found;
  const std::filesystem::path path = name;
  const std::string stem = path.stem().string(), ending = path.extension().string();
  if (std::string found = known(without_copy_number(stem) + ending); !found.empty()) return found;
  if (lower_case(ending) != ".txt") return {};
  if (std::string found = known(without_copy_number(stem)); !found.empty()) return found;
  return stem.size() < name.size() ? find(stem) : std::string();
}

const std::set<std::string>& ListedNames::steps_with(const std::string& listed) const {
  static const std::set<std::string> none;
  const auto found = steps_.find(listed);
  return found == steps_.end() ? none : found->second;
}

}  // namespace atelier::grade
