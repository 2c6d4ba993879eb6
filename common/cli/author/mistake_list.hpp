// Entries of mistakes.json and variants.json, added without touching what else is there.
#pragma once

#include <string>

namespace atelier {

/// What stands in a member that an author has to write: ./atelier audit asks for it.
inline constexpr const char* to_be_written = "TO BE WRITTEN: ";

/// The list with an entry more behind all others; `text` may be empty, for a list that is not there yet. Throws Error
/// naming `file` where it does not end as a list does.
std::string with_entry(const std::string& text, const std::string& entry, const std::string& file);

/// A mistake, or a variant, whose words are to be written.
std::string mistake_entry(const std::string& name);
std::string variant_entry(const std::string& name);

/// The list in which the mistake `name` has a second spelling, NAME.other.patch. Throws Error naming `file` where there
/// is no such mistake.
std::string with_spelling(const std::string& text, const std::string& name, const std::string& file);

}  // namespace atelier
