#include "cli/student/hints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/columns.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/near_names.hpp"
#include "base/strict_json.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;
using judge::CaseFile;
using judge::JudgedCase;
using strict_json::Json;

std::array<std::string, 2> two_levels(const Json& value, const std::string& where) {
  if (!value.is_array() || value.size() != 2) strict_json::refuse(value, where, "a list of two texts: levels 2 and 3");
  return {strict_json::text(value[0], where + ": level 2"), strict_json::text(value[1], where + ": level 3")};
}

/// Whether the last full check passed the case.
bool passed(const ProgressRecord& record, const std::string& step, const std::string& case_name) {
  const auto found = record.find(step);
  if (found == record.end() || !found->second.check) return false;
  const auto& cases = found->second.check->cases;
  const auto c = cases.find(case_name);
  return c != cases.end() && c->second;
}

const JudgedCase& case_named(const CaseFile& cases, const std::string& name) {
  std::vector<std::string> names;
  for (const JudgedCase& c : cases.cases) {
    if (c.ask.name == name) return c;
    names.push_back(c.ask.name);
  }
  throw Error(fmt::format("{}: there is no case '{}'{}", cases.step, name, suggestion(name, names)));
}

const JudgedCase& case_to_help_with(const CaseFile& cases, const std::string& name, const ProgressRecord& record) {
  if (!name.empty()) return case_named(cases, name);
  const auto found = record.find(cases.step);
  if (found != record.end() && found->second.check)
    for (const JudgedCase& c : cases.cases)
      if (c.ask.name == found->second.check->begin_with) return c;
  for (const JudgedCase& c : cases.cases)
    if (!passed(record, cases.step, c.ask.name)) return c;
  throw Error(fmt::format("{}: the last check passed every case; name the one that you want a hint for", cases.step));
}

/// Whether the function is known to be right: there are cases that name only it, and all have passed.
bool is_proven(const CaseFile& cases, const std::string& function, const ProgressRecord& record) {
  bool any = false;
  for (const JudgedCase& c : cases.cases) {
    if (c.functions != std::vector{function}) continue;
    if (!passed(record, cases.step, c.ask.name)) return false;
    any = true;
  }
  return any;
}

/// The function that is wrong by the last verdict, if that began with this case; else those that are not proven.
std::vector<std::string> functions_in_doubt(const CaseFile& cases, const JudgedCase& c, const ProgressRecord& record) {
  if (const auto found = record.find(cases.step); found != record.end() && found->second.check) {
    const CheckRecord& check = *found->second.check;
    if (check.begin_with == c.ask.name && std::ranges::count(c.functions, check.wrong_function) > 0)
      return {check.wrong_function};
  }
  std::vector<std::string> functions;
  for (const std::string& function : c.functions)
    if (!is_proven(cases, function, record)) functions.push_back(function);
  return functions.empty() ? c.functions : functions;
}

Hint hint_for(const ProjectFolders& folders, const CourseStep& step, const CaseFile& cases, const JudgedCase& c,
              const ProgressRecord& record, int level) {
  Hint hint{.step = cases.step, .case_name = c.ask.name, .case_title = c.title, .functions = {}, .texts = {}};
  hint.levels = c.functions.empty() ? 1 : most_hints;
  hint.level = std::clamp(level, 1, hint.levels);
  if (hint.level == 1) {
    hint.texts = {c.hint.empty() ? c.asked : c.hint};
    const std::vector<std::string> functions = functions_in_doubt(cases, c, record);
    if (functions.size() <= most_contracts)
      for (const std::string& function : functions)
        if (auto contract = contract_of(folders, step, function)) hint.contracts.push_back(std::move(*contract));
    return hint;
  }
  const FunctionHints hints = read_hints(folders.hints_file(cases.step), cases);
  hint.functions = functions_in_doubt(cases, c, record);
  for (const std::string& function : hint.functions)
    hint.texts.push_back(hints.at(function)[std::size_t(hint.level - 2)]);
  return hint;
}

}  // namespace

FunctionHints read_hints(const fs::path& file, const CaseFile& cases) {
  const std::string where = file.string();
  const Json document = strict_json::parse(read_file(file, 1 << 20), where);
  strict_json::refuse_unknown(document, {"schema", "step", "functions"}, where);
  strict_json::integer(strict_json::required(document, "schema", where), where + ": schema", 1, 1);
  strict_json::one_of(strict_json::required(document, "step", where), where + ": step", {cases.step});
  const Json& functions = strict_json::required(document, "functions", where);
  const std::set<std::string> known = judge::functions_of(cases.cases);
  strict_json::refuse_unknown(functions, {known.begin(), known.end()}, where + ": functions");

  FunctionHints hints;
  for (const std::string& name : known)
    hints[name] = two_levels(strict_json::required(functions, name.c_str(), where + ": functions"),
                             fmt::format("{}: functions: {}", where, name));
  return hints;
}

Hint hint_at(const ProjectFolders& folders, const CourseStep& step, const std::string& case_name,
             const ProgressRecord& record, int level) {
  const CaseFile cases = judge::read_case_file(folders.case_file(step.name));
  return hint_for(folders, step, cases, case_to_help_with(cases, case_name, record), record, level);
}

Hint next_hint(const ProjectFolders& folders, const CourseStep& step, const std::string& case_name,
               ProgressRecord& record) {
  const CaseFile cases = judge::read_case_file(folders.case_file(step.name));
  const JudgedCase& c = case_to_help_with(cases, case_name, record);
  const int level = hint_level(record, step.name, c.ask.name) + 1;
  const Hint hint = hint_for(folders, step, cases, c, record, level);
  raise_hint_level(record, step.name, c.ask.name, hint.level);
  return hint;
}

std::string hint_text(const Hint& hint, int width) {
  std::string text =
      fmt::format("{}  {}  {}\nhint {} of {}\n", hint.step, hint.case_name, hint.case_title, hint.level, hint.levels);
  for (const Contract& contract : hint.contracts)
    text += fmt::format("\n{}:{}\n{}\n", contract.file.string(), contract.line, indented(contract.text, "  "));
  for (std::size_t i = 0; i < hint.texts.size(); ++i) {
    const bool named = i < hint.functions.size();
    if (named) text += fmt::format("\n  {}\n", hint.functions[i]);
    const int indent = named ? 4 : 2;
    text += std::string(std::size_t(indent), ' ') + wrapped(hint.texts[i], width - indent, indent) + "\n";
  }
  const std::string number = hint.step.substr(0, hint.step.find('-'));
  text += hint.level < hint.levels ? fmt::format("\nThe next one: ./atelier hint {} {}\n", number, hint.case_name)
                                   : "\nThat was the last one.\n";
  return text;
}

}  // namespace atelier
