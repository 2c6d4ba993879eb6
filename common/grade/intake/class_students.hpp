// Gathers the entries of a class by student, by the names that the course platform has given them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include "grade/intake/class_folder.hpp"
#include "grade/intake/class_shape.hpp"
#include "grade/intake/platform_names.hpp"

namespace atelier::grade {

/// An entry that may be a student's.
struct ClassItem {
  std::filesystem::path path;
  std::string name;      ///< of the entry
  std::string relative;  ///< to the class's folder
  ClassEntry entry;
};

/// Entries that lie in one folder.
struct ClassItems {
  Platform platform = Platform::folders;
  std::vector<ClassItem> items;
  std::string group;  ///< if the folder is one in the class, its relative path; empty: it is the class's
  std::map<std::string, GradescopeSubmission> metadata;  ///< of Gradescope
};

class ClassStudents {
 public:
  /// Throws Error for a pattern that is no regular expression or has not one or two groups.
  explicit ClassStudents(const ClassNaming& naming);

  bool has_pattern() const { return pattern_.has_value(); }
  bool matches_pattern(const std::string& name) const;

  void add(const ClassItems& items);

  /// The submissions sorted by id. Names of entries that are none are appended to `ignored`, each with the reason.
  std::vector<HandedIn> hand_in(std::vector<std::string>& ignored);

 private:
  /// What belongs to one student, before it has an id.
  struct Gathered {
    Student student;
    std::vector<std::pair<std::uint64_t, ClassItem>> items;  ///< with the platform's order
    std::optional<std::int64_t> handed_in;
    bool late = false;
    std::vector<std::string> notes, needs_human;
  };

  Gathered& gather(const std::string& key, const std::string& name, const std::string& identifier,
                   const ClassItem& item, std::uint64_t order = 0);
  void ignore(const ClassItem& item, const std::string& why);
  /// An entry whose name tells no student: one that could be somebody's work is for a person; else it is ignored.
  void add_unnamed(const ClassItem& item, const std::string& why);
  void add_by_pattern(const ClassItem& item);
  void add_moodle(const ClassItem& item);
  void add_canvas(const ClassItem& item);
  void add_gradescope(const ClassItem& item, const ClassItems& all);
  void add_github(const ClassItem& item, const std::string& prefix);
  void add_folder(const ClassItem& item, const ClassItems& all, const std::map<std::string, int>& bases);
  void add_texts();
  void hand_in_unnamed();
  void doubt_cases();
  static HandedIn hand_in_one(Gathered& gathered);

  std::optional<std::regex> pattern_;
  std::string pattern_text_;
  std::map<std::string, std::pair<PlatformName, ClassItem>> texts_;  ///< typed into Moodle's page, by student
  std::map<std::string, Gathered> students_;                         ///< by what the platform tells them apart
  std::vector<std::pair<ClassItem, std::string>> unnamed_;           ///< work whose student is unknown, and why
  std::vector<std::string> ignored_;
};

}  // namespace atelier::grade
