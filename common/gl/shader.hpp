// GLSL from files: includes, defines, and errors that name the source file and line.
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

/// Finds the file for an include's name ("01-transforms/transforms.glsl"), or returns an empty path. The order in which
/// folders are searched chooses the implementation: the student's or the solution's.
using FindFile = std::function<std::filesystem::path(const std::string& name)>;

/// #define NAME VALUE before the first line; ordered, so that equal sets give equal text.
using Defines = std::map<std::string, std::string>;

/// A source with its includes resolved, ready for the driver, and a table from its lines back to the files.
///
/// It does not use GLSL's #line directives: Mesa loses their file number in most messages (22.3 reports "0:4(32): `x'
/// undeclared" for any file), and GLSL changed which line they name between 1.50 and 3.30.
struct ShaderSource {
  struct Line {
    int file = -1;         ///< index into `files` and `names`; -1 for the #version and #define lines in front
    std::size_t line = 0;  ///< counted from 1
  };
  std::string text;                          ///< #version, defines, and everything included; string 0 to the driver
  std::vector<Line> lines;                   ///< origin of each line of `text`
  std::vector<std::filesystem::path> files;  ///< the files that were read
  std::vector<std::string> names;            ///< their names as written in #include: for messages
};

/// Reads the file that `find` returns for `name`, resolves #include "name" lines, and puts `#version 330 core` and the
/// defines in front.
///
/// Each file is included once, at its first #include, so headers may include each other. An #include in a comment is
/// ignored; one inside #if is always followed. Windows line ends, a UTF-8 byte order mark and a missing last newline
/// are fixed. Throws Error naming file and line for an include that cannot be found or read, a #version, #extension or
/// #line (the assembler writes them), an unterminated comment, a null byte, or includes nested deeper than 32.
ShaderSource assemble_shader(const FindFile& find, const std::string& name, const Defines& defines);

/// The same for a text that is not a file; messages call it `label`.
ShaderSource assemble_shader_text(const FindFile& find, const std::string& text, const std::string& label,
                                  const Defines& defines);

/// GLSL that includes `file`: the defines, a line each, then `before`, which is whole lines, then the #include.
std::string text_including(const std::string& file, const Defines& defines = {}, const std::string& before = "");

/// A shader that the driver rejected. Each line of what() is like "blinn_phong.glsl:12: error: ...", with the source
/// file and line.
class ShaderError : public Error {
 public:
  using Error::Error;
};

/// Rewrites a driver's log to lines "file:line: error: ..." with the source files. Drops empty and repeated lines, and
/// keeps at most 30. Drivers write the number of the source string, always 0 here, and the line as "0:12(5): error:
/// ..." (Mesa), "0(12) : error C0000: ..." (NVIDIA) or "ERROR: 0:12: ..." (Apple, Intel, AMD, ANGLE). Other lines do
/// not change.
std::string translate_shader_log(const std::string& log, const ShaderSource& source);

/// Compiles and links; geometry may be null. Throws ShaderError.
GlProgram build_program(Gl& gl, const ShaderSource& vertex, const ShaderSource& fragment,
                        const ShaderSource* geometry = nullptr);

/// Sets uniforms of one program by name; looks up each location once. A name that the program does not use is ignored:
/// the driver removes unused uniforms. The setters act on the program in use, like glUniform: call gl.UseProgram first.
/// Set a bool or a sampler as an int; matrices are column-major, as in glm.
class Uniforms {
 public:
  Uniforms(Gl& gl, GLuint program) : gl_(&gl), program_(program) {}
  GLint location(std::string_view name);  ///< -1 if the program has none

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
