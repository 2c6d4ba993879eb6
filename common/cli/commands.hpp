// The subcommands of ./atelier: what each can be told, and the function that does it. One file each.
//
// Every function returns an exit status (base/error.hpp) and throws Error for bad input, before anything was written.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace atelier {

struct ListOptions {
  bool json = false;
};
int run_list(const ListOptions& options);

struct CheckOptions {
  std::string step;
  std::vector<std::string> cases;  ///< only these; empty: all
  std::string context;             ///< "osmesa", "egl", "window", or empty: the first of them that is there
  std::string earlier;             ///< "mine", "solution", or empty: yours where it has passed
  bool live = false;               ///< compare with what the solution draws here, not with the stored references
  std::filesystem::path report;    ///< folder of the report; empty: out/check/NN-name
  std::filesystem::path sources;   ///< where the own NN-name/ folders are; empty: steps/
  bool heatmap = false, json = false, skip_report = false;
};
int run_check(const CheckOptions& options);

struct WatchOptions {
  std::string step;     ///< empty: the first that has not passed
  std::string context;  ///< "osmesa", "egl", "window", or empty: the first of them that is there
  std::string earlier;  ///< as for check
  bool live = false;    ///< as for check
};
int run_watch(const WatchOptions& options);

struct RunOptions {
  std::string step;
  std::vector<std::string> arguments;  ///< for the step's program
  std::string earlier;
};
int run_run(const RunOptions& options);

struct HintOptions {
  std::string step, case_name;  ///< without a case: the first that the last check did not pass
  std::optional<int> level;     ///< 1..3: shown without being counted
};
int run_hint(const HintOptions& options);

struct ProgressOptions {
  bool json = false;
};
int run_progress(const ProgressOptions& options);

struct NextOptions {};
int run_next(const NextOptions& options);

struct ResetOptions {
  std::string file;    ///< as for find_student_file
  bool force = false;  ///< without asking
};
int run_reset(const ResetOptions& options);

struct CompareOptions {
  std::string step, function;  ///< without a function: all that have passed
  bool spoil = false;          ///< those that have not passed, too
};
int run_compare(const CompareOptions& options);

struct DoctorOptions {
  bool json = false;
  std::string found;    ///< what the launcher has found out (cli/student/doctor.hpp: parse_findings)
  std::string install;  ///< the system's command for installing packages; empty: unknown
  std::string context;  ///< only make this context and tell of it: how doctor tries one in a program of its own
};
int run_doctor(const DoctorOptions& options);

struct SubmitOptions {
  std::string step;
  std::filesystem::path out;  ///< the ZIP; empty: out/submit/NN-name.zip
};
int run_submit(const SubmitOptions& options);

struct GradeOptions {
  std::filesystem::path submission;  ///< a folder with NN-name/ folders, or a ZIP of one
  std::filesystem::path out;         ///< empty: out/grade/NAME
  std::vector<std::string> steps;    ///< asked for even where they are absent; empty: those that are there
  int workers = 2;
  std::string context;
  std::optional<std::uint64_t> shuffle;
  bool json = false;
};
int run_grade(const GradeOptions& options);

struct ReleaseOptions {
  std::vector<std::string> steps;  ///< or "all"
  std::filesystem::path out;       ///< a folder that is not there or empty, or a path that ends in .zip
  std::string earlier = "none";    ///< or "source", "library"
};
int run_release(const ReleaseOptions& options);

struct NewStepOptions {
  std::string step;   ///< "13-old-film"
  std::string title;  ///< empty: made of the name
};
int run_new_step(const NewStepOptions& options);

struct TablesOptions {
  bool check = false;
};
int run_tables(const TablesOptions& options);

struct MistakeOptions {
  std::string step, name;
  bool begin = false;          ///< make the copy that is to be edited
  bool spelling = false;       ///< of a mistake that there is: the same in other words
  bool variant = false;        ///< no mistake, another right answer
  std::filesystem::path from;  ///< the edited copy; empty: out/mistake/NN-name
  std::string rebase;          ///< renew all patches, made for the solution of this revision of git
};
int run_mistake(const MistakeOptions& options);

struct MutateOptions {
  std::vector<std::string> steps;
  std::uint64_t seed = 1;
  int count = 150;          ///< of mutants that build, or of variants, a step
  bool preserving = false;  ///< other forms of the same meaning, which must keep all points
  bool last_bits = false;   ///< earlier steps' results moved by a unit in the last place: all points must stay
  bool json = false;
};
int run_mutate(const MutateOptions& options);

struct AuditOptions {
  std::vector<std::string> steps;
  std::filesystem::path out;  ///< where the JSON goes beside; empty: nowhere
  bool json = false;
};
int run_audit(const AuditOptions& options);

struct ReferenceOptions {
  std::vector<std::string> steps, cases;
  bool check = false, json = false;
};
int run_reference(const ReferenceOptions& options);

struct SkeletonOptions {
  std::vector<std::string> steps;
  bool check = false, force = false;
};
int run_skeleton(const SkeletonOptions& options);

struct BenchOptions {
  std::string step = "02";
  int repeats = 5;
  bool baseline = false;  ///< only the frames beside those of a baseline
  bool json = false;
};
int run_bench(const BenchOptions& options);

struct MeasureOptions {
  std::string step;
  std::string setting;        ///< only the sweeps of this one; empty: everything
  std::string context;        ///< "osmesa", "egl", "window", or empty: the first of them that is there
  std::filesystem::path out;  ///< empty: out/measure/NN-name
  int frames = 15;            ///< that each picture is timed with
  bool mine = false;          ///< the student's own files, although there is a solution
  bool handout = false;       ///< write the plots of the handout instead
  bool check = false;         ///< with `handout`: write nothing, fail where a number has changed
  bool json = false;
};
int run_measure(const MeasureOptions& options);

struct StabilityOptions {
  std::string step;           ///< or "common"; empty: all tables
  std::filesystem::path out;  ///< folder of the plots and of all rows as CSV; empty: out/stability
  bool all = false;           ///< print every row, and not only the worst
  bool json = false;
};
int run_stability(const StabilityOptions& options);

struct TestOptions {
  enum class Tier { quick, usual, all } tier = Tier::usual;
  std::string step;  ///< all that must hold of this one alone; empty: the tier
};
int run_test(const TestOptions& options);

}  // namespace atelier
