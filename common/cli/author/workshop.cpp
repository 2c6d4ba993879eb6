#include "cli/author/workshop.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/sha256.hpp"
#include "cli/author/marked_text.hpp"
#include "cli/author/unwritten.hpp"
#include "judge/compare/mistakes.hpp"
#include "judge/run/ask.hpp"

namespace atelier {

namespace fs = std::filesystem;

Workshop::Workshop(const ProjectFolders& folders, const CourseStep& step)
    : folders_(folders),
      step_(step),
      flags_(judge::read_step_flags(folders.step_flags())),
      earlier_(choose_owners(folders, read_course(folders.step_flags()), step, "solution")),
      root_(folders.build / "audit" / step.name) {}

namespace {

/// A hash of the C++ files of a step.
std::string digest_of_cpp(const fs::path& folder, const CourseStep& step) {
  std::string text;
  for (const std::string& file : step.files)
    if (file.ends_with(".cpp")) text += file + '\0' + sha256(read_file(folder / file)) + '\n';
  return sha256(text).substr(0, 16);
}

bool same_text(const fs::path& a, const fs::path& b) {
  return fs::exists(b) && read_file(a) == read_file(b);
}

/// Makes `folder` hold the files of `fresh` and no others. Files that are the same are not touched: another process may
/// be reading them.
void bring_up_to_date(const fs::path& folder, const fs::path& fresh) {
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none))
    if (!fs::exists(fresh / entry.path().filename())) fs::remove_all(entry.path());
  for (const auto& entry : fs::directory_iterator(fresh))
    if (const fs::path there = folder / entry.path().filename(); !same_text(entry.path(), there))
      write_file(there, read_file(entry.path()));
}

}  // namespace

Version Workshop::make(const std::string& name, const std::function<void(const fs::path&)>& write) const {
  Version version{.name = name, .code = {root_ / name / "sources", {}}, .built = false, .log = {}};
  try {
    const TemporaryFolder fresh("atelier-version");
    write(fresh.path() / step_.name);
    const fs::path sources = version.code.sources / step_.name;
    bring_up_to_date(sources, fresh.path() / step_.name);
    // Half of the versions differ only in shaders: compile equal C++ once, in a shared folder.
    const fs::path compiled = root_ / "compiled" / digest_of_cpp(sources, step_);
    for (const std::string& file : step_.files)
      if (!fs::exists(compiled / "sources" / file)) write_file(compiled / "sources" / file, read_file(sources / file));
    version.code.libraries = compiled / "libraries";
    const judge::Built built = judge::build_step(flags_, step_.name, compiled / "sources", version.code.libraries);
    version.built = built.ok;
    version.log = built.log;
  } catch (const Error& error) {
    version.log = error.what();
  }
  return version;
}

Version Workshop::solution() const {
  return make("solution", [&](const fs::path& folder) {
    judge::take_step_files(flags_, step_.name, folders_.solutions() / step_.name, folder);
  });
}

Version Workshop::skeleton() const {
  return make("skeleton", [&](const fs::path& folder) {
    for (const std::string& file : step_.files) {
      const std::string name = step_.name + "/" + file;
      write_file(folder / file, cut_skeleton(read_file(folders_.solutions() / name), "solutions/" + name, step_.name));
    }
  });
}

Version Workshop::patched(const std::string& name, const fs::path& patch) const {
  return make(name, [&](const fs::path& folder) {
    fs::create_directories(folder.parent_path());
    judge::make_patched(folders_.solutions() / step_.name, patch, folder);
  });
}

Version Workshop::changed(const std::string& name, const std::map<std::string, std::string>& files) const {
  return make(name, [&](const fs::path& folder) {
    judge::take_step_files(flags_, step_.name, folders_.solutions() / step_.name, folder);
    for (const auto& [file, text] : files) write_file(folder / file, text);
  });
}

Version Workshop::without(const std::string& function) const {
  std::map<std::string, std::string> files;
  for (const std::string& file : step_.files) {
    const std::string name = step_.name + "/" + file;
    files[file] = with_unwritten(read_file(folders_.solutions() / name), {function}, "solutions/" + name, step_.name);
  }
  return changed("without-" + function, files);
}

judge::RunSettings Workshop::settings(const Version& version, const std::map<std::string, Version>& earlier) const {
  judge::RunSettings settings = this->settings(version);
  std::vector<Implementations::Root> roots;
  for (const auto& [step, other] : earlier)
    for (const fs::path& folder : {other.code.libraries, other.code.sources})
      if (fs::is_directory(folder)) roots.push_back({folder, step});
  roots.insert(roots.end(), settings.implementations.roots().begin(), settings.implementations.roots().end());
  settings.implementations = Implementations(std::move(roots));
  return settings;
}

judge::RunSettings Workshop::settings(const Version& version) const {
  judge::RunSettings settings;
  settings.program = folders_.program(step_.name);
  settings.implementations = search_path(folders_, step_, version.code, earlier_);
  settings.solution = search_path(folders_, step_, code_of(folders_, Owner::solution), earlier_);
  settings.workers = 1;
  settings.max_time_outs = 0;                                    // run every case, even after time-outs
  settings.shader_cache = folders_.build / "audit" / "shaders";  // all of it is trusted code
  return settings;
}

std::vector<judge::Answer> Workshop::answers(const Version& version,
                                             const std::vector<judge::JudgedCase>& cases) const {
  return judge::ask_cases(settings(version), step_.name, cases);
}

}  // namespace atelier
