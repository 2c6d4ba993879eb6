// The subcommands of ./atelier: the options of each, and the function that runs it. Each has its own .cpp file.
//
// Every function returns an exit status (base/error.hpp). It throws Error for bad input before it writes anything.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace atelier {

/// The commands that need what no release has: readable solutions, mistakes, tests. A release refuses them.
inline constexpr const char* for_whole_project[] = {"compare", "release",   "new-step",  "mistake", "mutate",
                                                    "tables",  "skeleton",  "reference", "audit",   "vary",
                                                    "bench",   "stability", "test"};

struct ListOptions {
  bool json = false;
};
int run_list(const ListOptions& options);

struct CheckOptions {
  std::string step;
  std::vector<std::string> cases;  ///< only these; empty: all
  std::string context;             ///< "osmesa", "egl", "window", or empty: the first available one
  std::string earlier;             ///< "mine", "solution", or empty: yours for steps that you have passed
  bool live = false;               ///< compare with what the solution draws here, not with the stored references
  std::filesystem::path report;    ///< folder of the report; empty: out/check/NN-name
  std::filesystem::path sources;   ///< the folder with your NN-name/ folders; empty: steps/
  bool table = false, heatmap = false, json = false, skip_report = false;
};
int run_check(const CheckOptions& options);

struct ExplainOptions {
  std::string step, case_name;
  std::string pixel;    ///< "X,Y" from the upper left corner; empty: where the picture differs most, else its middle
  std::string context;  ///< "osmesa", "egl", "window", or empty: the first available one
  std::string earlier;  ///< as for check
  std::filesystem::path sources;  ///< as for check
  bool json = false;
};
int run_explain(const ExplainOptions& options);

struct WatchOptions {
  std::string step;     ///< empty: the first that has not passed
  std::string context;  ///< "osmesa", "egl", "window", or empty: the first available one
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
  std::optional<int> level;     ///< 1..3: show this level without counting it
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
  bool force = false;  ///< do not ask
};
int run_reset(const ResetOptions& options);

struct CompareOptions {
  std::string step, function;  ///< without a function: all that have passed
  bool spoil = false;          ///< also those that have not passed
};
int run_compare(const CompareOptions& options);

struct DoctorOptions {
  bool json = false;
  std::string found;    ///< the launcher's findings (cli/student/doctor.hpp: parse_findings)
  std::string install;  ///< the system's command for installing packages; empty: unknown
  std::string context;  ///< only test this context: doctor does this in a separate process
};
int run_doctor(const DoctorOptions& options);

struct SubmitOptions {
  std::string step;
  std::filesystem::path out;  ///< the ZIP; empty: out/submit/NN-name.zip
};
int run_submit(const SubmitOptions& options);

struct GradeOptions {
  std::vector<std::filesystem::path> submissions;  ///< a submission (a folder with NN-name/ folders, or an archive of
                                                   ///< one), or a class: a folder of submissions, or several
  std::filesystem::path out;                       ///< empty: out/grade/NAME
  std::vector<std::string> steps;                  ///< grade these; empty: those that are present; of a class all
  int workers = 0;  ///< programs that draw at the same time, or of a class processes; 0: two, or one for each core
  std::string context;
  std::string sandbox = "best";                ///< or full, account, none (sandbox/tier.hpp)
  std::optional<std::uint64_t> seed, shuffle;  ///< seed: of the drawn numbers, 0..max_seed; none: by what is handed in
  std::filesystem::path cases;                 ///< folder of further cases, NN-name/cases.json; empty: none
  std::filesystem::path course;                ///< course.toml; empty: none. Only for a class.
  std::string engine = "local";                ///< or slurm. Only for a class.
  std::string engine_arguments;                ///< for sbatch
  bool json = false;
};
int run_grade(const GradeOptions& options);

struct CourseCheckOptions {
  std::filesystem::path file = "course.toml";
};
int run_course_check(const CourseCheckOptions& options);

struct ReleaseOptions {
  std::vector<std::string> steps;   ///< or "all"
  std::filesystem::path out;        ///< a new or empty folder, or a path that ends in .zip
  std::string earlier = "library";  ///< or "none", "source" (cli/grader/release_contents.hpp)
};
int run_release(const ReleaseOptions& options);

struct NewStepOptions {
  std::string step;   ///< "13-old-film"
  std::string title;  ///< empty: made from the name
};
int run_new_step(const NewStepOptions& options);

struct TablesOptions {
  bool check = false;
};
int run_tables(const TablesOptions& options);

struct MistakeOptions {
  std::string step, name;
  bool begin = false;          ///< make the copy to edit
  bool spelling = false;       ///< another spelling of an existing mistake
  bool variant = false;        ///< not a mistake but a variant: another correct solution
  std::filesystem::path from;  ///< the edited copy; empty: out/mistake/NN-name
  std::string rebase;          ///< update all patches; they apply to the solution of this git revision
};
int run_mistake(const MistakeOptions& options);

struct MutateOptions {
  std::vector<std::string> steps;
  std::uint64_t seed = 1;
  int count = 150;                ///< mutants that build, or variants, per step
  bool preserving = false;        ///< make equivalent code instead, which must keep all points
  std::filesystem::path patches;  ///< not empty: instead judge the patches NAME.patch, NAME.*.patch of this folder
  bool last_bits = false;  ///< change earlier steps' results by one unit in the last place; all points must be kept

  bool json = false;
};
int run_mutate(const MutateOptions& options);

struct AuditOptions {
  std::vector<std::string> steps;
  std::filesystem::path out;  ///< also write the JSON to this file; empty: do not
  int sample = 1;             ///< one in this many mistakes and variants is judged; at least 1
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

struct VaryOptions {
  std::vector<std::string> steps;
  std::uint64_t seed = 1;
  int seeds = 5;
  std::filesystem::path pictures;  ///< folder for the solution's pictures; empty: none
  bool json = false;
};
int run_vary(const VaryOptions& options);

struct BenchOptions {
  std::string step = "02";
  int repeats = 5;
  bool baseline = false;  ///< only compare: frames with a baseline's and with one another, work with packages'
  bool json = false;
};
int run_bench(const BenchOptions& options);

struct MeasureOptions {
  std::string step;
  std::string setting;        ///< only the sweeps of this setting; empty: everything
  std::string context;        ///< "osmesa", "egl", "window", or empty: the first available one
  std::filesystem::path out;  ///< empty: out/measure/NN-name
  int frames = 15;            ///< to time each picture with
  bool mine = false;          ///< the student's files, even if there is a solution
  bool handout = false;       ///< write the plots of the handout instead
  bool check = false;         ///< with `handout`: write nothing, fail if a number has changed
  bool json = false;
};
int run_measure(const MeasureOptions& options);

struct StabilityOptions {
  std::string step;           ///< or "common"; empty: all tables
  std::filesystem::path out;  ///< folder of the plots and of all rows as CSV; empty: out/stability
  bool all = false;           ///< print every row, not only the worst
  bool json = false;
};
int run_stability(const StabilityOptions& options);

struct TestOptions {
  enum class Tier { quick, usual, all } tier = Tier::usual;
  std::string step;  ///< only the tests of this step; empty: the tests of the tier
};
int run_test(const TestOptions& options);

}  // namespace atelier
