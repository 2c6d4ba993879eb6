#include "judge/report/report_pixel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "base/columns.hpp"
#include "base/printable.hpp"
#include "base/strict_json.hpp"
#include "case/setting_json.hpp"
#include "judge/compare/measure.hpp"
#include "judge/explain/sentences.hpp"

namespace atelier::judge {
namespace {

// ---- The table

std::string three(double a, double b, double c) {
  return fmt::format("{:.4g} {:.4g} {:.4g}", a, b, c);
}

int code(float encoded) {
  return int(std::clamp(encoded, 0.0f, 1.0f) * 255 + 0.5f);  // also of a NaN: 0
}

/// "0.214 0.214 0.214 [128 128 128]".
std::string colour_words(const Rgba& value, const PixelRow& row) {
  const Image codes = compared_form(Image(1, 1, value), row.how);
  const Rgba& c = codes.at(0, 0);
  return fmt::format("{} [{} {} {}]", three(value.r, value.g, value.b), code(c.r), code(c.g), code(c.b));
}

std::string value_words(const std::optional<Rgba>& value, const PixelRow& row) {
  if (!value) return "-";
  if (is_colour(row.how.unit)) return colour_words(*value, row);
  if (row.how.unit == Unit::degrees) {
    if (value->r == 0 && value->g == 0 && value->b == 0) return "none";
    return three(2.0 * value->r - 1, 2.0 * value->g - 1, 2.0 * value->b - 1);
  }
  const bool scalar = value->r == value->g && value->g == value->b;
  return scalar ? fmt::format("{:.6g}", value->r) : fmt::format("{:.5g} {:.5g} {:.5g}", value->r, value->g, value->b);
}

std::string apart_words(const PixelRow& row) {
  if (!row.yours || !row.right) return "-";
  return fmt::format("{} ({:.3g})", amount(row.apart, row.how.unit), row.tolerance());
}

std::string sign(const PixelRow& row, const TerminalStyle& style) {
  if (!row.right && !row.differs) return " ";
  if (style.unicode) return row.differs ? "\u2717" : "\u2713";
  return row.differs ? "x" : "+";
}

/// Whether all values have the same source, which is then the name of their column.
bool of_one_kind(const PixelReport& report) {
  return std::ranges::all_of(
      report.rows, [&](const PixelRow& row) { return !row.right || row.beside == report.rows.front().beside; });
}

std::string table(const PixelReport& report, const TerminalStyle& style) {
  constexpr std::size_t cells = 5;
  const bool mixed = !of_one_kind(report);
  const std::string right = mixed ? "right" : to_string(report.rows.front().beside);
  std::vector<std::array<std::string, cells>> lines = {{"output", "yours", right, "apart (allowed)", ""}};
  const PixelRow* const first = first_to_differ(report);
  for (const PixelRow& row : report.rows) {
    std::string remark = mixed && row.right ? to_string(row.beside) : "";
    if (&row == first) remark += fmt::format("{}<- the first to differ", remark.empty() ? "" : "  ");
    lines.push_back({row.output, value_words(row.yours, row), value_words(row.right, row), apart_words(row), remark});
  }
  std::array<int, cells> widths{};
  for (const auto& line : lines)
    for (std::size_t i = 0; i < cells; ++i) widths[i] = std::max(widths[i], columns(line[i]));
  std::string text;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::string line = i == 0 ? "   " : " " + sign(report.rows[i - 1], style) + " ";
    for (std::size_t k = 0; k < cells; ++k) line += padded(lines[i][k], widths[k] + 2);
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

// ---- The lines around it

std::string visible_words(Visible visible) {
  switch (visible) {
    case Visible::background:
      return "; it shows the background";
    case Visible::surface:
      return "; it shows a surface";
    case Visible::edge:
      return "; it is beside an edge";
    case Visible::unknown:
      break;
  }
  return "";
}

std::string place_words(const PixelReport& report) {
  std::string text = fmt::format("pixel {},{} of {} x {}, from the upper left corner", report.at.x, report.at.y,
                                 report.size.x, report.size.y);
  text += visible_words(report.visible);
  if (!report.region.empty()) text += "; in the region '" + report.region + "'";
  if (report.masked) text += "; in a mask: the case does not compare it";
  return text + "\n";
}

std::string settings_words(const PixelReport& report) {
  std::string text = report.scene.empty() ? "" : "scene " + report.scene;
  for (const auto& [name, value] : report.settings)
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", name, setting_text(value));
  return text;
}

/// "position, depth: crashed: ...": a line for each problem.
std::vector<std::string> missing_words(const PixelReport& report) {
  std::vector<std::pair<std::string, std::string>> problems;  // and the outputs that have them
  for (const PixelRow& row : report.rows) {
    if (row.yours) continue;
    const auto same = std::ranges::find(problems, row.problem, &std::pair<std::string, std::string>::first);
    if (same == problems.end())
      problems.emplace_back(row.problem, row.output);
    else
      same->second += ", " + row.output;
  }
  std::vector<std::string> lines;
  for (const auto& [problem, outputs] : problems) lines.push_back(outputs + ": " + problem);
  return lines;
}

// ---- JSON

using OrderedJson = nlohmann::ordered_json;

OrderedJson value_json(const std::optional<Rgba>& value) {
  if (!value) return nullptr;
  OrderedJson list = OrderedJson::array();
  for (const float part : {value->r, value->g, value->b}) list.push_back(OrderedJson(strict_json::from_number(part)));
  return list;
}

const char* visible_name(Visible visible) {
  constexpr std::array names = {"unknown", "background", "surface", "edge"};
  return names[std::size_t(visible)];
}

const char* unit_name(Unit unit) {
  constexpr std::array names = {"colour", "encoded", "degrees", "number"};
  return names[std::size_t(unit)];
}

OrderedJson row_json(const PixelRow& row) {
  const bool compared = row.yours && row.right;
  return {{"output", row.output},
          {"unit", unit_name(row.how.unit)},
          {"tolerance", row.tolerance()},
          {"yours", value_json(row.yours)},
          {"right", value_json(row.right)},
          {"beside", row.right ? OrderedJson(to_string(row.beside)) : OrderedJson(nullptr)},
          {"apart", compared ? OrderedJson(strict_json::from_number(row.apart)) : OrderedJson(nullptr)},
          {"differs", row.differs},
          {"problem", row.problem}};
}

}  // namespace

std::string pixel_text(const PixelReport& report, const TerminalStyle& style) {
  std::string text = fmt::format("{}  {}  {}\n{}", report.step, report.case_name, report.title, place_words(report));
  if (const std::string words = settings_words(report); !words.empty())
    text += wrapped(printable(words), style.width, 2) + "\n";
  for (const auto& [step, who] : report.implementations) text += fmt::format("  with {}: {}\n", step, who);
  text += "\n";
  if (!drew_nothing(report)) {
    text += table(report, style) + "\n";
    for (const std::string& line : missing_words(report)) text += wrapped(printable(line), style.width, 2) + "\n";
  }
  return text + wrapped(printable(pixel_sentence(report)), style.width, 0) + "\n";
}

std::string pixel_json(const PixelReport& report) {
  OrderedJson settings = OrderedJson::object(), rows = OrderedJson::array();
  for (const auto& [name, value] : report.settings) settings[name] = setting_to_json(value);
  for (const PixelRow& row : report.rows) rows.push_back(row_json(row));
  const PixelRow* const first = first_to_differ(report);
  const OrderedJson document = {{"step", report.step},
                                {"case", report.case_name},
                                {"pixel", {report.at.x, report.at.y}},
                                {"size", {report.size.x, report.size.y}},
                                {"scene", report.scene},
                                {"settings", std::move(settings)},
                                {"implementations", report.implementations},
                                {"visible", visible_name(report.visible)},
                                {"masked", report.masked},
                                {"region", report.region},
                                {"outputs", std::move(rows)},
                                {"first", first ? OrderedJson(first->output) : OrderedJson(nullptr)},
                                {"functions", report.functions},
                                {"sentence", pixel_sentence(report)}};
  return document.dump(1, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

}  // namespace atelier::judge
