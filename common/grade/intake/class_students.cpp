#include "grade/intake/class_students.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/error.hpp"
#include "base/near_names.hpp"
#include "base/printable.hpp"
#include "grade/intake/archive.hpp"
#include "grade/intake/listed_names.hpp"
#include "grade/intake/student_id.hpp"
#include "grade/intake/version_names.hpp"

namespace atelier::grade {
namespace {

std::string shown_label(const std::string& name) {
  return shorten(printable(name), 100);
}

/// A class's pattern, which the instructor has written. Names are at most 255 bytes long.
std::optional<std::regex> compile(const std::string& pattern) {
  if (pattern.empty()) return std::nullopt;
  try {
    std::regex compiled(pattern, std::regex::ECMAScript);
    if (compiled.mark_count() < 1 || compiled.mark_count() > 2)
      throw Error(
          fmt::format("the pattern '{}' must have one group, the name, or two, name and identifier, such as "
                      "'(.+)_([0-9]+)'",
                      shown_label(pattern)));
    return compiled;
  } catch (const std::regex_error& error) {
    throw Error(fmt::format("the pattern '{}' is no regular expression: {}", shown_label(pattern), error.what()));
  }
}

/// Whether an entry whose name tells no student could be somebody's work, also in a folder named as a compiler's.
bool could_be_work(const ClassItem& item) {
  const ClassEntry& entry = item.entry;
  if (is_name_of_course(item.name)) return false;
  if (is_name_of_given(item.name)) return entry.has_step_files;
  return entry.may_be_handed_in() || entry.has_source || item.name.find("_assignsubmission_") != std::string::npos;
}

/// What all clones' names begin with, up to a '-': "homework-".
std::string common_prefix(const std::vector<ClassItem>& items) {
  std::optional<std::string> prefix;
  for (const ClassItem& item : items) {
    if (!item.entry.is_folder) continue;
    if (!prefix) prefix = item.name;
    const auto end = std::ranges::mismatch(*prefix, item.name).in1;
    prefix->erase(end, prefix->end());
  }
  const auto dash = prefix ? prefix->find_last_of('-') : std::string::npos;
  return dash == std::string::npos ? "" : prefix->substr(0, dash + 1);
}

}  // namespace

ClassStudents::ClassStudents(const ClassNaming& naming)
    : pattern_(compile(naming.pattern)), pattern_text_(naming.pattern) {}

bool ClassStudents::matches_pattern(const std::string& name) const {
  return std::regex_match(name, *pattern_);
}

void ClassStudents::add(const ClassItems& items) {
  const std::string prefix = items.platform == Platform::github ? common_prefix(items.items) : "";
  std::map<std::string, int> bases;  // how many entries are one student's if versions are left out of their names
  for (const ClassItem& item : items.items) ++bases[split_version(item.name).base];
  for (const ClassItem& item : items.items) {
    if (pattern_)
      add_by_pattern(item);
    else if (items.platform == Platform::moodle)
      add_moodle(item);
    else if (items.platform == Platform::canvas)
      add_canvas(item);
    else if (items.platform == Platform::gradescope)
      add_gradescope(item, items);
    else if (items.platform == Platform::github)
      add_github(item, prefix);
    else
      add_folder(item, items, bases);
  }
}

std::vector<HandedIn> ClassStudents::hand_in(std::vector<std::string>& ignored) {
  add_texts();
  hand_in_unnamed();
  doubt_cases();
  std::vector<HandedIn> submissions;
  std::set<std::string> ids;
  for (auto& [key, gathered] : students_) {
    submissions.push_back(hand_in_one(gathered));
    Student& student = submissions.back().student;
    student.id = new_student_id(student.name, student.identifier, ids);
  }
  std::ranges::sort(submissions, {}, [](const HandedIn& handed) { return handed.student.id; });
  ignored.insert(ignored.end(), ignored_.begin(), ignored_.end());
  return submissions;
}

void ClassStudents::ignore(const ClassItem& item, const std::string& why) {
  ignored_.push_back(fmt::format("{} {}", shown_label(item.relative), why));
}

void ClassStudents::add_unnamed(const ClassItem& item, const std::string& why) {
  if (could_be_work(item))
    unnamed_.emplace_back(item, why);
  else
    ignore(item, why);
}

/// Where no entry names a student, the naming is wrong, and nothing is handed in.
void ClassStudents::hand_in_unnamed() {
  const bool any_named = !students_.empty();
  for (const auto& [item, why] : unnamed_)
    if (any_named)
      gather("unnamed/" + item.relative, without_archive_endings(item.name), "", item)
          .needs_human.push_back(fmt::format("'{}' {}; whose is it?", shown_label(item.relative), why));
    else
      ignore(item, why);
}

ClassStudents::Gathered& ClassStudents::gather(const std::string& key, const std::string& name,
                                               const std::string& identifier, const ClassItem& item,
                                               std::uint64_t order) {
  Gathered& gathered = students_[key];
  gathered.student.name = shown_label(name);
  gathered.student.identifier = shown_label(identifier);
  gathered.items.emplace_back(order, item);
  return gathered;
}

void ClassStudents::add_by_pattern(const ClassItem& item) {
  std::smatch match;
  if (!std::regex_match(item.name, match, *pattern_))
    return add_unnamed(item, fmt::format("does not match the pattern '{}'", shown_label(pattern_text_)));
  const std::string name = match[1].str(), identifier = match.size() > 2 ? match[2].str() : "";
  gather("pattern/" + name + "/" + identifier, name, identifier, item);
}

void ClassStudents::add_moodle(const ClassItem& item) {
  const auto found = moodle_name(item.name);
  if (!found) return add_unnamed(item, "is not named as Moodle names folders, NAME_NUMBER_assignsubmission_file_");
  const std::string key = "moodle/" + found->name + "/" + found->identifier;
  if (!found->is_text) {
    gather(key, found->name, found->identifier, item);
  } else {
    ignore(item, "was typed into Moodle's page and is no file");
    texts_.emplace(key, std::pair(*found, item));
  }
}

void ClassStudents::add_canvas(const ClassItem& item) {
  const auto found = canvas_name(item.name);
  if (!found) return add_unnamed(item, "is not named as Canvas names files, NAME_NUMBER_NUMBER_FILE");
  Gathered& gathered = gather("canvas/" + found->identifier, found->name, found->identifier, item, found->order);
  gathered.late |= found->late;
}

void ClassStudents::add_gradescope(const ClassItem& item, const ClassItems& all) {
  const auto found = gradescope_name(item.name);
  if (!found && item.name == gradescope_metadata) return;
  if (!found) return add_unnamed(item, "is not named as Gradescope names folders, submission_NUMBER");
  const auto known = all.metadata.find(item.name);
  const GradescopeSubmission about = known == all.metadata.end() ? GradescopeSubmission{} : known->second;
  std::vector<GradescopeSubmitter> submitters = about.submitters;
  if (submitters.empty()) submitters.emplace_back();
  std::vector<std::string> group;
  for (std::size_t i = 0; i < submitters.size(); ++i) {
    const auto& [name, identifier] = submitters[i];
    group.push_back(name.empty() ? fmt::format("student {}", i + 1) : shown_label(name));
  }
  for (std::size_t i = 0; i < submitters.size(); ++i) {
    const auto& [name, identifier] = submitters[i];
    const bool unknown = identifier.empty() && submitters.size() == 1;
    Gathered& gathered = gather(fmt::format("gradescope/{}/{}", found->identifier, i), name,
                                unknown ? found->identifier : identifier, item);
    gathered.handed_in = about.created;
    if (name.empty()) gathered.notes.push_back(fmt::format("{} does not name the student", gradescope_metadata));
    if (submitters.size() > 1)
      gathered.notes.push_back(fmt::format("{} is of a group: {}", shown_label(item.relative), join(group)));
  }
}

void ClassStudents::add_github(const ClassItem& item, const std::string& prefix) {
  if (!item.entry.is_folder && !has_archive_name(item.name)) return add_unnamed(item, "is no clone");
  const std::string name = without_archive_endings(item.name);
  const std::string login = name.starts_with(prefix) && name != prefix ? name.substr(prefix.size()) : name;
  gather("github/" + login, "", login, item);
}

void ClassStudents::add_folder(const ClassItem& item, const ClassItems& all, const std::map<std::string, int>& bases) {
  if (!item.entry.is_folder && !has_archive_name(item.name))
    return add_unnamed(item, "is neither a folder nor an archive");
  if (is_name_of_given(item.name)) return add_unnamed(item, "is named as a folder of the course or a compiler");
  if (item.entry.is_folder && !item.entry.may_be_handed_in() && is_name_of_work(item.name))
    return add_unnamed(item, "has none of the steps' files");
  const std::string whole = without_archive_endings(item.name), base = split_version(item.name).base;
  const std::string name = !base.empty() && bases.at(base) > 1 ? base : whole;
  Gathered& gathered = gather("folders/" + all.group + "/" + name, name, "", item);
  if (all.group.empty()) return;
  const std::string where = fmt::format("is one of several in the folder '{}'", shown_label(all.group));
  if (all.items.size() > 2)
    gathered.notes.push_back(where);
  else
    gathered.needs_human.push_back(where + ", which may be one student's");
}

/// Texts of students who have handed in nothing else are for a person.
void ClassStudents::add_texts() {
  for (const auto& [key, text] : texts_) {
    if (students_.contains(key)) continue;
    gather(key, text.first.name, text.first.identifier, text.second)
        .needs_human.push_back("handed in a text on Moodle's page and no file");
  }
}

/// Students whose names differ only by case may be one.
void ClassStudents::doubt_cases() {
  std::map<std::string, std::vector<Gathered*>> by_lower;
  for (auto& [key, gathered] : students_)
    if (gathered.student.identifier.empty()) by_lower[lower_case(gathered.student.name)].push_back(&gathered);
  for (const auto& [name, same] : by_lower)
    for (Gathered* gathered : same)
      for (const Gathered* other : same)
        if (gathered != other && gathered->student.name != other->student.name)
          gathered->needs_human.push_back(
              fmt::format("may be of the same student as '{}', a name that differs only by case", other->student.name));
}

HandedIn ClassStudents::hand_in_one(Gathered& gathered) {
  auto& items = gathered.items;
  std::ranges::stable_sort(items, [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first : is_older(a.second.name, b.second.name);
  });
  HandedIn handed{.student = gathered.student,
                  .sources = {},
                  .source = shown_label(items.back().second.relative),
                  .handed_in = gathered.handed_in,
                  .late = gathered.late,
                  .notes = gathered.notes,
                  .needs_human = gathered.needs_human};
  std::vector<std::string> names;
  for (const auto& [order, item] : items) names.push_back(item.name);
  names = names_for_sentences(names);
  bool ordered = true, archives_or_folders = true;
  for (const auto& [order, item] : items) {
    handed.sources.push_back(item.path);
    ordered &= order > 0;
    archives_or_folders &= item.entry.is_folder || has_archive_name(item.name);
  }
  for (std::string& name : names) name = "'" + shown_label(name) + "'";
  if (items.size() > 1 && archives_or_folders) {
    const std::string several =
        fmt::format("handed in {}; of a step in several, the one in {} counts", join(names), names.back());
    if (ordered)
      handed.notes.push_back(several + ", the newest");
    else
      handed.needs_human.push_back(several + ", the newest by its name");
  }
  return handed;
}

}  // namespace atelier::grade
