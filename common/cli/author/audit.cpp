// ./atelier audit: checks that the cases catch every known mistake and accept every right variant.
//
// Every known mistake is built and judged like a submission, by the cases that claim to catch it. It must lose points
// on every one of them. The name that the verdict gives it is taken from its first other spelling if there is one,
// because the atlas was made from its patch; no spelling may get another mistake's name. Every variant (another right
// solution) must keep all points. With a sample of 1 in N, the others are not judged, but their patches must apply.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <type_traits>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/near_names.hpp"
#include "base/parallel.hpp"
#include "cli/author/step_rules.hpp"
#include "cli/author/workshop.hpp"
#include "cli/commands.hpp"
#include "cli/criteria.hpp"
#include "judge/compare/mistakes.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;
using judge::CaseResult;
using judge::JudgedCase;
using judge::StepResult;
using OrderedJson = nlohmann::ordered_json;

struct MistakeAudit {
  std::string step, name;
  bool built = false, caught = false;
  std::optional<std::string> expected_case;  ///< the first case that claims to catch it
  std::optional<std::string> caught_by;      ///< that case if it does, otherwise any that does
  std::vector<std::string> claims_broken;    ///< cases that claim to catch it but do not
  std::optional<std::string> named;          ///< the verdict's name for it
  std::string trouble;                       ///< why it fails; empty if it does not
};

struct VariantAudit {
  std::string step, name;
  bool passed = false;
  std::string trouble;
};

struct Audit {
  std::vector<MistakeAudit> mistakes;
  std::vector<VariantAudit> variants;
  Problems problems;  ///< of the steps, in sentences
};

bool loses_points(const CaseResult& result) {
  return result.status != judge::Status::passed;
}

std::vector<std::string> claiming_cases(const std::vector<JudgedCase>& cases, const std::string& mistake) {
  std::vector<std::string> names;
  for (const JudgedCase& c : cases)
    if (std::find(c.rejects.begin(), c.rejects.end(), mistake) != c.rejects.end()) names.push_back(c.ask.name);
  return names;
}

const CaseResult& result_of(const StepResult& step, const std::string& name) {
  return *std::find_if(step.cases.begin(), step.cases.end(), [&](const CaseResult& c) { return c.name == name; });
}

/// The claiming cases that do not catch this version.
std::vector<std::string> broken_claims(const StepResult& result, const std::vector<std::string>& claims) {
  std::vector<std::string> broken;
  for (const std::string& name : claims)
    if (const CaseResult& c = result_of(result, name); !loses_points(c) || c.status == judge::Status::missing)
      broken.push_back(name);  // no answer proves nothing
  return broken;
}

/// The name in the verdict on the expected case, or else the most frequent name.
std::optional<std::string> name_given(const StepResult& result, const std::optional<std::string>& expected_case) {
  if (expected_case)
    if (const auto name = result_of(result, *expected_case).mistake) return name;
  std::map<std::string, int> votes;
  for (const CaseResult& c : result.cases)
    if (c.mistake) ++votes[*c.mistake];
  const auto most = std::max_element(votes.begin(), votes.end(), [](auto& a, auto& b) { return a.second < b.second; });
  return most == votes.end() ? std::nullopt : std::optional(most->first);
}

/// Whether the program answered any case: otherwise nothing is proven.
bool ran(const StepResult& result) {
  return std::any_of(result.cases.begin(), result.cases.end(), [](const CaseResult& c) {
    return c.status == judge::Status::passed || c.status == judge::Status::failed;
  });
}

/// Judges one version; none, with the reason in `trouble`, if it (or a shader) does not build, or does not run.
std::optional<StepResult> judge_version(const Workshop& workshop, const grade::StepJudge& judge,
                                        const grade::StepJudge& all_cases, const Version& version,
                                        std::string& trouble) {
  if (!version.built) {
    trouble = fmt::format("{} does not build: {}", version.name, version.log);
    return std::nullopt;
  }
  StepResult result = judge.judge(workshop.settings(version), judge::KeepEvidence::never);
  for (const CaseResult& c : result.cases)
    if (c.status == judge::Status::build_failed) {
      trouble = fmt::format("{} does not build: {}: {}", version.name, c.name, c.reason);
      return std::nullopt;
    }
  // A mistake may crash every case that claims it; then other cases must show that it runs.
  if (!ran(result) &&
      (&judge == &all_cases || !ran(all_cases.judge(workshop.settings(version), judge::KeepEvidence::never)))) {
    trouble = fmt::format("{} does not run: {}", version.name, result.cases.front().reason);
    return std::nullopt;
  }
  return result;
}

/// Judged only by the cases that claim to catch it; by all if none does, to find one that might.
MistakeAudit audit_mistake(const Workshop& workshop, const grade::Criteria& criteria, const grade::StepJudge& all_cases,
                           const judge::Mistake& mistake) {
  MistakeAudit audit{.step = workshop.step().name, .name = mistake.name};
  const auto claims = claiming_cases(all_cases.cases(), mistake.name);
  if (!claims.empty()) audit.expected_case = claims.front();

  const Version version = workshop.patched("mistake-" + mistake.name, mistake.patch);
  audit.built = version.built;
  const grade::StepJudge judge(criteria, claims);
  auto result = judge_version(workshop, judge, all_cases, version, audit.trouble);
  if (!result) return audit;
  audit.claims_broken = broken_claims(*result, claims);
  audit.caught = !claims.empty() && audit.claims_broken.empty();
  if (audit.expected_case && loses_points(result_of(*result, *audit.expected_case)))
    audit.caught_by = audit.expected_case;
  for (const CaseResult& c : result->cases)
    if (!audit.caught_by && loses_points(c)) audit.caught_by = c.name;

  if (mistake.spellings.empty()) audit.named = name_given(*result, audit.expected_case);
  for (const fs::path& patch : mistake.spellings) {
    const Version other = workshop.patched("spelling-" + patch.stem().string(), patch);
    audit.built = audit.built && other.built;
    result = judge_version(workshop, judge, all_cases, other, audit.trouble);
    if (!result) return audit;
    if (!claims.empty() && broken_claims(*result, claims).size() == claims.size())
      audit.trouble = fmt::format("{} is not caught by {}", patch.filename().string(), join(claims));
    const auto named = name_given(*result, audit.expected_case);
    if (patch == mistake.spellings.front() || (named && named != mistake.name)) audit.named = named;
  }
  if (claims.empty()) audit.trouble = "no case claims to catch it";
  if (!audit.claims_broken.empty()) audit.trouble = "it is not caught by " + join(audit.claims_broken);
  if (audit.named && audit.named != mistake.name) audit.trouble = fmt::format("the verdict calls it {}", *audit.named);
  return audit;
}

VariantAudit audit_variant(const Workshop& workshop, const grade::StepJudge& judge, const judge::Variant& variant) {
  VariantAudit audit{.step = workshop.step().name, .name = variant.name};
  const Version version = workshop.patched("variant-" + variant.name, variant.patch);
  const auto result = judge_version(workshop, judge, judge, version, audit.trouble);
  if (!result) return audit;
  audit.passed = grade::all_passed(*result);
  for (const CaseResult& c : result->cases)
    if (audit.trouble.empty() && loses_points(c)) audit.trouble = c.name + ": " + c.reason;
  return audit;
}

/// One sentence for each patch that does not apply to the solution.
Problems problems_of_patches(const ProjectFolders& folders, const CourseStep& step,
                             const std::vector<fs::path>& patches) {
  Problems problems;
  const TemporaryFolder scratch("atelier-audit");
  for (std::size_t i = 0; i < patches.size(); ++i) try {
      judge::make_patched(folders.solutions() / step.name, patches[i], scratch.path() / std::to_string(i));
    } catch (const Error& error) {
      problems.push_back(error.what());
    }
  return problems;
}

/// Takes one in `sample` out of `all`, the first among them; appends the patches of the others.
template <class Patched>
std::vector<Patched> sampled(const std::vector<Patched>& all, int sample, std::vector<fs::path>& others) {
  std::vector<Patched> taken;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i % std::size_t(sample) == 0) {
      taken.push_back(all[i]);
      continue;
    }
    others.push_back(all[i].patch);
    if constexpr (std::is_same_v<Patched, judge::Mistake>)
      others.insert(others.end(), all[i].spellings.begin(), all[i].spellings.end());
  }
  return taken;
}

void audit_step(const ProjectFolders& folders, const CourseStep& step, int sample, Audit& audit) {
  const grade::Criteria criteria = criteria_of(folders, step);
  const grade::StepJudge judge(criteria);
  judge.require_references();
  std::vector<fs::path> others;
  const auto mistakes = sampled(judge::read_mistakes(folders.mistakes_file(step.name)), sample, others);
  const auto variants =
      sampled(fs::exists(folders.variants_file(step.name)) ? judge::read_variants(folders.variants_file(step.name))
                                                           : std::vector<judge::Variant>{},
              sample, others);

  const Workshop workshop(folders, step);
  std::vector<MistakeAudit> audited_mistakes(mistakes.size());
  std::vector<VariantAudit> audited_variants(variants.size());
  for_each_parallel(mistakes.size() + variants.size(), worker_threads(), [&](std::size_t i) {
    if (i < mistakes.size())
      audited_mistakes[i] = audit_mistake(workshop, criteria, judge, mistakes[i]);
    else
      audited_variants[i - mistakes.size()] = audit_variant(workshop, judge, variants[i - mistakes.size()]);
  });
  audit.mistakes.insert(audit.mistakes.end(), audited_mistakes.begin(), audited_mistakes.end());
  for (const Problems& problems : {problems_of_mistakes(folders, step), problems_of_patches(folders, step, others)})
    audit.problems.insert(audit.problems.end(), problems.begin(), problems.end());
  audit.variants.insert(audit.variants.end(), audited_variants.begin(), audited_variants.end());
}

bool falls_short(const MistakeAudit& m) {
  return !m.built || !m.caught || !m.trouble.empty();
}
bool falls_short(const VariantAudit& v) {
  return !v.passed;
}

OrderedJson or_null(const std::optional<std::string>& text) {
  return text ? OrderedJson(*text) : OrderedJson(nullptr);
}

std::string to_json(const Audit& audit) {
  OrderedJson mistakes = OrderedJson::array(), variants = OrderedJson::array();
  for (const MistakeAudit& m : audit.mistakes)
    mistakes.push_back({{"step", m.step},
                        {"name", m.name},
                        {"built", m.built},
                        {"caught", m.caught},
                        {"expected_case", or_null(m.expected_case)},
                        {"caught_by", or_null(m.caught_by)},
                        {"named", or_null(m.named)},
                        {"trouble", m.trouble}});
  for (const VariantAudit& v : audit.variants)
    variants.push_back({{"step", v.step}, {"name", v.name}, {"passed", v.passed}, {"trouble", v.trouble}});
  return OrderedJson{{"mistakes", mistakes}, {"variants", variants}, {"lacks", audit.problems}}.dump(
             2, ' ', false, OrderedJson::error_handler_t::replace) +
         "\n";
}

void print_table(const Audit& audit) {
  fmt::print("{:<16} {:<28} {:<28} {}\n", "step", "mistake", "first caught by", "named");
  for (const MistakeAudit& m : audit.mistakes) {
    const std::string named = !m.named ? "-" : *m.named == m.name ? "yes" : *m.named;
    fmt::print("{:<16} {:<28} {:<28} {}\n", m.step, m.name, m.caught_by.value_or(m.built ? "nothing" : "not built"),
               named);
    if (!m.trouble.empty()) fmt::print("{:<16}   ! {}\n", "", m.trouble);
  }
  fmt::print("\n{:<16} {:<28} {}\n", "step", "variant", "keeps all points");
  for (const VariantAudit& v : audit.variants) {
    fmt::print("{:<16} {:<28} {}\n", v.step, v.name, v.passed ? "yes" : "NO");
    if (!v.trouble.empty()) fmt::print("{:<16}   ! {}\n", "", v.trouble);
  }
  const auto count = [](const auto& list, auto holds) { return std::count_if(list.begin(), list.end(), holds); };
  fmt::print("\n{} of {} mistakes caught, {} named; {} of {} variants keep all points\n",
             count(audit.mistakes, [](const auto& m) { return m.caught; }), audit.mistakes.size(),
             count(audit.mistakes, [](const auto& m) { return m.named == m.name; }),
             count(audit.variants, [](const auto& v) { return v.passed; }), audit.variants.size());
  fmt::print("{}", in_lines(audit.problems));
}

}  // namespace

int run_audit(const AuditOptions& options) {
  const ProjectFolders folders = project_folders();
  Audit audit;
  for (const CourseStep& step : resolve_steps(read_course(folders.step_flags()), options.steps))
    audit_step(folders, step, options.sample, audit);

  const std::string json = to_json(audit);
  if (!options.out.empty()) write_file(options.out, json);
  if (options.json)
    fmt::print("{}", json);
  else
    print_table(audit);
  const bool short_of =
      !audit.problems.empty() ||
      std::any_of(audit.mistakes.begin(), audit.mistakes.end(), [](auto& m) { return falls_short(m); }) ||
      std::any_of(audit.variants.begin(), audit.variants.end(), [](auto& v) { return falls_short(v); });
  return short_of ? exit_failed : exit_ok;
}

}  // namespace atelier
