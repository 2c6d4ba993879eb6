#include "oracle/height_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "oracle/texture.hpp"

namespace atelier::oracle {

namespace {

constexpr double most_repeats = 1e4;
constexpr double farthest = 100;  ///< of HeightField::edges, in half sides

/// A coordinate along a ray.
struct Line {
  double start, slope;  ///< at t = 0, and per unit of t
  double at(double t) const { return start + slope * t; }
  bool finite() const { return std::isfinite(start) && std::isfinite(slope); }
};

/// A part of a ray, closed; empty if least > most.
struct Part {
  double least, most;

  /// Removes what is outside low <= line <= high.
  void clip(const Line& line, double low, double high) {
    if (line.slope == 0) {
      if (!(line.start >= low && line.start <= high)) most = -std::numeric_limits<double>::infinity();
      return;
    }
    const double one = (low - line.start) / line.slope, other = (high - line.start) / line.slope;
    least = std::max(least, std::min(one, other));
    most = std::min(most, std::max(one, other));
  }
};

/// The surface between four neighbouring texel centres: metres above the plane as a function of 0 <= p, q <= 1, to the
/// right and up.
struct Patch {
  double corner = 0, along = 0, up = 0, twist = 0;
  double at(double p, double q) const { return corner + along * p + up * q + twist * p * q; }
};

/// A ray in the field's coordinates.
class FieldRay {
 public:
  FieldRay(const HeightField& field, const Ray& ray)
      : field_(field),
        image_(field.heights->pixels),
        scale_(field.repeat * glm::dvec2(image_.width(), image_.height()) / 2.0),
        normal_(glm::normalize(glm::cross(field.flat.half_u, field.flat.half_v))) {
    const glm::dvec3 &u = field.flat.half_u, &v = field.flat.half_v, from_centre = ray.origin - field.flat.centre;
    const auto line = [&](const glm::dvec3& way) {
      return Line{glm::dot(from_centre, way), glm::dot(ray.direction, way)};
    };
    a_ = line(u / glm::dot(u, u));
    b_ = line(v / glm::dot(v, v));
    z_ = line(normal_);
    x_ = {(a_.start + 1) * scale_.x - 0.5, a_.slope * scale_.x};
    y_ = {(b_.start + 1) * scale_.y - 0.5, b_.slope * scale_.y};
  }

  /// The part that may meet the surface.
  Part part(const Ray& ray) const {
    Part part{ray.least, ray.most};
    if (!(a_.finite() && b_.finite() && z_.finite() && x_.finite() && y_.finite()) ||
        (a_.slope == 0 && b_.slope == 0 && z_.slope == 0))
      return {0, -1};
    if (field_.window && !through_window(ray)) return {0, -1};
    // Slightly more than the slab: the surface may lie in its top or bottom. Thousands of rounding errors.
    const double margin =
        1e-12 * (field_.depth + std::abs(z_.start) + glm::length(field_.flat.half_u) + glm::length(field_.flat.half_v));
    part.clip(z_, -field_.depth - margin, margin);
    Part over = part;
    over.clip(a_, -1, 1);
    over.clip(b_, -1, 1);
    if (!std::isfinite(over.most)) return {0, -1};  // misses, or is as good as without a direction
    if (field_.edges || !(over.least <= over.most)) return over;
    part.clip(a_, -farthest, farthest);
    part.clip(b_, -farthest, farthest);
    return {over.least, part.most};
  }

  std::optional<ShapeHit> walk(const Part& part, bool front_only) const;

 private:
  /// Whether a ray begins below the plane, or crosses it within the rectangle.
  bool through_window(const Ray& ray) const {
    if (!(z_.start + ray.least * z_.slope > 0)) return true;
    if (!(z_.slope < 0)) return false;
    const double t = -z_.start / z_.slope;
    return std::abs(a_.start + t * a_.slope) <= 1 && std::abs(b_.start + t * b_.slope) <= 1;
  }

  /// Metres above the plane at a texel's centre; column from the left, row from the bottom.
  double level(double column, double row) const {
    const bool inside = column >= 0 && row >= 0 && column < image_.width() && row < image_.height();
    const double height = inside ? double(image_.at(int(column), image_.height() - 1 - int(row)).r)
                                 : texel(*field_.heights, column, row).r;
    return field_.depth * (height - 1);
  }
  Patch patch(double column, double row) const {
    const double corner = level(column, row), right = level(column + 1, row), upper = level(column, row + 1);
    return {corner, right - corner, upper - corner, level(column + 1, row + 1) - right - (upper - corner)};
  }
  ShapeHit hit(double t, const Patch& patch, double column, double row) const;

  const HeightField& field_;
  const Image& image_;
  glm::dvec2 scale_;  ///< texels per half side
  glm::dvec3 normal_;
  Line a_{}, b_{}, z_{};  ///< of the rectangle; metres above its plane
  Line x_{}, y_{};        ///< in texels, the centre of texel (column, row) at (column, row)
};

/// The root 0..1 of c + b s + a s^2 at which it falls. There must be one.
double falling_root(double a, double b, double c) {
  const double slope = std::sqrt(std::max(0.0, b * b - 4 * a * c));  // of the fall there
  if (b > 0) return (b + slope) / (-2 * a);
  return slope - b > 0 ? 2 * c / (slope - b) : 0;  // the same without cancellation
}

/// Where on its way, 0..1, a height first reaches zero: from + b s + bend s^2, which ends at `to`. From above only with
/// `front_only`. Each side of its turning point is monotone, so the signs at the ends tell whether there is a root.
std::optional<double> first_zero(double from, double to, double bend, bool front_only) {
  const double b = to - from - bend, turn = bend != 0 ? -b / (2 * bend) : 0;
  const auto zero = [&](double s, double value, double end, double end_value) -> std::optional<double> {
    if (value >= 0 && end_value <= 0 && value > end_value) return std::clamp(falling_root(bend, b, from), s, end);
    if (!front_only && value <= 0 && end_value >= 0 && value < end_value)
      return std::clamp(falling_root(-bend, -b, -from), s, end);
    return std::nullopt;
  };
  if (!(turn > 0 && turn < 1)) return zero(0, from, 1, to);
  const double at_turn = from + b * turn / 2;
  const auto before = zero(0, from, turn, at_turn);
  return before ? before : zero(turn, at_turn, 1, to);
}

std::optional<ShapeHit> FieldRay::walk(const Part& part, bool front_only) const {
  constexpr double never = std::numeric_limits<double>::infinity();
  double column = std::floor(x_.at(part.least)), row = std::floor(y_.at(part.least));
  double t = part.least, p = x_.at(t) - column, q = y_.at(t) - row;
  double above = z_.at(t) - patch(column, row).at(p, q);  // metres from the surface up to the ray
  while (true) {
    const Patch here = patch(column, row);
    p = x_.at(t) - column, q = y_.at(t) - row;
    const double to_column = x_.slope == 0 ? never : (column + (x_.slope > 0) - x_.start) / x_.slope,
                 to_row = y_.slope == 0 ? never : (row + (y_.slope > 0) - y_.start) / y_.slope;
    // Rounding may have put t slightly beyond a side.
    const double next = std::clamp(std::min(to_column, to_row), t, part.most);
    const double next_p = x_.at(next) - column, next_q = y_.at(next) - row;
    const double next_above = z_.at(next) - here.at(next_p, next_q);
    const double bend = -here.twist * (next_p - p) * (next_q - q);
    if (const auto share = first_zero(above, next_above, bend, front_only))
      return hit(t + *share * (next - t), here, column, row);
    if (next >= part.most) return std::nullopt;
    if (to_column <= to_row)
      column += x_.slope > 0 ? 1 : -1;
    else
      row += y_.slope > 0 ? 1 : -1;
    t = next;
    above = next_above;
  }
}

ShapeHit FieldRay::hit(double t, const Patch& patch, double column, double row) const {
  const double x = x_.at(t), y = y_.at(t);
  const double p = std::clamp(x - column, 0.0, 1.0), q = std::clamp(y - row, 0.0, 1.0);
  const glm::dvec3 &u = field_.flat.half_u, &v = field_.flat.half_v;
  const double slope_a = (patch.along + patch.twist * q) * scale_.x, slope_b = (patch.up + patch.twist * p) * scale_.y;
  const glm::dvec3 normal = normal_ - slope_a / glm::dot(u, u) * u - slope_b / glm::dot(v, v) * v;
  return {t, glm::normalize(normal), (glm::dvec2(x, y) + 0.5) / glm::dvec2(image_.width(), image_.height())};
}

bool is_side(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 0 && std::isfinite(length);
}

}  // namespace

void validate(const HeightField& field, const std::string& where) {
  const auto refuse = [&](const std::string& why) { throw Error(fmt::format("{}: height field: {}", where, why)); };
  if (!field.heights || field.heights->pixels.empty()) refuse("it has no heights");
  const Texture& heights = *field.heights;
  if (heights.filter == Filter::nearest)
    refuse(fmt::format("texture '{}' is not interpolated (allowed: Filter::linear, Filter::mipmap)", heights.name));
  for (const Rgba& pixel : heights.pixels.pixels())
    if (!(pixel.r >= 0 && pixel.r <= 1))
      refuse(fmt::format("texture '{}' contains the height {} (allowed: 0 to 1)", heights.name, pixel.r));
  if (!(field.depth >= 0 && std::isfinite(field.depth)))
    refuse(fmt::format("a depth of {} m (allowed: 0 or more)", field.depth));
  const glm::dvec3 &u = field.flat.half_u, &v = field.flat.half_v;
  if (!is_side(u) || !is_side(v) || !(std::abs(glm::dot(u, v)) <= 1e-9 * glm::length(u) * glm::length(v)))
    refuse("its sides are zero or not perpendicular");
  for (const double times : {field.repeat.x, field.repeat.y})
    if (!(times > 0 && times <= most_repeats))
      refuse(fmt::format("repeated {} times (allowed: above 0, to {})", times, most_repeats));
}

std::optional<ShapeHit> intersect(const HeightField& field, const Ray& ray, bool front_only) {
  const FieldRay in_field(field, ray);
  const Part part = in_field.part(ray);
  if (!(part.least <= part.most)) return std::nullopt;
  return in_field.walk(part, front_only);
}

}  // namespace atelier::oracle
