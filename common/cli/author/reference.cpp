// ./atelier reference: makes the references from the solution's answers.
//
// For each case it runs the solution, the untouched skeleton and every known mistake. A case that cannot distinguish a
// claimed mistake from the solution is refused; the other cases get their references.
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/parallel.hpp"
#include "base/replace_together.hpp"
#include "base/sha256.hpp"
#include "base/strict_json.hpp"
#include "cli/author/step_rules.hpp"
#include "cli/author/workshop.hpp"
#include "cli/commands.hpp"
#include "cli/criteria.hpp"
#include "grade/environment.hpp"
#include "image_io/image_io.hpp"
#include "judge/compare/make_reference.hpp"
#include "judge/compare/mistakes.hpp"
#include "judge/compare/sidecar.hpp"
#include "judge/run/ask.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;
using judge::Answer;
using judge::JudgedCase;

struct ReferenceRow {
  std::string step, name;
  std::uintmax_t bytes = 0;            ///< of the reference itself
  std::optional<std::string> nearest;  ///< the claimed mistake with the least margin
  double margin = 0;                   ///< its margin in tolerances
  std::string state;                   ///< "written", "as it was", "would change", "refused"
  std::string trouble;                 ///< why it was refused
};

// --- What is drawn ---

/// All versions' answers to the cases of a step, in the cases' order: a few hundred megabytes of pictures.
struct Drawn {
  std::vector<Answer> solution, skeleton, truths;
  std::map<std::string, std::vector<Answer>> mistakes, without;
  /// By mistake and spelling, to probes; the answers to pictures are empty.
  std::map<std::string, std::vector<std::vector<Answer>>> spellings;
};

std::vector<Answer> draw(const Workshop& workshop, const Version& version, const std::vector<JudgedCase>& cases) {
  if (!version.built)
    throw Error(fmt::format("{}: {} does not build: {}", workshop.step().name, version.name, version.log));
  return workshop.answers(version, cases);
}

/// Throws if a mistake gives no answer in any case: no picture can reject it.
void require_answer(const std::string& mistake, const std::vector<Answer>& answers) {
  const auto is_normal = [](const Answer& answer) { return answer.ended == Answer::Ended::normally; };
  if (!answers.empty() && std::none_of(answers.begin(), answers.end(), is_normal))
    throw Error(fmt::format("mistake '{}' does not run: {}", mistake, answers.front().error));
}

/// The answers of other spellings to the probes.
void draw_spellings(const Workshop& workshop, const std::vector<judge::Mistake>& mistakes,
                    const std::vector<JudgedCase>& cases, Drawn& drawn) {
  std::vector<JudgedCase> probes;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < cases.size(); ++i)
    if (cases[i].profile == judge::Profile::values) probes.push_back(cases[i]), places.push_back(i);
  if (probes.empty()) return;
  struct Spelled {
    const fs::path& patch;
    std::vector<Answer>& answers;
  };
  std::vector<Spelled> spelled;
  for (const judge::Mistake& mistake : mistakes) {
    auto& answers = drawn.spellings[mistake.name];
    answers.assign(mistake.spellings.size(), std::vector<Answer>(cases.size()));
    for (std::size_t k = 0; k < answers.size(); ++k) spelled.push_back({mistake.spellings[k], answers[k]});
  }
  for_each_parallel(spelled.size(), worker_threads(), [&](std::size_t i) {
    const Version version = workshop.patched("spelling-" + spelled[i].patch.stem().string(), spelled[i].patch);
    std::vector<Answer> answers = draw(workshop, version, probes);
    for (std::size_t k = 0; k < places.size(); ++k) spelled[i].answers[places[k]] = std::move(answers[k]);
  });
}

/// `functions`: all that a student writes.
Drawn draw_all(const Workshop& workshop, const std::vector<judge::Mistake>& mistakes,
               const std::set<std::string>& functions, const std::vector<JudgedCase>& cases, bool whole_step) {
  Drawn drawn;
  struct Drawing {
    std::function<Version()> make;
    std::vector<Answer>& answers;
  };
  std::vector<Drawing> drawings{{[&] { return workshop.solution(); }, drawn.solution},
                                {[&] { return workshop.skeleton(); }, drawn.skeleton}};
  for (const judge::Mistake& mistake : mistakes)
    drawings.push_back(
        {[&] { return workshop.patched("mistake-" + mistake.name, mistake.patch); }, drawn.mistakes[mistake.name]});
  for (const std::string& function : functions)
    drawings.push_back({[&] { return workshop.without(function); }, drawn.without[function]});
  for_each_parallel(drawings.size(), worker_threads(),
                    [&](std::size_t i) { drawings[i].answers = draw(workshop, drawings[i].make(), cases); });
  draw_spellings(workshop, mistakes, cases, drawn);
  drawn.truths = judge::ask_truths(workshop.settings(workshop.solution()), cases);
  if (whole_step)
    for (const auto& [name, answers] : drawn.mistakes) require_answer(name, answers);
  return drawn;
}

judge::ReferenceMaterial material_of(const Drawn& drawn, std::size_t index, const judge::Environment& environment) {
  judge::ReferenceMaterial material{
      .solution = drawn.solution[index], .truth = drawn.truths[index], .skeleton = drawn.skeleton[index]};
  for (const auto& [name, answers] : drawn.mistakes) material.mistakes[name] = answers[index];
  for (const auto& [name, spellings] : drawn.spellings)
    for (const auto& answers : spellings) material.spellings[name].push_back(answers[index]);
  for (const auto& [name, answers] : drawn.without) material.without[name] = answers[index];
  for (const char* key : {"driver", "cpu"}) material.environment[key] = environment.at(key);
  return material;
}

// --- Existing files ---

/// The files below `folder` that belong to a case, relative to it.
std::set<fs::path> files_of(const fs::path& folder, const JudgedCase& c) {
  std::set<fs::path> files;
  const auto add = [&](const fs::path& file) {
    if (fs::exists(file)) files.insert(file.lexically_relative(folder));
  };
  add(judge::values_path(folder, c.ask.name));
  add(judge::wrong_values_path(folder, c.ask.name));
  if (!c.references.empty()) {
    add(folder / c.references.front().filename());
    add(judge::sidecar_path(folder / c.references.front().filename()));
  }
  add(judge::atlas_path(folder, c.ask.name));
  return files;
}

/// Without members that depend on the machine even for equal pictures: its name, and the hash of compressed bytes.
strict_json::Json comparable(const fs::path& file) {
  strict_json::Json json = strict_json::parse(read_file(file), file.string());
  if (json.is_object()) json.erase("environment"), json.erase("sha256");
  return json;
}

bool says_the_same(const fs::path& a, const fs::path& b) {
  if (a.extension() == ".json") return comparable(a) == comparable(b);
  return read_image(a, Encoding::data) == read_image(b, Encoding::data);
}

bool would_change(const fs::path& made, const fs::path& there, const JudgedCase& c) {
  const std::set<fs::path> files = files_of(made, c);
  if (files != files_of(there, c)) return true;
  return !std::all_of(files.begin(), files.end(),
                      [&](const fs::path& f) { return says_the_same(made / f, there / f); });
}

/// Takes the old file of each picture whose pixels are the same: files hold the time at which they were written.
void keep_equal_pictures(const fs::path& made, const fs::path& there, const JudgedCase& c) {
  for (const fs::path& file : files_of(made, c)) {
    if (file.extension() == ".json" || !fs::exists(there / file) || !says_the_same(made / file, there / file)) continue;
    fs::copy_file(there / file, made / file, fs::copy_options::overwrite_existing);
    const fs::path sidecar_file = judge::sidecar_path(made / file);
    if (!fs::exists(sidecar_file)) continue;  // an atlas has none
    judge::Sidecar sidecar = judge::read_sidecar(sidecar_file);
    sidecar.sha256 = sha256(read_file(made / file));
    judge::write_sidecar(sidecar_file, sidecar);
  }
}

/// Replaces a case's files by the new ones, all or none.
void replace(const fs::path& made, const fs::path& there, const JudgedCase& c) {
  const std::set<fs::path> files = files_of(made, c), old = files_of(there, c);
  std::vector<Replacement> replacements;
  for (const fs::path& file : files)
    replacements.push_back({there / file, [source = made / file](const fs::path& beside) {
                              fs::create_directories(beside.parent_path());
                              fs::copy_file(source, beside, fs::copy_options::overwrite_existing);
                            }});
  try {
    replace_together(replacements);
    for (const fs::path& file : old)
      if (!files.contains(file)) fs::remove(there / file);
  } catch (const fs::filesystem_error& error) {
    throw Error(error.what());
  }
}

// --- One case, one step ---

/// Makes the reference in a temporary folder, and moves it only if its content is new, so that files do not change
/// unnecessarily.
ReferenceRow make_one(const fs::path& folder, const JudgedCase& c, const judge::ReferenceMaterial& material,
                      bool check) {
  ReferenceRow row{.name = c.ask.name};
  const TemporaryFolder fresh("atelier-reference");
  try {
    const judge::MadeReference made = judge::make_reference(fresh.path(), c, material);
    row.bytes = fs::file_size(made.written.front());
    row.nearest = made.nearest;
    row.margin = made.margin;
    const bool changes = would_change(fresh.path(), folder, c);
    row.state = !changes ? "as it was" : check ? "would change" : "written";
    if (changes && !check) {
      keep_equal_pictures(fresh.path(), folder, c);
      replace(fresh.path(), folder, c);
    }
  } catch (const Error& error) {
    row.state = "refused";
    row.trouble = error.what();
  }
  return row;
}

std::vector<ReferenceRow> make_step(const ProjectFolders& folders, const CourseStep& step,
                                    const ReferenceOptions& options, const judge::Environment& environment) {
  grade::Criteria criteria = criteria_of(folders, step);
  criteria.reference_cache.clear();  // it holds what is about to be replaced
  const grade::StepJudge judge(criteria, options.cases);
  const fs::path mistakes_file = folders.mistakes_file(step.name);
  const auto mistakes = fs::exists(mistakes_file) ? judge::read_mistakes(mistakes_file) : std::vector<judge::Mistake>{};
  const auto functions = judge::functions_of(judge::read_case_file(folders.case_file(step.name)).cases);
  const Drawn drawn = draw_all(Workshop(folders, step), mistakes, functions, judge.cases(), options.cases.empty());

  std::vector<ReferenceRow> rows(judge.cases().size());
  for_each_parallel(rows.size(), worker_threads(), [&](std::size_t i) {
    rows[i] = make_one(judge::references_folder(folders.case_file(step.name)), judge.cases()[i],
                       material_of(drawn, i, environment), options.check);
    rows[i].step = step.name;
  });
  return rows;
}

// --- Output ---

void print_table(const std::vector<ReferenceRow>& rows) {
  fmt::print("{:<16} {:<32} {:>9}  {:<28} {:>8}  {}\n", "step", "case", "bytes", "nearest claimed mistake", "margin",
             "state");
  for (const ReferenceRow& row : rows) {
    fmt::print("{:<16} {:<32} {:>9}  {:<28} {:>8}  {}\n", row.step, row.name, row.bytes, row.nearest.value_or("-"),
               row.nearest ? fmt::format("{:.2f}", row.margin) : "-", row.state);
    if (!row.trouble.empty()) fmt::print("{:<16}   ! {}\n", "", row.trouble);
  }
}

/// Files in the folder of references that belong to no case.
Problems orphans_of(const ProjectFolders& folders, const CourseStep& step) {
  const judge::CaseFile cases = judge::read_case_file(folders.case_file(step.name));
  const fs::path folder = judge::references_folder(cases.path);
  std::set<fs::path> known;
  for (const JudgedCase& c : cases.cases) {
    known.merge(files_of(folder, c));
    for (const fs::path& other : c.references)  // further accepted answers
      known.insert({other.filename(), judge::sidecar_path(other).filename()});
  }
  Problems problems;
  for (const auto& entry : fs::directory_iterator(folder))
    if (!known.contains(entry.path().filename()))
      problems.push_back(entry.path().string() + " belongs to no case: delete it");
  return problems;
}

/// Other problems of the step's cases, if all were requested, and of new references against the truth.
Problems problems_of(const ProjectFolders& folders, const CourseStep& step, const ReferenceOptions& options,
                     const std::vector<ReferenceRow>& rows) {
  std::vector<std::string> fresh;
  for (const ReferenceRow& row : rows)
    if (row.state == "written") fresh.push_back(row.name);
  Problems problems = problems_of_truth(folders, step, fresh);
  if (!options.cases.empty()) return problems;
  for (const Problems& more : {problems_of_cases(folders, step), orphans_of(folders, step)})
    problems.insert(problems.end(), more.begin(), more.end());
  return problems;
}

void print_json(const std::vector<ReferenceRow>& rows, const Problems& problems) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const ReferenceRow& row : rows)
    list.push_back({{"step", row.step},
                    {"case", row.name},
                    {"bytes", row.bytes},
                    {"nearest", row.nearest ? nlohmann::ordered_json(*row.nearest) : nullptr},
                    {"margin", row.margin},
                    {"state", row.state},
                    {"trouble", row.trouble}});
  fmt::print("{}\n", nlohmann::ordered_json{{"references", list}, {"lacks", problems}}.dump(2));
}

}  // namespace

int run_reference(const ReferenceOptions& options) {
  const ProjectFolders folders = project_folders();
  if (!options.cases.empty() && options.steps.size() != 1)
    throw Error(
        "reference: --case needs the one step that the case belongs to, as in ./atelier reference 02 --case NAME");
  const judge::Environment environment = grade::describe_environment("", folders.step_flags(), folders.root);
  std::vector<ReferenceRow> rows;
  Problems problems;
  for (const CourseStep& step : resolve_steps(read_course(folders.step_flags()), options.steps)) {
    const auto more = make_step(folders, step, options, environment);
    rows.insert(rows.end(), more.begin(), more.end());
    for (const std::string& problem : problems_of(folders, step, options, more)) problems.push_back(problem);
  }
  options.json ? print_json(rows, problems) : print_table(rows);
  if (!options.json) fmt::print("{}", in_lines(problems));

  const auto any = [&](const char* state) {
    return std::any_of(rows.begin(), rows.end(), [&](const ReferenceRow& row) { return row.state == state; });
  };
  if (any("refused")) throw Error("some references were refused and not changed: the table says why");
  return any("would change") || !problems.empty() ? exit_failed : exit_ok;
}

}  // namespace atelier
