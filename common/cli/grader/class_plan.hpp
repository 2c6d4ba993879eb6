// What is to be graded of a class, written once for the processes that grade it: DIR/state/plan.cbor.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cli/layout.hpp"
#include "grade/course/course_file.hpp"
#include "grade/intake/class_folder.hpp"

namespace atelier {

/// The folder of a class's results.
struct ClassPlaces {
  std::filesystem::path out;

  std::filesystem::path student(const std::string& id) const { return out / "students" / id; }
  std::filesystem::path record(const std::string& id) const { return student(id) / "record.json"; }
  std::filesystem::path state() const { return out / "state"; }
  std::filesystem::path plan() const { return state() / "plan.cbor"; }
  std::filesystem::path unpacked() const { return state() / "unpacked"; }
  std::filesystem::path temporary() const { return state() / "temporary"; }  ///< names the temporary folder of a run
  /// What the grading process of this number works on: an id. It removes the file when it ends in order.
  std::filesystem::path at_work(int worker) const { return state() / ("worker-" + std::to_string(worker)); }
};

struct ClassPlan {
  std::string name;  ///< of the class
  grade::ClassFolder folder;
  std::vector<std::string> steps;     ///< names, in the order of the course
  std::filesystem::path course_file;  ///< empty: none
  std::filesystem::path cases;        ///< folder of further cases; empty: none
  std::string context, sandbox;       ///< as for `grade`; the tier
  std::optional<std::uint64_t> seed, shuffle;
  std::map<std::string, std::string> criteria;  ///< by step: a hash of all that it is judged with
};

/// The rules of a course.toml; those without one if `file` is empty. Throws as grade::read_course_file does.
grade::CourseFile read_rules(const std::filesystem::path& file, const std::vector<CourseStep>& course);

/// Throws Error if it cannot be written.
void write_plan(const ClassPlaces& places, const ClassPlan& plan);

/// Throws Error naming the file if it is missing or damaged.
ClassPlan read_plan(const ClassPlaces& places);

}  // namespace atelier
