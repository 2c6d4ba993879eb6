// The style and the script of the HTML report as text, since a report is one self-contained file.
#pragma once

#include <string_view>

namespace atelier::judge {

/// report.css: for light and dark screens and for printing.
extern const std::string_view report_css;

/// report.js: adds the slider, the full-size viewer with arrow keys, the filter and copying of commands. The report is
/// readable without it.
extern const std::string_view report_script;

}  // namespace atelier::judge
