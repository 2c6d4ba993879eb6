// The command line that every step program has.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "case/implementations.hpp"
#include "gl/context.hpp"

namespace atelier {

/// --vary NAME=FROM..TO, still as text.
struct SettingRange {
  std::string name, from, to;
};

struct CommandLine {
  bool list = false, json = false, stats = false;
  std::optional<ContextKind> context;
  std::optional<Implementations> implementations;

  Case picture;                                               ///< --scene --size --set --output, as for a case
  std::vector<std::pair<std::string, std::string>> settings;  ///< --set NAME=VALUE, still as text
  std::filesystem::path out;                                  ///< --out: a picture file; with --cases: a folder
  std::filesystem::path record;  ///< --record: .gif, or a .png, .bmp or .exr whose frames are numbered
  int frames = 48;
  std::optional<SettingRange> vary;  ///< --vary: of a recording, what changes in place of the camera
  int repeat = 0;                    ///< --repeat: how often a picture is drawn by the clock; 0: once, without one

  bool truth = false;  ///< --truth: the oracle's pictures instead of OpenGL's
  int samples = 1;     ///< --samples: n x n a pixel of the truth

  std::filesystem::path cases;  ///< --cases: what the judge calls
  std::optional<int> progress;  ///< --progress: a descriptor for "begin NAME" and "end NAME"
};

/// Throws Error with what is wrong, also where an option would change nothing; on --help prints and returns nothing.
std::optional<CommandLine> parse_command_line(int count, char** arguments, const std::string& step);

}  // namespace atelier
