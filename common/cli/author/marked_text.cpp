#include "cli/author/marked_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "base/trimmed.hpp"

namespace atelier {
namespace {

constexpr std::string_view open_mark = "// >>> student:";
constexpr std::string_view close_mark = "// <<< student";
constexpr std::string_view skeleton_mark = "// --- skeleton";
constexpr std::string_view skeleton_line = "// |";

/// Whether a line looks like a mark: if it is not an exact mark, it is an author's typing error, which would leave a
/// part of the solution in the skeleton.
bool looks_like_mark(std::string_view line) {
  return line.starts_with("//") && (line.find(">>>") != line.npos || line.find("<<<") != line.npos);
}

class Cutter {
 public:
  enum class Keep { skeleton, solution };

  Cutter(const std::string& file, const std::string& step, Keep keep = Keep::skeleton)
      : file_(file), step_(step), keep_(keep) {}

  void take(std::string_view line) {
    ++number_;
    const std::string_view text = trimmed(line);
    const std::string_view indentation = line.substr(0, line.find_first_not_of(" \t"));
    if (text.starts_with(open_mark))
      open(indentation, trimmed(text.substr(open_mark.size())));
    else if (text == close_mark)
      close();
    else if (text == skeleton_mark && part_ == Part::solution)
      part_ = Part::skeleton;
    else if (looks_like_mark(text) || text == skeleton_mark)
      refuse(fmt::format("'{}' is not a mark here; write '{} TASK', '{}' and '{}', each on its own line", text,
                         open_mark, skeleton_mark, close_mark));
    else if (part_ == Part::skeleton)
      uncomment(indentation, text);
    else
      take_code(line, text);
  }

  std::string finish() {
    if (part_ != Part::common)
      throw Error(fmt::format("{}:{}: this block is not closed by '{}'", file_, opened_, close_mark));
    return std::move(out_);
  }

  int tasks() const { return tasks_; }
  const std::vector<std::string>& left_out() const { return left_out_; }

 private:
  enum class Part { common, solution, skeleton };

  void open(std::string_view indentation, std::string_view task) {
    if (part_ != Part::common) refuse(fmt::format("a block inside the one that line {} opens", opened_));
    if (task.empty()) refuse("the task is missing: describe in one line what to write");
    part_ = Part::solution;
    opened_ = number_;
    ++tasks_;
    if (keep_ == Keep::skeleton) append(fmt::format("{}// TODO({}): {}", indentation, step_, task));
  }

  /// A line without a mark, outside the skeleton's part.
  void take_code(std::string_view line, std::string_view text) {
    if (part_ == Part::solution) left_out_.emplace_back(text);
    if (part_ == Part::common || keep_ == Keep::solution) append(line);
  }

  void close() {
    if (part_ == Part::common) refuse("this closes a block that is not open");
    part_ = Part::common;
  }

  void uncomment(std::string_view indentation, std::string_view text) {
    if (!text.starts_with(skeleton_line))
      refuse(
          fmt::format("between '{}' and '{}' every line starts with '{}'", skeleton_mark, close_mark, skeleton_line));
    std::string_view code = text.substr(skeleton_line.size());
    if (code.starts_with(' ')) code.remove_prefix(1);
    if (keep_ == Keep::skeleton) append(code.empty() ? std::string() : fmt::format("{}{}", indentation, code));
  }

  void append(std::string_view line) {
    out_ += line;
    out_ += '\n';
  }

  [[noreturn]] void refuse(const std::string& what) const {
    throw Error(fmt::format("{}:{}: {}", file_, number_, what));
  }

  const std::string& file_;
  const std::string& step_;
  const Keep keep_;
  std::string out_;
  std::vector<std::string> left_out_;
  Part part_ = Part::common;
  int number_ = 0, opened_ = 0, tasks_ = 0;
};

/// Feeds a text line by line, including a last line without line end.
void feed(Cutter& cutter, std::string_view text) {
  while (!text.empty()) {
    const auto end = text.find('\n');
    cutter.take(text.substr(0, end));
    text.remove_prefix(end == text.npos ? text.size() : end + 1);
  }
}

}  // namespace

std::string cut_skeleton(std::string_view marked, const std::string& file, const std::string& step) {
  Cutter cutter(file, step);
  feed(cutter, marked);
  return cutter.finish();
}

std::string finished_text(std::string_view marked, const std::string& file) {
  const std::string no_step;
  Cutter cutter(file, no_step, Cutter::Keep::solution);
  feed(cutter, marked);
  return cutter.finish();
}

std::vector<std::string> solution_lines(std::string_view marked, const std::string& file) {
  const std::string no_step;
  Cutter cutter(file, no_step);
  feed(cutter, marked);
  cutter.finish();
  return cutter.left_out();
}

std::vector<std::pair<std::size_t, std::size_t>> student_parts(std::string_view marked) {
  std::vector<std::pair<std::size_t, std::size_t>> parts;
  for (std::size_t at = marked.find(open_mark); at != marked.npos; at = marked.find(open_mark, at)) {
    const std::size_t begin = marked.find('\n', at), skeleton = marked.find(skeleton_mark, begin),
                      close = marked.find(close_mark, begin);
    parts.emplace_back(begin, std::min(skeleton, close));
    at = close;
  }
  return parts;
}

int count_tasks(std::string_view marked, const std::string& file) {
  const std::string no_step;
  Cutter cutter(file, no_step);
  feed(cutter, marked);
  cutter.finish();
  return cutter.tasks();
}

}  // namespace atelier
