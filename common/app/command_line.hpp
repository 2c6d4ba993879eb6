// The command line of all step programs.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "case/implementations.hpp"
#include "gl/context.hpp"

namespace atelier {

/// --vary NAME=FROM..TO, unparsed.
struct SettingRange {
  std::string name, from, to;
};

struct CommandLine {
  bool list = false, json = false, stats = false;
  std::optional<ContextKind> context;
  std::optional<Implementations> implementations;

  Case picture;                                               ///< --scene --size --set --output, as for a case
  std::vector<std::pair<std::string, std::string>> settings;  ///< --set NAME=VALUE, unparsed
  std::filesystem::path out;                                  ///< --out: a picture file; with --cases: a folder
  std::filesystem::path record;  ///< --record: .gif, or a .png, .bmp or .exr whose frames are numbered
  int frames = 48;
  std::optional<SettingRange> vary;  ///< --vary: what a recording changes instead of the camera
  int repeat = 0;                    ///< --repeat: number of timed drawings; 0: one, untimed

  bool truth = false;  ///< --truth: pictures from the oracle instead of OpenGL
  int samples = 1;     ///< --samples: n x n per pixel of the truth

  std::filesystem::path cases;  ///< --cases: what the judge calls
  std::optional<int> progress;  ///< --progress: a file descriptor for "begin NAME" and "end NAME"
};

/// Throws Error for invalid options and for options without effect; prints the help and returns none for --help.
std::optional<CommandLine> parse_command_line(int count, char** arguments, const std::string& step);

}  // namespace atelier
