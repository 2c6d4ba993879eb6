// ./atelier vary: checks the ranges of cases that vary, with many seeds.
//
// Whatever numbers are drawn, the solution must give an answer that could be a reference, every variant must agree with
// it, and the skeleton and every mistake that the case rejects must not. A probe's drawn inputs may leave some of these
// mistakes to its stored ones, such as mistakes about an extreme, but not all. The worst of all seeds is printed, in
// tolerances: how far the variants are below 1, and the mistakes above it.
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>

#include "base/error.hpp"
#include "base/near_names.hpp"
#include "base/parallel.hpp"
#include "cli/author/step_rules.hpp"
#include "cli/author/workshop.hpp"
#include "cli/commands.hpp"
#include "grade/varied_cases.hpp"
#include "image_io/image_io.hpp"
#include "judge/compare/make_reference.hpp"
#include "judge/compare/mistakes.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;
using grade::VariedCase;
using judge::Answer;
using judge::JudgedCase;
using OrderedJson = nlohmann::ordered_json;

/// An answer's distance in tolerances, and where it was found.
struct Distance {
  double tolerances = 0;
  std::string version, numbers;
  std::uint64_t seed = 0;
};

/// The worst of all seeds for one case.
struct VaryRow {
  std::string step, name;
  std::optional<Distance> variant;  ///< the farthest; none: the step has no variant
  std::optional<Distance> mistake;  ///< the nearest that the drawn numbers catch, or the skeleton
  std::vector<std::string> left;    ///< of a probe: the mistakes that only its stored inputs catch
  Problems problems;
};

/// A case with the numbers of one seed.
struct Drawn {
  VariedCase varied;
  std::uint64_t seed = 0;
  Answer solution{};
};

constexpr const char* skeleton_name = "the skeleton";

/// A version of the code, the cases it answers, and what its distance means.
struct Contender {
  enum class Kind { variant, mistake };
  std::string name;
  Kind kind;
  std::function<Version()> make;
  std::function<bool(const JudgedCase&)> answers;
};

std::vector<Contender> contenders_of(const ProjectFolders& folders, const CourseStep& step, const Workshop& workshop) {
  std::vector<Contender> all;
  const auto every = [](const JudgedCase&) { return true; };
  if (fs::exists(folders.variants_file(step.name)))
    for (const judge::Variant& variant : judge::read_variants(folders.variants_file(step.name)))
      all.push_back({variant.name, Contender::Kind::variant,
                     [&workshop, variant] { return workshop.patched("variant-" + variant.name, variant.patch); },
                     every});
  all.push_back({skeleton_name, Contender::Kind::mistake, [&workshop] { return workshop.skeleton(); },
                 [](const JudgedCase& c) { return c.student; }});
  for (const judge::Mistake& mistake : judge::read_mistakes(folders.mistakes_file(step.name)))
    all.push_back({mistake.name, Contender::Kind::mistake,
                   [&workshop, mistake] { return workshop.patched("mistake-" + mistake.name, mistake.patch); },
                   [name = mistake.name](const JudgedCase& c) { return std::ranges::count(c.rejects, name) > 0; }});
  return all;
}

std::vector<Drawn> draw(const std::vector<JudgedCase>& cases, const VaryOptions& options) {
  std::vector<Drawn> all;
  for (int i = 0; i < options.seeds; ++i) {
    const std::uint64_t seed = options.seed + std::uint64_t(i);
    for (VariedCase& varied : grade::draw_numbers(cases, seed)) {
      varied.judged.ask.name += fmt::format("-{}", seed);  // one program answers all seeds
      all.push_back({.varied = std::move(varied), .seed = seed});
    }
  }
  return all;
}

/// The version's answers to those of `drawn` that `asked` accepts, each with its index in `drawn`.
void answer(const Workshop& workshop, const Version& version, const std::vector<Drawn>& drawn,
            const std::function<bool(const JudgedCase&)>& asked,
            const std::function<void(std::size_t, const Answer&)>& on_answer) {
  if (!version.built) throw Error(fmt::format("{} does not build: {}", version.name, version.log));
  std::vector<Case> asks;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < drawn.size(); ++i)
    if (asked(drawn[i].varied.judged)) asks.push_back(drawn[i].varied.judged.ask), places.push_back(i);
  if (asks.empty()) return;
  judge::RunSettings settings = workshop.settings(version);
  settings.max_time_outs = 3;  // a mistake may hang every time
  judge::run_cases(settings, asks, [&](std::size_t i, const Answer& given) { on_answer(places[i], given); });
}

/// The distance of an answer from the solution's. Throws Error if the solution's could be no reference.
double distance(const Drawn& drawn, const std::string& name, const Answer& given) {
  JudgedCase c = drawn.varied.judged;
  c.rejects.clear();  // distances are judged here
  return judge::check_reference(c, {.solution = drawn.solution, .skeleton = {}, .mistakes = {{name, given}}})
      .margins.at(name);
}

using Worst = std::map<std::string, Distance>;  ///< by version: of a variant the largest, of a mistake the smallest

void note(Worst& worst, const Distance& found, Contender::Kind kind) {
  const auto [there, is_new] = worst.try_emplace(found.version, found);
  const bool worse = kind == Contender::Kind::variant ? found.tolerances > there->second.tolerances
                                                      : found.tolerances < there->second.tolerances;
  if (!is_new && worse) there->second = found;
}

std::string problem_of(const Distance& found, const std::string& what) {
  return fmt::format("{} {} with seed {} ({}): {:.3g} tolerances", found.version, what, found.seed, found.numbers,
                     found.tolerances);
}

void add_variants(VaryRow& row, const Worst& variants) {
  for (const auto& [name, found] : variants) {
    if (!row.variant || found.tolerances > row.variant->tolerances) row.variant = found;
    if (found.tolerances >= 1) row.problems.push_back(problem_of(found, "fails"));
  }
}

void add_mistakes(VaryRow& row, const Worst& mistakes, bool is_probe) {
  std::size_t caught = 0;
  for (const auto& [name, found] : mistakes) {
    const bool is_caught = found.tolerances >= 1;
    if (is_caught && (!row.mistake || found.tolerances < row.mistake->tolerances)) row.mistake = found;
    if (name != skeleton_name) caught += is_caught;
    if (is_caught) continue;
    if (is_probe && name != skeleton_name)
      row.left.push_back(name);
    else
      row.problems.push_back(problem_of(found, "passes"));
  }
  if (caught == 0 && !row.left.empty())
    row.problems.push_back("the drawn inputs catch none of the mistakes that the case rejects");
}

void write_pictures(const fs::path& folder, const std::string& step, const std::vector<Drawn>& drawn) {
  for (const Drawn& one : drawn)
    if (one.solution.pixels) {
      const bool linear = one.varied.judged.unit == judge::Unit::colour;
      fs::create_directories(folder);
      write_image(folder / fmt::format("{}-{}.png", step, one.varied.judged.ask.name), *one.solution.pixels,
                  {linear ? Encoding::linear : Encoding::data, Depth::bits8});
    }
}

std::vector<VaryRow> vary_step(const ProjectFolders& folders, const CourseStep& step, const VaryOptions& options) {
  const std::vector<JudgedCase> cases = judge::read_case_file(folders.case_file(step.name)).cases;
  std::vector<Drawn> drawn = draw(cases, options);
  const Workshop workshop(folders, step);
  const auto every = [](const JudgedCase&) { return true; };
  answer(workshop, workshop.solution(), drawn, every,
         [&](std::size_t i, const Answer& given) { drawn[i].solution = given; });
  if (!options.pictures.empty()) write_pictures(options.pictures, step.name, drawn);

  struct Found {
    Worst variants, mistakes;
    std::set<std::string> refused;  ///< why the solution's answers could be no references
  };
  std::vector<Found> found(cases.size());
  const std::vector<Contender> contenders = contenders_of(folders, step, workshop);
  std::mutex mutex;
  for_each_parallel(contenders.size(), worker_threads(), [&](std::size_t k) {
    const auto& [name, kind, make, asked] = contenders[k];
    answer(workshop, make(), drawn, asked, [&, &name = name, kind = kind](std::size_t i, const Answer& given) {
      Found& here = found[drawn[i].varied.of];
      try {
        const double tolerances = distance(drawn[i], name, given);
        const std::lock_guard lock(mutex);
        note(kind == Contender::Kind::variant ? here.variants : here.mistakes,
             {tolerances, name, drawn[i].varied.numbers, drawn[i].seed}, kind);
      } catch (const Error& error) {
        const std::lock_guard lock(mutex);
        here.refused.insert(error.what());
      }
    });
  });

  std::vector<VaryRow> rows;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (!cases[i].vary) continue;
    VaryRow& row = rows.emplace_back(VaryRow{.step = step.name, .name = cases[i].ask.name});
    row.problems.assign(found[i].refused.begin(), found[i].refused.end());
    add_variants(row, found[i].variants);
    add_mistakes(row, found[i].mistakes, cases[i].profile == judge::Profile::values);
  }
  return rows;
}

/// The functions that no case that varies tests, although not_varied does not say why, and those that one does although
/// it does.
Problems problems_of_functions(const fs::path& path) {
  const judge::CaseFile file = judge::read_case_file(path);
  std::vector<JudgedCase> varied;
  std::ranges::copy_if(file.cases, std::back_inserter(varied), [](const JudgedCase& c) { return c.vary.has_value(); });
  const std::set<std::string> reached = judge::functions_of(varied);
  Problems problems;
  for (const std::string& name : judge::functions_of(file.cases)) {
    if (reached.contains(name) != file.not_varied.contains(name)) continue;
    const std::string what = reached.contains(name)
                                 ? "is tested by a case that varies: remove it from \"not_varied\""
                                 : "is tested by no case that varies: give one a \"vary\", or say in "
                                   "\"not_varied\" why there is none";
    problems.push_back(fmt::format("{}: {} {}", path.string(), name, what));
  }
  return problems;
}

OrderedJson to_json(const std::optional<Distance>& distance) {
  if (!distance) return nullptr;
  return {{"version", distance->version},
          {"tolerances", distance->tolerances},
          {"seed", distance->seed},
          {"numbers", distance->numbers}};
}

void print_json(const std::vector<VaryRow>& rows, const Problems& problems) {
  OrderedJson list = OrderedJson::array();
  for (const VaryRow& row : rows)
    list.push_back({{"step", row.step},
                    {"case", row.name},
                    {"variant", to_json(row.variant)},
                    {"mistake", to_json(row.mistake)},
                    {"left", row.left},
                    {"problems", row.problems}});
  fmt::print("{}\n", OrderedJson{{"cases", list}, {"lacks", problems}}.dump(2, ' ', false,
                                                                            OrderedJson::error_handler_t::replace));
}

std::string in_words(const std::optional<Distance>& distance) {
  return distance ? fmt::format("{:>7.3g} {:<28}", distance->tolerances, distance->version)
                  : fmt::format("{:>7} {:<28}", "-", "");
}

void print_table(const std::vector<VaryRow>& rows, const Problems& problems) {
  fmt::print("{:<18} {:<24} {:<36} {}\n", "step", "case", "farthest variant, in tolerances", "nearest mistake");
  for (const VaryRow& row : rows) {
    fmt::print("{:<18} {:<24} {} {}\n", row.step, row.name, in_words(row.variant), in_words(row.mistake));
    if (!row.left.empty()) fmt::print("{:<18}   left to the stored inputs: {}\n", "", join(row.left));
    fmt::print("{}", in_lines(row.problems));
  }
  fmt::print("{}", in_lines(problems));
}

}  // namespace

int run_vary(const VaryOptions& options) {
  const ProjectFolders folders = project_folders();
  std::vector<VaryRow> rows;
  Problems problems;
  for (const CourseStep& step : resolve_steps(read_course(folders.step_flags()), options.steps)) {
    for (VaryRow& row : vary_step(folders, step, options)) rows.push_back(std::move(row));
    for (std::string& problem : problems_of_functions(folders.case_file(step.name)))
      problems.push_back(std::move(problem));
  }
  options.json ? print_json(rows, problems) : print_table(rows, problems);
  const bool fine = problems.empty() && std::ranges::all_of(rows, [](const VaryRow& r) { return r.problems.empty(); });
  return fine ? exit_ok : exit_failed;
}

}  // namespace atelier
