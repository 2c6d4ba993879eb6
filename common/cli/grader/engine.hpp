// Where the processes that grade a class run.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "cli/grader/class_plan.hpp"
#include "cli/grader/temporary_place.hpp"

namespace atelier {

struct EngineSettings {
  const ClassPlaces& places;
  const TemporaryPlace& temporary;
  int workers = 2;                    ///< processes that grade at the same time, 1..1000
  std::string arguments;              ///< of the cluster's command, such as "--partition=short"; empty: none
  std::function<bool()> interrupted;  ///< true: stop
  std::function<void()> waiting;      ///< called a few times a second
};

/// Grades until every submission of the plan has a record, on this machine. A submission on which a process ends twice,
/// however it does, gets a record that says so, and the others go on. Throws judge::Interrupted, and Error with a
/// process's own message if it fails before it takes any submission.
void run_local_engine(const EngineSettings& settings, const ClassPlan& plan);

/// The same with job arrays of Slurm, whose machines must see the project and the folder of the results under the same
/// paths. What a failed or requeued task leaves is taken by the others, and by further arrays. Throws Error too if an
/// array can never start, or if two have graded nothing.
void run_slurm_engine(const EngineSettings& settings, const ClassPlan& plan);

/// Throws Error if the commands of Slurm are missing here.
void require_slurm();

/// The submissions without a record of this plan.
std::vector<const grade::HandedIn*> ungraded(const ClassPlaces& places, const ClassPlan& plan);

/// The command of one of these processes.
std::vector<std::string> worker_command(const ClassPlaces& places, const std::string& index, int of);

/// Counts on which submissions processes have ended, and gives those up on which they did so twice.
class WorkerEnds {
 public:
  WorkerEnds(const ClassPlaces& places, const ClassPlan& plan) : places_(places), plan_(plan) {}

  /// Notes that the process of this number has ended before its work was done, and why. Returns whether it was at work
  /// on a submission.
  bool note(int index, const std::string& why);

 private:
  const ClassPlaces& places_;
  const ClassPlan& plan_;
  std::map<std::string, int> ends_;  ///< by id
};

}  // namespace atelier
