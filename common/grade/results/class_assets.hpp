// The style and the script of class.html as text, beside those that it shares with the students' reports.
#pragma once

#include <string_view>

namespace atelier::grade {

extern const std::string_view class_css;     ///< class_report.css
extern const std::string_view class_script;  ///< class_report.js: sorting and searching

}  // namespace atelier::grade
