// Assembles one GLSL text from many files (GLSL has no #include) and records the file of each line.
#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <optional>

#include "base/file.hpp"
#include "base/sealed.hpp"
#include "gl/shader.hpp"

namespace atelier {
namespace {

constexpr int deepest_include = 32;
constexpr std::size_t largest_file = 1 << 20;  // bytes; a shader file of a megabyte is a mistake

/// A file's text with every line ending in '\n'. Throws Error for a null byte.
std::string normalised(std::string text, const std::string& name) {
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);  // UTF-8's byte order mark
  if (const auto at = text.find('\0'); at != std::string::npos)
    throw Error(fmt::format("{}:{}: contains a null byte: this is not GLSL text", name,
                            1 + std::count(text.begin(), text.begin() + std::ptrdiff_t(at), '\n')));
  for (std::size_t at = 0; (at = text.find('\r', at)) != std::string::npos; ++at)
    at + 1 < text.size() && text[at + 1] == '\n' ? text.erase(at, 1) : text.replace(at, 1, "\n");
  if (text.empty() || text.back() != '\n') text += '\n';  // an empty file has one empty line: errors need a place
  if (text.ends_with("\\\n")) text += '\n';  // a continued last line must not swallow what follows the file
  return text;
}

/// Tracks from line to line where comments begin and end.
class CommentTracker {
 public:
  /// `line` with its comments replaced by spaces; positions do not change.
  std::string without_comments(std::string_view line);
  bool inside() const { return inside_; }

 private:
  bool inside_ = false;  ///< a /* comment that has not ended
};

std::string CommentTracker::without_comments(std::string_view line) {
  std::string code(line);
  bool quoted = false;  // in the name of an #include, the only quotes in GLSL
  for (std::size_t i = 0; i < code.size(); ++i) {
    const std::string_view pair = line.substr(i, 2);
    if (inside_) {
      const bool ends = pair == "*/";
      code[i] = ' ';
      if (ends) code[++i] = ' ', inside_ = false;
    } else if (code[i] == '"') {
      quoted = !quoted;
    } else if (!quoted && pair == "//") {
      std::fill(code.begin() + std::ptrdiff_t(i), code.end(), ' ');
      break;
    } else if (!quoted && pair == "/*") {
      code[i] = code[i + 1] = ' ';
      ++i, inside_ = true;
    }
  }
  return code;
}

/// A line that begins with '#': the directive's name, and where the rest of the line begins.
struct Directive {
  std::string word;
  std::size_t begin = 0, rest = 0;
};

std::optional<Directive> directive_in(const std::string& code) {
  constexpr const char* blank = " \t\v\f";
  const std::size_t hash = code.find_first_not_of(blank);
  if (hash == std::string::npos || code[hash] != '#') return std::nullopt;
  const std::size_t word = std::min(code.find_first_not_of(blank, hash + 1), code.size());
  std::size_t end = word;
  while (end < code.size() && std::isalpha(static_cast<unsigned char>(code[end]))) ++end;
  return Directive{code.substr(word, end - word), hash, end};
}

std::string define_lines(const Defines& defines) {
  std::string lines;
  for (const auto& [name, value] : defines) lines += fmt::format("#define {} {}\n", name, value);
  return lines;
}

bool is_blank(std::string_view text) {
  return text.find_first_not_of(" \t\v\f") == std::string_view::npos;
}

class Assembler {
 public:
  explicit Assembler(const FindFile& find) : find_(find) {}

  /// Adds the file for `name`; `where` ("file:line: ", or empty) is the line that includes it.
  void add_file(const std::string& name, const std::string& where, int depth);
  void add_text(const std::filesystem::path& file, const std::string& name, const std::string& text, int depth);
  ShaderSource finish(const Defines& defines) &&;

 private:
  void add_line(ShaderSource::Line from, std::string_view text, CommentTracker& comments, int depth);
  void add_include(ShaderSource::Line from, std::string_view text, const std::string& code, const Directive& directive,
                   int depth);
  void emit(ShaderSource::Line from, std::string_view text);
  std::string place(ShaderSource::Line from) const;  ///< "file:line: "

  const FindFile& find_;
  ShaderSource source_;
};

void Assembler::add_file(const std::string& name, const std::string& where, int depth) {
  std::filesystem::path file = find_(name);
  if (file.empty()) throw Error(fmt::format("{}shader file \"{}\" is not found", where, name));
  file = std::filesystem::weakly_canonical(file);  // one file, however it is spelt
  if (std::find(source_.files.begin(), source_.files.end(), file) != source_.files.end()) return;
  if (depth > deepest_include)
    throw Error(fmt::format("{}\"{}\" is included {} files deep, and at most {} are allowed", where, name, depth,
                            deepest_include));
  std::string text;
  try {
    text = unsealed(read_file(file, largest_file));  // a release has its solutions' shaders sealed
  } catch (const Error& error) {
    throw Error(where + error.what());
  }
  add_text(file, name, text, depth);
}

void Assembler::add_text(const std::filesystem::path& file, const std::string& name, const std::string& text,
                         int depth) {
  ShaderSource::Line from{int(source_.files.size()), 0};
  source_.files.push_back(file);
  source_.names.push_back(name);

  const std::string lines = normalised(text, name);
  CommentTracker comments;
  ShaderSource::Line comment_begin;
  for (std::size_t begin = 0; begin < lines.size();) {
    const std::size_t end = lines.find('\n', begin);
    const bool inside = comments.inside();
    ++from.line;
    add_line(from, std::string_view(lines).substr(begin, end - begin), comments, depth);
    if (!inside && comments.inside()) comment_begin = from;
    begin = end + 1;
  }
  // It would comment out whatever follows the file.
  if (comments.inside()) throw Error(place(comment_begin) + "this /* comment has no end");
}

void Assembler::add_line(ShaderSource::Line from, std::string_view text, CommentTracker& comments, int depth) {
  const std::string code = comments.without_comments(text);
  if (const auto directive = directive_in(code)) {
    if (directive->word == "include") return add_include(from, text, code, *directive, depth);
    if (directive->word == "version" || directive->word == "extension" || directive->word == "line")
      throw Error(
          fmt::format("{}remove this #{}: the program puts `#version 330 core` in front of every shader and keeps "
                      "track of files and lines itself",
                      place(from), directive->word));
  }
  emit(from, text);
}

void Assembler::add_include(ShaderSource::Line from, std::string_view text, const std::string& code,
                            const Directive& directive, int depth) {
  const std::size_t open = code.find('"', directive.rest);
  const std::size_t close = open == std::string::npos ? open : code.find('"', open + 1);
  if (close == std::string::npos || close == open + 1 ||
      !is_blank(code.substr(directive.rest, open - directive.rest)) || !is_blank(code.substr(close + 1)))
    throw Error(place(from) + "this must read #include \"file\"");

  // Around the directive there can only be comments, which may begin or end on other lines: keep them.
  const std::string_view before = text.substr(0, directive.begin), behind = text.substr(close + 1);
  if (!is_blank(before)) emit(from, before);
  add_file(code.substr(open + 1, close - open - 1), place(from), depth + 1);
  if (!is_blank(behind)) emit(from, behind);
}

void Assembler::emit(ShaderSource::Line from, std::string_view text) {
  source_.text.append(text) += '\n';
  source_.lines.push_back(from);
}

std::string Assembler::place(ShaderSource::Line from) const {
  return fmt::format("{}:{}: ", source_.names[std::size_t(from.file)], from.line);
}

ShaderSource Assembler::finish(const Defines& defines) && {
  const std::string head = "#version 330 core\n" + define_lines(defines);
  source_.text.insert(0, head);
  std::vector<ShaderSource::Line> head_lines;
  for (std::size_t line = 1; line <= 1 + defines.size(); ++line) head_lines.push_back({-1, line});
  source_.lines.insert(source_.lines.begin(), head_lines.begin(), head_lines.end());
  return std::move(source_);
}

}  // namespace

std::string text_including(const std::string& file, const Defines& defines, const std::string& before) {
  return define_lines(defines) + before + fmt::format("#include \"{}\"\n", file);
}

ShaderSource assemble_shader(const FindFile& find, const std::string& name, const Defines& defines) {
  Assembler assembler(find);
  assembler.add_file(name, "", 0);
  return std::move(assembler).finish(defines);
}

ShaderSource assemble_shader_text(const FindFile& find, const std::string& text, const std::string& label,
                                  const Defines& defines) {
  Assembler assembler(find);
  assembler.add_text(label, label, text, 0);
  return std::move(assembler).finish(defines);
}

}  // namespace atelier
