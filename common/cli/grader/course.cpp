// ./atelier course check: reads a course.toml and says what it means.
#include <fmt/format.h>

#include <map>

#include "base/error.hpp"
#include "cli/commands.hpp"
#include "cli/layout.hpp"
#include "grade/course/course_file.hpp"
#include "grade/course/course_words.hpp"

namespace atelier {

int run_course_check(const CourseCheckOptions& options) {
  std::map<std::string, std::string> titles;
  std::vector<std::string> names;
  for (const CourseStep& step : read_course(project_folders().step_flags())) {
    titles[step.name] = step.title;
    names.push_back(step.name);
  }
  if (!std::filesystem::exists(options.file))
    throw Error(fmt::format("course check: there is no file {}; docs/course.toml is one to copy, with every setting",
                            options.file.string()));
  fmt::print("{}", grade::course_in_words(grade::read_course_file(options.file, names), titles));
  return exit_ok;
}

}  // namespace atelier
