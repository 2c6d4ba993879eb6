#include "scene_import/obj_file.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <unordered_map>

#include "base/error.hpp"
#include "base/file.hpp"
#include "scene_import/scene_import.hpp"
#include "scene_import/text_lines.hpp"

namespace atelier::scene_import {
namespace {

constexpr int most_corners = 10'000;

class ObjParser {
 public:
  ObjParser(std::string_view text, const std::filesystem::path& path) : lines_(text, path.string()) {
    file_.objects.push_back(path.stem().string());
  }

  ObjFile parse() {
    while (lines_.next()) {
      const std::string_view keyword = lines_.word();
      if (keyword == "v")
        add_position();
      else if (keyword == "vt")
        add_texcoord();
      else if (keyword == "vn")
        add_normal();
      else if (keyword == "f" || keyword == "fo")
        add_face();  // fo: the keyword of the format's first version
      else if (keyword == "o" || keyword == "g")
        object_ = place_of(lines_.rest(), file_.objects, object_places_);
      else if (keyword == "usemtl")
        material_ = place_of(lines_.rest(), file_.materials, material_places_);
      else if (keyword == "mtllib")
        file_.libraries.emplace_back(lines_.rest());
      else if (keyword == "s")
        set_smoothing(lines_.word());
    }
    check_numbers_ahead();
    return std::move(file_);
  }

 private:
  using Places = std::unordered_map<std::string, int>;

  void add_position() {
    const auto x = lines_.number(), y = lines_.number(), z = lines_.number();
    if (!z) lines_.fail("a vertex needs three coordinates");
    if (!(std::isfinite(*x) && std::isfinite(*y) && std::isfinite(*z)))
      lines_.fail(fmt::format("the position is not finite ({}, {}, {})", *x, *y, *z));
    if (file_.positions.size() >= max_import_vertices)
      lines_.fail(fmt::format("more than {} vertices", max_import_vertices));
    file_.positions.emplace_back(*x, *y, *z);
  }

  void add_texcoord() {
    const float u = lines_.number().value_or(0), v = lines_.number().value_or(0);
    file_.texcoords.push_back(std::isfinite(u) && std::isfinite(v) ? glm::vec2(u, v) : glm::vec2(0));
  }

  void add_normal() {
    const float x = lines_.number().value_or(0), y = lines_.number().value_or(0), z = lines_.number().value_or(0);
    file_.normals.emplace_back(x, y, z);
  }

  /// 1 is the first element of the list, which may come later in the file; -1 its last element so far.
  int vertex(std::string_view text) {
    const std::optional<long long> value = whole_number(text);
    if (!value) lines_.fail(fmt::format("'{}' is not a vertex number", text.substr(0, 40)));
    const std::optional<int> place = place_in(*value, file_.positions.size());
    if (!place) lines_.fail(fmt::format("vertex {} of {}", *value, file_.positions.size()));
    if (*place >= int(file_.positions.size()) && (ahead_.empty() || *place > ahead_.back().place))
      ahead_.push_back({*place, lines_.line_number()});
    return *place;
  }

  /// The same of what a corner may lack; -1 for a number that names nothing.
  int attribute(std::string_view text, std::size_t count) {
    const std::optional<long long> value = whole_number(text);
    const std::optional<int> place = value ? place_in(*value, count) : std::nullopt;
    if (!place) ++file_.missing_attributes;
    return place.value_or(-1);
  }

  static std::optional<long long> whole_number(std::string_view text) {
    long long value = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    return problem == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
  }

  static std::optional<int> place_in(long long value, std::size_t count) {
    const long long place = value > 0 ? value - 1 : (long long)(count) + value;
    const bool possible = value != 0 && place >= 0 && place < std::numeric_limits<int>::max();
    return possible ? std::optional(int(place)) : std::nullopt;
  }

  /// At the end of the file, when the lists are complete.
  void check_numbers_ahead() {
    for (const Ahead& ahead : ahead_)
      if (ahead.place >= int(file_.positions.size()))
        lines_.fail(fmt::format("vertex {} of {}", (long long)(ahead.place) + 1, file_.positions.size()), ahead.line);
    const auto check = [&](int& place, std::size_t count) {
      if (place < int(count)) return;
      place = -1;
      ++file_.missing_attributes;
    };
    for (ObjCorner& corner : file_.corners) {
      check(corner.texcoord, file_.texcoords.size());
      check(corner.normal, file_.normals.size());
    }
  }

  /// "7", "7/2", "7//3" or "7/2/3".
  ObjCorner corner(std::string_view text) {
    const std::size_t first = std::min(text.find('/'), text.size());
    const std::size_t second = first == text.size() ? first : std::min(text.find('/', first + 1), text.size());
    ObjCorner corner;
    corner.position = vertex(text.substr(0, first));
    if (first + 1 < second)
      corner.texcoord = attribute(text.substr(first + 1, second - first - 1), file_.texcoords.size());
    if (second + 1 < text.size()) corner.normal = attribute(text.substr(second + 1), file_.normals.size());
    return corner;
  }

  void add_face() {
    ObjFace face{.first = file_.corners.size(), .object = object_, .material = material_, .smoothing = smoothing_};
    for (std::string_view text = lines_.word(); !text.empty(); text = lines_.word()) {
      file_.corners.push_back(corner(text));
      if (++face.count > most_corners) lines_.fail(fmt::format("a face of more than {} corners", most_corners));
    }
    if (face.count < 3) {
      file_.corners.resize(face.first);
      return;
    }
    triangles_ += std::size_t(face.count - 2);
    if (triangles_ > max_import_triangles) lines_.fail(fmt::format("more than {} triangles", max_import_triangles));
    file_.faces.push_back(face);
  }

  void set_smoothing(std::string_view text) {
    int group = 0;
    std::from_chars(text.data(), text.data() + text.size(), group);
    smoothing_ = text == "off" || group < 1 ? 0 : group;
  }

  static int place_of(std::string_view name, std::vector<std::string>& names, Places& places) {
    const auto [place, added] = places.try_emplace(std::string(name), int(names.size()));
    if (added) names.emplace_back(name);
    return place->second;
  }

  TextLines lines_;
  ObjFile file_;
  struct Ahead {
    int place, line;
  };
  std::vector<Ahead> ahead_;  ///< vertices named before they came, where the number was the largest so far
  Places object_places_, material_places_;
  int object_ = 0, material_ = -1, smoothing_ = -1;
  std::size_t triangles_ = 0;
};

}  // namespace

ObjFile read_obj_file(const std::filesystem::path& path) {
  const std::string text = read_file(path);
  if (text.empty()) throw Error(fmt::format("{}: the file is empty", path.string()));
  return ObjParser(text, path).parse();
}

}  // namespace atelier::scene_import
