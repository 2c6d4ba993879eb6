// The style and the script of the HTML report, as text: a report is one file that needs nothing beside it.
#pragma once

#include <string_view>

namespace atelier::judge {

/// report.css: for light and dark screens and for paper.
extern const std::string_view report_css;

/// report.js: without it everything can be read; with it there are the slider, the full-size viewer with its arrow
/// keys, the filter and copying of commands.
extern const std::string_view report_script;

}  // namespace atelier::judge
