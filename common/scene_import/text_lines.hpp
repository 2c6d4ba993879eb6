// The line-based text format of OBJ and MTL.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace atelier::scene_import {

/// Reads a text line by line. A comment begins with # at the beginning of a line or of a word; names (`rest`) may
/// contain it. Joins lines that end in a backslash with the next, accepts all kinds of line ends. Throws Error naming
/// the file if the text is UTF-16 or contains null bytes.
class TextLines {
 public:
  /// `text` must outlive this; `name` is for messages.
  TextLines(std::string_view text, std::string name);

  /// Goes to the next line that is not empty; false at the end. Read its words with word() and rest().
  bool next();

  /// The next word of the line; empty if there is none.
  std::string_view word();
  /// The rest of the line, without surrounding spaces: a name.
  std::string_view rest();
  /// The next word as a number; none at the end of the line. Throws Error if it is not a number. Overflow gives
  /// infinity; "1.#INF", "1.#QNAN" and the like, which old programs write, are what they stand for.
  std::optional<float> number();

  int line_number() const { return line_number_; }  ///< of the current line, from 1

  /// Throws Error "file:line: complaint" about the current line, or an earlier one.
  [[noreturn]] void fail(const std::string& complaint) const { fail(complaint, line_number_); }
  [[noreturn]] void fail(const std::string& complaint, int line) const;

 private:
  std::string_view text_;
  std::string name_;
  std::size_t at_ = 0;
  int number_of_lines_ = 0, line_number_ = 0;
  std::string joined_;     ///< a line with its continuation lines
  std::string_view line_;  ///< the rest of the current line
};

}  // namespace atelier::scene_import
