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
  throw Error(fmt::format("case '{}': cannot make a reference: {}", c.ask.name, why));
}

// --- The solution's answer ---

/// Refuses a value halfway between two 8-bit levels, where rounding depends on the processor.
void refuse_ties(const JudgedCase& c, const Image& picture) {
  constexpr double near = 0.02;  // of a level; arithmetic differs by only about 1e-4 of a level
  JudgedCase unrounded = c;
  unrounded.profile = Profile::strict;
  const Image encoded = compared_form(picture, unrounded);
  for (int y = 0; y < encoded.height(); ++y)
    for (int x = 0; x < encoded.width(); ++x)
      for (float channel : {encoded.at(x, y).r, encoded.at(x, y).g, encoded.at(x, y).b}) {
        const double level = 255.0 * channel;
        if (std::abs(level - std::floor(level) - 0.5) >= near) continue;
        refuse(c, fmt::format(
                      "pixel ({}, {}) has the value {:.3f}, halfway between two of 255 levels, where rounding depends "
                      "on the processor; change the case's inputs or its profile",
                      x, y, level));
      }
}

/// `who`: "the solution", or "the truth".
void check_correct(const JudgedCase& c, const Answer& solution, const std::string& who) {
  if (solution.ended != Answer::Ended::normally) refuse(c, who + " did not answer: " + solution.error);
  if (c.profile == Profile::values) {
    if (!solution.values) refuse(c, who + " returned no numbers");
    return;
  }
  if (!solution.pixels) refuse(c, who + " drew no picture");
  const Image& picture = *solution.pixels;
  if (picture.width() != c.ask.size.x || picture.height() != c.ask.size.y)
    refuse(c, fmt::format("{}'s picture is {}x{} pixels; the case requires {}x{}", who, picture.width(),
                          picture.height(), c.ask.size.x, c.ask.size.y));
  if (const auto stopped = find_gate_failure(picture, {picture}, c))
    refuse(c, who + "'s picture: " + stopped->sentence);
  if (is_single_colour(picture)) refuse(c, who + "'s picture is a single colour, as an empty picture would be");
  if (c.profile == Profile::exact && is_colour(c.unit)) refuse_ties(c, picture);
}

/// The expected numbers of a probe: those in the case file, with which the solution must agree, or the solution's.
std::vector<Numbers> expected_values(const JudgedCase& c, const Answer& solution) {
  if (c.expected.empty()) {
    if (solution.values->size() != c.ask.inputs.size())
      refuse(c, fmt::format("the solution answered {} of {} inputs", solution.values->size(), c.ask.inputs.size()));
    return *solution.values;
  }
  const ProbeMeasurement measured = measure_probe(*solution.values, c.expected, c);
  if (!measured.malformed.empty()) refuse(c, "the solution's " + measured.malformed);
  if (!measured.passed)
    refuse(c, fmt::format("for input {} the solution returns {}; the case file expects {}", measured.worst.input,
                          measured.worst.yours, measured.worst.expected));
  return c.expected;
}

// --- Other answers ---

/// What other answers are compared with: a picture, raw and in compared form, or the expected numbers of a probe.
struct CorrectAnswer {
  Image raw, picture;
  std::vector<Numbers> values;
};

bool comparable(const JudgedCase& c, const Answer& answer, const CorrectAnswer& correct) {
  if (answer.ended != Answer::Ended::normally) return false;
  if (c.profile == Profile::values) return answer.values.has_value();
  return answer.pixels && !find_gate_failure(*answer.pixels, {correct.raw}, c);
}

ChoiceMeasurement choice_of(const JudgedCase& c, const Answer& answer, const CorrectAnswer& correct) {
  return measure_choice(*answer.pixels, correct.raw, encoding_of(c.unit), answer.counts, *c.choice);
}

/// The distance of an answer in tolerances; max_margin if it cannot be compared, and so fails.
double margin_of(const JudgedCase& c, const Answer& answer, const CorrectAnswer& correct) {
  if (!comparable(c, answer, correct)) return max_margin;
  if (c.choice) return std::min(margin(choice_of(c, answer, correct), *c.choice), max_margin);
  if (c.profile != Profile::values) return margin(compared_form(*answer.pixels, c), correct.picture, c);
  const ProbeMeasurement measured = measure_probe(*answer.values, correct.values, c);
  return measured.malformed.empty() ? std::min(measured.worst_times, max_margin) : max_margin;
}

bool fails(const JudgedCase& c, const Answer& answer, const CorrectAnswer& correct) {
  if (c.choice && comparable(c, answer, correct)) return !choice_of(c, answer, correct).passed();
  return margin_of(c, answer, correct) >= 1;
}

double failing_fraction(const JudgedCase& c, const Answer& answer, const CorrectAnswer& correct) {
  if (c.choice) return 1;  // credit depends only on the error
  if (answer.ended != Answer::Ended::normally) return 1;
  if (c.profile == Profile::values) {
    if (!answer.values) return 1;
    const ProbeMeasurement measured = measure_probe(*answer.values, correct.values, c);
    return measured.inputs > 0 ? double(measured.wrong) / measured.inputs : 1;
  }
  // A picture of a single colour fails at the gate, but its fraction counts: a correct background must earn nothing.
  if (!answer.pixels || !answer.pixels->same_size(correct.picture)) return 1;
  return measure(compared_form(*answer.pixels, c), correct.picture, c).failing_fraction;
}

void check_skeleton(const JudgedCase& c, const ReferenceMaterial& material, const CorrectAnswer& correct,
                    MadeReference& made) {
  if (!material.skeleton) return;
  made.skeleton_fraction = failing_fraction(c, *material.skeleton, correct);
  if (c.choice && comparable(c, *material.skeleton, correct) && choice_of(c, *material.skeleton, correct).credit > 0)
    refuse(c, "the untouched skeleton's choice earns points: set \"none\" to at most its error");
  if (c.student && c.points > 0 && margin_of(c, *material.skeleton, correct) < 1)
    refuse(c, "the untouched skeleton passes it; choose another picture, or set \"student\": false");
}

void check_mistakes(const JudgedCase& c, const ReferenceMaterial& material, const CorrectAnswer& correct,
                    MadeReference& made) {
  for (const auto& [mistake, answer] : material.mistakes) made.margins[mistake] = margin_of(c, answer, correct);
  for (const std::string& claimed : c.rejects) {
    const auto found = made.margins.find(claimed);
    if (found == made.margins.end()) refuse(c, fmt::format("it claims to reject '{}', which was not drawn", claimed));
    // Without an answer nothing is proven, unless the mistake itself ended the program.
    if (const Answer& answer = material.mistakes.at(claimed);
        answer.ended == Answer::Ended::missing || answer.ended == Answer::Ended::build_failed)
      refuse(c, fmt::format("it claims to reject '{}', which has no answer: {}", claimed, answer.error));
    if (found->second < min_margin)
      refuse(c, fmt::format("it claims to reject '{}', which is {:.2f} tolerances away; at least {:.2g} are required; "
                            "choose another camera, scene or setting, tighten the tolerance, or remove the claim",
                            claimed, found->second, min_margin));
    if (made.nearest && made.margin <= found->second) continue;
    made.nearest = claimed;
    made.margin = found->second;
  }
}

CorrectAnswer correct_answer(const JudgedCase& c, const ReferenceMaterial& material) {
  const Answer& solution = material.solution;
  check_correct(c, solution, "the solution");
  CorrectAnswer correct;
  if (c.choice) {
    if (!material.truth) refuse(c, "there is no truth to compare a choice with");
    check_correct(c, *material.truth, "the truth");
    correct.raw = *material.truth->pixels;
    correct.picture = compared_form(correct.raw, c);
    const ChoiceMeasurement own = choice_of(c, solution, correct);
    if (!own.passed())
      refuse(c, "the solution's choice does not earn all points: " + describe_choice(own, solution.counts, *c.choice));
    return correct;
  }
  if (c.profile == Profile::values) {
    correct.values = expected_values(c, solution);
  } else {
    correct.raw = *solution.pixels;
    correct.picture = compared_form(correct.raw, c);
  }
  return correct;
}

MadeReference check_against(const JudgedCase& c, const ReferenceMaterial& material, const CorrectAnswer& correct) {
  MadeReference made;
  check_skeleton(c, material, correct, made);
  check_mistakes(c, material, correct, made);
  return made;
}

// --- Writing ---

/// Half floats store colours eight times finer than 8-bit sRGB. Data, exact colours and very bright ones need 32 bits.
Depth depth_for(const JudgedCase& c, const Image& picture) {
  constexpr float largest_half = 65504;
  if (!is_colour(c.unit) || c.profile == Profile::exact || c.choice) return Depth::single;
  for (const Rgba& p : picture.pixels())
    if (std::max({std::abs(p.r), std::abs(p.g), std::abs(p.b)}) > largest_half) return Depth::single;
  return Depth::half;
}

/// Writes the pictures of the mistakes that this case detects, one below the other; returns their names in this order.
std::vector<std::string> write_atlas(const std::filesystem::path& folder, const JudgedCase& c,
                                     const ReferenceMaterial& material, const CorrectAnswer& correct,
                                     MadeReference& made) {
  std::vector<std::string> names;
  std::vector<Rgba> pixels;
  Image picture;
  if (!c.choice)  // a budget case has none: a picture that is too expensive looks like the truth
    for (const auto& [mistake, answer] : material.mistakes) {
      // Leave out mistakes that this case does not detect.
      const bool drawn = answer.ended == Answer::Ended::normally && answer.pixels &&
                         answer.pixels->same_size(correct.raw) && find_non_finite(*answer.pixels).count == 0;
      if (!drawn || made.margins.at(mistake) < 1) continue;
      picture = make_atlas_picture(compared_form(*answer.pixels, c), correct.picture, c.unit);
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
                   const CorrectAnswer& correct, Sidecar& sidecar, MadeReference& made) {
  if (c.references.empty()) refuse(c, "it names no reference file");
  const std::filesystem::path file = folder / c.references.front().filename();
  const Encoding encoding = c.unit == Unit::colour ? Encoding::linear : Encoding::data;
  const Depth depth = file.extension() == ".exr" ? depth_for(c, correct.raw) : Depth::automatic;
  write_image(file, correct.raw, {encoding, depth});
  made.written = {file, sidecar_path(file)};
  sidecar.sha256 = sha256(read_file(file));
  sidecar.atlas = write_atlas(folder, c, material, correct, made);
  write_sidecar(sidecar_path(file), sidecar);
  if (!c.choice) return;
  WrongValues wrong;
  for (const auto& [mistake, answer] : material.mistakes)
    if (comparable(c, answer, correct) && fails(c, answer, correct))
      wrong.mistakes[mistake] = {exceeded(choice_of(c, answer, correct), answer.counts, *c.choice)};
  write_wrong_values(wrong_values_path(folder, c.ask.name), wrong);
  made.written.push_back(wrong_values_path(folder, c.ask.name));
}

void write_values(const std::filesystem::path& folder, const JudgedCase& c, const ReferenceMaterial& material,
                  const CorrectAnswer& correct, Sidecar& sidecar, MadeReference& made) {
  if (c.expected.empty()) sidecar.values = correct.values;
  const std::filesystem::path file = values_path(folder, c.ask.name);
  write_sidecar(file, sidecar);
  made.written = {file};

  WrongValues wrong;
  const auto is_wrong = [&](const Answer& answer) {
    return comparable(c, answer, correct) && margin_of(c, answer, correct) >= 1;
  };
  for (const auto& [mistake, answer] : material.mistakes) {
    std::map<std::string, const Answer*> forms{{mistake, &answer}};
    if (const auto found = material.spellings.find(mistake); found != material.spellings.end())
      for (std::size_t k = 0; k < found->second.size(); ++k) forms[form_of_spelling(mistake, k)] = &found->second[k];
    std::erase_if(forms, [&](const auto& form) { return !comparable(c, *form.second, correct); });
    if (std::none_of(forms.begin(), forms.end(), [&](const auto& form) { return is_wrong(*form.second); })) continue;
    for (const auto& [form, given] : forms)
      wrong.mistakes[form] = is_wrong(*given) ? *given->values : std::vector<Numbers>();
  }
  const auto add_unwritten = [&](const Answer& answer) {
    if (is_wrong(answer) &&
        std::find(wrong.unwritten.begin(), wrong.unwritten.end(), *answer.values) == wrong.unwritten.end())
      wrong.unwritten.push_back(*answer.values);
  };
  if (!c.functions.empty() && material.without.contains(c.functions.front()))
    add_unwritten(material.without.at(c.functions.front()));
  if (material.skeleton) add_unwritten(*material.skeleton);
  const std::filesystem::path atlas = wrong_values_path(folder, c.ask.name);
  if (wrong.mistakes.empty() && wrong.unwritten.empty()) {
    std::error_code ignored;
    std::filesystem::remove(atlas, ignored);
    return;
  }
  write_wrong_values(atlas, wrong);
  made.written.push_back(atlas);
}

}  // namespace

MadeReference check_reference(const JudgedCase& c, const ReferenceMaterial& material) {
  return check_against(c, material, correct_answer(c, material));
}

MadeReference make_reference(const std::filesystem::path& folder, const JudgedCase& c,
                             const ReferenceMaterial& material) {
  const CorrectAnswer correct = correct_answer(c, material);
  MadeReference made = check_against(c, material, correct);

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
  sidecar.skeleton_fraction = made.skeleton_fraction;
  sidecar.nearest = made.nearest;
  for (const auto& [function, answer] : material.without)
    if (fails(c, answer, correct)) sidecar.needs.push_back(function);
  sidecar.margin = made.margin;
  const auto write = c.profile == Profile::values ? write_values : write_picture;
  write(folder, c, material, correct, sidecar, made);
  return made;
}

}  // namespace atelier::judge
