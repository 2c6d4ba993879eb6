// The results of a class: gradebook.csv, class.html, class.json and junit.xml in the folder of the results, beside
// students/ID/ with the report of each student.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grade/course/comments.hpp"
#include "grade/course/course_file.hpp"
#include "grade/course/grading_rules.hpp"
#include "grade/results/record.hpp"
#include "judge/compare/mistakes.hpp"
#include "judge/compare/result.hpp"

namespace atelier::grade {

/// A step as the reports of a class name it.
struct StepSummary {
  std::string step, title;
  std::vector<judge::Mistake> mistakes;  ///< known ones, for their titles and sentences; patches are not needed
};

/// What is said of a class beside its records.
struct ClassSummary {
  std::string name;
  std::string platform;              ///< as in ClassFolder
  std::vector<std::string> ignored;  ///< entries of the class's folder that are no submission, and why
  judge::Environment environment;
  double seconds = 0;  ///< of wall-clock time
  std::vector<StepSummary> steps;
};

/// A student with all that stands in a line of the results.
struct ClassRow {
  SubmissionRecord record;
  Grade grade;
  std::string comment;  ///< a person's; empty: none
};

/// The content of all files: made once, written in several forms.
struct ClassResults {
  ClassSummary summary;
  CourseFile course;
  std::vector<std::string> steps;   ///< that count and that any record has, or that the course lists; sorted
  std::vector<ClassRow> rows;       ///< sorted by id
  bool commented = false;           ///< there is a comment or an adjustment
  std::vector<std::string> unsaid;  ///< comments that belong to no submission, a sentence each
  std::filesystem::path folder;     ///< of the results
};

/// Reads folder/comments.csv. Throws as read_comments does, and Error naming an id that two records have.
ClassResults class_results(const std::filesystem::path& folder, const CourseFile& course, const ClassSummary& summary,
                           const std::vector<SubmissionRecord>& records);

/// The folder of a student's report, relative to that of the results: "students/ID".
std::string report_folder(const SubmissionRecord& record);

/// Seconds of work for a submission: without those in which it only waited.
double seconds_of_work(const SubmissionRecord& record);

/// Writes all files together: if one cannot be written, none is replaced. Creates comments.csv if it is absent, and
/// puts comments into the reports of their students (grade/results/student_comment.hpp). Throws as class_results does,
/// and Error naming a file that cannot be written.
void write_class_results(const std::filesystem::path& out, const CourseFile& course, const ClassSummary& summary,
                         const std::vector<SubmissionRecord>& records);

}  // namespace atelier::grade
