#include "grade/results/student_comment.hpp"

#include <fmt/format.h>

#include <fstream>

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

/// Whether a report has a comment. Its place is near the beginning, and the pictures after it need not be read.
bool has_comment(const std::filesystem::path& file) {
  std::string beginning(256 << 10, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(beginning.data(), std::streamsize(beginning.size()));
  beginning.resize(std::size_t(stream.gcount()));
  return judge::with_comment(beginning, "") != beginning;
}

}  // namespace

void set_comment(const std::filesystem::path& file, const std::string& text, double points) {
  const std::string added = said_of_points(points), said = text + (text.empty() || added.empty() ? "" : "\n") + added;
  if (!std::filesystem::exists(file) || (said.empty() && !has_comment(file))) return;
  const std::string page = read_file(file), changed = judge::with_comment(page, said);
  if (changed != page) write_file(file, changed);
}

}  // namespace atelier::grade
