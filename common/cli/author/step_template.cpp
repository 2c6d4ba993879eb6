#include "cli/author/step_template.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <set>
#include <vector>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/near_names.hpp"
#include "base/process.hpp"
#include "base/replace_together.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_name = 32, longest_title = 60;

/// Names that cannot be a namespace or a prefix of functions: keywords of C++ and GLSL, and our own names.
const std::set<std::string> reserved = {
    "and",       "asm",      "atelier",   "auto",      "bool",     "break",    "case",     "catch",   "char",
    "class",     "const",    "continue",  "default",   "delete",   "discard",  "do",       "double",  "else",
    "enum",      "explicit", "export",    "extern",    "false",    "float",    "flat",     "for",     "friend",
    "gl",        "glm",      "goto",      "if",        "in",       "inline",   "inout",    "int",     "invariant",
    "layout",    "long",     "main",      "namespace", "new",      "not",      "or",       "out",     "operator",
    "precision", "private",  "protected", "public",    "register", "return",   "shade",    "short",   "signed",
    "sizeof",    "smooth",   "static",    "std",       "struct",   "switch",   "template", "this",    "throw",
    "true",      "try",      "typedef",   "union",     "uniform",  "unsigned", "using",    "varying", "virtual",
    "void",      "volatile", "while",     "xor"};

/// The folders with a subfolder for each step.
const std::vector<std::string> step_folders = {"steps",          "solutions",      "tests/cases",
                                               "tests/mistakes", "tests/variants", "tests/stability"};

/// The entries of a folder that begin with a step's number: "01-transforms".
std::vector<std::string> numbered_in(const fs::path& folder) {
  static const std::regex numbered("[0-9]{2}-.*");
  std::vector<std::string> names;
  std::error_code missing;
  for (const auto& entry : fs::directory_iterator(folder, missing))
    if (const std::string name = entry.path().filename().string(); std::regex_match(name, numbered))
      names.push_back(name);
  std::sort(names.begin(), names.end());
  return names;
}

std::string lowest_free_number(const fs::path& root) {
  std::set<std::string> taken;
  for (const std::string& folder : step_folders)
    for (const std::string& step : numbered_in(root / folder)) taken.insert(step.substr(0, 2));
  for (int number = 3; number < 100; ++number)
    if (const std::string text = fmt::format("{:02}", number); !taken.contains(text)) return text;
  return "none";
}

/// Steps that are not committed yet; none without git.
std::vector<std::string> uncommitted_steps(const fs::path& root) {
  std::vector<std::string> names;
  try {
    const Finished git =
        run_process({.arguments = {"git", "-C", root.string(), "status", "--porcelain", "-uall", "--", "steps"}});
    static const std::regex made(R"((?:^|\n)(?:\?\?|A.) "?steps/([^/\n]+)/given/step\.cmake)");
    if (git.ok())
      for (std::sregex_iterator at(git.output.begin(), git.output.end(), made), end; at != end; ++at)
        names.push_back((*at)[1]);
  } catch (const Error&) {  // no git
  }
  return names;
}

}  // namespace

StepNames names_of_step(const std::string& text, const std::string& title) {
  static const std::regex form("([0-9]{2})-([a-z][a-z0-9]*(?:-[a-z0-9]+)*)");
  std::smatch parts;
  if (!std::regex_match(text, parts, form) || text.size() > longest_name)
    throw Error(fmt::format(
        "new-step '{}': write NN-name: two digits, a dash, small letters and digits with dashes between them, at most "
        "{} in all, as in 13-old-film",
        text, longest_name));
  StepNames names{.step = text, .number = parts[1], .name = parts[2], .type = {}, .title = title};
  if (names.number < "03")
    throw Error(
        fmt::format("new-step '{}': the number must be 03 or more: a new step is built on steps 01 and 02", text));
  if (reserved.contains(names.name))
    throw Error(fmt::format("new-step '{}': '{}' is a reserved name; choose another", text, names.name));
  if (title.empty()) {
    names.title = names.name;
    std::replace(names.title.begin(), names.title.end(), '-', ' ');
    names.title[0] = char(names.title[0] - 'a' + 'A');
  }
  const auto unfit = [](char c) {
    return (c >= 0 && c < ' ') || c == 127 || std::string("\"\\|$;@`<>").find(c) != std::string::npos;
  };
  if (names.title.size() > longest_title || names.title.front() == ' ' ||
      std::any_of(names.title.begin(), names.title.end(), unfit))
    throw Error(fmt::format(
        "new-step: --title '{}': at most {} bytes, no space at its beginning, and none of \" \\ | $ ; @ ` < >",
        names.title, longest_title));
  bool begins = true;
  for (char& c : names.name) {
    if (c != '-') names.type += begins && c >= 'a' ? char(c - 'a' + 'A') : c;
    begins = c == '-';
    if (begins) c = '_';
  }
  return names;
}

std::string filled_in(const std::string& text, const StepNames& names, const std::string& where) {
  const std::map<std::string, std::string> values = {{"@STEP@", names.step},
                                                     {"@NUMBER@", names.number},
                                                     {"@NAME@", names.name},
                                                     {"@TYPE@", names.type},
                                                     {"@TITLE@", names.title}};
  static const std::regex placeholder("@[A-Z]+@");
  std::string out;
  auto rest = text.cbegin();
  for (std::sregex_iterator at(text.begin(), text.end(), placeholder), end; at != end; ++at) {
    const auto found = values.find(at->str());
    if (found == values.end())
      throw Error(fmt::format("{}: {} is not a placeholder; there are @STEP@, @NUMBER@, @NAME@, @TYPE@ and @TITLE@",
                              where, at->str()));
    out.append(rest, (*at)[0].first);
    out += found->second;
    rest = (*at)[0].second;
  }
  return out.append(rest, text.cend());
}

StepFiles files_of_step(const fs::path& folder, const StepNames& names) {
  StepFiles files;
  std::error_code missing;
  for (const auto& entry : fs::recursive_directory_iterator(folder, missing)) {
    if (!entry.is_regular_file()) continue;
    const std::string path = entry.path().lexically_relative(folder).generic_string();
    files[filled_in(path, names, path)] = filled_in(read_file(entry.path()), names, entry.path().string());
  }
  if (files.empty()) throw Error(fmt::format("{}: the templates of a step are missing", folder.string()));
  return files;
}

void refuse_taken(const fs::path& root, const StepNames& names, const StepFiles& files) {
  for (const std::string& folder : step_folders)
    for (const std::string& step : numbered_in(root / folder)) {
      const std::string there = folder + "/" + step;
      if (step.starts_with(names.number + "-"))
        throw Error(fmt::format("new-step {}: {} exists already, so the number {} is in use; the lowest free one is {}",
                                names.step, there, names.number, lowest_free_number(root)));
      if (step.substr(3) == names.step.substr(3))
        throw Error(fmt::format("new-step {}: {} exists already, so the name '{}' is in use; choose another",
                                names.step, there, step.substr(3)));
    }
  for (const auto& [path, text] : files)
    if (fs::exists(root / path))
      throw Error(fmt::format("new-step {}: {} exists already: move it away or choose another name", names.step, path));
  if (const auto begun = uncommitted_steps(root); !begun.empty())
    throw Error(
        fmt::format("new-step {}: {} is not committed; commit it, or remove its files, which 'git status' lists",
                    names.step, join(begun)));
}

void write_step(const fs::path& root, const StepFiles& files) {
  std::vector<fs::path> made;  // folders, outer before inner
  std::vector<Replacement> replacements;
  try {
    for (const auto& [path, text] : files) {
      std::vector<fs::path> missing;
      for (fs::path folder = (root / path).parent_path(); !fs::exists(folder); folder = folder.parent_path())
        missing.push_back(folder);
      for (auto folder = missing.rbegin(); folder != missing.rend(); ++folder)
        if (fs::create_directory(*folder)) made.push_back(*folder);
      replacements.push_back({root / path, [&text = text](const fs::path& beside) { write_file(beside, text); }});
    }
    replace_together(replacements);
  } catch (const std::exception& error) {
    std::error_code ignored;
    for (auto folder = made.rbegin(); folder != made.rend(); ++folder) fs::remove(*folder, ignored);
    throw Error(fmt::format("nothing was written: {}", error.what()));
  }
}

}  // namespace atelier
