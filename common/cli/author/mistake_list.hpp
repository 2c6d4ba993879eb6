// Adds entries to mistakes.json and variants.json without changing the rest.
#pragma once

#include <string>

namespace atelier {

/// Placeholder in members that an author must write; ./atelier audit reports it.
inline constexpr const char* to_be_written = "TO BE WRITTEN: ";

/// The list with an entry appended; `text` may be empty for a new list. Throws Error naming `file` if it does not end
/// like a list.
std::string with_entry(const std::string& text, const std::string& entry, const std::string& file);

/// A new entry of a mistake or a variant, with placeholders for its texts.
std::string mistake_entry(const std::string& name);
std::string variant_entry(const std::string& name);

/// The list with another spelling, a patch file, added to the mistake `name`. Throws Error naming `file` if there is no
/// such mistake.
std::string with_spelling(const std::string& text, const std::string& name, const std::string& spelling,
                          const std::string& file);

}  // namespace atelier
