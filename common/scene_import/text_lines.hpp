// The line-and-word format that OBJ and MTL share.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace atelier::scene_import {

/// Walks a text line by line: comments (#) cut, lines that end in a backslash joined with the next, all kinds of line
/// ends. Throws Error naming the file where the text is UTF-16 or holds bytes that no text has.
class TextLines {
 public:
  /// `text` must outlive this; `name` is for messages.
  TextLines(std::string_view text, std::string name);

  /// Steps to the next line that is not empty; false at the end. Its words are then taken by word() and rest().
  bool next();

  /// The next word of the line; empty where there is none.
  std::string_view word();
  /// What is left of the line, without blanks around it.
  std::string_view rest();
  /// The next word as a number; nothing where there is none. Throws Error where it is no number. Overflow gives
  /// infinity.
  std::optional<float> number();

  /// Throws Error "file:line: complaint".
  [[noreturn]] void fail(const std::string& complaint) const;

 private:
  std::string_view text_;
  std::string name_;
  std::size_t at_ = 0;
  int number_of_lines_ = 0, line_number_ = 0;
  std::string joined_;     ///< holds a line that was continued
  std::string_view line_;  ///< what is left of the current line
};

}  // namespace atelier::scene_import
