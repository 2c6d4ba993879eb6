// GLSL from files: includes, defines, and errors that name the line that the author wrote.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "gl/objects.hpp"

namespace atelier {

/// Finds the file behind an include's name ("01-transforms/transforms.glsl"), or returns an empty path. Which folder
/// answers first, the student's or the solution's, is how one implementation stands in for another.
using FindFile = std::function<std::filesystem::path(const std::string& name)>;

/// #define NAME VALUE before the first line; ordered, so that equal sets give equal text.
using Defines = std::map<std::string, std::string>;

/// A source with its includes resolved, ready for the driver, and the way back from its lines to the files.
struct ShaderSource {
  std::string text;                          ///< #version, defines, and everything included, with #line directives
  std::vector<std::filesystem::path> files;  ///< by the source-string number that the #line directives carry
};

/// Reads what `find` gives for `name`, follows #include "name" lines (each file once), and puts `#version 330 core` and the
/// defines in front. Throws Error naming the file and the line of an include that cannot be found, of a #version or
/// #extension line (the assembler owns both), or of includes nested deeper than 32.
ShaderSource assemble_shader(const FindFile& find, const std::string& name, const Defines& defines);

/// The same over a text that is not a file; `label` stands for its name in messages.
ShaderSource assemble_shader_text(const FindFile& find, const std::string& text, const std::string& label,
                                  const Defines& defines);

/// A shader that the driver refused. what() reads "blinn_phong.glsl:12: error: ..." a line each, the author's file and line.
class ShaderError : public Error {
 public:
  using Error::Error;
};

/// Rewrites a driver's log ("0:12(5): error: ..." and "0(12) : error ...", as Mesa and NVIDIA have it) to author's
/// file:line, and drops what repeats.
std::string translate_shader_log(const std::string& log, const ShaderSource& source);

/// Compiles and links; geometry may be null. Throws ShaderError.
GlProgram build_program(Gl& gl, const ShaderSource& vertex, const ShaderSource& fragment,
                        const ShaderSource* geometry = nullptr);

/// Sets uniforms of one program by name, finding each location once. A name that the program does not use is ignored: the
/// driver removes what a variant does not need.
class Uniforms {
 public:
  Uniforms(Gl& gl, GLuint program) : gl_(&gl), program_(program) {}
  GLint location(const std::string& name);

 private:
  Gl* gl_;
  GLuint program_;
  std::map<std::string, GLint> locations_;
};

}  // namespace atelier
