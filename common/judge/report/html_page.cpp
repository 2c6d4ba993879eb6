#include "judge/report/html_page.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <vector>

#include "base/base64.hpp"
#include "base/sha256.hpp"
#include "judge/report/report_words.hpp"

namespace atelier::judge {
namespace {

/// The script's hash for the content security policy, which allows only this script to run.
std::string script_hash(const std::string& script) {
  const std::string digits = sha256(script);
  std::vector<std::byte> bytes;
  for (std::size_t i = 0; i < digits.size(); i += 2)
    bytes.push_back(std::byte(std::stoi(digits.substr(i, 2), nullptr, 16)));
  return "sha256-" + base64(bytes);
}

}  // namespace

std::string html_page(const HtmlPage& page) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; style-src "
      "'unsafe-inline'; script-src '{}'\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n{}<script>{}</script>\n</body>\n</html>\n",
      script_hash(page.script), escape_markup(page.title), page.style, page.body, page.script);
}

std::string environment_footer(const Environment& environment) {
  if (environment.empty()) return {};
  std::string html = "<footer>\n<details class=\"list\">\n<summary>Environment</summary>\n<dl>\n";
  for (const auto& [name, value] : environment) {
    html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", escape_markup(name), escape_markup(value));
  }
  return html + "</dl>\n</details>\n</footer>\n";
}

}  // namespace atelier::judge
