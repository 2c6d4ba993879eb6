#include "judge/explain/pixel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>

#include "base/error.hpp"
#include "base/near_names.hpp"
#include "judge/compare/measure.hpp"
#include "judge/compare/verdict_parts.hpp"
#include "judge/explain/sentences.hpp"

namespace atelier::judge {
namespace {

// ---- Which outputs, and how they are compared

/// `listed_before`: in the program's list.
bool leads_to(const OutputSpec& output, const OutputSpec& own, bool listed_before) {
  if (own.stage == Stage::other_view) return false;
  if (own.stage == Stage::aside) return output.stage == Stage::surface;
  if (output.stage != own.stage) return output.stage < own.stage;
  return listed_before && own.stage != Stage::after_colour;  // these are made from the picture, not from one another
}

struct Usual {
  const char* output;
  Unit unit;
  double delta;
};

constexpr Usual usual_data[] = {
    {"normal", Unit::degrees, 0.5},  // as the cases that judge normals; 8-bit codes are 0.2 degrees apart
    {"recorded_normal", Unit::degrees, 0.5}, {"relief", Unit::degrees, 0.5},
    {"position", Unit::number, 0.01},  // a centimetre; floats are that coarse at 100 km
    {"depth", Unit::number, 1e-4},
};

constexpr Usual other_data{"", Unit::number, 0.002};  // texture coordinates: a texel of 512

const Usual& usual_for(const std::string& output) {
  const auto found = std::ranges::find_if(usual_data, [&](const Usual& usual) { return usual.output == output; });
  return found == std::end(usual_data) ? other_data : *found;
}

bool judges(const JudgedCase& c, const std::string& output) {
  return c.ask.probe.empty() && !c.choice && c.ask.output == output;
}

/// Colours are codes of directions only to the eye.
bool fits(const JudgedCase& c, const OutputSpec& output) {
  const bool direction = output.encoding == Encoding::data && usual_for(output.name).unit == Unit::degrees;
  return !direction || c.unit == Unit::degrees;
}

// ---- Comparing

Image single_pixel(const Rgba& value) {
  return {1, 1, value};
}

bool is_finite(const Rgba& p) {
  return std::isfinite(p.r) && std::isfinite(p.g) && std::isfinite(p.b);
}

/// The 3x3 pixels around one, cut off at the border, and its place in them.
struct Surroundings {
  Image pixels;
  Position centre;
};

Surroundings around(const Image& image, Position at) {
  const int left = std::max(at.x - 1, 0), top = std::max(at.y - 1, 0);
  const int right = std::min(at.x + 1, image.width() - 1), bottom = std::min(at.y + 1, image.height() - 1);
  Surroundings found{Image(right - left + 1, bottom - top + 1), {at.x - left, at.y - top}};
  for (int y = top; y <= bottom; ++y)
    for (int x = left; x <= right; ++x) found.pixels.at(x - left, y - top) = image.at(x, y);
  return found;
}

struct Distance {
  double apart = 0;
  bool differs = false;
};

/// Only `yours` can differ: all other pixels are the picture's own.
Distance distance(const Rgba& yours, const Image& right, Position at, const JudgedCase& how) {
  const double delta = how.profile == Profile::exact ? 0 : how.delta;
  const Measure measure = measure_of(how.unit);
  if (how.profile != Profile::robust) {
    const Difference found = compare_strict(compared_form(single_pixel(yours), how),
                                            compared_form(single_pixel(right.at(at.x, at.y)), how), measure, delta);
    return {found.worst_distance, found.over > 0};
  }
  const Surroundings reference = around(right, at);
  Image changed = reference.pixels;
  changed.at(reference.centre.x, reference.centre.y) = yours;
  const Difference found =
      compare_robust(compared_form(changed, how), compared_form(reference.pixels, how), measure, delta);
  return {found.worst_distance, found.over > 0};
}

// ---- Words

/// "The normal", "The texture coordinate", "The output 'bright'".
std::string subject(const PixelRow& row) {
  if (row.output == "texcoord") return "The texture coordinate";
  static const std::set<std::string> nouns = {"colour",  "depth",         "normal",           "position",
                                              "diffuse", "shadow_factor", "shadow_coordinate"};
  if (!nouns.contains(row.output)) return fmt::format("The output '{}'", row.output);
  std::string noun = row.output == "diffuse" ? "diffuse light" : row.output;
  std::ranges::replace(noun, '_', ' ');
  return "The " + noun;
}

std::string how_far(const PixelRow& row) {
  if (!row.yours) return "yours is missing: " + row.problem;
  if (!is_finite(*row.yours)) return "yours is not a finite number";
  const std::string allowed = fmt::format(" ({} {} allowed)", amount(row.tolerance(), row.how.unit),
                                          row.how.unit == Unit::number ? "is" : "are");
  const std::string apart = amount(row.apart, row.how.unit);
  return (row.how.unit == Unit::degrees ? "yours points " + apart + " away" : "yours is off by " + apart) + allowed;
}

/// A truth of a step that approximates it says less than a solution.
std::string doubt(const PixelReport& report, const PixelRow& row) {
  if (row.beside != Beside::truth) return {};
  return " It is compared with the ray-traced truth, which a right step may only approximate" +
         (report.truth_differs.empty() ? "." : ": " + report.truth_differs);
}

std::string functions_words(const PixelReport& report) {
  if (report.functions.empty()) return {};
  const bool of_another_step = report.functions_of != report.step;
  return fmt::format(" Look at {}{}, and at what {}.", join(report.functions),
                     of_another_step ? fmt::format(" ({})", report.functions_of) : "",
                     report.functions.size() == 1 ? "it calls" : "they call");
}

/// Where else to look.
std::string elsewhere(const PixelReport& report) {
  if (report.worst && *report.worst != report.at)
    return fmt::format(" The picture differs most at {},{}.", report.worst->x, report.worst->y);
  return report.worst ? "" : " No pixel of the picture differs by more than is allowed.";
}

}  // namespace

std::vector<OutputSpec> pipeline_to(const std::string& own, const std::vector<OutputSpec>& outputs) {
  const auto last = std::ranges::find(outputs, own, &OutputSpec::name);
  if (last == outputs.end()) {
    std::vector<std::string> names;
    for (const OutputSpec& output : outputs) names.push_back(output.name);
    throw Error(fmt::format("output '{}': the program has no such output{}", own, suggestion(own, names)));
  }
  std::vector<OutputSpec> pipeline;
  for (auto output = outputs.begin(); output != outputs.end(); ++output)
    if (output != last && leads_to(*output, *last, output < last)) pipeline.push_back(*output);
  std::ranges::stable_sort(pipeline, {}, &OutputSpec::stage);
  pipeline.push_back(*last);
  return pipeline;
}

JudgedCase comparison_of(const OutputSpec& output, const JudgedCase& c, const std::vector<JudgedCase>& step) {
  JudgedCase how = c;
  how.choice.reset();
  how.ask.output = output.name;
  if (c.ask.output == output.name && fits(c, output)) return how;
  how.profile = Profile::strict;
  for (const JudgedCase& other : step)
    if (judges(other, output.name) && fits(other, output)) {
      how.unit = other.unit;
      how.delta = other.delta;
      if (other.ask.output != c.ask.output) how.exposure = other.exposure;
      return how;
    }
  how.unit = output.encoding == Encoding::linear ? Unit::colour : Unit::encoded;
  how.delta = JudgedCase().delta;
  if (output.encoding != Encoding::data) return how;
  std::tie(how.unit, how.delta) = std::pair(usual_for(output.name).unit, usual_for(output.name).delta);
  return how;
}

std::string to_string(Beside beside) {
  switch (beside) {
    case Beside::solution:
      return "solution";
    case Beside::reference:
      return "reference";
    case Beside::truth:
      return "truth";
  }
  return "";
}

PixelRow compare_pixel(const OutputSpec& output, const JudgedCase& how, const Answer& yours, const RightPictures& right,
                       Position at) {
  PixelRow row{.output = output.name, .stage = output.stage, .how = how, .beside = right.beside};
  if (!right.pictures.empty()) row.right = right.pictures.front()->at(at.x, at.y);
  if (!yours.pixels) {
    const Status status = status_of(yours.ended);
    std::string words = to_string(status);
    std::ranges::replace(words, '_', ' ');
    row.problem = fmt::format("{}: {}", words, reason_without_answer(status, yours));
    row.differs = row.right.has_value();
    return row;
  }
  row.yours = yours.pixels->at(at.x, at.y);
  JudgedCase compared = how;
  if (right.beside == Beside::truth) compared.profile = Profile::robust;
  std::optional<Distance> nearest;
  for (const Image* picture : right.pictures) {
    const Distance found = distance(*row.yours, *picture, at, compared);
    if (nearest && !(found.apart < nearest->apart)) continue;
    nearest = found;
    row.right = picture->at(at.x, at.y);
  }
  if (nearest) std::tie(row.apart, row.differs) = std::pair(nearest->apart, nearest->differs);
  if (!is_finite(*row.yours)) {  // the encoding for a display would make it 0
    row.apart = std::numeric_limits<double>::infinity();
    row.differs = true;
  }
  return row;
}

Visible visible_at(const Image& things, Position at) {
  const Surroundings near = around(things, at);
  const float own = things.at(at.x, at.y).r;
  const auto is_own = [&](const Rgba& p) { return p.r == own; };
  if (!std::ranges::all_of(near.pixels.pixels(), is_own)) return Visible::edge;
  return own == 0 ? Visible::background : Visible::surface;
}

bool drew_nothing(const PixelReport& report) {
  return std::ranges::none_of(report.rows, [](const PixelRow& row) { return row.yours.has_value(); });
}

const PixelRow* first_to_differ(const PixelReport& report) {
  if (drew_nothing(report)) return nullptr;
  const auto found = std::ranges::find_if(report.rows, &PixelRow::differs);
  return found == report.rows.end() ? nullptr : &*found;
}

std::vector<std::string> functions_behind(const std::string& output, const JudgedCase& c,
                                          const std::vector<std::string>& needs, const std::vector<JudgedCase>& step) {
  if (c.ask.output == output && !c.functions.empty()) return c.functions;
  std::vector<std::string> functions;
  for (const JudgedCase& other : step) {
    if (!judges(other, output)) continue;
    for (const std::string& function : other.functions) {
      const bool needed =
          needs.empty() || std::ranges::count(needs, function) + std::ranges::count(c.functions, function) > 0;
      if (needed && std::ranges::count(functions, function) == 0) functions.push_back(function);
    }
  }
  return functions;
}

std::string pixel_sentence(const PixelReport& report) {
  if (drew_nothing(report))
    return "Your program drew nothing: " + (report.rows.empty() ? "no output" : report.rows.front().problem);
  const bool comparable =
      std::ranges::any_of(report.rows, [](const PixelRow& row) { return row.right.has_value() || row.differs; });
  if (!comparable) return "There is nothing to compare with.";
  const PixelRow* first = first_to_differ(report);
  if (!first) return "Nothing differs at this pixel." + elsewhere(report);
  std::string text = fmt::format("{} is the first to differ: {}.", subject(*first), how_far(*first));
  text += functions_words(report) + doubt(report, *first);
  if (first->stage == Stage::pass) text += " A pass may read other pixels, at which an output before it may differ.";
  if (!report.rows.back().differs)
    text += fmt::format(" The case's own output, {}, does not differ here.{}", report.rows.back().output,
                        elsewhere(report));
  return text;
}

}  // namespace atelier::judge
