// Sealed texts: shaders of solutions that a release carries for later steps, in a form that nobody reads by accident.
//
// This is not encryption. The driver needs the text, so whoever wants it can get it, as from a compiled library; but a
// search, an editor or a look at the file shows nothing.
#pragma once

#include <string>
#include <string_view>

namespace atelier {

/// The text in sealed form: a line that says what the file is, then the text's bytes, scrambled.
std::string seal(std::string_view text);

/// Whether these bytes begin as a sealed text does; its first seal_length bytes are enough.
bool is_sealed(std::string_view bytes);
extern const std::size_t seal_length;

/// The text of sealed bytes; other bytes are returned unchanged.
std::string unsealed(std::string bytes);

}  // namespace atelier
