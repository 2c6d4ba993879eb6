#include "judge/compare/regions.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/strict_json.hpp"

namespace atelier::judge {
namespace {

using strict_json::Json;

constexpr double least_weight = 0.01, most_weight = 100;

Rectangle read_rectangle(const Json& value, const std::string& where, glm::ivec2 size) {
  const std::string allowed =
      fmt::format("[x, y, width, height] in whole pixels from the upper left, inside {}x{}", size.x, size.y);
  if (!value.is_array() || value.size() != 4) strict_json::refuse(value, where, allowed);
  for (const Json& number : value)
    if (!number.is_number_integer()) strict_json::refuse(value, where, allowed);
  const auto inside = [&](int begin, int length, int side) {
    const auto first = value[std::size_t(begin)].get<long long>(), count = value[std::size_t(length)].get<long long>();
    return first >= 0 && first < side && count >= 1 && count <= side - first;
  };
  if (!inside(0, 2, size.x) || !inside(1, 3, size.y)) strict_json::refuse(value, where, allowed);
  return {value[0].get<int>(), value[1].get<int>(), value[2].get<int>(), value[3].get<int>()};
}

Json to_json(const Rectangle& r) {
  return {r.x, r.y, r.width, r.height};
}

bool overlap(const Rectangle& a, const Rectangle& b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

template <class Visit>
void for_pixels(const Rectangle& r, Visit visit) {
  for (int y = r.y; y < r.y + r.height; ++y)
    for (int x = r.x; x < r.x + r.width; ++x) visit(x, y);
}

}  // namespace

std::vector<Rectangle> read_mask(const Json& list, const std::string& where, glm::ivec2 size) {
  if (!list.is_array() || list.empty()) strict_json::refuse(list, where, "a list of rectangles [x, y, width, height]");
  std::vector<Rectangle> mask;
  for (const Json& value : list)
    mask.push_back(read_rectangle(value, fmt::format("{}: rectangle {}", where, mask.size()), size));
  const double fraction = mask_of(mask, size).count() / (double(size.x) * size.y);
  if (fraction > max_masked_fraction)
    throw Error(
        fmt::format("{}: {:.3g} of the picture is masked; at most {} may be", where, fraction, max_masked_fraction));
  return mask;
}

std::vector<Region> read_regions(const Json& list, const std::string& where, glm::ivec2 size) {
  if (!list.is_array() || list.empty()) strict_json::refuse(list, where, "a list of objects {name, at, weight}");
  std::vector<Region> regions;
  for (const Json& object : list) {
    const std::string place = fmt::format("{}: region {}", where, regions.size());
    strict_json::refuse_unknown(object, {"name", "at", "weight"}, place);
    Region region;
    region.name = strict_json::text(strict_json::required(object, "name", place), place + ": name", 64);
    region.at = read_rectangle(strict_json::required(object, "at", place), place + ": at", size);
    region.weight = strict_json::number(strict_json::required(object, "weight", place), place + ": weight",
                                        least_weight, most_weight);
    for (const Region& other : regions)
      if (overlap(other.at, region.at))
        throw Error(fmt::format("{}: '{}' overlaps '{}'; regions must not overlap", place, region.name, other.name));
    regions.push_back(std::move(region));
  }
  return regions;
}

Json to_json(const std::vector<Rectangle>& mask) {
  Json list = Json::array();
  for (const Rectangle& rectangle : mask) list.push_back(to_json(rectangle));
  return list;
}

Json to_json(const std::vector<Region>& regions) {
  Json list = Json::array();
  for (const Region& region : regions)
    list.push_back({{"name", region.name}, {"at", to_json(region.at)}, {"weight", region.weight}});
  return list;
}

Mask mask_of(const std::vector<Rectangle>& mask, glm::ivec2 size) {
  Mask result(size.x, size.y);
  for (const Rectangle& rectangle : mask) for_pixels(rectangle, [&](int x, int y) { result.set(x, y, true); });
  return result;
}

double weighted_fraction(const Mask& over, const std::vector<Rectangle>& mask, const std::vector<Region>& regions) {
  const Mask masked = mask_of(mask, {over.width(), over.height()});
  // Count every pixel once, then add each region's extra weight.
  double failing = 0, all = double(over.width()) * over.height() - masked.count();
  for (int y = 0; y < over.height(); ++y)
    for (int x = 0; x < over.width(); ++x) failing += over.at(x, y) && !masked.at(x, y);
  for (const Region& region : regions)
    for_pixels(region.at, [&](int x, int y) {
      if (masked.at(x, y)) return;
      all += region.weight - 1;
      failing += over.at(x, y) ? region.weight - 1 : 0;
    });
  return failing / all;
}

}  // namespace atelier::judge
