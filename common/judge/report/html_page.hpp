// What all HTML reports have in common: one self-contained page that loads nothing and runs only its own script.
#pragma once

#include <string>

#include "judge/compare/result.hpp"

namespace atelier::judge {

struct HtmlPage {
  std::string title;         ///< plain text
  std::string style;         ///< CSS
  std::string body, script;  ///< markup, without the body element; JavaScript
};

/// The whole document. Its content security policy allows only this script, pictures in data addresses and styles.
std::string html_page(const HtmlPage& page);

/// The environment, folded, as the end of a page; nothing if it is empty.
std::string environment_footer(const Environment& environment);

}  // namespace atelier::judge
