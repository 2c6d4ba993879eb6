#include "measure/ratios.hpp"

#include <fmt/format.h>

#include <utility>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/strict_json.hpp"
#include "image/error.hpp"

namespace atelier::measure {
namespace {

using strict_json::Json;

constexpr std::size_t ratio_plan_limit = 1 << 16;  ///< bytes

/// A picture's members, with those of `defaults` that it lacks. Refuses those that only the judge reads.
Json asked_picture(const Json& defaults, const Json& object, const std::string& where) {
  strict_json::refuse_unknown(object, {"scene", "size", "camera", "output", "settings"}, where);
  return with_defaults(defaults, object, where);
}

Case picture_named(const char* name, Json object, const std::string& where) {
  object["name"] = name;
  return parse_case(object, where);
}

RatioRow ratio_row_of(const Json& json, const Json& defaults, const std::string& where) {
  strict_json::refuse_unknown(json, {"name", "picture", "beside", "without", "at_most", "alike"}, where);
  const auto member = [&](const char* name) -> const Json& { return strict_json::required(json, name, where); };
  RatioRow row;
  row.name = strict_json::text(member("name"), where + ": name", 60);
  const Json picture = asked_picture(defaults, member("picture"), where + ": picture");
  row.picture = picture_named("picture", picture, where);
  row.beside = picture_named("beside", asked_picture(picture, member("beside"), where + ": beside"), where);
  if (const Json* without = strict_json::optional(json, "without"))
    row.without = picture_named("without", asked_picture(picture, *without, where + ": without"), where);
  if (const Json* most = strict_json::optional(json, "at_most"))
    row.at_most = strict_json::number(*most, where + ": at_most", 0.01, 100);
  if (const Json* alike = strict_json::optional(json, "alike")) {
    row.alike = strict_json::number(*alike, where + ": alike", 0, 1);
    if (row.picture.size != row.beside.size || row.picture.output != row.beside.output)
      throw Error(where + ": alike: pictures of different sizes or outputs are not alike");
  }
  return row;
}

/// What both pictures of a row have taken, round by round.
struct Rounds {
  std::vector<double> seconds, beside_seconds, ratios;
};

}  // namespace

RatioPlan parse_ratio_plan(std::string_view text, const std::string& where) {
  const Json json = strict_json::parse(text, where);
  strict_json::refuse_unknown(json, {"defaults", "counts", "rows"}, where);
  Json defaults = Json::object();
  if (const Json* given = strict_json::optional(json, "defaults"))
    defaults = asked_picture(defaults, *given, where + ": defaults");
  RatioPlan plan;
  plan.counts = strict_json::names(strict_json::required(json, "counts", where), where + ": counts", "_");
  const Json& rows = strict_json::required(json, "rows", where);
  if (!rows.is_array() || rows.empty()) strict_json::refuse(rows, where + ": rows", "a list of at least one row");
  for (const Json& row : rows)
    plan.rows.push_back(ratio_row_of(row, defaults, fmt::format("{}: row {}", where, plan.rows.size() + 1)));
  return plan;
}

RatioPlan read_ratio_plan(const std::filesystem::path& file) {
  return parse_ratio_plan(read_file(file, ratio_plan_limit), file.string());
}

bool holds(const RatioRow& row, const MeasuredRatio& measured) {
  const bool cheap = !row.at_most || measured.ratio.median <= *row.at_most;
  const bool same = !row.alike || (measured.difference && *measured.difference <= *row.alike);
  return cheap && same;
}

std::vector<MeasuredRatio> measure_ratios(const RatioPlan& plan, const Program& program, int rounds, int frames) {
  std::vector<MeasuredRatio> all(plan.rows.size());
  std::vector<Rounds> taken(plan.rows.size());
  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < plan.rows.size(); ++i) {
      const RatioRow& row = plan.rows[i];
      const bool swapped = round % 2 == 1;
      std::vector<Case> pictures = {row.picture, row.beside};
      if (swapped) std::swap(pictures[0], pictures[1]);
      if (row.without) pictures.push_back(*row.without);
      std::vector<Drawn> drawn = draw(program, pictures, frames);
      if (swapped) std::swap(drawn[0], drawn[1]);
      const auto taken_by = [&](std::size_t which) { return drawn[which].cost.times.value().median; };
      const double common = row.without ? taken_by(2) : 0;
      const double seconds = taken_by(0) - common, beside = taken_by(1) - common;
      if (seconds <= 0 || beside <= 0)
        throw Error(fmt::format("'{}': a picture of {:.3f} ms and one of {:.3f} ms must take longer than what is "
                                "subtracted from them, {:.3f} ms",
                                row.name, taken_by(0) * 1e3, taken_by(1) * 1e3, common * 1e3));
      taken[i].seconds.push_back(seconds);
      taken[i].beside_seconds.push_back(beside);
      taken[i].ratios.push_back(seconds / beside);
      if (round > 0) continue;  // all else is the same in each round
      for (const std::string& count : plan.counts) {
        all[i].counts.push_back(count_of(drawn[0].cost, count, "counts"));
        all[i].beside_counts.push_back(count_of(drawn[1].cost, count, "counts"));
      }
      if (row.alike) all[i].difference = error_of(drawn[0].picture, drawn[1].picture, ErrorMetric::rmse);
    }
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i].seconds = median(taken[i].seconds);
    all[i].beside_seconds = median(taken[i].beside_seconds);
    all[i].ratio = spread_of(taken[i].ratios);
  }
  return all;
}

}  // namespace atelier::measure
