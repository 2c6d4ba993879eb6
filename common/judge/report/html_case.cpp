#include "judge/report/html_case.hpp"

#include <fmt/format.h>

#include "base/base64.hpp"
#include "image_io/image_io.hpp"
#include "judge/report/report_pictures.hpp"

namespace atelier::judge {
namespace {

constexpr int small_side = 256;  // the page enlarges smaller pictures with sharp pixels

std::string picture_html(const ReportPicture& picture, bool at_once) {
  const std::string data = base64(encode_png(picture.pixels, {.encoding = Encoding::srgb}));
  const bool small = picture.pixels.width() < small_side;
  return fmt::format(
      "<figure data-role=\"{}\"><button type=\"button\"><img{}{} width=\"{}\" height=\"{}\" alt=\"{}\" "
      "src=\"data:image/png;base64,{}\"></button><figcaption>{}</figcaption></figure>\n",
      picture.role, small ? " class=\"small\"" : "", at_once ? "" : " loading=\"lazy\"", picture.pixels.width(),
      picture.pixels.height(), escape_markup(picture.alt), data, escape_markup(picture.title));
}

std::string score_html(const CaseResult& result) {
  return fmt::format("<span class=\"score\">{}</span>", score_text(result.score, result.max_score));
}

}  // namespace

std::string status_html(Status status) {
  return fmt::format("<span class=\"status {}\">{}</span>", to_string(status), status_words(status));
}

std::string name_link(const std::string& anchor, const CaseResult& result) {
  return fmt::format("<a class=\"name\" href=\"#{}\">{}</a>", anchor, escape_markup(result.name));
}

std::string remark_html(const Remark& remark) {
  const char* const looks = remark.label == "looks like" ? " class=\"looks\"" : "";
  std::string text = escape_markup(remark.text);
  if (remark.label == "rerun") text = "<code class=\"command\">" + text + "</code>";
  return fmt::format("<dt>{}</dt><dd{}>{}</dd>\n", remark.label, looks, text);
}

std::string remarks_html(const std::vector<Remark>& remarks) {
  if (remarks.empty()) return {};
  std::string html = "<dl>\n";
  for (const Remark& remark : remarks) html += remark_html(remark);
  return html + "</dl>\n";
}

std::string text_block(const char* label, const std::string& text, const char* kind) {
  if (text.empty()) return {};
  return fmt::format("<p class=\"soft label\">{}</p>\n<pre class=\"{}\" tabindex=\"0\">{}</pre>\n", label, kind,
                     escape_markup(text));
}

PicturesHtml pictures_html(const CaseResult& result, bool at_once) {
  PicturesHtml html;
  for (const ReportPicture& picture : report_pictures(result)) {
    const bool first = picture.role == "yours" || picture.role == "reference" || picture.role == "difference";
    (first ? html.first : html.rest) += picture_html(picture, at_once && first);
  }
  if (!html.first.empty()) html.first = "<div class=\"pictures first\">\n" + html.first + "</div>\n";
  if (!html.rest.empty()) html.rest = "<div class=\"pictures\">\n" + html.rest + "</div>\n";
  return html;
}

std::string numbers_html(const CaseResult& result) {
  std::string html;
  if (!result.figures.empty()) {
    html += "<p class=\"figures\">";
    for (const auto& [name, value] : result.figures)
      html += fmt::format("<span>{} <b>{:.4g}</b></span> ", escape_markup(name), value);
    html += "</p>\n";
  }
  return html + text_block("Inputs and numbers", result.table, "table");
}

std::string case_html(const std::string& anchor, const CaseResult& result) {
  const PicturesHtml pictures = pictures_html(result);
  return fmt::format(
             "<details class=\"case\" id=\"{}\">\n<summary>{}<span class=\"title\">{}</span> {} {}</summary>\n"
             "<div class=\"body\">\n",
             anchor, status_html(result.status), escape_markup(result.title), name_link(anchor, result),
             score_html(result)) +
         pictures.first + remarks_html(remarks(result)) + numbers_html(result) + pictures.rest +
         text_block("Program output", result.output) + "</div>\n</details>\n";
}

std::string card_html(const std::string& anchor, const CaseResult& result) {
  return fmt::format("<article class=\"case card\" id=\"{}\">\n<h4>{}</h4>\n<p>{} {}</p>\n", anchor,
                     escape_markup(result.title), name_link(anchor, result), score_html(result)) +
         pictures_html(result).first + fmt::format("<p class=\"soft\">{}</p>\n", escape_markup(result.reason)) +
         text_block("Program output", result.output) + "</article>\n";
}

}  // namespace atelier::judge
