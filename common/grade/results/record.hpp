// What grading one submission of a class has given: the lines of gradebook and class report are made of these.
//
// A record is a file, students/ID/record.json in the folder of the results, that is written last and whole: a
// submission with a record is graded, one without is not.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "judge/compare/result.hpp"

namespace atelier::grade {

/// Who handed something in. All texts are printable UTF-8.
struct Student {
  std::string id;          ///< unique in the class; a file name of [a-z0-9.-]: the folder of the results
  std::string name;        ///< as the course platform writes it; empty: unknown
  std::string identifier;  ///< the platform's number or login; empty: unknown
};

/// The points of a step's cases of one tier.
struct TierPoints {
  double score = 0, max_score = 0;
  bool operator==(const TierPoints&) const = default;
};

struct StepRecord {
  enum class State {
    judged,
    not_built,      ///< does not compile, or files are missing or unusable
    not_handed_in,  ///< nothing, or not the step's folder
    untouched,      ///< all files are as in the skeleton
  };
  std::string step;
  State state = State::judged;
  double score = 0, max_score = 0;          ///< points of the cases, before course.toml
  std::map<std::string, TierPoints> tiers;  ///< the same by tier: "core", "further", "challenge"; empty: all are core
  int passed = 0, cases = 0;                ///< cases with points
  std::map<std::string, int> mistakes;      ///< recognised mistakes, each with the number of its cases
};

struct SubmissionRecord {
  Student student;
  std::string source;                     ///< relative path of the folder or archive in the class's folder, printable
  std::optional<std::int64_t> handed_in;  ///< seconds since 1970, UTC; none: the platform's names do not say
  bool late = false;                      ///< as the platform marks it; course.toml's deadlines decide where they are
  std::vector<StepRecord> steps;
  std::vector<std::string> needs_human;   ///< why a person must look at it, a sentence each; empty: nobody must
  std::vector<std::string> notes;         ///< what was taken, ignored or converted
  std::string sandbox;                    ///< the tier in which it ran: "full", "account", "none"
  std::string key;                        ///< identifies files, cases, solution and settings: nothing is graded twice
  std::uint64_t seed = 0;                 ///< of the drawn numbers
  std::map<std::string, double> seconds;  ///< "compile", "start", "render", "compare", "report", "wait"
};

/// The record's part for a judged step. Of a step in another state the mistakes are left out.
StepRecord record_of(const judge::StepResult& step, StepRecord::State state);

std::string to_string(StepRecord::State state);  ///< "judged", "not_built", "not_handed_in", "untouched"

/// JSON with schema 1. read_record throws Error naming the file and the member.
std::string to_json_text(const SubmissionRecord& record);
SubmissionRecord read_record(const std::filesystem::path& file);

}  // namespace atelier::grade
