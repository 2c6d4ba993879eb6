// Where the processes that grade a class run.
#pragma once

#include <functional>
#include <string>

#include "cli/grader/class_plan.hpp"

namespace atelier {

struct EngineSettings {
  ClassPlaces places;
  int workers = 2;                    ///< processes that grade at the same time, 1..1000
  std::string arguments;              ///< of the cluster's command, such as "--partition=short"; empty: none
  std::function<bool()> interrupted;  ///< true: stop
  std::function<void()> waiting;      ///< called a few times a second
};

/// Grades until every submission of the plan has a record, on this machine. A submission on which a process ends twice,
/// however it does, gets a record that says so, and the others go on. Throws judge::Interrupted, and Error with a
/// process's own message if it fails before it takes any submission.
void run_local_engine(const EngineSettings& settings, const ClassPlan& plan);

/// The same with a job array of Slurm, whose machines must see the project and the folder of the results under the same
/// paths. What a failed or requeued task leaves is taken by the others, and by a second and a third array.
void run_slurm_engine(const EngineSettings& settings, const ClassPlan& plan);

/// The submissions without a record of this plan.
std::vector<const grade::HandedIn*> ungraded(const ClassPlaces& places, const ClassPlan& plan);

/// The command of one of these processes.
std::vector<std::string> worker_command(const ClassPlaces& places, const std::string& index, int of);

}  // namespace atelier
