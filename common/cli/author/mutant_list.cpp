#include "cli/author/mutant_list.hpp"

#include <algorithm>

#include "base/file.hpp"
#include "base/sha256.hpp"
#include "base/shuffle.hpp"
#include "base/strict_json.hpp"
#include "base/trimmed.hpp"
#include "cli/author/mutations.hpp"
#include "cli/code_text.hpp"
#include "cli/student/function_text.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;

/// The whole lines that [begin, end) lies in, without the blanks around them.
std::string lines_around(std::string_view text, std::size_t begin, std::size_t end) {
  const std::size_t first = begin_of_line(text, begin), last = std::min(text.find('\n', end), text.size());
  return std::string(trimmed(text.substr(first, last - first)));
}

/// The lines of each function, from its first to its last.
struct Span {
  std::string function;
  int first = 0, last = 0;
};
std::vector<Span> spans_of(const std::string& text, const std::set<std::string>& functions) {
  std::vector<Span> spans;
  for (const std::string& function : functions)
    if (const auto found = find_function(text, function))
      spans.push_back(
          {function, found->line, found->line + int(std::count(found->text.begin(), found->text.end(), '\n')) - 1});
  return spans;
}

}  // namespace

std::vector<Mutant> mutants_of(const ProjectFolders& folders, const CourseStep& step,
                               const std::set<std::string>& functions, std::uint64_t seed) {
  std::vector<Mutant> mutants;
  for (const std::string& file : step.files) {
    if (file.ends_with(".txt")) continue;
    const std::string text = read_file(folders.solutions() / step.name / file);
    const std::vector<Span> spans = spans_of(text, functions);
    std::map<std::string, int> seen;
    for (const Edit& edit : mutations_of(text)) {
      Mutant mutant{.file = file, .kind = edit.kind, .text = edited(text, {edit})};
      mutant.line = line_number(text, edit.begin);
      mutant.before = lines_around(text, edit.begin, edit.end);
      mutant.after = lines_around(mutant.text, edit.begin, edit.begin + edit.text.size());
      for (const Span& span : spans)
        if (mutant.line >= span.first && mutant.line <= span.last) mutant.function = span.function;
      const std::string what = mutant.function + '\n' + mutant.before + '\n' + mutant.after;
      mutant.id = sha256(file + '\n' + what + '\n' + std::to_string(seen[what]++)).substr(0, 10);
      mutants.push_back(std::move(mutant));
    }
  }
  std::vector<Mutant> shuffled;
  for (const std::size_t i : shuffled_order(mutants.size(), seed)) shuffled.push_back(std::move(mutants[i]));
  return shuffled;
}

std::map<std::string, std::string> read_equivalents(const fs::path& file) {
  std::map<std::string, std::string> reasons;
  if (!fs::exists(file)) return reasons;
  const std::string where = file.string();
  const strict_json::Json list = strict_json::parse(read_file(file), where);
  if (!list.is_array()) strict_json::refuse(list, where, "a list of objects");
  for (const strict_json::Json& entry : list) {
    strict_json::refuse_unknown(entry, {"id", "line", "reason"}, where);
    strict_json::text(strict_json::required(entry, "line", where), where + ": line");
    reasons[strict_json::text(strict_json::required(entry, "id", where), where + ": id")] =
        strict_json::text(strict_json::required(entry, "reason", where), where + ": reason");
  }
  return reasons;
}

}  // namespace atelier
