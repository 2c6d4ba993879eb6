#include "judge/run/build.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <future>
#include <system_error>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/folder_lock.hpp"
#include "base/near_names.hpp"
#include "base/printable.hpp"
#include "base/strict_json.hpp"
#include "judge/run/build_record.hpp"
#include "judge/run/choices_file.hpp"
#include "judge/run/includes.hpp"
#include "judge/run/opened_files.hpp"
#include "judge/run/run_tool.hpp"

namespace atelier::judge {
namespace {

namespace fs = std::filesystem;
using strict_json::Json;

/// A list of texts, each at most 4096 bytes.
std::vector<std::string> texts(const Json& value, const std::string& where) {
  if (!value.is_array()) strict_json::refuse(value, where, "a list of texts");
  std::vector<std::string> list;
  for (const Json& item : value) list.push_back(strict_json::text(item, where, 4096));
  return list;
}

std::map<std::string, std::vector<std::string>> texts_by_step(const Json& value, const std::string& where) {
  if (!value.is_object()) strict_json::refuse(value, where, "an object with a list of texts for every step");
  std::map<std::string, std::vector<std::string>> lists;
  for (const auto& [step, list] : value.items()) lists[step] = texts(list, where + ": " + step);
  return lists;
}

std::map<std::string, std::string> titles_by_step(const Json& value, const std::string& where) {
  if (!value.is_object()) strict_json::refuse(value, where, "an object with a text for every step");
  std::map<std::string, std::string> titles;
  for (const auto& [step, title] : value.items()) titles[step] = strict_json::text(title, where + ": " + step);
  return titles;
}

const std::vector<std::string>& files_of(const StepFlags& flags, const std::string& step) {
  const auto found = flags.files.find(step);
  if (found != flags.files.end()) return found->second;
  std::vector<std::string> known;
  for (const auto& [name, files] : flags.files) known.push_back(name);
  throw Error(fmt::format("there is no step '{}'{}", step, suggestion(step, known)));
}

UnusableFiles missing_files(const StepFlags& flags, const std::string& step, const fs::path& sources) {
  UnusableFiles missing;
  for (const std::string& name : files_of(flags, step))
    if (const std::string why = why_unusable(sources / name); !why.empty() && !(why == is_missing && may_miss(name)))
      missing[name] = why;
  return missing;
}

/// Error messages, one per line, for includes that are not allowed.
std::string check_includes(const StepFlags& flags, const std::string& step, const fs::path& sources) {
  std::string log;
  for (const std::string& name : files_of(flags, step))
    if (name.ends_with(".cpp"))
      log += refused_includes(read_file(sources / name, source_limit), name, step, flags.headers_of(step));
  return log;
}

/// Otherwise an older library would be used.
void remove_older(const fs::path& library) {
  std::error_code ignored;
  fs::remove(library, ignored);
}

void append(std::vector<std::string>& list, const std::vector<std::string>& more) {
  list.insert(list.end(), more.begin(), more.end());
}

/// The result of one command.
struct Outcome {
  bool ok = false, fresh = false;
  std::string log;
};

/// The compile options, and the folder of the step's contract for #include "blinn_phong.hpp": a student's file is in
/// the same folder as its contract, but a submission or a patched solution is not.
std::vector<std::string> compile_options(const StepFlags& flags, const std::string& step) {
  std::vector<std::string> options = flags.compile;
  for (const std::string& option : flags.compile)
    if (option.starts_with("-I") && fs::is_directory(fs::path(option.substr(2)) / step))
      append(options, {"-iquote", option.substr(2) + "/" + step});
  return options;
}

/// The headers in -include options and their precompiled forms, which the compiler's dependency list leaves out.
std::vector<std::string> included_by_options(const StepFlags& flags) {
  std::vector<std::string> headers;
  for (std::size_t i = 1; i < flags.compile.size(); ++i)
    if (flags.compile[i - 1] == "-include")
      for (const std::string& header : {flags.compile[i], flags.compile[i] + ".gch"})
        if (fs::exists(header)) headers.push_back(header);
  return headers;
}

/// Compiles one .cpp file to one object.
Outcome compile(const StepFlags& flags, const std::string& step, const fs::path& sources, const std::string& source,
                const fs::path& objects, const ToolSettings& tools) {
  const fs::path dependencies = objects / (source + ".d");
  const std::vector<std::string> options = compile_options(flags, step);
  Recipe recipe{.command = {flags.compiler}, .folder = sources, .product = objects / (source + ".o")};
  append(recipe.command, options);
  append(recipe.command, {"-c", source, "-o", recipe.product.string(), "-MMD", "-MF", dependencies.string()});
  if (const auto log = recorded_log(recipe)) return {.ok = true, .fresh = false, .log = *log};

  require_space(objects, working_space);
  forget_record(recipe);
  const Inputs before = fingerprints({source}, sources);
  const auto begin = fs::file_time_type::clock::now();
  Outcome outcome{.ok = false, .fresh = true, .log = {}};
  const Opened opened = check_opened_files(flags, step, options, sources, source, objects, tools);
  if (!opened.allowed) {
    outcome.log = opened.log;
    return outcome;
  }
  outcome.ok = run_tool(recipe.command, sources, source, tools, room_of_tools(options, objects), outcome.log);
  if (!outcome.ok) return outcome;

  // If an input was edited while the compiler ran, write no record, so that the next build compiles again.
  std::vector<std::string> read = included_by_options(flags);
  append(read, read_dependencies(dependencies));
  const Inputs inputs = fingerprints(read, sources);
  const bool steady = std::all_of(inputs.begin(), inputs.end(), [&](const auto& input) {
    if (input.first == source) return input == before.front();
    std::error_code error;
    return fs::last_write_time(sources / input.first, error) < begin && !error;
  });
  if (steady) write_record(recipe, inputs, outcome.log);
  return outcome;
}

/// Compiles all .cpp files, two at a time: the smallest machines have two cores.
std::vector<Outcome> compile_all(const StepFlags& flags, const std::string& step, const fs::path& sources,
                                 const std::vector<std::string>& names, const fs::path& objects,
                                 const ToolSettings& tools) {
  std::vector<Outcome> done(names.size());
  const auto every_second = [&](std::size_t first) {
    for (std::size_t i = first; i < names.size(); i += 2)
      done[i] = compile(flags, step, sources, names[i], objects, tools);
  };
  std::future<void> other;
  if (names.size() > 1) other = std::async(std::launch::async, every_second, 1);
  every_second(0);
  if (other.valid()) other.get();
  return done;
}

/// Links to a temporary file and renames it, so that a running program keeps the old library.
Outcome link(const StepFlags& flags, const std::vector<std::string>& names, const fs::path& objects,
             const fs::path& library, const ToolSettings& tools) {
  Recipe recipe{.command = {flags.compiler}, .folder = objects, .product = library};
  std::vector<std::string> inputs;
  for (const std::string& name : names) inputs.push_back(name + ".o");
  append(recipe.command, inputs);
  append(recipe.command, flags.link);
  if (const auto log = recorded_log(recipe)) return {.ok = true, .fresh = false, .log = *log};

  forget_record(recipe);
  const fs::path partial = objects / fmt::format("{}.{}", library.filename().string(), ::getpid());
  std::vector<std::string> command = recipe.command;
  append(command, {"-o", partial.string()});
  Outcome outcome{.ok = false, .fresh = true, .log = {}};
  outcome.ok = run_tool(command, objects, "linking", tools, room_of_tools({}, objects), outcome.log);
  if (!outcome.ok) return outcome;
  std::error_code error;
  fs::rename(partial, library, error);
  if (error) throw Error(fmt::format("{}: cannot be written: {}", library.string(), error.message()));
  write_record(recipe, fingerprints(inputs, objects), outcome.log);
  return outcome;
}

std::string bounded(const std::string& log) {
  constexpr std::string_view cut = "\n(the rest is left out)\n";
  return log.size() <= log_limit ? log : shorten(log, log_limit - cut.size()) + std::string(cut);
}

}  // namespace

const std::vector<std::string>& StepFlags::headers_of(const std::string& step) const {
  static const std::vector<std::string> none;
  const auto found = headers.find(step);
  return found == headers.end() ? none : found->second;
}

StepFlags read_step_flags(const fs::path& file) {
  const std::string where = file.string();
  const Json json = strict_json::parse(read_file(file, 1 << 20), where);
  strict_json::refuse_unknown(
      json, {"compiler", "compiler_version", "compile", "link", "files", "headers", "uses", "titles"}, where);
  StepFlags flags;
  flags.compiler = strict_json::text(strict_json::required(json, "compiler", where), where + ": compiler", 4096);
  flags.compiler_version =
      strict_json::text(strict_json::required(json, "compiler_version", where), where + ": compiler_version");
  flags.compile = texts(strict_json::required(json, "compile", where), where + ": compile");
  flags.link = texts(strict_json::required(json, "link", where), where + ": link");
  flags.files = texts_by_step(strict_json::required(json, "files", where), where + ": files");
  flags.headers = texts_by_step(strict_json::required(json, "headers", where), where + ": headers");
  flags.uses = texts_by_step(strict_json::required(json, "uses", where), where + ": uses");
  flags.titles = titles_by_step(strict_json::required(json, "titles", where), where + ": titles");
  for (const auto& [step, names] : flags.files)
    for (const std::string& name : names)
      if (fs::path(name).filename() != name || name.front() == '.' || name.front() == '-')
        throw Error(fmt::format("{}: files: {}: '{}' must be a file name without a folder", where, step, name));
  return flags;
}

bool may_miss(const std::string& file) {
  return file == choices_file;
}

Built not_built(const UnusableFiles& files) {
  Built built;
  built.log = in_words(files) + ": all files of the step are needed.\n";
  built.unusable = files;
  return built;
}

Built build_step(const StepFlags& flags, const std::string& step, const fs::path& sources, const fs::path& out,
                 const ToolSettings& tools) {
  const fs::path folder = fs::absolute(out) / step, objects = folder / "objects", library = folder / "libstep.so";
  std::error_code error;
  fs::create_directories(objects, error);
  if (error) throw Error(fmt::format("{}: cannot be created: {}", objects.string(), error.message()));
  if (tools.sandbox) tools.sandbox->give(objects);
  const FolderLock lock(folder);  // `watch` and `check` may build the same step at the same time
  if (const UnusableFiles missing = missing_files(flags, step, sources); !missing.empty()) {
    remove_older(library);
    return not_built(missing);
  }
  Built built;
  built.log = check_includes(flags, step, sources);
  if (built.log.empty()) {
    std::vector<std::string> names;
    for (const std::string& name : files_of(flags, step))
      if (name.ends_with(".cpp")) names.push_back(name);

    std::vector<Outcome> done = compile_all(flags, step, fs::absolute(sources), names, objects, tools);
    const auto succeeded = [](const Outcome& s) { return s.ok; };
    built.ok = std::all_of(done.begin(), done.end(), succeeded);
    if (built.ok && !names.empty()) done.push_back(link(flags, names, objects, library, tools));
    for (const Outcome& s : done) {
      built.ok = built.ok && s.ok;
      built.fresh = built.fresh || s.fresh;
      built.log += s.log;
    }
  }
  built.log = bounded(built.log);
  if (!built.ok) {
    remove_older(library);
    require_space(folder, min_free_space);
    // Compilers write temporary files there.
    if (const fs::path theirs = fs::temp_directory_path(error); !error) require_space(theirs, min_free_space);
  }
  return built;
}

UnusableFiles take_step_files(const StepFlags& flags, const std::string& step, const fs::path& sources,
                              const fs::path& folder) {
  const UnusableFiles missing = missing_files(flags, step, sources);
  for (const std::string& name : files_of(flags, step))
    if (!missing.contains(name) && fs::exists(sources / name))
      write_file(folder / name, read_file(sources / name, source_limit));
  return missing;
}

}  // namespace atelier::judge
