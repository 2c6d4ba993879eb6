// GLSL from files: includes, defines, and errors that name the line that the author wrote.
#pragma once

#include <filesystem>
#include <functional>
#include <glm/glm.hpp>
#include <map>
#include <string>
#include <string_view>
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
///
/// The way back is a table, and not GLSL's own #line directives: Mesa forgets their file number for most expressions
/// (22.3 reports "0:4(32): `x' undeclared" whatever the file), and GLSL changed which line they name between 1.50
/// and 3.30.
struct ShaderSource {
  struct Line {
    int file = -1;         ///< index into `files` and `names`; -1 for the #version and #define lines in front
    std::size_t line = 0;  ///< counted from 1
  };
  std::string text;                          ///< #version, defines, and everything included; string 0 to the driver
  std::vector<Line> lines;                   ///< where each line of `text` comes from
  std::vector<std::filesystem::path> files;  ///< where they were read
  std::vector<std::string> names;            ///< the same as the author named them in #include: for messages
};

/// Reads what `find` gives for `name`, follows #include "name" lines, and puts `#version 330 core` and the defines in
/// front.
///
/// A file is taken in at its first #include only, so that headers may include each other. An #include inside a comment
/// is none; one inside #if is followed whatever the condition. Windows line ends, a UTF-8 byte order mark and a missing
/// last newline are mended. Throws Error naming the file and the line of an include that cannot be found or read, of a
/// #version, #extension or #line (the assembler owns them), of a comment without an end, of a null byte, or of includes
/// nested deeper than 32.
ShaderSource assemble_shader(const FindFile& find, const std::string& name, const Defines& defines);

/// The same over a text that is not a file; `label` stands for its name in messages.
ShaderSource assemble_shader_text(const FindFile& find, const std::string& text, const std::string& label,
                                  const Defines& defines);

/// GLSL that includes `file`: the defines, a line each, then `before`, which is whole lines, then the #include.
std::string text_including(const std::string& file, const Defines& defines = {}, const std::string& before = "");

/// A shader that the driver refused. what() reads "blinn_phong.glsl:12: error: ..." a line each, the author's file and
/// line.
class ShaderError : public Error {
 public:
  using Error::Error;
};

/// Rewrites a driver's log to "file:line: error: ..." lines with the author's files, and drops empty lines and what
/// repeats; at most 30 lines are kept. Drivers write the number of the source string, always 0 here, and the line as
/// "0:12(5): error: ..." (Mesa), "0(12) : error C0000: ..." (NVIDIA) or "ERROR: 0:12: ..." (Apple, Intel, AMD, ANGLE).
/// Lines of any other form stay as they are.
std::string translate_shader_log(const std::string& log, const ShaderSource& source);

/// Compiles and links; geometry may be null. Throws ShaderError.
GlProgram build_program(Gl& gl, const ShaderSource& vertex, const ShaderSource& fragment,
                        const ShaderSource* geometry = nullptr);

/// Sets uniforms of one program by name, finding each location once. A name that the program does not use is ignored:
/// the driver removes what a variant does not need. The setters act on the program in use, as glUniform does: call
/// gl.UseProgram first. A bool or a sampler is set as an int; matrices are columns, as glm has them.
class Uniforms {
 public:
  Uniforms(Gl& gl, GLuint program) : gl_(&gl), program_(program) {}
  GLint location(std::string_view name);  ///< -1 where the program has none

  void set(std::string_view name, int value);
  void set(std::string_view name, float value);
  void set(std::string_view name, const glm::vec2& value);
  void set(std::string_view name, const glm::vec3& value);
  void set(std::string_view name, const glm::vec4& value);
  void set(std::string_view name, const glm::mat3& value);
  void set(std::string_view name, const glm::mat4& value);

 private:
  Gl* gl_;
  GLuint program_;
  std::map<std::string, GLint, std::less<>> locations_;
};

}  // namespace atelier
