#include "grade/student_comment.hpp"

#include <fmt/format.h>

#include "base/file.hpp"
#include "judge/report/report_html.hpp"
#include "judge/report/report_words.hpp"

namespace atelier::grade {
namespace {

std::string said_of_points(double points) {
  if (points == 0) return "";
  const double size = points < 0 ? -points : points;
  return fmt::format("{} {} {} the total in the gradebook.", judge::points_text(size), size == 1 ? "point" : "points",
                     points < 0 ? "taken off" : "added to");
}

}  // namespace

void set_comment(const std::filesystem::path& file, const std::string& text, double points) {
  if (!std::filesystem::exists(file)) return;
  const std::string added = said_of_points(points), page = read_file(file);
  const std::string changed = judge::with_comment(page, text + (text.empty() || added.empty() ? "" : "\n") + added);
  if (changed != page) write_file(file, changed);
}

}  // namespace atelier::grade
