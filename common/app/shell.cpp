#include "app/shell.hpp"

#include <fmt/core.h>

#include <cstdio>

#include "app/cases.hpp"
#include "app/command_line.hpp"
#include "app/crash.hpp"
#include "app/list.hpp"
#include "app/picture.hpp"
#include "app/record.hpp"
#include "app/thrown.hpp"
#include "app/truth.hpp"
#include "app/window.hpp"
#include "base/error.hpp"
#include "image_io/image_io.hpp"

namespace atelier {

namespace {

/// Throws if camera options are given to a program without camera, before anything is drawn.
void check_has_camera(const StepDescription& description, const CommandLine& line) {
  const bool turning = !line.record.empty() && !line.vary;
  const bool moved = line.picture.camera.eye || line.picture.camera.target || turning;
  if (moved && !description.camera)
    throw Error(description.name +
                " has no camera: --eye, --target and a --record without --vary would change nothing");
}

/// Throws if eye and target coincide when only one of them was given.
void check_camera(const CaseCamera& given, const Camera& camera) {
  if ((given.eye || given.target) && camera.eye == camera.target)
    throw Error(fmt::format("--{} is where the scene's camera {}: eye and target must be different points",
                            given.eye ? "eye" : "target", given.eye ? "looks" : "stands"));
}

void take_settings(CommandLine& line, const StepDescription& description) {
  for (const auto& [name, text] : line.settings) {
    Settings checked(description.settings);
    checked.set(name, std::string_view(text));
    line.picture.settings[name] = checked.value(name);
  }
}

/// In the program's own format, if it has one for this file.
void write_picture(const StepProgram& program, const std::filesystem::path& file, const Image& image,
                   Encoding encoding) {
  if (!program.write(file, image)) write_image(file, image, {.encoding = encoding});
}

/// Pictures from the oracle, without context and shaders.
int trace(const StepIdentity& identity, const Implementations& implementations, CommandLine& line) {
  const auto program = load_step(identity, implementations);
  if (!line.cases.empty()) {
    trace_cases(*program, line.cases, line.out, line.samples, line.progress);
    return exit_ok;
  }
  check_has_camera(program->description(), line);
  take_settings(line, program->description());
  const Image image = trace_case(*program, line.picture, line.samples);
  const Encoding encoding = encoding_of(program->description(), line.picture.output);
  write_picture(*program, line.out, image, encoding);
  return exit_ok;
}

/// Draws pictures without a window.
int draw_headless(const StepIdentity& identity, const Implementations& implementations, CommandLine& line) {
  const auto context = line.context ? make_headless_context(*line.context) : make_headless_context();
  const auto program = load_step(identity, implementations);  // after the context, so that it is destroyed first
  Painter painter(*program, *context, implementations);
  painter.time_frames(line.repeat);
  painter.count_fragments(line.stats);
  if (!line.cases.empty()) {
    answer_cases(painter, line.cases, line.out, line.progress, line.stats);
    return exit_ok;
  }
  check_has_camera(program->description(), line);
  take_settings(line, program->description());
  std::optional<VariedSetting> varied;
  if (line.vary) {
    varied = varied_setting(program->description().settings, line.vary->name, line.vary->from, line.vary->to);
    line.picture.settings[varied->name] = varied->from;
  }
  const Encoding encoding = encoding_of(program->description(), line.picture.output);
  const Image image = painter.paint(line.picture);  // loads the scene, whose camera is needed below
  const Camera camera = apply(line.picture.camera, program->camera());
  check_camera(line.picture.camera, camera);
  if (line.record.empty())
    write_picture(*program, line.out, image, encoding);
  else
    record(painter, line.picture, varied ? change_of_setting(*varied) : turn_of_camera(camera), encoding, line.record,
           line.frames);
  if (line.stats) std::fputs((line.json ? cost_as_json : cost_as_text)(painter.cost()).c_str(), stdout);
  return exit_ok;
}

int run(int count, char** arguments, const StepIdentity& identity) {
  auto line = parse_command_line(count, arguments, identity.name);
  if (!line) return exit_ok;
  const Implementations implementations =
      with_given_files(line->implementations ? *line->implementations : default_implementations(identity));
  const bool headless = !line->out.empty() || !line->record.empty() || !line->cases.empty();
  if (!headless && !line->list) return run_window(identity, implementations, *line);

  if (line->list) {
    const auto program = load_step(identity, implementations);
    const StepDescription& description = program->description();
    std::fputs((line->json ? list_as_json(description) : list_as_text(description)).c_str(), stdout);
    return exit_ok;
  }
  if (line->truth) return trace(identity, implementations, *line);
  return draw_headless(identity, implementations, *line);
}

}  // namespace

int run_step(int count, char** arguments, const StepIdentity& identity) {
  tell_what_was_thrown_before_aborting();
  name_function_on_crash();
  try {
    const int status = run(count, arguments, identity);
    if (std::fflush(stdout) != 0 || std::ferror(stdout)) throw Error("the output could not be written in full");
    return status;
  } catch (const Error& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return exit_usage;
  }
}

}  // namespace atelier
