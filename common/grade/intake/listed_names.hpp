// Recognises the files that the steps list by their names, also where a program has changed them a little.
#pragma once

#include <map>
#include <set>
#include <string>

#include "judge/run/build.hpp"

namespace atelier::grade {

/// ASCII letters in lower case.
std::string lower_case(std::string text);

class ListedNames {
 public:
  explicit ListedNames(const judge::StepFlags& flags);

  /// The listed name that a file's name stands for: itself, in another case, or with what browsers and course platforms
  /// add to a second copy ("light (1).cpp", "light-1.cpp", "light - Copy.cpp"), or with the ending of a text behind it
  /// ("light.cpp.txt"), as editors add it where the system hides endings. Empty if it stands for none.
  std::string find(const std::string& name) const;

  /// The steps that list a name; empty: none.
  const std::set<std::string>& steps_with(const std::string& listed) const;

  /// Whether the name tells the step: only one lists it.
  bool tells_step(const std::string& listed) const { return steps_with(listed).size() == 1; }

 private:
  std::map<std::string, std::set<std::string>> steps_;  ///< by listed name
  std::map<std::string, std::string> by_lower_;         ///< listed names by their lower case
};

}  // namespace atelier::grade
