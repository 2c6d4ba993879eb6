#include "class_sample.hpp"

#include <fmt/format.h>

#include <iterator>

namespace atelier::test {

using grade::StepRecord;
using grade::SubmissionRecord;

namespace {

struct MadeUpStep {
  const char *step, *title, *mistake, *mistake_title, *sentence;
  double max_score;
};

constexpr MadeUpStep made_up_steps[] = {
    {"01-transforms", "Transforms and vertex buffers", "transposed", "A matrix is transposed",
     "It looks as if rows and columns of the model matrix were swapped: what should move turns.", 20},
    {"02-blinn-phong", "Light and materials after Blinn and Phong", "rv-for-nh", "Phong's R.V instead of Blinn's N.H",
     "It looks as if the mirrored direction were compared with the eye: the highlight is about half as wide.", 41},
    {"03-shadow-mapping", "Shadow mapping", "no-bias", "The depth bias is missing",
     "It looks as if nothing were subtracted from the depth: lit surfaces have stripes.", 30},
    {"04-point-shadows", "Shadows of point lights", "one-face", "Only one face of the cube", "One side is lit.", 12.5},
    {"05-normal-mapping", "Normal mapping", "left-handed", "The frame is left-handed", "Bumps are dents.", 135},
    {"06-parallax-mapping", "Parallax mapping", "no-secant", "The last step is missing", "There are steps.", 113},
    {"07-stencil-portals", "Portals", "no-clip", "Nothing is clipped at the exit", "A wall is in the way.", 140},
    {"08-post-processing", "After the scene", "twice-encoded", "Colours are encoded twice", "All is too light.", 105},
    {"09-dithering", "Dithering", "wrong-row", "Errors go to the row above",
     "It looks as if the error were added to pixels that are finished.", 25},
    {"10-artstyles", "Art styles", "no-outline", "Outlines are missing", "Edges are lost.", 117},
    {"11-skin", "Skin", "no-blur", "Light is not spread", "Skin looks like stone.", 1},
    {"12-gallery", "The gallery", "stale", "Pictures are not recorded again", "A painting shows the past.", 114}};

/// Numbers that look random and are always the same: a linear congruential generator (Knuth).
class Numbers {
 public:
  int below(int limit) {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return int((state_ >> 33) % std::uint64_t(limit));
  }

 private:
  std::uint64_t state_ = 42;
};

StepRecord made_up_step(const MadeUpStep& step, Numbers& numbers) {
  using State = StepRecord::State;
  const int luck = numbers.below(100);
  if (luck < 8) return step_record(step.step, 0, step.max_score, State::not_handed_in);
  if (luck < 12) return step_record(step.step, 0, step.max_score, State::not_built);
  if (luck < 15) return step_record(step.step, 0, step.max_score, State::untouched);
  if (luck < 45) return step_record(step.step, step.max_score, step.max_score);
  StepRecord record = step_record(step.step, step.max_score * (30 + numbers.below(70)) / 100, step.max_score);
  if (numbers.below(2) == 0) record.mistakes[step.mistake] = 1 + numbers.below(4);
  return record;
}

}  // namespace

StepRecord step_record(const std::string& step, double score, double max_score, StepRecord::State state) {
  StepRecord record{.step = step, .state = state, .score = score, .max_score = max_score};
  record.tiers["core"] = {score, max_score};
  return record;
}

SubmissionRecord ada() {
  SubmissionRecord record{.student = {"ada-lovelace", "Ada Lovelace", "4711"}, .source = "Ada Lovelace_4711_file"};
  record.handed_in = 1'793'660'340;  // 2026-11-02 22:59 UTC
  record.steps = {step_record("01-transforms", 7.5, 10), step_record("02-blinn-phong", 12, 20)};
  record.steps[1].mistakes = {{"rv-for-nh", 3}};
  record.sandbox = "full";
  record.seconds = {{"compile", 2.5}, {"render", 4}, {"wait", 100}};
  return record;
}

std::vector<SubmissionRecord> made_up_class(int count) {
  constexpr const char* first[] = {"Ada",   "Grace",      "Käthe",   "Alan",     "Łukasz",
                                   "Sofía", "Jun'ichirō", "Barbara", "Ole-Johan"};
  constexpr const char* last[] = {"Lovelace", "Hopper", "Müller", "Turing", "O'Brien", "van der Berg", "Ng"};
  Numbers numbers;
  std::vector<SubmissionRecord> records;
  for (int i = 0; i < count; ++i) {
    const std::string name = fmt::format("{} {}", first[i % std::size(first)], last[i % std::size(last)]);
    SubmissionRecord record{.student = {fmt::format("student-{:03}", i), name, std::to_string(40'000 + i)}};
    record.source = fmt::format("{}_{}_assignsubmission_file", name, 40'000 + i);
    record.handed_in = 1'793'660'340 + numbers.below(30) * 3600 - 24 * 3600;
    for (const MadeUpStep& step : made_up_steps) record.steps.push_back(made_up_step(step, numbers));
    record.seconds = {
        {"compile", 4 + numbers.below(60) / 10.0}, {"render", 8 + numbers.below(300) / 10.0}, {"wait", 60}};
    record.sandbox = "full";
    if (i % 17 == 3) record.needs_human = {"02-blinn-phong: the file blinn_phong.glsl is a symbolic link."};
    if (i % 23 == 5) record.needs_human.push_back("Two archives have the same time; the second by name was taken.");
    records.push_back(record);
  }
  return records;
}

grade::ClassSummary made_up_summary() {
  grade::ClassSummary summary{.name = "homework-2", .platform = "moodle", .seconds = 254};
  summary.ignored = {"desktop.ini: is no folder and no archive"};
  summary.environment = {{"driver", "Mesa 22.3.6, llvmpipe (LLVM 15.0.6, 256 bits)"}, {"compiler", "g++ 12.2.0"}};
  for (const MadeUpStep& step : made_up_steps)
    summary.steps.push_back(
        {step.step, step.title, {{.name = step.mistake, .title = step.mistake_title, .sentence = step.sentence}}});
  return summary;
}

}  // namespace atelier::test
