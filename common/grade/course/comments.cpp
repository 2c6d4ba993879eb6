#include "grade/course/comments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/csv.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/near_names.hpp"
#include "base/parse_number.hpp"
#include "base/printable.hpp"
#include "base/trimmed.hpp"

namespace atelier::grade {
namespace {

constexpr double most_points_added = 10'000;
const std::vector<std::string> comment_headings = {"id", "points", "comment"};

std::string shown(std::string_view text) {
  return shorten(printable(text), 80);
}

/// Spreadsheets also write other encodings, whose letters would be lost.
void require_utf8(std::string_view text, const std::string& where) {
  int line = 1;
  while (!text.empty()) {
    const CodePoint c = first_code_point(text);
    if (!c.valid) throw Error(fmt::format("{}:{}: is not UTF-8; save the table as \"CSV UTF-8\"", where, line));
    line += c.value == '\n' ? 1 : 0;
    text.remove_prefix(c.bytes);
  }
}

/// The place of each heading among the columns; none: no such column.
class CommentTable {
 public:
  CommentTable(const CsvRow& headings, const std::string& where) : where_(where) {
    for (const std::string& heading : headings.fields) {
      const std::string name(trimmed(heading));
      if (std::find(comment_headings.begin(), comment_headings.end(), name) == comment_headings.end())
        throw Error(fmt::format("{}:{}: unknown heading '{}'{}", where_, headings.line, shown(name),
                                suggestion(name, comment_headings)));
      if (std::find(order_.begin(), order_.end(), name) != order_.end())
        throw Error(fmt::format("{}:{}: heading '{}' appears twice", where_, headings.line, name));
      order_.push_back(name);
    }
    if (std::find(order_.begin(), order_.end(), "id") == order_.end())
      throw Error(
          fmt::format("{}:{}: heading 'id' is missing; known are {}", where_, headings.line, join(comment_headings)));
  }

  std::string_view field(const CsvRow& row, std::string_view heading) const {
    for (std::size_t i = 0; i < row.fields.size(); ++i)
      if (i < order_.size() && order_[i] == heading) return trimmed(row.fields[i]);
    return {};
  }

  Comment comment(const CsvRow& row) const {
    if (row.fields.size() > order_.size())
      throw Error(fmt::format("{}:{}: has {} fields, and there are {} headings; a text with the separator needs quotes",
                              where_, row.line, row.fields.size(), order_.size()));
    Comment comment{.text = printable(lines_joined(field(row, "comment"))), .line = row.line};
    std::string points(field(row, "points"));
    std::replace(points.begin(), points.end(), ',', '.');
    const bool is_number = points.empty() || parse_number(points, comment.points);
    if (!is_number || !(std::abs(comment.points) <= most_points_added))
      throw Error(fmt::format("{}:{}: points: '{}' is not allowed; it takes a number {}..{}, or nothing", where_,
                              row.line, shown(field(row, "points")), -most_points_added, most_points_added));
    return comment;
  }

 private:
  static std::string lines_joined(std::string_view text) {
    std::string line;
    for (const char c : text)
      if (c != '\r') line += c == '\n' || c == '\t' ? ' ' : c;
    return line;
  }

  const std::string& where_;
  std::vector<std::string> order_;
};

}  // namespace

Comments read_comments(const std::filesystem::path& file) {
  Comments comments;
  if (!std::filesystem::exists(file)) return comments;
  const std::string where = printable(file.string());
  const std::string text = read_file(file, 16 << 20);
  require_utf8(text, where);
  const std::vector<CsvRow> rows = parse_csv(text, where);
  if (rows.empty()) return comments;
  const CommentTable table(rows.front(), where);
  for (auto row = rows.begin() + 1; row != rows.end(); ++row) {
    const std::string id(table.field(*row, "id"));
    if (id.empty()) throw Error(fmt::format("{}:{}: id is empty; it takes that of a student", where, row->line));
    if (!comments.emplace(id, table.comment(*row)).second)
      throw Error(fmt::format("{}:{}: id '{}' appears twice, first in line {}", where, row->line, shown(id),
                              comments.at(id).line));
  }
  return comments;
}

void create_comments(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) write_file(file, join(comment_headings, ",") + "\n");
}

std::vector<std::string> misplaced_comments(const Comments& comments, const std::vector<std::string>& ids,
                                            const std::filesystem::path& file) {
  std::vector<std::string> sentences;
  for (const auto& [id, comment] : comments) {
    if (std::find(ids.begin(), ids.end(), id) != ids.end()) continue;
    const std::string near = nearest_name(id, ids);
    sentences.push_back(fmt::format("{}:{}: there is no submission with the id '{}', so this comment stands nowhere{}",
                                    printable(file.string()), comment.line, shown(id),
                                    near.empty() ? "" : "; did you mean '" + near + "'?"));
  }
  return sentences;
}

}  // namespace atelier::grade
