// opening_rectangle: held against the exact bounds of a polygon in a picture, by the ends of its edges.
#include <numeric>
#include <optional>

#include "stability/07-stencil-portals/rows.hpp"

namespace atelier::stability {

using namespace stencil_portals;

namespace {

using Clip = glm::vec<3, long double>;  ///< x, y and w of a corner
using Pixels = glm::vec<2, long double>;

/// What of a polygon is in a picture, in pixels.
struct Bounds {
  Pixels low{1e30L}, high{-1e30L};
  bool any() const { return low.x <= high.x; }
  void add(const Pixels& p) { low = glm::min(low, p), high = glm::max(high, p); }
};

/// Distances from the picture's sides, times w; a picture that is `wider` by so much in x and y.
std::array<long double, 4> inside_by(const Clip& p, const Pixels& wider) {
  return {p.z * (1 + wider.x) + p.x, p.z * (1 + wider.x) - p.x, p.z * (1 + wider.y) + p.y, p.z * (1 + wider.y) - p.y};
}

/// The bounds without cutting a polygon: of what is seen of each edge (an interval of its length), and of those corners
/// of the picture that look at the polygon's inside.
Bounds exact_bounds(const std::vector<glm::vec4>& corners, const glm::ivec2& size, const Pixels& wider = Pixels(0)) {
  std::vector<Clip> polygon;
  for (const glm::vec4& c : corners) polygon.emplace_back(c.x, c.y, c.w);
  const Pixels half = Pixels(size) * 0.5L;
  Bounds bounds;
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Clip &a = polygon[i], &b = polygon[(i + 1) % n];
    const auto at_a = inside_by(a, wider), at_b = inside_by(b, wider);
    // From each end its own way is kept, so that an edge 1e30 m long loses no digits at either.
    long double from_a = 0, from_b = 0;
    bool none = false;
    std::size_t side_a = 4, side_b = 4;
    for (std::size_t side = 0; side < 4; ++side) {
      none = none || (at_a[side] < 0 && at_b[side] < 0);
      if (at_a[side] < 0 && at_b[side] >= 0 && at_a[side] / (at_a[side] - at_b[side]) > from_a)
        from_a = at_a[side] / (at_a[side] - at_b[side]), side_a = side;
      if (at_b[side] < 0 && at_a[side] >= 0 && at_b[side] / (at_b[side] - at_a[side]) > from_b)
        from_b = at_b[side] / (at_b[side] - at_a[side]), side_b = side;
    }
    if (none || from_a + from_b > 1) continue;
    const auto add = [&](Clip p, std::size_t on_side) {
      if (p.z <= 0) return;
      Pixels q(p.x / p.z, p.y / p.z);
      if (on_side < 4) q[int(on_side) / 2] = (1 + wider[int(on_side) / 2]) * (on_side % 2 == 0 ? -1 : 1);
      bounds.add((q + 1.0L) * half);
    };
    add(a + (b - a) * from_a, side_a);
    add(b + (a - b) * from_b, side_b);
  }
  const auto volume = [](const Clip& a, const Clip& b, const Clip& c) { return glm::dot(glm::cross(a, b), c); };
  const Clip middle = std::accumulate(polygon.begin(), polygon.end(), Clip(0));
  for (const Clip& ray : {Clip(-1 - wider.x, -1 - wider.y, 1), Clip(1 + wider.x, -1 - wider.y, 1),
                          Clip(1 + wider.x, 1 + wider.y, 1), Clip(-1 - wider.x, 1 + wider.y, 1)}) {
    bool hit = true;
    for (std::size_t i = 0; i < n; ++i) {
      const Clip &a = polygon[i], &b = polygon[(i + 1) % n];
      hit = hit && volume(a, b, ray) * volume(a, b, middle) > 0;
    }
    if (hit) bounds.add((Pixels(ray.x, ray.y) + 1.0L) * half);
  }
  return bounds;
}

/// How far, in pixels, the polygon's edges would have to be moved so that this is the rectangle: 0 where it is right.
double rectangle_error(const std::vector<glm::vec4>& corners, const glm::ivec2& size, const glm::ivec4& around) {
  const std::optional<glm::ivec4> found = opening_rectangle(corners, size, around);
  const Bounds bounds = exact_bounds(corners, size);
  const glm::ivec2 first(around), end = first + glm::ivec2(around.z, around.w);
  if (!found) {
    if (!bounds.any()) return 0;
    long double least = 1e30L;  // along one axis no pixel is left: beyond the rectangle around, or between two pixels
    for (int i = 0; i < 2; ++i) {
      const long double line = std::round((bounds.low[i] + bounds.high[i]) / 2);
      least = std::min({least, std::max(0.0L, bounds.high[i] - first[i]), std::max(0.0L, end[i] - bounds.low[i]),
                        std::max(bounds.high[i] - line, line - bounds.low[i])});
    }
    return double(least);
  }
  if (found->z <= 0 || found->w <= 0) return double(infinite);
  if (!bounds.any())  // a hair outside counts as inside
    return exact_bounds(corners, size, 0.002L / Pixels(size)).any() ? 0 : double(infinite);
  long double worst = 0;
  for (int i = 0; i < 2; ++i) {
    const int low = (*found)[i], high = low + (*found)[i + 2];
    if (low < first[i] || high > end[i]) return double(infinite);
    if (low > first[i]) worst = std::max(worst, low - bounds.low[i]);
    if (high < end[i]) worst = std::max(worst, bounds.high[i] - high);
    worst = std::max({worst, bounds.low[i] - (low + 1), (high - 1) - bounds.high[i]});
  }
  return double(worst);
}

/// Whole pictures.
double rectangle_error(const std::vector<glm::vec4>& corners, const glm::ivec2& size) {
  return rectangle_error(corners, size, {0, 0, size});
}

/// How far, in pixels, points of a polygon that are in the picture and `around` lie outside of the rectangle.
double points_outside(Trial& t, const std::vector<glm::vec4>& corners, const glm::ivec2& size,
                      const glm::ivec4& around) {
  const std::optional<glm::ivec4> found = opening_rectangle(corners, size, around);
  const glm::dvec2 first(around), end = first + glm::dvec2(around.z, around.w);
  double worst = 0;
  for (int k = 0; k < 1000; ++k) {
    double sum = 0;
    glm::dvec4 p(0);
    for (const glm::vec4& corner : corners) {
      const double share = t.size_between(1e-3, 1);
      p += share * glm::dvec4(corner), sum += share;
    }
    p /= sum;
    const glm::dvec2 q = (glm::dvec2(p) / p.w + 1.0) * 0.5 * glm::dvec2(size);
    const double margin = 1e-3;  // what is nearer to a side may be on either
    if (p.w <= 0 || q.x < first.x + margin || q.y < first.y + margin || q.x > end.x - margin || q.y > end.y - margin)
      continue;
    if (!found) {  // it may lie between two pixels: then all of it is as near to their side
      const Bounds bounds = exact_bounds(corners, size);
      const Pixels extent = bounds.high - bounds.low;
      if (double(std::min(extent.x, extent.y)) > margin) return double(infinite);
      continue;
    }
    for (int i = 0; i < 2; ++i) worst = std::max({worst, (*found)[i] - q[i], q[i] - ((*found)[i] + (*found)[i + 2])});
  }
  return worst;
}

/// A flat convex polygon with its middle at `middle` of view space, its corners on an ellipse of this size, seen under
/// a field of view of 90 degrees.
std::vector<glm::vec4> some_polygon(Trial& t, const glm::dvec3& middle, double size, int corners) {
  const glm::dmat4 frame = odd_frame(t, 0);
  const double narrow = t.between(0.2, 1), start = t.between(0, 1);
  std::vector<glm::vec4> polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.7 * t.between(0, 1) + start) / corners;
    const glm::dvec3 p =
        middle + size * (std::cos(angle) * glm::dvec3(frame[0]) + narrow * std::sin(angle) * glm::dvec3(frame[1]));
    polygon.emplace_back(p.x, p.y, p.z, -p.z);
  }
  return polygon;
}

Values rectangle(const std::vector<glm::vec4>& corners, const glm::ivec2& size, const glm::ivec4& around) {
  const auto found = opening_rectangle(corners, size, around);
  return found ? values(*found) : Values{};
}

std::vector<glm::vec4> box(float left, float bottom, float right, float top, float w = 1) {
  return {{left, bottom, 0, w}, {right, bottom, 0, w}, {right, top, 0, w}, {left, top, 0, w}};
}

void add_named_rectangles(Group& group) {
  const glm::ivec2 size(100);
  const glm::ivec4 all(0, 0, size);
  const auto row = [&](const char* what, const std::vector<glm::vec4>& corners, const Values& expected,
                       const glm::ivec4& around) {
    group.equals(
        what, [=] { return rectangle(corners, size, around); }, expected);
  };
  row("all corners behind the eye", box(-0.5f, -0.5f, 0.5f, 0.5f, -1), {}, all);
  row("all corners behind the eye, far to the side", box(5, 5, 9, 9, -1), {}, all);
  row("all corners at w = 0", box(-1, -1, 1, 1, 0), {}, all);
  row("one corner at w = 0", {{-0.5f, -0.5f, 0, 1}, {0.5f, -0.5f, 0, 1}, {0.5f, 0.5f, 0, 0}}, {25, 25, 75, 75}, all);
  row("one corner at the eye, on a line between two pixels", {{0, 0, 0, 0}, {-0.5f, 0, 0, 1}, {0.5f, 0, 0, 1}}, {},
      all);
  row("a floor from behind the eye", {{-10, -0.5f, 0, -5}, {10, -0.5f, 0, -5}, {10, -0.5f, 0, 20}, {-10, -0.5f, 0, 20}},
      {0, 0, 100, 49}, all);
  row("corners before and behind, all of the picture between",
      {{-9, -2, 0, 1}, {9, -2, 0, 1}, {9, 9, 0, -1}, {-9, 9, 0, -1}}, {0, 0, 100, 100}, all);
  row("it touches the left side from outside", box(-2, -0.5f, -1, 0.5f), {}, all);
  row("the right side", box(1, -0.5f, 2, 0.5f), {}, all);
  row("the lower side", box(-0.5f, -2, 0.5f, -1), {}, all);
  row("the upper side", box(-0.5f, 1, 0.5f, 2), {}, all);
  row("one corner of the picture alone", {{1, 1, 0, 1}, {3, 1, 0, 1}, {1, 3, 0, 1}}, {}, all);
  row("a line slants past a corner of the picture", {{0.5f, 2, 0, 1}, {2, 0.5f, 0, 1}, {2, 2, 0, 1}}, {}, all);
  row("the whole picture to its very sides", box(-1, -1, 1, 1), {0, 0, 100, 100}, all);
  row("it covers the picture: all of what is around", box(-7, -8, 9, 6), {20, 30, 5, 6}, {20, 30, 5, 6});
  row("nothing around: no width", box(-1, -1, 1, 1), {}, {10, 10, 0, 5});
  row("nothing around: no height", box(-1, -1, 1, 1), {}, {10, 10, 5, 0});
  row("it ends where what is around begins", box(-1, -1, 0, 0), {}, {50, 0, 50, 100});
  for (const float huge : {1e4f, 1e8f, 1e12f}) {
    row(fmt::format("corners at {:g}: it covers the picture", huge).c_str(), box(-huge, -huge, huge, huge),
        {0, 0, 100, 100}, all);
    row(fmt::format("from -{:g} to the middle of a pixel", huge).c_str(), box(-huge, -huge, 0.51f, 0.31f),
        {0, 0, 76, 66}, all);
    row(fmt::format("all of x, y and w are {:g} as large", huge).c_str(),
        box(-0.51f * huge, -0.51f * huge, 0.51f * huge, 0.51f * huge, huge), {24, 24, 52, 52}, all);
  }
  for (const float tiny : {1e-4f, 1e-18f, 1e-30f})
    row(fmt::format("all of x, y and w are {:g} as large", tiny).c_str(),
        box(-0.51f * tiny, -0.51f * tiny, 0.51f * tiny, 0.51f * tiny, tiny), {24, 24, 52, 52}, all);
  // Without an area nothing, or the line itself, is seen: both are the smallest.
  group.equals("seen from its own plane, from behind to before the eye: other than none or its line",
               [=] {
                 const std::vector<glm::vec4> edge_on = {
                     {-0.25f, -1, 0, -1}, {0.25f, -1, 0, 1}, {0.25f, 1, 0, 1}, {-0.25f, 1, 0, -1}};
                 const Values found = rectangle(edge_on, size, all);
                 return Values{double(!found.empty() && found != Values{62, 0, 1, 100})};
               },
               {0});
  group.equals("pictures of one pixel: inside, across, beside",
               [] {
                 const auto of = [](const std::vector<glm::vec4>& corners) {
                   return double(rectangle(corners, glm::ivec2(1), {0, 0, 1, 1}) == Values{0, 0, 1, 1});
                 };
                 return Values{of(box(-1e-3f, -1e-3f, 1e-3f, 1e-3f)), of(box(-5, -5, 5, 5)), of(box(2, -1, 3, 1))};
               },
               {1, 1, 0});
}

void add_random_rectangles(Group& group) {
  const Bound allowed{1e-3, "pixels", "the contract's own"};
  const auto row = [&](std::string what, int count, auto error) {
    group.close(std::move(what), allowed, [=] { return worst_of(count, 730, error); });
  };
  row("2000 quadrangles about the eye, many with corners behind it", 2000, [](Trial& t) {
    return rectangle_error(some_polygon(t, t.in_cube(3), t.between(0.5, 4), 4), {640, 480});
  });
  row("2000 triangles to heptagons a metre before the eye", 2000, [](Trial& t) {
    return rectangle_error(
        some_polygon(t, {t.between(-1, 1), t.between(-1, 1), -1}, t.between(0.1, 2), 3 + int(t.between(0, 5))),
        {1920, 1080});
  });
  for (const double near : {1e-1, 1e-2, 1e-3, 1e-4})
    row(fmt::format("2000 triangles of a metre, with a plane about {:g} m from the eye", near), 2000, [=](Trial& t) {
      const glm::dmat4 frame = odd_frame(t, 0);
      std::vector<glm::vec4> corners;
      for (int i = 0; i < 3; ++i) {
        const Exact p = at(frame, {t.between(-1, 1), t.between(-1, 1), near});
        corners.emplace_back(p.x, p.y, p.z, -p.z);
      }
      return rectangle_error(corners, {640, 480});
    });
  for (const double before : {1e-2, 1e-4})
    row(fmt::format("4000 looks about from {:g} m before an opening of 2 m x 2 m", before), 4000, [=](Trial& t) {
      const glm::dmat4 frame = odd_frame(t, 0);
      const double x = t.between(-0.9, 0.9), y = t.between(-0.9, 0.9);
      std::vector<glm::vec4> corners;
      for (const glm::dvec2& c : {glm::dvec2(-1, -1), glm::dvec2(1, -1), glm::dvec2(1, 1), glm::dvec2(-1, 1)}) {
        const Exact p = at(frame, {c.x - x, c.y - y, -before});
        corners.emplace_back(p.x, p.y, p.z, -p.z);
      }
      return rectangle_error(corners, {1920, 1080});
    });
  row("2000 triangles of 1e-4 to 1e4 m at such distances", 2000, [](Trial& t) {
    const double size = t.size_between(1e-4, 1e4);
    return rectangle_error(some_polygon(t, t.size_between(1e-4, 1e4) * t.direction(), size, 3), {640, 480});
  });
  row("2000 triangles in pictures of 16384 x 16384", 2000,
      [](Trial& t) { return rectangle_error(some_polygon(t, t.in_cube(3), t.between(0.5, 4), 3), glm::ivec2(16384)); });
  row("2000 triangles in pictures of 1 x 1 to 5 x 5", 2000, [](Trial& t) {
    const int width = 1 + int(t.between(0, 5));
    return rectangle_error(some_polygon(t, t.in_cube(3), t.between(0.1, 4), 3), {width, 1 + int(t.between(0, 5))});
  });
  row("2000 upright openings in what is around them", 2000, [](Trial& t) {
    const float x = float(t.between(-2, 1)), y = float(t.between(-2, 1));
    const glm::ivec4 around(t.between(0, 400), t.between(0, 300), t.between(1, 240), t.between(1, 180));
    return rectangle_error(box(x, y, x + float(t.between(0.1, 2)), y + float(t.between(0.1, 2))), {640, 480}, around);
  });
  row("300 quadrangles: none of 1000 points of each, seen in what is around, is outside", 300, [](Trial& t) {
    const std::vector<glm::vec4> corners = some_polygon(t, t.in_cube(3), t.between(0.5, 4), 4);
    const glm::ivec4 around(t.between(0, 400), t.between(0, 300), t.between(1, 240), t.between(1, 180));
    return std::max(points_outside(t, corners, {640, 480}, around),
                    points_outside(t, corners, {640, 480}, {0, 0, 640, 480}));
  });
}

}  // namespace

void add_rectangle_rows(Table& table) {
  Group group = table.of("opening_rectangle");
  add_named_rectangles(group);
  add_random_rectangles(group);
}

}  // namespace atelier::stability
