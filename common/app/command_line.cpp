#include "app/command_line.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>

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

std::pair<std::string, std::string> parse_setting(const std::string& text) {
  const auto equals = text.find('=');
  if (equals == std::string::npos || equals == 0) throw Error("--set " + text + ": write NAME=VALUE");
  return {text.substr(0, equals), text.substr(equals + 1)};
}

}  // namespace

std::optional<CommandLine> parse_command_line(int count, char** arguments, const std::string& step) {
  CommandLine line;
  line.picture.name = "frame";
  std::string size, context, implementations, eye, target;
  std::vector<std::string> settings;

  CLI::App app{"Step " + step + " of Atelier. Without --out, --record, --cases or --list it opens a window."};
  app.add_flag("--list", line.list, "Print scenes, settings, outputs and probes")->group("What to do");
  app.add_option("--out", line.out, "Draw one picture into this file (.png .exr .bmp); with --cases: a folder")
      ->group("What to do");
  app.add_option("--record", line.record, "Draw a turn round the scene: .gif, or numbered .png / .bmp files")
      ->group("What to do");
  app.add_option("--frames", line.frames, "Pictures of a recording")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str()
      ->group("What to do");
  app.add_option("--cases", line.cases, "Answer every case in this file; what the judge calls")->group("What to do");
  app.add_option("--scene", line.picture.scene, "A built-in scene, or a .gltf, .glb or .obj file")
      ->group("What to draw");
  app.add_option("--size", size, "WIDTHxHEIGHT in pixels")->group("What to draw");
  app.add_option("--set", settings, "NAME=VALUE, any number of times")->group("What to draw")->take_all();
  app.add_option("--output", line.picture.output, "colour, or an intermediate")->group("What to draw");
  app.add_option("--eye", eye, "X,Y,Z where the camera stands")->group("What to draw");
  app.add_option("--target", target, "X,Y,Z where it looks")->group("What to draw");
  app.add_option("--context", context, "osmesa, egl or window")->group("How");
  app.add_option("--implementations", implementations, "Whose code: DIR or STEP=DIR, joined by ':', first match wins")
      ->group("How");
  app.add_flag("--stats", line.stats, "Print what the drawing has cost")->group("How");
  app.add_flag("--json", line.json, "Print for programs")->group("How");
  app.add_option("--progress", line.progress, "A descriptor to tell the judge which case is being answered")
      ->group("How");

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
  if (!implementations.empty()) line.implementations = Implementations::parse(implementations);
  for (const std::string& text : settings) line.settings.push_back(parse_setting(text));
  if (!line.cases.empty() && line.out.empty()) throw Error("--cases needs --out DIR");
  return line;
}

}  // namespace atelier
