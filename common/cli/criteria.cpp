#include "cli/criteria.hpp"

namespace atelier {

grade::Criteria criteria_of(const ProjectFolders& folders, const CourseStep& step) {
  return {.title = step.title,
          .cases = folders.case_file(step.name),
          .mistakes = folders.mistakes_file(step.name),
          .reference_cache = folders.reference_cache()};
}

}  // namespace atelier
