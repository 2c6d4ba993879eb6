// ./atelier mutate: small changes of the solutions, made by machine. A change of meaning must lose points; another form
// of the same meaning must keep them, and so must the last bits of what earlier steps return.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/parallel.hpp"
#include "cli/author/last_bits.hpp"
#include "cli/author/mutant_list.hpp"
#include "cli/author/rewritings.hpp"
#include "cli/author/workshop.hpp"
#include "cli/commands.hpp"
#include "cli/criteria.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;
using judge::CaseResult;
using OrderedJson = nlohmann::ordered_json;

enum class Fate { not_built, caught, equivalent, survived, kept, failed };

std::string to_string(Fate fate) {
  constexpr const char* words[] = {"not built", "caught", "equivalent", "survived", "kept all points", "failed"};
  return words[std::size_t(fate)];
}

/// What became of one change.
struct Trial {
  Mutant mutant;  ///< of a variant: its lines, joined
  Fate fate = Fate::survived;
  std::string by;                                         ///< the case that caught it, or that a variant failed
  std::map<std::string, std::vector<std::string>> named;  ///< what the verdict called it, in which cases
  std::string why;                                        ///< the reason on record, or the verdict's
};

struct StepTrials {
  std::string step;
  std::vector<Trial> trials;
  int count(Fate fate) const {
    return int(std::count_if(trials.begin(), trials.end(), [&](const Trial& t) { return t.fate == fate; }));
  }
};

/// Tries the changes of one step.
class Field {
 public:
  Field(const ProjectFolders& folders, const CourseStep& step)
      : folders_(folders), step_(step), workshop_(folders, step), all_(criteria_of(folders, step)) {
    all_.require_references();
  }

  /// Mutants until `count` of them have been built.
  StepTrials mutants(std::uint64_t seed, int count) const {
    const auto known = read_equivalents(folders_.equivalents_file(step_.name));
    std::vector<Mutant> mutants = mutants_of(folders_, step_, judge::functions_of(all_.cases()), seed);
    StepTrials tried{step_.name, {}};
    for (std::size_t next = 0; next < mutants.size();) {
      const int missing = count - int(tried.trials.size()) + tried.count(Fate::not_built);
      if (missing <= 0) break;
      const std::size_t end = std::min(mutants.size(), next + std::size_t(missing));
      std::vector<Trial> trials(end - next);
      for_each_parallel(trials.size(), worker_threads(),
                        [&](std::size_t i) { trials[i] = try_mutant(std::move(mutants[next + i]), known); });
      tried.trials.insert(tried.trials.end(), std::make_move_iterator(trials.begin()),
                          std::make_move_iterator(trials.end()));
      next = end;
    }
    return tried;
  }

  /// Known mistakes in others' words: NAME.patch and NAME.*.patch in FOLDER or FOLDER/NN-name.
  StepTrials spellings(const fs::path& folder) const {
    StepTrials tried{step_.name, {}};
    const fs::path own = folder / step_.name, place = fs::is_directory(own) ? own : folder;
    for (const auto& entry : fs::directory_iterator(place))
      if (entry.path().extension() == ".patch")
        tried.trials.push_back({.mutant = {.id = entry.path().filename().string(), .kind = "spelling"}});
    if (tried.trials.empty()) throw Error(fmt::format("{}: has no .patch files", place.string()));
    std::sort(tried.trials.begin(), tried.trials.end(),
              [](const Trial& a, const Trial& b) { return a.mutant.id < b.mutant.id; });
    for_each_parallel(tried.trials.size(), worker_threads(), [&](std::size_t i) {
      Trial& trial = tried.trials[i];
      const fs::path patch = place / trial.mutant.id;
      const Version version = workshop_.patched("given-" + patch.stem().string(), patch);
      judge_mutant(version, trial);
      if (trial.fate == Fate::not_built) trial.why = version.log;
      fs::remove_all(version.code.sources);
    });
    return tried;
  }

  /// Variants of several rewritings each.
  StepTrials variants(std::uint64_t seed, int count) const {
    StepTrials tried{step_.name, std::vector<Trial>(std::size_t(count))};
    for_each_parallel(tried.trials.size(), worker_threads(),
                      [&](std::size_t i) { tried.trials[i] = try_variant(seed * 1000003 + i); });
    return tried;
  }

  /// The solution on earlier steps whose results are moved.
  Trial last_bits(const std::vector<CourseStep>& course, std::uint64_t seed) const {
    Trial trial{.mutant = {.id = std::to_string(seed), .kind = "last bits"}, .fate = Fate::kept};
    std::map<std::string, Version> earlier;
    for (const std::string& name : step_.uses) {
      const CourseStep& step = resolve_step(course, name);
      std::map<std::string, std::string> files;
      for (const std::string& file : step.files)
        if (file.ends_with(".cpp"))
          files[file] = with_moved_last_bits(read_file(folders_.solutions() / name / file), seed);
      earlier[name] = Workshop(folders_, step).changed("last-bits-" + std::to_string(seed), files);
      if (!earlier[name].built)
        throw Error(fmt::format("{}: with moved results it does not build: {}", name, earlier[name].log));
    }
    const judge::RunSettings settings = workshop_.settings(workshop_.solution(), earlier);
    for (const CaseResult& c : all_.judge(settings, judge::KeepEvidence::never).cases)
      if (c.status != judge::Status::passed && trial.fate == Fate::kept) {
        trial.fate = Fate::failed;
        trial.by = c.name;
        trial.why = c.reason;
      }
    return trial;
  }

 private:
  Trial try_mutant(Mutant mutant, const std::map<std::string, std::string>& known) const {
    Trial trial{.mutant = std::move(mutant)};
    const Version version = workshop_.changed("mutant-" + trial.mutant.id, {{trial.mutant.file, trial.mutant.text}});
    judge_mutant(version, trial);
    fs::remove_all(version.code.sources);
    if (const auto found = known.find(trial.mutant.id); found != known.end() && trial.fate == Fate::survived) {
      trial.fate = Fate::equivalent;
      trial.why = found->second;
    }
    trial.mutant.text.clear();
    return trial;
  }

  void judge_mutant(const Version& version, Trial& trial) const {
    if (!version.built) {
      trial.fate = Fate::not_built;
      return;
    }
    judge::RunSettings settings = workshop_.settings(version);
    settings.max_time_outs = 1;
    for (const CaseResult& c : all_.judge(settings, judge::KeepEvidence::never).cases) {
      if (c.status == judge::Status::build_failed) {
        trial.fate = Fate::not_built;
        return;
      }
      if (c.status == judge::Status::passed) continue;
      if (trial.fate == Fate::survived) trial.by = c.name, trial.why = c.reason;
      trial.fate = Fate::caught;
      if (c.mistake) trial.named[*c.mistake].push_back(c.name);
    }
  }

  Trial try_variant(std::uint64_t seed) const {
    constexpr std::size_t changes_a_file = 6;
    Trial trial{.mutant = {.id = std::to_string(seed), .kind = "variant"}, .fate = Fate::kept};
    std::map<std::string, std::string> files;
    for (const std::string& file : step_.files) {
      if (file.ends_with(".txt")) continue;
      const std::string text = read_file(folders_.solutions() / step_.name / file);
      const std::vector<Edit> edits = sampled(rewritings_of(text, file.ends_with(".glsl")), changes_a_file, seed);
      for (const Edit& edit : edits)
        trial.mutant.after +=
            fmt::format("{}: {} -> {}\n", file, text.substr(edit.begin, edit.end - edit.begin), edit.text);
      files[file] = edited(text, edits);
    }
    const Version version = workshop_.changed("variant-of-" + trial.mutant.id, files);
    if (!version.built) {
      trial.fate = Fate::not_built;
      trial.why = version.log;
    } else {
      for (const CaseResult& c : all_.judge(workshop_.settings(version), judge::KeepEvidence::never).cases) {
        if (c.status == judge::Status::passed || trial.fate == Fate::failed) continue;
        trial.fate = c.status == judge::Status::build_failed ? Fate::not_built : Fate::failed;
        trial.by = c.name;
        trial.why = c.reason;
      }
    }
    fs::remove_all(version.code.sources);
    return trial;
  }

  const ProjectFolders& folders_;
  const CourseStep& step_;
  Workshop workshop_;
  grade::StepJudge all_;
};

// --- What is said ---

/// Whether a verdict calls a spelling by its mistake's name; nothing if by none.
std::optional<bool> named_rightly(const Trial& trial) {
  if (trial.named.empty()) return std::nullopt;
  const std::string mistake = trial.mutant.id.substr(0, trial.mutant.id.find('.'));
  return trial.named.size() == 1 && trial.named.contains(mistake);
}

bool is_spelling(const Trial& trial) {
  return trial.mutant.kind == "spelling";
}

bool falls_short(const Trial& trial) {
  return trial.fate == Fate::survived || trial.fate == Fate::failed ||
         (is_spelling(trial) && (trial.fate == Fate::not_built || !named_rightly(trial).value_or(true)));
}

void print_spellings(const StepTrials& tried) {
  const auto count = [&](std::optional<bool> rightly) {
    return std::count_if(tried.trials.begin(), tried.trials.end(),
                         [&](const Trial& t) { return t.fate == Fate::caught && named_rightly(t) == rightly; });
  };
  fmt::print("\n{}: {} spellings, {} caught; {} named rightly, {} wrongly, {} not named\n", tried.step,
             tried.trials.size(), tried.count(Fate::caught), count(true), count(false), count(std::nullopt));
  for (const Trial& trial : tried.trials) {
    std::vector<std::string> names;
    for (const auto& [name, cases] : trial.named) names.push_back(name);
    if (trial.fate != Fate::caught)
      fmt::print("  {:<40} {}\n{}", trial.mutant.id, to_string(trial.fate), trial.why);
    else if (!named_rightly(trial).value_or(false))
      fmt::print("  {:<40} {}\n", trial.mutant.id, names.empty() ? "-" : fmt::format("{}", fmt::join(names, ", ")));
  }
}

void print_step(const StepTrials& tried, bool mutants) {
  fmt::print("\n{}: {} made", tried.step, tried.trials.size());
  for (const Fate fate : {Fate::not_built, Fate::caught, Fate::equivalent, Fate::survived, Fate::kept, Fate::failed})
    if (const int count = tried.count(fate); count > 0) fmt::print(", {} {}", count, to_string(fate));
  const auto named =
      std::count_if(tried.trials.begin(), tried.trials.end(), [](const Trial& t) { return !t.named.empty(); });
  if (mutants) fmt::print("; {} given a mistake's name", named);
  fmt::print("\n");
  for (const Trial& trial : tried.trials) {
    const bool unfit = !mutants && trial.fate == Fate::not_built;
    if (!falls_short(trial) && !unfit) continue;
    const Mutant& m = trial.mutant;
    if (mutants)
      fmt::print("\n  {}  {}:{}  {}\n    - {}\n    + {}\n", m.id, m.file, m.line, m.kind, m.before, m.after);
    else
      fmt::print("\n  seed {}{}: {}\n{}", m.id, unfit ? " does not build" : " fails " + trial.by, trial.why, m.after);
  }
}

OrderedJson to_json(const StepTrials& tried, std::uint64_t seed) {
  OrderedJson json{{"step", tried.step},
                   {"seed", seed},
                   {"made", tried.trials.size()},
                   {"built", int(tried.trials.size()) - tried.count(Fate::not_built)}};
  for (const Fate fate : {Fate::caught, Fate::equivalent, Fate::kept}) json[to_string(fate)] = tried.count(fate);
  json["survived"] = OrderedJson::array();
  json["named"] = OrderedJson::array();
  for (const Trial& trial : tried.trials) {
    const Mutant& m = trial.mutant;
    const OrderedJson entry{{"id", m.id},
                            {"file", m.file},
                            {"line", m.line},
                            {"kind", m.kind},
                            {"diff", "- " + m.before + "\n+ " + m.after},
                            {"case", trial.by},
                            {"named", trial.named},
                            {"reason", trial.why}};
    if (falls_short(trial)) json["survived"].push_back(entry);
    if (!trial.named.empty()) json["named"].push_back(entry);
  }
  return json;
}

}  // namespace

int run_mutate(const MutateOptions& options) {
  const ProjectFolders folders = project_folders();
  const auto course = read_course(folders.step_flags());
  OrderedJson all = OrderedJson::array();
  bool short_of = false;
  for (const CourseStep& step : resolve_steps(course, options.steps)) {
    const Field field(folders, step);
    StepTrials tried{step.name, {}};
    if (!options.patches.empty()) {
      tried = field.spellings(options.patches);
    } else if (options.last_bits) {
      if (step.uses.empty()) continue;
      constexpr int seeds = 3;
      for (int i = 0; i < seeds; ++i) tried.trials.push_back(field.last_bits(course, options.seed + std::uint64_t(i)));
    } else {
      tried =
          options.preserving ? field.variants(options.seed, options.count) : field.mutants(options.seed, options.count);
    }
    short_of = short_of || std::any_of(tried.trials.begin(), tried.trials.end(), falls_short);
    if (options.json)
      all.push_back(to_json(tried, options.seed));
    else if (!options.patches.empty())
      print_spellings(tried);
    else
      print_step(tried, !options.preserving && !options.last_bits);
  }
  if (options.json)
    fmt::print("{}\n", OrderedJson{{"mutations", all}}.dump(2, ' ', false, OrderedJson::error_handler_t::replace));
  return short_of ? exit_failed : exit_ok;
}

}  // namespace atelier
