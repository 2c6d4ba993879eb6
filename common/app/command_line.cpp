#include "app/command_line.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>

#include "app/record.hpp"
#include "base/error.hpp"

namespace atelier {

namespace {

glm::ivec2 parse_size(const std::string& text) {
  int width = 0, height = 0, used = 0;
  if (std::sscanf(text.c_str(), "%dx%d%n", &width, &height, &used) != 2 || std::size_t(used) != text.size() ||
      width < 1 || height < 1 || width > 4096 || height > 4096)
    throw Error("--size " + text + ": write WIDTHxHEIGHT, each 1 to 4096 pixels");
  return {width, height};
}

glm::dvec3 parse_vector(const std::string& option, const std::string& text) {
  glm::dvec3 v;
  int used = 0;
  if (std::sscanf(text.c_str(), "%lf,%lf,%lf%n", &v.x, &v.y, &v.z, &used) != 3 || std::size_t(used) != text.size() ||
      !(v.x * 0 == 0 && v.y * 0 == 0 && v.z * 0 == 0))
    throw Error(option + " " + text + ": write three finite numbers as X,Y,Z");
  return v;
}

using Setting = std::pair<std::string, std::string>;

Setting parse_setting(const std::string& text, const std::vector<Setting>& earlier) {
  const auto equals = text.find('=');
  if (equals == std::string::npos || equals == 0) throw Error("--set " + text + ": write NAME=VALUE");
  const Setting setting{text.substr(0, equals), text.substr(equals + 1)};
  for (const auto& [name, value] : earlier)
    if (name == setting.first) throw Error("--set " + text + ": " + name + " is set to " + value + " already");
  return setting;
}

SettingRange parse_range(const std::string& text, const std::vector<Setting>& settings) {
  const auto equals = text.find('='), dots = equals == text.npos ? equals : text.find("..", equals);
  if (equals == 0 || dots == text.npos || dots == equals + 1 || dots + 2 == text.size())
    throw Error("--vary " + text + ": write NAME=FROM..TO");
  const SettingRange range{text.substr(0, equals), text.substr(equals + 1, dots - equals - 1), text.substr(dots + 2)};
  for (const auto& [name, value] : settings)
    if (name == range.name) throw Error("--vary " + text + ": --set gives it the value " + value + " already");
  return range;
}

Implementations parse_implementations(const std::string& text) {
  Implementations implementations = Implementations::parse(text);
  if (implementations.roots().empty()) throw Error("--implementations " + text + ": it names no folder");
  return implementations;
}

}  // namespace

std::optional<CommandLine> parse_command_line(int count, char** arguments, const std::string& step) {
  CommandLine line;
  line.picture.name = "frame";
  std::string size, context, implementations, eye, target, vary;
  std::vector<std::string> settings;

  CLI::App app{"Step " + step + " of Atelier. Without --out, --record, --cases or --list it opens a window."};
  const auto option = [&](const char* group, const char* name, auto& value, const char* help) {
    const auto something = [](const std::string& text) { return text.empty() ? "no value is given" : ""; };
    return app.add_option(name, value, help)->group(group)->check(CLI::Validator(something, ""));
  };
  const char *const what = "What to do", *const picture = "What to draw", *const how = "How";
  CLI::Option* const list =
      app.add_flag("--list", line.list, "Print scenes, settings, outputs and probes")->group(what);
  CLI::Option* const out =
      option(what, "--out", line.out, "Draw one picture into this file (.png .exr .bmp .gif); with --cases: a folder");
  CLI::Option* const record = option(
      what, "--record", line.record,
      "Draw a camera orbit around the scene, or the change of --vary: .gif, or numbered .png / .bmp / .exr files");
  CLI::Option* const frames = option(what, "--frames", line.frames, "Pictures of a recording")
                                  ->check(CLI::Range(1, 10000))
                                  ->capture_default_str();
  CLI::Option* const varied = option(what, "--vary", vary, "NAME=FROM..TO: a setting that changes in a recording");
  CLI::Option* const cases =
      option(what, "--cases", line.cases, "Answer every case in this file; what the judge calls");
  CLI::Option* const truth =
      app.add_flag("--truth", line.truth, "Trace the ground truth, in double precision, instead of drawing")
          ->group(what);
  CLI::Option* const samples = option(what, "--samples", line.samples, "Of the truth: N x N per pixel")
                                   ->check(CLI::Range(1, 64))
                                   ->capture_default_str();
  const std::vector<CLI::Option*> of_a_picture = {
      option(picture, "--scene", line.picture.scene, "A built-in scene, or a .gltf, .glb or .obj file"),
      option(picture, "--size", size, "WIDTHxHEIGHT in pixels"),
      option(picture, "--set", settings, "NAME=VALUE, any number of times")->take_all(),
      option(picture, "--output", line.picture.output, "colour, or an intermediate"),
      option(picture, "--eye", eye, "X,Y,Z where the camera stands"),
      option(picture, "--target", target, "X,Y,Z where it looks"),
  };
  CLI::Option* const kind = option(how, "--context", context, "osmesa, egl or window");
  option(how, "--implementations", implementations,
         "Where code is searched: DIR or STEP=DIR, joined by ':', first match wins");
  CLI::Option* const stats =
      app.add_flag("--stats", line.stats, "Print the cost of drawing; with --cases: write DIR/NAME.stats")->group(how);
  CLI::Option* const repeat =
      option(how, "--repeat", line.repeat, "With --stats: time this many frames, after two that are not timed")
          ->check(CLI::Range(1, 10000));
  app.add_flag("--json", line.json, "Print JSON")->group(how);
  CLI::Option* const progress =
      option(how, "--progress", line.progress, "A file descriptor on which to report the current case to the judge");

  // An option without effect is an error.
  frames->needs(record);
  varied->needs(record);
  repeat->needs(stats);
  repeat->excludes(record);
  progress->needs(cases);
  cases->needs(out);
  truth->needs(out);
  samples->needs(truth);
  record->excludes(out);
  for (CLI::Option* other : {record, kind, stats}) truth->excludes(other);  // the truth uses no driver
  for (CLI::Option* other : {out, record, cases, kind, stats}) list->excludes(other);
  cases->excludes(record);
  for (CLI::Option* other : of_a_picture) {
    list->excludes(other);
    cases->excludes(other);
  }

  try {
    app.parse(count, arguments);
  } catch (const CLI::CallForHelp&) {
    std::fputs(app.help().c_str(), stdout);
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    throw Error(std::string(error.what()) + " (see " + step + " --help)");
  }

  if (!size.empty())
    line.picture.size = parse_size(size);
  else
    line.picture.size = {640, 480};
  if (!eye.empty()) line.picture.camera.eye = parse_vector("--eye", eye);
  if (!target.empty()) line.picture.camera.target = parse_vector("--target", target);
  if (!context.empty()) line.context = parse_context_kind(context);
  if (!implementations.empty()) line.implementations = parse_implementations(implementations);
  for (const std::string& text : settings) line.settings.push_back(parse_setting(text, line.settings));
  if (!vary.empty()) line.vary = parse_range(vary, line.settings);
  if (line.json && !line.list && (!line.stats || !line.cases.empty()))
    throw Error("--json: only --list and the --stats of a picture print JSON; add one of them");
  if (line.stats && line.out.empty() && line.record.empty())
    throw Error("--stats: a window shows the cost of drawing itself; add --out FILE or --record FILE");
  if (line.picture.camera.eye && line.picture.camera.eye == line.picture.camera.target)
    throw Error("--eye and --target are both " + eye + ": they must be different points");
  if (!line.record.empty()) check_recording(line.record);
  return line;
}

}  // namespace atelier
