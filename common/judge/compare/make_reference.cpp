#include "judge/compare/make_reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <system_error>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/sha256.hpp"
#include "image/compare.hpp"
#include "image_io/image_io.hpp"
#include "judge/compare/gate.hpp"
#include "judge/compare/measure.hpp"
#include "judge/compare/probe.hpp"
#include "judge/compare/sidecar.hpp"
#include "judge/explain/naming.hpp"

namespace atelier::judge {
namespace {

[[noreturn]] void refuse(const JudgedCase& c, const std::string& why) {
  throw Error(fmt::format("case '{}': no reference can be made: {}", c.ask.name, why));
}

// --- The solution's own answer ---

/// Refuses grey between two 8-bit levels: half a level up or down is a matter of the processor there.
void refuse_ties(const JudgedCase& c, const Image& picture) {
  constexpr double near = 0.02;  // of a level; arithmetic differs by about 1e-4 of one, so this leaves much room
  JudgedCase unrounded = c;
  unrounded.profile = Profile::strict;
  const Image encoded = compared_form(picture, unrounded);
  for (int y = 0; y < encoded.height(); ++y)
    for (int x = 0; x < encoded.width(); ++x)
      for (float channel : {encoded.at(x, y).r, encoded.at(x, y).g, encoded.at(x, y).b}) {
        const double level = 255.0 * channel;
        if (std::abs(level - std::floor(level) - 0.5) >= near) continue;
        refuse(c, fmt::format(
                      "pixel ({}, {}) has the value {:.3f}, on the border between two of 255 levels, which the exact "
                      "profile cannot tell apart; change the case's inputs or its profile",
                      x, y, level));
      }
}

/// `who`: "the solution", or "the truth".
void check_right(const JudgedCase& c, const Answer& solution, const std::string& who) {
  if (solution.ended != Answer::Ended::normally) refuse(c, who + " did not answer: " + solution.error);
  if (c.profile == Profile::values) {
    if (!solution.values) refuse(c, who + " returned no numbers");
    return;
  }
  if (!solution.pixels) refuse(c, who + " drew no picture");
  const Image& picture = *solution.pixels;
  if (picture.width() != c.ask.size.x || picture.height() != c.ask.size.y)
    refuse(c, fmt::format("{}'s picture is {}x{} pixels, and the case asks for {}x{}", who, picture.width(),
                          picture.height(), c.ask.size.x, c.ask.size.y));
  if (const auto stopped = stopped_at_gate(picture, {picture}, c)) refuse(c, who + "'s picture: " + stopped->sentence);
  if (is_single_colour(picture)) refuse(c, who + "'s picture is a single colour, which any empty picture could be");
  if (c.profile == Profile::exact && is_colour(c.unit)) refuse_ties(c, picture);
}

/// Right answers of a probe: from the case file, and then the solution must agree, or the solution's.
std::vector<Numbers> expected_values(const JudgedCase& c, const Answer& solution) {
  if (c.expected.empty()) {
    if (solution.values->size() != c.ask.inputs.size())
      refuse(c, fmt::format("the solution answered {} of {} inputs", solution.values->size(), c.ask.inputs.size()));
    return *solution.values;
  }
  const ProbeMeasurement measured = measure_probe(*solution.values, c.expected, c);
  if (!measured.malformed.empty()) refuse(c, "the solution's " + measured.malformed);
  if (!measured.passed)
    refuse(c, fmt::format("at input {} the solution answers {}, and the case file expects {}", measured.worst.input,
                          measured.worst.yours, measured.worst.expected));
  return c.expected;
}

// --- Other answers against it ---

/// What others are compared with: the solution's picture as it is compared, or the probe's right numbers.
struct Right {
  Image raw, picture;
  std::vector<Numbers> values;
};

bool comparable(const JudgedCase& c, const Answer& answer, const Right& right) {
  if (answer.ended != Answer::Ended::normally) return false;
  if (c.profile == Profile::values) return answer.values.has_value();
  return answer.pixels && !stopped_at_gate(*answer.pixels, {right.raw}, c);
}

ChoiceMeasurement choice_of(const JudgedCase& c, const Answer& answer, const Right& right) {
  return measure_choice(*answer.pixels, right.raw, encoding_of(c.unit), answer.counts, *c.choice);
}

/// How many tolerances away an answer lies; what cannot be compared fails in any case.
double margin_of(const JudgedCase& c, const Answer& answer, const Right& right) {
  if (!comparable(c, answer, right)) return largest_margin;
  if (c.choice) return std::min(margin(choice_of(c, answer, right), *c.choice), largest_margin);
  if (c.profile != Profile::values) return margin(compared_form(*answer.pixels, c), right.picture, c);
  const ProbeMeasurement measured = measure_probe(*answer.values, right.values, c);
  return measured.malformed.empty() ? std::min(measured.worst_times, largest_margin) : largest_margin;
}

double failing_share(const JudgedCase& c, const Answer& answer, const Right& right) {
  if (c.choice) return 1;  // credit goes by the error alone
  if (answer.ended != Answer::Ended::normally) return 1;
  if (c.profile == Profile::values) {
    if (!answer.values) return 1;
    const ProbeMeasurement measured = measure_probe(*answer.values, right.values, c);
    return measured.inputs > 0 ? double(measured.wrong) / measured.inputs : 1;
  }
  // A single colour stops at the gate, but its share counts: a background that is right earns nothing.
  if (!answer.pixels || !answer.pixels->same_size(right.picture)) return 1;
  return measure(compared_form(*answer.pixels, c), right.picture, c).share;
}

void check_skeleton(const JudgedCase& c, const ReferenceMaterial& material, const Right& right, MadeReference& made) {
  if (!material.skeleton) return;
  made.skeleton_share = failing_share(c, *material.skeleton, right);
  if (c.choice && comparable(c, *material.skeleton, right) && choice_of(c, *material.skeleton, right).credit > 0)
    refuse(c, "the untouched skeleton's choice earns points: let \"none\" be no more than its error");
  if (c.student && c.points > 0 && margin_of(c, *material.skeleton, right) < 1)
    refuse(c, "the untouched skeleton passes it; choose another picture, or say \"student\": false");
}

void check_mistakes(const JudgedCase& c, const ReferenceMaterial& material, const Right& right, MadeReference& made) {
  for (const auto& [mistake, answer] : material.mistakes) made.margins[mistake] = margin_of(c, answer, right);
  for (const std::string& claimed : c.rejects) {
    const auto found = made.margins.find(claimed);
    if (found == made.margins.end()) refuse(c, fmt::format("it claims to reject '{}', which was not drawn", claimed));
    // Where there is nothing to be compared nothing is proven, unless the mistake itself ended the program.
    if (const Answer& answer = material.mistakes.at(claimed);
        answer.ended == Answer::Ended::missing || answer.ended == Answer::Ended::build_failed)
      refuse(c, fmt::format("it claims to reject '{}', which has no answer: {}", claimed, answer.error));
    if (found->second < least_margin)
      refuse(c, fmt::format(
                    "it claims to reject '{}', which lies {:.2f} tolerances away where at least {:.2g} are needed; "
                    "choose another camera, scene or setting, tighten the tolerance, or drop the claim",
                    claimed, found->second, least_margin));
    if (made.nearest && made.margin <= found->second) continue;
    made.nearest = claimed;
    made.margin = found->second;
  }
}

Right right_answer(const JudgedCase& c, const ReferenceMaterial& material) {
  const Answer& solution = material.solution;
  check_right(c, solution, "the solution");
  Right right;
  if (c.choice) {
    if (!material.truth) refuse(c, "there is no truth to compare a choice with");
    check_right(c, *material.truth, "the truth");
    right.raw = *material.truth->pixels;
    right.picture = compared_form(right.raw, c);
    const ChoiceMeasurement own = choice_of(c, solution, right);
    if (!own.passed())
      refuse(c,
             "the solution's own choice does not earn all points: " + describe_choice(own, solution.counts, *c.choice));
    return right;
  }
  if (c.profile == Profile::values) {
    right.values = expected_values(c, solution);
  } else {
    right.raw = *solution.pixels;
    right.picture = compared_form(right.raw, c);
  }
  return right;
}

MadeReference check_against(const JudgedCase& c, const ReferenceMaterial& material, const Right& right) {
  MadeReference made;
  check_skeleton(c, material, right, made);
  check_mistakes(c, material, right, made);
  return made;
}

// --- Writing ---

/// Half floats hold colours eight times finer than 8-bit sRGB; data, exact colours and very bright ones keep all bits.
Depth depth_for(const JudgedCase& c, const Image& picture) {
  constexpr float largest_half = 65504;
  if (!is_colour(c.unit) || c.profile == Profile::exact || c.choice) return Depth::single;
  for (const Rgba& p : picture.pixels())
    if (std::max({std::abs(p.r), std::abs(p.g), std::abs(p.b)}) > largest_half) return Depth::single;
  return Depth::half;
}

/// Writes the pictures of the mistakes that this case sees, one below the other; returns their names in this order.
std::vector<std::string> write_atlas(const std::filesystem::path& folder, const JudgedCase& c,
                                     const ReferenceMaterial& material, const Right& right, MadeReference& made) {
  std::vector<std::string> names;
  std::vector<Rgba> pixels;
  Image picture;
  if (!c.choice)  // what is too dear looks like the truth: a choice is no picture to be recognised by
    for (const auto& [mistake, answer] : material.mistakes) {
      // A mistake that this case does not see has nothing to be recognised by.
      const bool drawn = answer.ended == Answer::Ended::normally && answer.pixels &&
                         answer.pixels->same_size(right.raw) && find_non_finite(*answer.pixels).count == 0;
      if (!drawn || made.margins.at(mistake) < 1) continue;
      picture = make_atlas_picture(compared_form(*answer.pixels, c), right.picture, c.unit);
      pixels.insert(pixels.end(), picture.pixels().begin(), picture.pixels().end());
      names.push_back(mistake);
    }
  const std::filesystem::path file = atlas_path(folder, c.ask.name);
  if (names.empty()) {
    std::error_code ignored;
    std::filesystem::remove(file, ignored);
    return names;
  }
  Image atlas(picture.width(), picture.height() * int(names.size()));
  std::copy(pixels.begin(), pixels.end(), atlas.pixels().begin());
  write_image(file, atlas, {Encoding::data, Depth::bits8});
  made.written.push_back(file);
  return names;
}

void write_picture(const std::filesystem::path& folder, const JudgedCase& c, const ReferenceMaterial& material,
                   const Right& right, Sidecar& sidecar, MadeReference& made) {
  if (c.references.empty()) refuse(c, "it names no reference file");
  const std::filesystem::path file = folder / c.references.front().filename();
  const Encoding encoding = c.unit == Unit::colour ? Encoding::linear : Encoding::data;
  const Depth depth = file.extension() == ".exr" ? depth_for(c, right.raw) : Depth::automatic;
  write_image(file, right.raw, {encoding, depth});
  made.written = {file, sidecar_path(file)};
  sidecar.sha256 = sha256(read_file(file));
  sidecar.atlas = write_atlas(folder, c, material, right, made);
  write_sidecar(sidecar_path(file), sidecar);
}

void write_values(const std::filesystem::path& folder, const JudgedCase& c, const ReferenceMaterial& material,
                  const Right& right, Sidecar& sidecar, MadeReference& made) {
  if (c.expected.empty()) sidecar.values = right.values;
  const std::filesystem::path file = values_path(folder, c.ask.name);
  write_sidecar(file, sidecar);
  made.written = {file};

  WrongValues wrong;
  for (const auto& [mistake, answer] : material.mistakes)
    if (answer.ended == Answer::Ended::normally && answer.values && made.margins.at(mistake) >= 1)
      wrong[mistake] = *answer.values;
  const std::filesystem::path atlas = wrong_values_path(folder, c.ask.name);
  if (wrong.empty()) {
    std::error_code ignored;
    std::filesystem::remove(atlas, ignored);
    return;
  }
  write_wrong_values(atlas, wrong);
  made.written.push_back(atlas);
}

}  // namespace

MadeReference check_reference(const JudgedCase& c, const ReferenceMaterial& material) {
  return check_against(c, material, right_answer(c, material));
}

MadeReference make_reference(const std::filesystem::path& folder, const JudgedCase& c,
                             const ReferenceMaterial& material) {
  const Right right = right_answer(c, material);
  MadeReference made = check_against(c, material, right);

  Sidecar sidecar;
  sidecar.case_name = c.ask.name;
  sidecar.profile = c.profile;
  sidecar.unit = c.unit;
  sidecar.delta = c.delta;
  sidecar.budget = c.budget;
  sidecar.exposure = c.exposure;
  sidecar.mask = c.mask;
  sidecar.regions = c.regions;
  sidecar.reason = c.reason;
  sidecar.environment = material.environment;
  sidecar.skeleton_share = made.skeleton_share;
  sidecar.nearest = made.nearest;
  sidecar.margin = made.margin;
  const auto write = c.profile == Profile::values ? write_values : write_picture;
  write(folder, c, material, right, sidecar, made);
  return made;
}

}  // namespace atelier::judge
