#include "grade/course/grading_rules.hpp"

#include "catch.hpp"
#include "class_sample.hpp"

using namespace atelier;
using namespace atelier::grade;
using atelier::test::step_record;
using State = StepRecord::State;

namespace {

constexpr std::int64_t minute = 60, hour = 60 * minute, one_day = 24 * hour, deadline = 1'000'000'000;

CourseFile course_with_deadline() {
  CourseFile course;
  course.steps = {{.step = "01-transforms", .points = 20, .deadline = deadline, .deadline_text = ""}};
  course.late = {.percent_per_day = 10, .grace_minutes = 15, .days = 3};
  return course;
}

SubmissionRecord one_step(double score, double max_score, State state = State::judged) {
  SubmissionRecord record{.student = {.id = "a", .name = "", .identifier = ""}};
  record.steps = {step_record("01-transforms", score, max_score, state)};
  return record;
}

}  // namespace

TEST_CASE("without rules the points are those of the cases") {
  const Grade grade = grade_of(test::ada(), {});
  CHECK(grade.points == 19.5);
  CHECK(grade.max_points == 30);
  REQUIRE(grade.steps.size() == 2);
  CHECK(grade.steps[1].points == 12);
  CHECK_FALSE(grade.late);
  CHECK(grade.needs_human.empty());
}

TEST_CASE("a step's points scale its cases, and only listed steps count") {
  CourseFile course;
  course.steps = {{.step = "02-blinn-phong", .points = 5, .deadline = {}, .deadline_text = ""},
                  {.step = "03-shadow-mapping", .points = 7, .deadline = {}, .deadline_text = ""}};
  const Grade grade = grade_of(test::ada(), course);
  REQUIRE(grade.steps.size() == 2);
  CHECK(grade.steps[0].points == 3);
  CHECK(grade.steps[0].max_points == 5);
  CHECK(grade.steps[1].state == State::not_handed_in);
  CHECK(grade.steps[1].max_points == 7);
  CHECK(grade.points == 3);
  CHECK(grade.max_points == 12);
}

TEST_CASE("tiers count, are a bonus, or are ignored") {
  SubmissionRecord record = one_step(0, 0);
  record.steps[0].tiers = {{"core", {6, 10}}, {"further", {4, 5}}, {"challenge", {2, 5}}};
  struct Row {
    const char* name;
    TierRule further, challenge;
    std::optional<double> points;
    double expected, expected_max;
  };
  const Row rows[] = {
      {"all count", TierRule::counts, TierRule::counts, {}, 12, 20},
      {"a bonus", TierRule::counts, TierRule::bonus, {}, 12, 15},
      {"ignored", TierRule::counts, TierRule::ignored, {}, 10, 15},
      {"scaled", TierRule::ignored, TierRule::ignored, 20, 12, 20},
      {"a bonus by the same scale", TierRule::bonus, TierRule::ignored, 20, 20, 20},
      {"more than all", TierRule::bonus, TierRule::bonus, 20, 24, 20},
      {"worth nothing", TierRule::counts, TierRule::counts, 0, 0, 0},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    CourseFile course;
    course.steps = {{.step = "01-transforms", .points = row.points, .deadline = {}, .deadline_text = ""}};
    course.tiers["further"] = row.further, course.tiers["challenge"] = row.challenge;
    const Grade grade = grade_of(record, course);
    CHECK(grade.points == Approx(row.expected));
    CHECK(grade.max_points == Approx(row.expected_max));
  }
  SubmissionRecord older = one_step(3, 4);
  older.steps[0].tiers.clear();
  CHECK(grade_of(older, {}).points == 3);  // without tiers all are core
}

TEST_CASE("started days after the deadline cost points, and grace is free") {
  struct Row {
    const char* name;
    std::int64_t after;  ///< the deadline, in seconds
    int days;
    double points, penalty;  ///< of 16 earned
  };
  const Row rows[] = {
      {"long before", -one_day, 0, 16, 0},
      {"on the second", 0, 0, 16, 0},
      {"at the end of the grace", 15 * minute, 0, 16, 0},
      {"a second after it", 15 * minute + 1, 1, 14.4, 1.6},
      {"a day", one_day, 1, 14.4, 1.6},
      {"a day and a second", one_day + 1, 2, 12.8, 3.2},
      {"the last day", 3 * one_day, 3, 11.2, 4.8},
      {"too late", 3 * one_day + 1, 4, 0, 16},
      {"years", 4000 * one_day, 4000, 0, 16},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    SubmissionRecord record = one_step(8, 10);
    record.handed_in = deadline + row.after;
    record.late = true;  // the deadline decides, not the mark
    const Grade grade = grade_of(record, course_with_deadline());
    CHECK(grade.steps[0].days_late == row.days);
    CHECK(grade.steps[0].points == Approx(row.points));
    CHECK(grade.steps[0].penalty == Approx(row.penalty));
    CHECK(grade.late == (row.days > 0));
    CHECK(grade.needs_human.empty());
  }
  CourseFile steep = course_with_deadline();
  steep.late = {.percent_per_day = 40, .grace_minutes = 0, .days = {}};
  SubmissionRecord record = one_step(8, 10);
  record.handed_in = deadline + 5 * one_day;
  CHECK(grade_of(record, steep).points == 0);  // never negative
}

TEST_CASE("whether something is late is left to a person where no time is known") {
  SubmissionRecord record = one_step(8, 10);
  record.needs_human = {"Look."};
  record.late = true;
  const Grade grade = grade_of(record, course_with_deadline());
  CHECK(grade.points == 16);
  CHECK(grade.late);
  REQUIRE(grade.needs_human.size() == 2);
  CHECK(test::mentions(grade.needs_human[1], {"late", "no points were taken off"}));
  record.late = false;
  CHECK(grade_of(record, course_with_deadline()).needs_human.size() == 1);
  record.late = true;
  CHECK(grade_of(record, {}).needs_human.size() == 1);  // no deadline: the mark is only told
  CHECK(grade_of(record, {}).late);
  SubmissionRecord absent = one_step(0, 10, State::not_handed_in);
  absent.handed_in = deadline + one_day;
  CHECK(grade_of(absent, course_with_deadline()).steps[0].days_late == 0);
}

TEST_CASE("points are rounded down to hundredths, and the total is not the sum of rounded ones") {
  CHECK(rounded_points(0.29) == 0.29);
  CHECK(rounded_points(1.0 / 3) == 0.33);
  CHECK(rounded_points(9.999) == 9.99);
  CHECK(rounded_points(10) == 10);
  SubmissionRecord record = one_step(1.0 / 3, 1);
  record.steps.push_back(step_record("02-blinn-phong", 1.0 / 3, 1));
  record.steps.push_back(step_record("03-shadow-mapping", 1.0 / 3, 1));
  CHECK(grade_of(record, {}).points == 1);
}

TEST_CASE("a person's adjustment changes the total, but not below 0") {
  CHECK(grade_of(one_step(8, 10), {}, 1.5).points == 9.5);
  CHECK(grade_of(one_step(8, 10), {}, 5).points == 13);
  CHECK(grade_of(one_step(8, 10), {}, -9).points == 0);
}

TEST_CASE("the last version counts, or the best") {
  CourseFile course;
  const std::vector<SubmissionRecord> versions = {one_step(3, 10), one_step(8, 10), one_step(8, 10), one_step(5, 10)};
  CHECK(counting_version(versions, course) == 3);
  course.attempts = Attempts::best;
  CHECK(counting_version(versions, course) == 2);
  // A late one is worth less.
  CourseFile strict = course_with_deadline();
  strict.attempts = Attempts::best;
  std::vector<SubmissionRecord> late = {one_step(8, 10), one_step(10, 10)};
  late[0].handed_in = deadline, late[1].handed_in = deadline + 3 * one_day;
  CHECK(counting_version(late, strict) == 0);
}
