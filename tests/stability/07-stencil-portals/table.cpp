// Step 07's table of extremes. What a function gives is held against the geometry of vectors, in long double: points
// are taken apart along the axes of frames, pictures of polygons are bounded by the ends of their edges.
#include <numeric>

#include "07-stencil-portals/stencil_portals.hpp"
#include "stability/entry.hpp"
#include "stability/rows.hpp"

namespace atelier::stability {

namespace {

using namespace stencil_portals;

using Exact = glm::vec<3, long double>;

constexpr double double_unit = 0x1p-53;  ///< what one rounding of a double may cost, relative to the result
constexpr double million = 1e6;

double largest_of(const Exact& v) {
  return double(std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}));
}

// ---- Frames

/// Turned at random, `distance` metres from the origin.
glm::dmat4 odd_frame(Trial& t, double distance) {
  const Exact z = glm::normalize(Exact(t.direction()));
  Exact other(0);
  other[std::abs(z.x) < 0.6L ? 0 : 1] = 1;
  const Exact u = glm::normalize(glm::cross(other, z)), v = glm::cross(z, u);
  const double angle = t.between(0, 2 * std::numbers::pi);
  const long double c = std::cos(static_cast<long double>(angle)), s = std::sin(static_cast<long double>(angle));
  const Exact x = c * u + s * v, y = c * v - s * u;
  return {glm::dvec4(x, 0), glm::dvec4(y, 0), glm::dvec4(z, 0), glm::dvec4(distance * t.direction(), 1)};
}

/// A multiple of 1/1024 between -size and size.
double dyadic(Trial& t, double size) {
  return std::floor(t.between(-size, size) * 1024) / 1024;
}

glm::dvec3 dyadic_place(Trial& t, double size) {
  const double x = dyadic(t, size), y = dyadic(t, size);
  return {x, y, dyadic(t, size)};
}

/// At one of the 24 turns by quarters, at multiples of 1/1024 m.
glm::dmat4 quarter_frame(Trial& t, double size) {
  const int first = int(t.between(0, 3)), second = (first + (t.sign() > 0 ? 1 : 2)) % 3;
  glm::dvec3 x(0), y(0);
  x[first] = t.sign();
  y[second] = t.sign();
  return {glm::dvec4(x, 0), glm::dvec4(y, 0), glm::dvec4(glm::cross(x, y), 0), glm::dvec4(dyadic_place(t, size), 1)};
}

Exact axis(const glm::dmat4& frame, int i) {
  return Exact(glm::dvec3(frame[i]));
}
Exact origin(const glm::dmat4& frame) {
  return Exact(glm::dvec3(frame[3]));
}
/// The point at these coordinates of a frame.
Exact at(const glm::dmat4& frame, const Exact& local) {
  return origin(frame) + local.x * axis(frame, 0) + local.y * axis(frame, 1) + local.z * axis(frame, 2);
}
/// Metres before the frame's plane.
long double height_above(const glm::dmat4& frame, const Exact& p) {
  return glm::dot(axis(frame, 2), p - origin(frame));
}

/// What was to the right of the entry's axes by so much is as far to the left of the exit's, and the same for front and
/// back: who goes in backwards along z comes out forwards.
Exact turned_through(const glm::dmat4& entry, const glm::dmat4& exit, const Exact& direction) {
  return -glm::dot(axis(entry, 0), direction) * axis(exit, 0) + glm::dot(axis(entry, 1), direction) * axis(exit, 1) -
         glm::dot(axis(entry, 2), direction) * axis(exit, 2);
}
Exact through(const glm::dmat4& entry, const glm::dmat4& exit, const Exact& p) {
  return origin(exit) + turned_through(entry, exit, p - origin(entry));
}
Exact reflected(const glm::dmat4& mirror, const Exact& p) {
  return p - 2 * height_above(mirror, p) * axis(mirror, 2);
}

Exact mapped(const glm::dmat4& passage, const glm::dvec3& p) {
  return Exact(glm::dvec3(passage * glm::dvec4(p, 1)));
}

/// Of the upper left 3x3, in long double.
double determinant_of(const glm::dmat4& m) {
  return double(glm::dot(axis(m, 0), glm::cross(axis(m, 1), axis(m, 2))));
}

Bound metres(double size, const char* reason) {
  return {16 * double_unit * size, "m", reason};
}

// ---- Passages

const char* const sums_of_products = "coordinates of that size through a matrix that is a product of three";

/// Adds rows for passages of any kind: make(trial, distance) is a passage with its exact map.
template <class Make>
void add_passage_rows(Group& group, double determinant, Make make) {
  for (const double distance : {1.0, 1e3, million})
    group.close(fmt::format("1000 odd frames {:g} m from the origin, points 10 m from them", distance),
                metres(2 * (distance + 10), sums_of_products), [=] {
                  return worst_of(1000, 700, [=](Trial& t) {
                    const auto [passage, exact, place] = make(t, distance, false);
                    const glm::dvec3 p = place + 10.0 * t.direction();
                    return largest_of(mapped(passage, p) - exact(Exact(p)));
                  });
                });
  group.equals("1000 frames at quarter turns and dyadic places up to 2048 m along each axis: the error",
               [=] {
                 return Values{worst_of(1000, 701, [=](Trial& t) {
                   const auto [passage, exact, place] = make(t, 2048, true);
                   const glm::dvec3 p = dyadic_place(t, 2048);
                   return largest_of(mapped(passage, p) - exact(Exact(p)));
                 })};
               },
               {0});
  group.close(fmt::format("determinant {:+g}, lengths stay, a million metres away", determinant),
              {32 * double_unit, "absolute", "products of three turns, each of unit vectors with a rounding each"},
              [=] {
                return worst_of(1000, 702, [=](Trial& t) {
                  const glm::dmat4 passage = std::get<0>(make(t, million, false));
                  const glm::dmat3 turn(passage);
                  return std::max(std::abs(determinant_of(passage) - determinant),
                                  difference(values(glm::transpose(turn) * turn), values(glm::dmat3(1))));
                });
              });
}

using Map = std::function<Exact(const Exact&)>;

std::tuple<glm::dmat4, Map, glm::dvec3> some_portal(Trial& t, double distance, bool quarters) {
  const glm::dmat4 entry = quarters ? quarter_frame(t, distance) : odd_frame(t, distance);
  const glm::dmat4 exit = quarters ? quarter_frame(t, distance) : odd_frame(t, distance);
  return {portal_passage(entry, exit), [=](const Exact& p) { return through(entry, exit, p); }, glm::dvec3(entry[3])};
}

std::tuple<glm::dmat4, Map, glm::dvec3> some_mirror(Trial& t, double distance, bool quarters) {
  const glm::dmat4 frame = quarters ? quarter_frame(t, distance) : odd_frame(t, distance);
  return {mirror_passage(frame), [=](const Exact& p) { return reflected(frame, p); }, glm::dvec3(frame[3])};
}

void add_portal_rows(Table& table) {
  Group group = table.of("portal_passage");
  add_passage_rows(group, 1, some_portal);
  for (const double distance : {1.0, million})
    group.close(fmt::format("there and back, {:g} m away: the identity for points 10 m from the entry", distance),
                metres(4 * (distance + 10), "two passages one after the other"), [=] {
                  return worst_of(1000, 703, [=](Trial& t) {
                    const glm::dmat4 entry = odd_frame(t, distance), exit = odd_frame(t, distance);
                    const glm::dvec3 p = glm::dvec3(entry[3]) + 10.0 * t.direction();
                    const glm::dvec3 there(mapped(portal_passage(entry, exit), p));
                    return largest_of(mapped(portal_passage(exit, entry), there) - Exact(p));
                  });
                });
  group.close("into the very frame that it comes out of: half a turn about y", metres(20, sums_of_products), [] {
    return worst_of(1000, 704, [](Trial& t) {
      const glm::dmat4 frame = odd_frame(t, 10);
      const Exact local(t.in_cube(5));
      return largest_of(mapped(portal_passage(frame, frame), glm::dvec3(at(frame, local))) -
                        at(frame, {-local.x, local.y, -local.z}));
    });
  });
  group.close("points of the entry's plane come to lie on the exit's, a million metres away",
              metres(2 * million, sums_of_products), [] {
                return worst_of(1000, 705, [](Trial& t) {
                  const glm::dmat4 entry = odd_frame(t, million), exit = odd_frame(t, million);
                  const Exact p = at(entry, {t.between(-5, 5), t.between(-5, 5), 0});
                  return std::abs(double(height_above(exit, mapped(portal_passage(entry, exit), glm::dvec3(p)))));
                });
              });
}

void add_mirror_rows(Table& table) {
  Group group = table.of("mirror_passage");
  add_passage_rows(group, -1, some_mirror);
  group.close("twice, a million metres away: the identity", metres(4 * million, "two passages one after the other"),
              [] {
                return worst_of(1000, 706, [](Trial& t) {
                  const glm::dmat4 frame = odd_frame(t, million), passage = mirror_passage(frame);
                  const glm::dvec3 p = glm::dvec3(frame[3]) + 10.0 * t.direction();
                  return largest_of(mapped(passage, glm::dvec3(mapped(passage, p))) - Exact(p));
                });
              });
  group.close("points of the mirror stay", metres(20, sums_of_products), [] {
    return worst_of(1000, 707, [](Trial& t) {
      const glm::dmat4 frame = odd_frame(t, 10);
      const glm::dvec3 p(at(frame, {t.between(-5, 5), t.between(-5, 5), 0}));
      return largest_of(mapped(mirror_passage(frame), p) - Exact(p));
    });
  });
}

// ---- Views

/// The view of a camera that stands as a frame does: right, up and backwards are its axes.
glm::mat4 view_of(const glm::dmat4& camera) {
  glm::mat4 view(1);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) view[column][row] = float(camera[row][column]);
    view[3][row] = float(-glm::dot(axis(camera, row), origin(camera)));
  }
  return view;
}

/// Where a view has a point, in double precision.
glm::dvec3 seen(const glm::mat4& view, const glm::dvec3& p) {
  return glm::dvec3(glm::dmat4(view) * glm::dvec4(p, 1));
}

/// The largest difference between what the camera sees of points and what the virtual camera sees of their images, as
/// a share of how far from the origin all of that is.
template <class Make>
double view_error(double distance, bool quarters, Make make) {
  return worst_of(1000, 710, [=](Trial& t) {
    const auto [passage, exact, place] = make(t, distance, quarters);
    const glm::dmat4 camera = quarters ? quarter_frame(t, distance) : odd_frame(t, distance);
    const glm::mat4 view = view_of(camera), inside = virtual_view(view, passage);
    const glm::dvec3 p = quarters ? dyadic_place(t, distance) : place + 10.0 * t.direction();
    return largest_of(Exact(seen(inside, glm::dvec3(exact(Exact(p))))) - Exact(seen(view, p))) / (distance + 10);
  });
}

void add_view_rows(Table& table) {
  Group group = table.of("virtual_view");
  const Bound rounded{12 * rounding_unit, "of the distance",
                      "each of three turns and a shift is rounded, and the points are that far away, twice"};
  for (const double distance : {1.0, 1e3, million}) {
    group.close(fmt::format("1000 portals {:g} m from the origin: images are seen where the points are", distance),
                rounded, [=] { return view_error(distance, false, some_portal); });
    group.close(fmt::format("1000 mirrors {:g} m from the origin", distance), rounded,
                [=] { return view_error(distance, false, some_mirror); });
  }
  group.equals("quarter turns and dyadic places up to 1024 m, portals and mirrors: the error",
               [] {
                 return Values{view_error(1024, true, some_portal), view_error(1024, true, some_mirror)};
               },
               {0, 0});
  group.close("a view that a mirror has turned round has a determinant of -1",
              {8 * rounding_unit, "absolute", "nine rounded entries"}, [] {
                return worst_of(1000, 711, [](Trial& t) {
                  const glm::mat4 view = view_of(odd_frame(t, 5));
                  return std::abs(determinant_of(glm::dmat4(virtual_view(view, mirror_passage(odd_frame(t, 5))))) + 1);
                });
              });
  group.close("the mirror in the mirror: the camera's own view, 100 m away",
              {16 * rounding_unit * 100, "absolute", "two rounded views one after the other"}, [] {
                return worst_of(1000, 712, [](Trial& t) {
                  const glm::mat4 view = view_of(odd_frame(t, 100));
                  const glm::dmat4 passage = mirror_passage(odd_frame(t, 100));
                  return difference(values(virtual_view(virtual_view(view, passage), passage)), values(view));
                });
              });
}

// ---- Planes

void add_plane_rows(Table& table) {
  Group group = table.of("opening_plane");
  const auto error = [](const glm::dmat4& frame, const Exact& local, bool from_behind) {
    const glm::dvec4 plane = opening_plane(frame, from_behind);
    const Exact p(glm::dvec3(at(frame, local)));
    const long double expected = height_above(frame, p) * (from_behind ? -1 : 1);
    return std::abs(double(glm::dot(Exact(glm::dvec3(plane)), p) + static_cast<long double>(plane.w) - expected));
  };
  for (const double distance : {1.0, million})
    for (const bool behind : {false, true})
      group.close(
          fmt::format("1000 odd frames {:g} m away, points 10 m around{}", distance, behind ? ", from behind" : ""),
          metres(distance + 10, "three products of that size are summed to the plane's offset"), [=] {
            return worst_of(1000, 720, [=](Trial& t) {
              const glm::dmat4 frame = odd_frame(t, distance);
              return error(frame, Exact(10.0 * t.direction()), behind);
            });
          });
  group.equals("quarter turns and dyadic places up to 2048 m along each axis: the error, and on the plane",
               [=] {
                 return Values{worst_of(1000, 721, [=](Trial& t) {
                   const glm::dmat4 frame = quarter_frame(t, 2048);
                   const Exact local(dyadic_place(t, 64));
                   return std::max({error(frame, local, false), error(frame, local, true),
                                    error(frame, {local.x, local.y, 0}, false)});
                 })};
               },
               {0});
}

// ---- Rectangles

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

// ---- A visitor

const glm::dvec2 half_door(1, 1.25);

/// By the volumes between the line and the opening's edges: all are on one side where the line is inside.
bool meets(const glm::dmat4& frame, const glm::dvec2& half_size, const Exact& from, const Exact& to) {
  if (height_above(frame, from) < 0 || height_above(frame, to) >= 0) return false;
  const Exact corners[] = {at(frame, {-half_size.x, -half_size.y, 0}), at(frame, {half_size.x, -half_size.y, 0}),
                           at(frame, {half_size.x, half_size.y, 0}), at(frame, {-half_size.x, half_size.y, 0})};
  int before = 0;
  for (int i = 0; i < 4; ++i)
    before += glm::dot(glm::cross(corners[i] - from, corners[(i + 1) % 4] - corners[i]), to - from) <= 0;
  return before == 4;
}

/// Of `count` movements of this length about a frame, how many the function judges wrongly; those that rounding may
/// decide are left out, and less than half of them may be. `steepest` is the largest slope against the plane, 1 for
/// any.
double misjudged(int count, double distance, double length, double steepest) {
  int wrong = 0, judged = 0;
  for (int i = 0; i < count; ++i) {
    Trial t(740, i);
    const glm::dmat4 frame = odd_frame(t, distance);
    const double z = -steepest * t.between(0.1, 1), angle = t.between(0, 2 * std::numbers::pi);
    const double flat = std::sqrt(1 - z * z), before = t.between(-0.5, 1.5);
    const Exact met(1.5 * half_door.x * t.between(-1, 1), 1.5 * half_door.y * t.between(-1, 1), 0);
    const Exact along = static_cast<long double>(length) * Exact(flat * std::cos(angle), flat * std::sin(angle), z);
    const glm::dvec3 from(at(frame, met - static_cast<long double>(before) * along));
    const glm::dvec3 to(at(frame, met + static_cast<long double>(1 - before) * along));
    const double noise = 32 * double_unit * (distance + length + 2), aside = noise / std::abs(z);
    const double a = double(height_above(frame, Exact(from))), b = double(height_above(frame, Exact(to)));
    if (std::abs(a) < noise || std::abs(b) < noise) continue;
    const bool certain = meets(frame, half_door - aside, Exact(from), Exact(to));
    if (certain != meets(frame, half_door + aside, Exact(from), Exact(to))) continue;
    wrong += goes_through(frame, half_door, from, to) != certain;
    ++judged;
  }
  return judged < count / 2 ? double(infinite) : double(wrong);
}

/// How often someone goes through who walks straight on through an opening in steps of this length, first before it,
/// at last behind it.
double times_through(const glm::dmat4& frame, double step, double offset) {
  double times = 0;
  for (int k = -50; k < 50; ++k) {
    const glm::dvec3 from(at(frame, {0.25L, 0.5L, -static_cast<long double>(k * step + offset)}));
    const glm::dvec3 to(at(frame, {0.25L, 0.5L, -static_cast<long double>((k + 1) * step + offset)}));
    times += goes_through(frame, half_door, from, to);
  }
  return times;
}

void add_through_rows(Table& table) {
  Group group = table.of("goes_through");
  struct Case {
    double distance, length, steepest;
    const char* words;
  };
  for (const Case& c :
       {Case{1, 1e-9, 1, "1e-9 m"}, Case{1, 1, 1, "1 m"}, Case{1, 1e7, 1, "1e7 m"},
        Case{million, 1, 1, "1 m, a million metres away"}, Case{million, 1e-6, 1, "1e-6 m, a million metres away"},
        Case{million, 1e7, 1, "1e7 m, a million metres away"}, Case{1, 1, 1e-6, "1 m, a millionth out of the plane"},
        Case{1, 1e7, 1e-5, "1e7 m, a hundred-thousandth out of the plane"}})
    group.equals(fmt::format("4000 movements of {}: misjudged", c.words),
                 [=] { return Values{misjudged(4000, c.distance, c.length, c.steepest)}; }, {0});

  // Quarter turns and dyadic places: nothing is rounded.
  const auto row = [&](const char* what, const Exact& from, const Exact& to, bool expected) {
    group.equals(std::string(what) + ", 200 frames: others",
                 [=] {
                   return Values{worst_of(200, 741, [=](Trial& t) {
                     const glm::dmat4 frame = quarter_frame(t, 2048);
                     return double(goes_through(frame, half_door, glm::dvec3(at(frame, from)),
                                                glm::dvec3(at(frame, to))) != expected);
                   })};
                 },
                 {0});
  };
  const long double x = half_door.x, y = half_door.y, hair = 1.0L / 1024;
  row("straight through a corner", {x, y, 3}, {x, y, -7}, true);
  row("at an angle through a corner", {-x - 2, -y + 1, 0.5L}, {-x + 2, -y - 1, -0.5L}, true);
  row("through the rim", {x, 0, 0.25L}, {x, 0, -0.25L}, true);
  row("1 mm beside the rim", {x + hair, 0, 0.25L}, {x + hair, 0, -0.25L}, false);
  row("1 mm above the rim", {0, -y - hair, 0.25L}, {0, -y - hair, -0.25L}, false);
  row("from the plane to behind it", {0.5L, 0.5L, 0}, {5, 5, -1}, true);
  row("from the plane beside the opening", {x + 1, 0, 0}, {0, 0, -1}, false);
  row("from before onto the plane", {0, 0, 1}, {0, 0, 0}, false);
  row("along the plane, in it", {-x, 0, 0}, {x, 0, 0}, false);
  row("along the plane, before it", {-5, 0, hair}, {5, 0, hair}, false);
  row("along the plane, behind it", {-5, 0, -hair}, {5, 0, -hair}, false);
  row("no movement on the plane", {0.5L, 0, 0}, {0.5L, 0, 0}, false);
  row("no movement before it", {0.5L, 0, 1}, {0.5L, 0, 1}, false);
  row("no movement behind it", {0.5L, 0, -1}, {0.5L, 0, -1}, false);
  row("from behind to before", {0, 0, -1}, {0, 0, 1}, false);
  row("from behind onto the plane", {0, 0, -1}, {0, 0, 0}, false);
  row("from far before to a hair behind", {0, 0, 2048}, {0, 0, -hair}, true);

  group.equals("a walk with a halt on the plane, quarter turns: times through, most and least",
               [] {
                 double least = 9, most = 0;
                 for (int i = 0; i < 200; ++i) {
                   Trial t(742, i);
                   const double times = times_through(quarter_frame(t, 2048), 1.0 / 1024, 0);
                   least = std::min(least, times), most = std::max(most, times);
                 }
                 return Values{least, most};
               },
               {1, 1});
  group.equals("walks in steps of 1e-8 m, odd frames a million metres away: times through, most and least",
               [] {
                 double least = 9, most = 0;
                 for (int i = 0; i < 200; ++i) {
                   Trial t(743, i);
                   const double times = times_through(odd_frame(t, million), 1e-8, 1e-8 * t.between(0, 1));
                   least = std::min(least, times), most = std::max(most, times);
                 }
                 return Values{least, most};
               },
               {1, 1});
  group.equals("an opening without an extent: through its point, and beside it",
               [] {
                 const glm::dmat4 frame(1);
                 return Values{double(goes_through(frame, {0, 0}, {0, 0, 1}, {0, 0, -1})),
                               double(goes_through(frame, {0, 0}, {1e-300, 0, 1}, {1e-300, 0, -1}))};
               },
               {1, 0});
}

/// Carried `times` through a portal and back through its exit.
Camera there_and_back(Camera camera, const glm::dmat4& entry, const glm::dmat4& exit, int times) {
  const glm::dmat4 there = portal_passage(entry, exit), back = portal_passage(exit, entry);
  for (int i = 0; i < times; ++i) camera = carried(carried(camera, there), back);
  return camera;
}

/// Beside a frame.
Camera camera_by(Trial& t, const glm::dmat4& frame) {
  Camera camera;
  camera.eye = glm::dvec3(frame[3]) + 2.0 * t.direction();
  camera.target = camera.eye + 5.0 * t.direction();
  camera.up = glm::vec3(t.direction());
  return camera;
}

void add_carried_rows(Table& table) {
  Group group = table.of("carried");
  for (const double distance : {1.0, million})
    group.close(fmt::format("1000 odd portals {:g} m away: eye and target", distance),
                metres(2 * (distance + 10), sums_of_products), [=] {
                  return worst_of(1000, 750, [=](Trial& t) {
                    const glm::dmat4 entry = odd_frame(t, distance), exit = odd_frame(t, distance);
                    const Camera camera = camera_by(t, entry), after = carried(camera, portal_passage(entry, exit));
                    return std::max(largest_of(Exact(after.eye) - through(entry, exit, Exact(camera.eye))),
                                    largest_of(Exact(after.target) - through(entry, exit, Exact(camera.target))));
                  });
                });
  group.close("a million metres away: up", {2 * rounding_unit, "absolute", "a turn in double precision, rounded"}, [] {
    return worst_of(1000, 751, [](Trial& t) {
      const glm::dmat4 entry = odd_frame(t, million), exit = odd_frame(t, million);
      const Camera camera = camera_by(t, entry), after = carried(camera, portal_passage(entry, exit));
      return largest_of(Exact(after.up) - turned_through(entry, exit, Exact(camera.up)));
    });
  });
  for (const double distance : {10.0, million})
    group.close(
        fmt::format("10000 times there and back through odd frames {:g} m away", distance),
        {1e-3, "m", "a visitor may not notice; 20000 passages of some ten roundings of that distance each make 2e-5 m"},
        [=] {
          return worst_of(20, 752, [=](Trial& t) {
            const glm::dmat4 entry = odd_frame(t, distance), exit = odd_frame(t, distance);
            const Camera camera = camera_by(t, entry), after = there_and_back(camera, entry, exit, 10'000);
            return std::max(largest_of(Exact(after.eye) - Exact(camera.eye)),
                            largest_of(Exact(after.target) - Exact(camera.target)));
          });
        });
  group.close(
      "10000 times there and back: where up is", {0.1, "degrees", "20000 roundings of a float, all one way"}, [] {
        return worst_of(20, 753, [](Trial& t) {
          const glm::dmat4 entry = odd_frame(t, 10), exit = odd_frame(t, 10);
          const Camera camera = camera_by(t, entry);
          return degrees_between(glm::dvec3(there_and_back(camera, entry, exit, 10'000).up), glm::dvec3(camera.up));
        });
      });
  group.equals("10000 times there and back at quarter turns and dyadic places: the error",
               [] {
                 return Values{worst_of(20, 754, [](Trial& t) {
                   const glm::dmat4 entry = quarter_frame(t, 2048), exit = quarter_frame(t, 2048);
                   Camera camera;
                   camera.eye = dyadic_place(t, 2048), camera.target = dyadic_place(t, 2048);
                   camera.up = {0, 0.6f, 0.8f};
                   const Camera after = there_and_back(camera, entry, exit, 10'000);
                   return std::max({difference(values(after.eye), values(camera.eye)),
                                    difference(values(after.target), values(camera.target)),
                                    difference(values(after.up), values(camera.up))});
                 })};
               },
               {0});
  group.equals("all else stays",
               [] {
                 Camera camera;
                 camera.projection = Projection::orthographic;
                 camera.fov_y = 3, camera.height = 1e-9f, camera.near = -1e9f, camera.far = infinite;
                 const Camera after = carried(camera, mirror_passage(glm::dmat4(1)));
                 return Values{double(after.projection == Projection::orthographic), double(after.fov_y),
                               double(after.height), double(after.near), double(after.far)};
               },
               {1, 3, double(1e-9f), -1e9, double(infinite)});
}

// ---- Near planes

/// A view that turns, or turns and reflects.
glm::mat4 some_view(const glm::dmat4& camera, bool reflecting) {
  glm::mat4 view = view_of(camera);
  if (reflecting)
    for (int column = 0; column < 4; ++column) view[column][0] = -view[column][0];
  return view;
}

void add_plane_in_view_rows(Table& table) {
  Group group = table.of("plane_in_view");
  // How far apart both distances of a point are.
  const auto error = [](const glm::dvec4& plane, const glm::mat4& view, const glm::dvec3& p) {
    const glm::vec4 found = plane_in_view(plane, view);
    const glm::vec<4, long double> v(glm::dmat4(view) * glm::dvec4(p, 1));
    return std::abs(double(glm::dot(glm::vec<4, long double>(found), v) -
                           glm::dot(glm::vec<4, long double>(plane), glm::vec<4, long double>(p, 1))));
  };
  for (const bool reflecting : {false, true})
    for (const double size : {1e-3, 1.0, 1e3})
      group.close(
          fmt::format("1000 odd {}views and planes, all within {:g} m", reflecting ? "reflecting " : "", size),
          {16 * rounding_unit, "of that size",
           "the view's nine entries are rounded, then the plane's four, and points are up to 4 sizes from the eye"},
          [=] {
            return worst_of(1000, 760, [=](Trial& t) {
              const glm::dmat4 frame = odd_frame(t, size), camera = odd_frame(t, size);
              const glm::dvec4 plane(glm::dvec3(frame[2]), double(-glm::dot(axis(frame, 2), origin(frame))));
              return error(plane, some_view(camera, reflecting), t.in_cube(size)) / size;
            });
          });
  for (const bool reflecting : {false, true})
    group.equals(fmt::format("quarter turns and dyadic places a million metres away{}: the error",
                             reflecting ? ", reflecting" : ""),
                 [=] {
                   return Values{worst_of(1000, 761, [=](Trial& t) {
                     glm::dmat4 camera = quarter_frame(t, 0), frame = quarter_frame(t, 16);
                     const glm::dvec3 place = million * glm::dvec3(t.sign(), t.sign(), t.sign());
                     camera[3] = glm::dvec4(place, 1);
                     frame[3] += glm::dvec4(place, 0);
                     const glm::dvec4 plane(glm::dvec3(frame[2]), double(-glm::dot(axis(frame, 2), origin(frame))));
                     return error(plane, some_view(camera, reflecting), place + dyadic_place(t, 64));
                   })};
                 },
                 {0});
}

struct Frustum {
  double slope_x = 1, slope_y = 1, near = 0.1, far = 100;  ///< slopes: half the width at 1 m
  /// Rounded to floats, as step 01's is.
  glm::mat4 projection() const {
    glm::mat4 p(0);
    p[0][0] = float(1 / slope_x), p[1][1] = float(1 / slope_y);
    p[2][2] = float((near + far) / (near - far)), p[2][3] = -1, p[3][2] = float(2 * near * far / (near - far));
    return p;
  }
};

/// Tilted by so many degrees away from the view's direction, so far from the eye.
glm::vec4 tilted_plane(Trial& t, double distance, double degrees) {
  const double tilt = degrees * std::numbers::pi / 180, around = t.between(0, 2 * std::numbers::pi);
  return glm::vec4(
      glm::dvec4(std::sin(tilt) * std::cos(around), std::sin(tilt) * std::sin(around), -std::cos(tilt), -distance));
}

/// z and w of a point of view space.
glm::dvec2 depth_and_w(const glm::mat4& projection, const glm::dvec3& p) {
  const glm::dvec4 clip = glm::dmat4(projection) * glm::dvec4(p, 1);
  return {clip.z, clip.w};
}

/// A point of the plane in a direction of the frustum; none if that does not meet it before the eye, or at a cosine
/// below `least`.
std::optional<glm::dvec3> on_plane(Trial& t, const Frustum& frustum, const glm::vec4& plane, double least = 1e-3) {
  const glm::dvec3 along(frustum.slope_x * t.between(-1, 1), frustum.slope_y * t.between(-1, 1), -1);
  const double towards = glm::dot(glm::dvec3(plane), along);
  if (towards < least) return {};
  return along * (-double(plane.w) / towards);
}

/// The largest error over planes at this distance and tilt: z = -w on the plane.
double off_plane(double distance, double degrees) {
  return worst_of(500, 770, [=](Trial& t) {
    const Frustum frustum{t.between(0.3, 2), t.between(0.3, 2), 0.1, 1e4};
    const glm::vec4 plane = tilted_plane(t, distance, degrees);
    const glm::mat4 oblique = oblique_projection(frustum.projection(), plane);
    double worst = 0;
    for (int i = 0; i < 20; ++i)
      if (const auto p = on_plane(t, frustum, plane)) {
        const glm::dvec2 clip = depth_and_w(oblique, *p);
        worst = std::max(worst, std::abs(clip.x + clip.y) / clip.y);
      }
    return worst;
  });
}

/// The same of the far corners: the largest of their z / w is 1. The far plane is that of the rounded projection.
double off_corner(double distance, double degrees) {
  return worst_of(500, 771, [=](Trial& t) {
    const Frustum frustum{t.between(0.3, 2), t.between(0.3, 2), 0.1, 1e4};
    const glm::vec4 plane = tilted_plane(t, distance, degrees);
    const glm::mat4 projection = frustum.projection(), oblique = oblique_projection(projection, plane);
    const double far = double(projection[3][2]) / (double(projection[2][2]) + 1);
    double largest = -double(infinite);
    for (const double x : {-1.0, 1.0})
      for (const double y : {-1.0, 1.0}) {
        const glm::dvec3 corner(far * x / double(projection[0][0]), far * y / double(projection[1][1]), -far);
        const glm::dvec2 clip = depth_and_w(oblique, corner);
        largest = std::max(largest, clip.x / clip.y);
      }
    return std::abs(largest - 1);
  });
}

void add_oblique_rows(Table& table) {
  Group group = table.of("oblique_projection");
  for (const double distance : {1e-4, 1e-2, 1.0, 1e3})
    for (const double degrees : {0.0, 60.0, 89.0}) {
      group.close(
          fmt::format("500 planes {:g} m from the eye, tilted by {:g} degrees: z = -w on them", distance, degrees),
          {64 * rounding_unit, "of w",
           "four terms of a row, each rounded twice, up to five times as large as w where the plane is steep"},
          [=] { return off_plane(distance, degrees); });
      group.close(fmt::format("{:g} m, {:g} degrees: z = w at the farthest corner", distance, degrees),
                  {(64 + 16 * distance / 0.1) * rounding_unit, "of w",
                   "who inverts the projection in floats finds 1 / far as a difference of numbers like 1 / near (0.1 "
                   "m): that much of the plane's distance, and a row's roundings"},
                  [=] { return off_corner(distance, degrees); });
    }
  group.equals("x, y and w stay, to the last bit: others of 1000",
               [] {
                 return Values{worst_of(1000, 772, [](Trial& t) {
                   const Frustum frustum{t.between(0.3, 2), t.between(0.3, 2), 0.1, 1e4};
                   const glm::mat4 p = frustum.projection();
                   const double distance = t.size_between(1e-4, 1e3);
                   const glm::mat4 o = oblique_projection(p, tilted_plane(t, distance, t.between(0, 89)));
                   double others = 0;
                   for (int column = 0; column < 4; ++column)
                     for (const int row : {0, 1, 3}) others += p[column][row] != o[column][row];
                   return others;
                 })};
               },
               {0});
  group.equals(
      "points a ten-thousandth before and behind the plane: clipped or not, wrong of 1000",
      [] {
        return Values{worst_of(1000, 773, [](Trial& t) {
          const Frustum frustum{t.between(0.3, 2), t.between(0.3, 2), 0.1, 1e4};
          const glm::vec4 plane = tilted_plane(t, t.size_between(1e-4, 1e3), t.between(0, 80));
          const glm::mat4 oblique = oblique_projection(frustum.projection(), plane);
          const auto p = on_plane(t, frustum, plane, 0.1);
          if (!p) return 0.0;
          const glm::dvec2 before = depth_and_w(oblique, *p * (1 - 1e-4) - 1e-4 * glm::dvec3(plane) * double(-plane.w));
          const glm::dvec2 behind = depth_and_w(oblique, *p * (1 + 1e-4) + 1e-4 * glm::dvec3(plane) * double(-plane.w));
          return double(before.x >= -before.y) + double(behind.x <= -behind.y);
        })};
      },
      {0});
  for (const double far : {1.0, 1e2, 1e4})
    group.close(fmt::format("the near plane itself, far / near {:g}: the projection", far / 0.1),
                {16 * rounding_unit, "absolute",
                 "a scaled row: the error of 1 / far is like that of 1 / near, where the plane is"},
                [=] {
                  const Frustum frustum{1, 0.75, 0.1, far};
                  return difference(values(oblique_projection(frustum.projection(), {0, 0, -1, -0.1f})),
                                    values(frustum.projection()));
                });
}

// ---- GLSL

void add_cut_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("cut_away (GLSL)");
  const ShaderFunction function{text_including("07-stencil-portals/stencil_portals.glsl"),
                                {"p", "plane"},
                                "vec4(cut_away(p.xyz, plane) ? 1.0 : 0.0)"};
  const auto of = [=, &shaders](glm::vec3 p, glm::vec4 plane) {
    return Values{shaders.number(function, input_of(p, plane))};
  };
  const glm::vec4 at_5(0, 0, 1, -5), behind(0, 0, -1, 5);
  group.equals("on the plane", [=] { return of({1, 2, 5}, at_5); }, {0});
  group.equals("on the plane, from behind", [=] { return of({1, 2, 5}, behind); }, {0});
  group.equals("one float before it", [=] { return of({1, 2, std::nextafter(5.0f, 0.0f)}, at_5); }, {1});
  group.equals("one float beyond it", [=] { return of({1, 2, std::nextafter(5.0f, 9.0f)}, at_5); }, {0});
  group.equals("one float beyond it, from behind", [=] { return of({1, 2, std::nextafter(5.0f, 9.0f)}, behind); }, {1});
  group.equals("1e30 m along the plane", [=] { return of({1e30f, -1e30f, 4}, at_5); }, {1});
  group.equals("1e30 m before and beyond",
               [=] {
                 return Values{of({0, 0, -1e30f}, at_5)[0], of({0, 0, 1e30f}, at_5)[0]};
               },
               {1, 0});
  group.equals("all is on the seen side of no plane, or on the other",
               [=] {
                 return Values{of({3, 4, 5}, {0, 0, 0, 1})[0], of({3, 4, 5}, {0, 0, 0, -1})[0]};
               },
               {0, 1});
  group.equals("on a plane a million metres away", [=] { return of({1e6f, 7, 8}, {-1, 0, 0, 1e6f}); }, {0});
  for (const double size : {1.0, million})
    group.equals(fmt::format("2000 points and planes within {:g} m, but those that rounding decides: wrong", size),
                 [=, &shaders] {
                   std::vector<ShaderInput> inputs;
                   Values expected;
                   for (int i = 0; i < 2000; ++i) {
                     Trial t(780, i);
                     const glm::vec4 plane(glm::dvec4(t.direction(), size * t.between(-1, 1)));
                     const glm::vec3 p(t.in_cube(size));
                     const double distance = glm::dot(glm::dvec4(plane), glm::dvec4(p, 1));
                     if (std::abs(distance) < 16 * rounding_unit * size) continue;
                     inputs.push_back(input_of(p, plane));
                     expected.push_back(distance < 0 ? 1 : 0);
                   }
                   return Values{difference(shaders.numbers(function, inputs), expected)};
                 },
                 {0});
}

}  // namespace

}  // namespace atelier::stability

// begin_mark and begin_restore only tell OpenGL what to do: cases read the stencil, depth and colour buffers back.
void atelier_stability_table(atelier::stability::Table& table, atelier::stability::ShaderFunctions& shaders) {
  using namespace atelier::stability;
  add_portal_rows(table);
  add_mirror_rows(table);
  add_view_rows(table);
  add_plane_rows(table);
  {
    Group group = table.of("opening_rectangle");
    add_named_rectangles(group);
    add_random_rectangles(group);
  }
  add_through_rows(table);
  add_carried_rows(table);
  add_plane_in_view_rows(table);
  add_oblique_rows(table);
  add_cut_rows(table, shaders);
}
