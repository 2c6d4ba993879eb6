#include "judge/run/opened_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <mutex>
#include <set>
#include <sstream>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/printable.hpp"
#include "judge/run/build_record.hpp"
#include "judge/run/includes.hpp"
#include "judge/run/run_tool.hpp"

namespace atelier::judge {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t preprocessed_limit = std::size_t(256) << 20;  ///< bytes; a large file of a student has 4 MB

/// What the preprocessor has opened, and what line markers name, as canonical paths.
struct Preprocessed {
  bool ok = false;
  std::string log;
  std::set<std::string> opened, named;
};

std::string canonical(const fs::path& folder, const std::string& file) {
  std::error_code error;
  const fs::path path = fs::weakly_canonical(folder / file, error);
  return error ? (folder / file).lexically_normal().string() : path.string();
}

/// The file that a line marker names, `# 12 "a.hpp" 1 3`; empty if the line is none, or names no file.
std::string named_by(const std::string& line) {
  if (line.size() < 6 || line[0] != '#' || line[1] != ' ' || !std::isdigit(static_cast<unsigned char>(line[2])))
    return "";
  const std::size_t open = line.find('"');
  if (open == line.npos) return "";
  std::string name;
  for (std::size_t i = open + 1; i < line.size() && line[i] != '"'; ++i) {
    if (line[i] == '\\' && i + 1 < line.size()) ++i;
    name += line[i];
  }
  const bool is_folder = name.ends_with("//");  // the working directory, for debuggers
  return name.starts_with("<") || is_folder ? "" : name;
}

Preprocessed preprocess(const StepFlags& flags, const std::vector<std::string>& options, const fs::path& folder,
                        const std::string& source, const fs::path& objects, const ToolSettings& tools) {
  const fs::path text = objects / (source + ".ii"), dependencies = objects / (source + ".opened");
  std::vector<std::string> command = {flags.compiler};
  command.insert(command.end(), options.begin(), options.end());
  const bool clang = flags.compiler_version.starts_with("Clang") || flags.compiler.find("clang") != std::string::npos;
  // Messages must not show lines of files that may not be opened.
  if (clang)
    command.push_back("-fno-caret-diagnostics");
  else
    command.insert(command.end(), {"-fpch-preprocess", "-fno-diagnostics-show-caret"});
  command.insert(command.end(),
                 {"-E", source, "-o", text.string(), "-MD", "-MF", dependencies.string(), "-MT", "opened"});
  Preprocessed result;
  result.ok = run_tool(command, folder, source, tools, room_of_tools(options, objects), result.log);
  if (!result.ok) return result;
  std::error_code error;
  if (fs::file_size(text, error) > preprocessed_limit || error)
    return {.ok = false,
            .log = fmt::format("{}: grows to more than {} MiB when it is preprocessed\n", source,
                               preprocessed_limit >> 20)};
  for (const std::string& file : read_dependencies(dependencies)) result.opened.insert(canonical(folder, file));
  std::istringstream lines(read_file(text, preprocessed_limit));
  for (std::string line; std::getline(lines, line);)
    if (const std::string name = named_by(line); !name.empty()) result.named.insert(canonical(folder, name));
  fs::remove(text, error);
  return result;
}

/// What may be opened and named besides the source itself.
struct Openable {
  std::set<std::string> files;
  std::string library;  ///< the folder of the standard library's headers, with a slash at its end

  bool contains(const std::string& file) const {
    if (files.contains(file)) return true;
    return !library.empty() && file.starts_with(library) && file.find('/', library.size()) != file.npos;
  }
};

Openable find_openable(const StepFlags& flags, const std::string& step, const std::vector<std::string>& options,
                       const fs::path& objects, const ToolSettings& tools) {
  const std::string source = "all-headers.cpp";
  write_file(objects / source, text_with_all_headers(flags.headers_of(step)));
  const Preprocessed all = preprocess(flags, options, objects, source, objects, tools);
  if (!all.ok) throw Error(fmt::format("{}: the headers that a file may include cannot be read:\n{}", step, all.log));
  Openable openable{.files = all.opened, .library = {}};
  openable.files.insert(all.named.begin(), all.named.end());
  for (const std::string& file : openable.files)
    if (file.ends_with("/vector") && (openable.library.empty() || file.size() < openable.library.size() + 6))
      openable.library = file.substr(0, file.size() - 6);
  return openable;
}

/// Asked of the compiler once, and again when a contract has changed.
const Openable& openable(const StepFlags& flags, const std::string& step, const std::vector<std::string>& options,
                         const fs::path& objects, const ToolSettings& tools) {
  static std::mutex mutex;
  static std::map<std::string, Openable> known;
  std::string key = flags.compiler + '\n' + step;
  for (const std::string& option : options) {
    key += '\n' + option;
    std::error_code error;
    if (option.starts_with("-I"))
      for (const std::string& header : flags.headers_of(step))
        if (const auto time = fs::last_write_time(fs::path(option.substr(2)) / header, error); !error)
          key += fmt::format(" {}", time.time_since_epoch().count());
  }
  const std::lock_guard lock(mutex);
  auto found = known.find(key);
  if (found == known.end()) found = known.emplace(key, find_openable(flags, step, options, objects, tools)).first;
  return found->second;
}

}  // namespace

Opened check_opened_files(const StepFlags& flags, const std::string& step, const std::vector<std::string>& options,
                          const fs::path& sources, const std::string& source, const fs::path& objects,
                          const ToolSettings& tools) {
  const Preprocessed seen = preprocess(flags, options, sources, source, objects, tools);
  if (!seen.ok) return {.allowed = false, .log = seen.log};
  const Openable& may = openable(flags, step, options, objects, tools);
  const std::string itself = canonical(sources, source);
  Opened result{.allowed = true, .log = {}};
  const auto refuse = [&](const std::string& file, const char* does) {
    if (file == itself || may.contains(file)) return;
    result.allowed = false;
    result.log +=
        fmt::format("{}: {} {}, which is not allowed in a step\n", source, does, shorten(printable(file), 200));
  };
  for (const std::string& file : seen.opened) refuse(file, "the compiler opens");
  for (const std::string& file : seen.named)
    if (!seen.opened.contains(file)) refuse(file, "a #line names");
  return result;
}

}  // namespace atelier::judge
