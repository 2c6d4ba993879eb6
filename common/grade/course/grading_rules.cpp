#include "grade/course/grading_rules.hpp"

#include <algorithm>
#include <cmath>

namespace atelier::grade {
namespace {

constexpr std::int64_t seconds_per_day = 24 * 60 * 60;

/// A step's grade before it is rounded.
struct Exact {
  double points = 0, max_points = 0, penalty = 0;
};

/// Adds what a tier earns.
void add_tier(const TierPoints& tier, TierRule rule, Exact& sum) {
  if (rule != TierRule::ignored) sum.points += tier.score;
  if (rule == TierRule::counts) sum.max_points += tier.max_score;
}

Exact scaled_points(const StepRecord& step, const CourseFile& course, const StepRules* rules) {
  Exact sum;
  for (const auto& [tier, points] : step.tiers) {
    const auto rule = course.tiers.find(tier);
    add_tier(points, rule == course.tiers.end() ? TierRule::counts : rule->second, sum);
  }
  if (step.tiers.empty()) add_tier({step.score, step.max_score}, course.tiers.at("core"), sum);
  if (rules == nullptr || !rules->points || sum.max_points == 0) return sum;
  const double scale = *rules->points / sum.max_points;
  return {.points = sum.points * scale, .max_points = *rules->points};
}

/// Started days after the deadline; 0: in time.
int days_late(std::int64_t handed_in, std::int64_t deadline, const LatePenalty& late) {
  const std::int64_t seconds = handed_in - deadline;
  if (seconds <= std::int64_t(late.grace_minutes) * 60) return 0;
  return int(std::min<std::int64_t>((seconds + seconds_per_day - 1) / seconds_per_day, 1'000'000));
}

/// The share of the points that is taken off, 0..1.
double share_off(int days, const LatePenalty& late) {
  if (days == 0) return 0;
  if (late.days && days > *late.days) return 1;
  return std::min(1.0, days * late.percent_per_day / 100);
}

}  // namespace

double rounded_points(double points) {
  return std::floor(points * 100 + 1e-6) / 100;
}

Grade grade_of(const SubmissionRecord& record, const CourseFile& course, double adjustment) {
  Grade grade{.steps = {}, .adjustment = adjustment, .needs_human = record.needs_human};
  double sum = 0;
  bool decided = false;  // a deadline has decided whether a step is late
  bool open = false;     // a step has a deadline, and nobody knows the time
  const auto add = [&](const StepRecord& step) {
    const StepRules* const rules = course.rules(step.step);
    Exact exact = scaled_points(step, course, rules);
    StepGrade of_step{.step = step.step, .state = step.state};
    if (rules != nullptr && rules->deadline && step.state != StepRecord::State::not_handed_in) {
      (record.handed_in ? decided : open) = true;
      if (record.handed_in) of_step.days_late = days_late(*record.handed_in, *rules->deadline, course.late);
    }
    exact.penalty = exact.points * share_off(of_step.days_late, course.late);
    of_step.points = rounded_points(exact.points - exact.penalty);
    of_step.penalty = rounded_points(exact.penalty);
    of_step.max_points = rounded_points(exact.max_points);
    grade.late = grade.late || of_step.days_late > 0;
    sum += exact.points - exact.penalty;
    grade.max_points += exact.max_points;
    grade.steps.push_back(of_step);
  };

  for (const StepRecord& step : record.steps)
    if (course.counts(step.step)) add(step);
  for (const StepRules& rules : course.steps) {
    const auto same = [&](const StepRecord& step) { return step.step == rules.step; };
    if (std::none_of(record.steps.begin(), record.steps.end(), same)) {
      const double points = rules.points.value_or(0);
      add({.step = rules.step, .state = StepRecord::State::not_handed_in, .max_score = points});
    }
  }
  std::sort(grade.steps.begin(), grade.steps.end(), [](const auto& a, const auto& b) { return a.step < b.step; });

  if (!decided) grade.late = record.late;
  if (open && record.late)
    grade.needs_human.push_back(
        "The platform marks it as late, but its time is not known: no points were taken off for that.");
  grade.points = std::max(0.0, rounded_points(sum + adjustment));
  grade.max_points = rounded_points(grade.max_points);
  return grade;
}

std::size_t counting_version(const std::vector<SubmissionRecord>& versions, const CourseFile& course) {
  std::size_t counting = versions.size() - 1;
  if (course.attempts == Attempts::last) return counting;
  for (std::size_t i = versions.size(); i-- > 0;)
    if (grade_of(versions[i], course).points > grade_of(versions[counting], course).points) counting = i;
  return counting;
}

}  // namespace atelier::grade
