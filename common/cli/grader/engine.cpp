#include "cli/grader/engine.hpp"

#include <fmt/format.h>

#include <system_error>

#include "base/file.hpp"
#include "cli/grader/class_worker.hpp"

namespace atelier {

namespace fs = std::filesystem;

std::vector<const grade::HandedIn*> ungraded(const ClassPlaces& places, const ClassPlan& plan) {
  const fs::file_time_type written = fs::last_write_time(places.plan());
  std::vector<const grade::HandedIn*> left;
  for (const grade::HandedIn& handed_in : plan.folder.submissions)
    if (!is_graded(places, handed_in.student.id, written)) left.push_back(&handed_in);
  return left;
}

std::vector<std::string> worker_command(const ClassPlaces& places, const std::string& index, int of) {
  return {fs::read_symlink("/proc/self/exe").string(),
          "grade-worker",
          places.out.string(),
          "--index",
          index,
          "--of",
          std::to_string(of)};
}

bool WorkerEnds::note(int index, const std::string& why) {
  constexpr int most_ends = 2;
  const fs::path at_work = places_.at_work(index);
  std::error_code none;
  if (!fs::exists(at_work, none)) return false;
  const std::string id = read_file(at_work);
  fs::remove(at_work, none);
  for (const grade::HandedIn* handed_in : ungraded(places_, plan_))
    if (handed_in->student.id == id && ++ends_[id] >= most_ends)
      record_failure(places_, plan_, *handed_in,
                     fmt::format("The grader itself has ended {} times on it: {}", most_ends, why));
  return true;
}

}  // namespace atelier
