// ./atelier explain: every intermediate result at one pixel of a case, yours beside the right one, and the first that
// differs (judge/explain/pixel.hpp).
//
// The case is asked once for each output that leads to its own, of the student's code and, where it is there, of the
// solution's. Without a solution, and for a choice, values are compared with the stored reference and the ray-traced
// truth.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>

#include "base/error.hpp"
#include "base/near_names.hpp"
#include "base/parse_number.hpp"
#include "cli/commands.hpp"
#include "cli/student/own_files.hpp"
#include "judge/compare/measure.hpp"
#include "judge/compare/verdict_picture.hpp"
#include "judge/explain/pixel.hpp"
#include "judge/report/report_pixel.hpp"
#include "judge/run/ask.hpp"
#include "measure/program.hpp"

namespace atelier {
namespace {

using judge::Answer;
using judge::Beside;
using judge::JudgedCase;

constexpr std::chrono::seconds trace_limit{30};  ///< of one output; soft shadows take long

// ---- Reading the arguments

bool is_picture(const JudgedCase& c) {
  return c.ask.probe.empty();
}

const JudgedCase& picture_named(const judge::CaseFile& file, const std::string& name) {
  std::vector<std::string> names, pictures;
  for (const JudgedCase& c : file.cases) {
    names.push_back(c.ask.name);
    if (is_picture(c)) pictures.push_back(c.ask.name);
  }
  if (name.empty()) throw Error(fmt::format("{}: name a case with a picture: {}", file.step, join(pictures)));
  const auto found = std::ranges::find(names, name);
  if (found == names.end())
    throw Error(fmt::format("{}: there is no case '{}'{}", file.step, name,
                            suggestion(name, nearest_name(name, names).empty() ? pictures : names)));
  const JudgedCase& c = file.cases[std::size_t(found - names.begin())];
  if (!is_picture(c))
    throw Error(fmt::format("{}: '{}' is a probe: it has no pixels; cases with pictures: {}", file.step, name,
                            pictures.empty() ? "none" : join(pictures)));
  return c;
}

Position pixel_in(const std::string& text, glm::ivec2 size) {
  const auto comma = text.find(',');
  const auto number = [&](std::string_view part, int end) {
    int value = -1;
    if (!parse_number(part, value) || value < 0 || value >= end)
      throw Error(
          fmt::format("--pixel {}: it takes X,Y, two whole numbers from the upper left corner: X 0..{}, Y 0..{}", text,
                      size.x - 1, size.y - 1));
    return value;
  };
  const std::string_view all = text;
  return {number(all.substr(0, comma), size.x),
          number(comma == text.npos ? std::string_view() : all.substr(comma + 1), size.y)};
}

// ---- Drawing

/// The case `ask`, once for each output. Names of outputs may have letters that names of cases must not have.
std::vector<Case> asks_for(const Case& ask, const std::vector<OutputSpec>& outputs) {
  std::vector<Case> asks;
  for (const OutputSpec& output : outputs) {
    Case& one = asks.emplace_back(ask);
    one.name = fmt::format("output-{}", asks.size());
    one.output = output.name;
  }
  return asks;
}

std::vector<Answer> traced(judge::RunSettings settings, const std::vector<Case>& asks) {
  settings.truth = true;
  settings.case_limit = trace_limit;
  return judge::run_cases(settings, asks);
}

/// What the truth shows at each pixel; none if there is no truth.
std::optional<Image> traced_things(const judge::RunSettings& settings, Case ask) {
  ask.output = "thing";
  return traced(settings, {ask}).front().pixels;
}

/// Everything that is drawn and compared with, in the order of the pipeline.
struct Drawn {
  std::vector<OutputSpec> outputs;
  std::vector<Answer> yours, right;  ///< of each output; right: from the solution, or the truth
  std::vector<Image> references;     ///< stored, for the case's own output; if `right` is the truth
  Beside beside = Beside::solution;

  judge::RightPictures right_of(std::size_t i) const {
    judge::RightPictures found{.beside = beside, .pictures = {}};
    if (i + 1 == outputs.size() && !references.empty()) {
      found.beside = Beside::reference;
      for (const Image& picture : references) found.pictures.push_back(&picture);
    } else if (right[i].pixels) {
      found.pictures.push_back(&*right[i].pixels);
    }
    return found;
  }
};

/// The step under inspection.
struct Inspected {
  ProjectFolders folders;
  CourseStep step;
  judge::CaseFile file;

  judge::StepReferences references() const {
    return judge::StepReferences(file.step, {}, judge::references_folder(file.path), folders.reference_cache());
  }
};

Drawn draw(const Inspected& inspected, const JudgedCase& c, const Case& ask, const judge::RunSettings& mine) {
  Drawn drawn;
  drawn.outputs = judge::pipeline_to(c.ask.output, measure::list_of({.file = mine.program,
                                                                     .implementations = mine.implementations,
                                                                     .context = mine.context,
                                                                     .shader_cache = mine.shader_cache})
                                                       .outputs);
  const std::vector<Case> asks = asks_for(ask, drawn.outputs);
  drawn.yours = judge::run_cases(mine, asks);
  if (mine.solution && !c.choice) {
    judge::RunSettings solution = mine;
    solution.implementations = *mine.solution;
    drawn.right = judge::run_cases(solution, asks);
  } else {
    drawn.beside = Beside::truth;
    drawn.right = traced(mine, asks);
    drawn.references = inspected.references().of(c).pictures;
  }
  return drawn;
}

/// Where the case's own picture differs most, and whether by more than is allowed.
struct WorstPixel {
  Position at;
  bool differs = false;
};
std::optional<WorstPixel> worst_pixel(const JudgedCase& c, const Drawn& drawn) {
  const Answer& yours = drawn.yours.back();
  const judge::RightPictures right = drawn.right_of(drawn.outputs.size() - 1);
  if (!yours.pixels || right.pictures.empty()) return {};
  std::vector<Image> pictures;
  for (const Image* picture : right.pictures) pictures.push_back(*picture);
  const Difference found = judge::best_match(c, *yours.pixels, pictures).measured.difference;
  return WorstPixel{found.worst, found.over > 0};
}

// ---- The report

/// Whether there is nothing to say about an output: this scene does not draw it. Only a solution knows if it should.
bool is_idle(const judge::PixelRow& row, const Answer& yours) {
  return yours.ended == Answer::Ended::missing && (!row.right || row.beside == Beside::truth);
}

void name_functions(judge::PixelReport& report, const Inspected& inspected, const JudgedCase& c) {
  const judge::PixelRow* first = judge::first_to_differ(report);
  if (!first) return;
  const auto& needs = inspected.references().of(c).needs;
  report.functions_of = inspected.step.name;
  report.functions = judge::functions_behind(first->output, c, needs, inspected.file.cases);
  // The functions of an earlier step may make it; a release need not have that step's cases.
  for (auto used = inspected.step.uses.begin(); report.functions.empty() && used != inspected.step.uses.end(); ++used) {
    const auto path = inspected.folders.case_file(*used);
    if (!std::filesystem::exists(path)) continue;
    report.functions_of = *used;
    report.functions = judge::functions_behind(first->output, c, {}, judge::read_case_file(path).cases);
  }
}

void place(judge::PixelReport& report, const JudgedCase& c) {
  const Position& at = report.at;
  report.masked = judge::mask_of(c.mask, c.ask.size).at(at.x, at.y);
  for (const judge::Region& region : c.regions)
    if (judge::mask_of({region.at}, c.ask.size).at(at.x, at.y)) report.region = region.name;
}

}  // namespace

int run_explain(const ExplainOptions& options) {
  const ProjectFolders folders = project_folders();
  const auto course = read_course(folders.step_flags());
  const CourseStep step = resolve_step(course, options.step);
  const Inspected inspected{folders, step, judge::read_case_file(folders.case_file(step.name))};
  const JudgedCase& c = picture_named(inspected.file, options.case_name);
  std::optional<Position> at;
  if (!options.pixel.empty()) at = pixel_in(options.pixel, c.ask.size);

  const OwnFiles own = prepare_own_files(folders, course, step, own_code(folders, options.sources), options.earlier);
  if (!own.built.ok) throw Error(fmt::format("{} does not build:\n{}", step.name, own.built.log));
  judge::RunSettings settings = run_settings(folders, step, own.path, options.context);
  settings.max_time_outs = 1;  // the outputs of one case: if one hangs, the others do
  const Case ask = judge::ask_of(settings, step.name, c);
  const Drawn drawn = draw(inspected, c, ask, settings);
  const std::optional<WorstPixel> worst = worst_pixel(c, drawn);
  if (!at) at = worst && worst->differs ? worst->at : Position{c.ask.size.x / 2, c.ask.size.y / 2};

  judge::PixelReport report{.step = step.name,
                            .case_name = c.ask.name,
                            .title = c.title,
                            .at = *at,
                            .size = c.ask.size,
                            .scene = ask.scene,
                            .settings = ask.settings,
                            .implementations = in_words(own.earlier, step.name, "yours"),
                            .truth_differs = c.truth_differs};
  place(report, c);
  for (std::size_t i = 0; i < drawn.outputs.size(); ++i) {
    const OutputSpec& output = drawn.outputs[i];
    judge::PixelRow row = judge::compare_pixel(output, judge::comparison_of(output, c, inspected.file.cases),
                                               drawn.yours[i], drawn.right_of(i), *at);
    if (i + 1 == drawn.outputs.size() || !is_idle(row, drawn.yours[i])) report.rows.push_back(std::move(row));
  }
  if (worst && worst->differs) report.worst = worst->at;
  if (drawn.outputs.back().stage != Stage::other_view)
    if (const auto things = traced_things(settings, ask)) report.visible = judge::visible_at(*things, *at);
  name_functions(report, inspected, c);
  fmt::print(
      "{}", options.json ? judge::pixel_json(report) : judge::pixel_text(report, judge::terminal_style(STDOUT_FILENO)));
  const bool differs = std::ranges::any_of(report.rows, &judge::PixelRow::differs);
  return differs || judge::drew_nothing(report) ? exit_failed : exit_ok;
}

}  // namespace atelier
