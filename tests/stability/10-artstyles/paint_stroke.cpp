// paint_stroke: coordinates of +-10 000, pixels exactly at the border, radii of 0 to 64, every opacity, canvases and
// rows of one pixel, other regions.
#include "stability/10-artstyles/rows.hpp"

namespace atelier::stability {

using artstyles::paint_stroke;
using artstyles::Picture;
using artstyles::Stroke;

namespace {

constexpr int far_away = 10'000;

Picture even_canvas(int width, int height, const glm::u8vec4& colour) {
  return {width, height, std::vector<glm::u8vec4>(std::size_t(width) * std::size_t(height), colour)};
}

/// No pixel has the red of the strokes, 255.
Picture some_canvas(int width, int height) {
  Picture canvas = even_canvas(width, height, {});
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      canvas.pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)] =
          glm::u8vec4((37 * x + 11 * y) % 200, (13 * x + 59 * y) % 256, (71 * x + 5 * y) % 256, (x + y) % 256);
  return canvas;
}

void paint_all(Picture& canvas, const Stroke& stroke) {
  paint_stroke(canvas, stroke, {0, canvas.height}, {});
}

/// Whether a pixel belongs to a stroke: near one of its ends, or beside the line and near it. In whole numbers, of
/// which the largest is 6e17.
bool covered(std::int64_t x, std::int64_t y, const Stroke& stroke) {
  const std::int64_t reach = std::int64_t(stroke.radius) * stroke.radius;
  const auto square = [](std::int64_t a, std::int64_t b) { return a * a + b * b; };
  const glm::i64vec2 from(stroke.from), to(stroke.to), way = to - from;
  if (std::min(square(x - from.x, y - from.y), square(x - to.x, y - to.y)) <= reach) return true;
  const bool beside = way.x * (x - from.x) + way.y * (y - from.y) > 0 && way.x * (x - to.x) + way.y * (y - to.y) < 0;
  const std::int64_t across = way.x * (y - from.y) - way.y * (x - from.x);
  return beside && across * across <= reach * square(way.x, way.y);
}

/// The nearest whole number to n / 255.
int nearest_code(int n) {
  return (2 * n + 255) / 510;
}

/// How many pixels are not what they should be after a stroke.
double count_wrong(const Picture& before, const Stroke& stroke, artstyles::Rows rows, const std::vector<int>& regions) {
  Picture canvas = before;
  paint_stroke(canvas, stroke, rows, regions);
  if (canvas.pixels.size() != before.pixels.size()) return double(INFINITY);
  double wrong = 0;
  for (std::size_t i = 0; i < before.pixels.size(); ++i) {
    glm::u8vec4 right = before.pixels[i];
    const int x = int(i) % before.width, y = int(i) / before.width;
    const bool mine = regions.empty() || regions[i] == 0 || regions[i] == stroke.region;
    if (mine && y >= rows.first && y < rows.end && covered(x, y, stroke))
      for (int c = 0; c < 3; ++c)
        right[c] = std::uint8_t(nearest_code(stroke.opacity * stroke.colour[c] + (255 - stroke.opacity) * right[c]));
    wrong += canvas.pixels[i] != right;
  }
  return wrong;
}

double count_wrong(const Picture& before, const Stroke& stroke) {
  return count_wrong(before, stroke, {0, before.height}, {});
}

double count_painted(const Picture& canvas) {
  return double(std::ranges::count_if(canvas.pixels, [](const glm::u8vec4& p) { return p.r == 255; }));
}

Stroke red_stroke(glm::ivec2 from, glm::ivec2 to, int radius) {
  return {.from = from, .to = to, .radius = radius, .colour = glm::u8vec4(255, 40, 3, 9)};
}

void add_shape_rows(Group& group) {
  group.equals("radii of 0 to 10, both ends in the same place: pixels painted",
               [] {
                 Values counts;
                 for (int radius = 0; radius <= 10; ++radius) {
                   Picture canvas = some_canvas(31, 31);
                   paint_all(canvas, red_stroke({15, 15}, {15, 15}, radius));
                   counts.push_back(count_painted(canvas));
                 }
                 return counts;
               },
               {1, 5, 13, 29, 49, 81, 113, 149, 197, 253, 317});  // Gauss's circle problem
  // Beside a line along (4, 3), the pixels (-3, 4) m away from it are at a distance of exactly 5 m.
  for (const int m : {1, 3, 12}) {
    const auto painted_beside = [=](int radius, int sign) {
      double painted = 0;
      for (const glm::ivec2& corner : {glm::ivec2(0, 0), glm::ivec2(-9500, -7125)}) {
        Picture canvas = some_canvas(300, 300);
        const glm::ivec2 from = glm::ivec2(100, 100) + corner;
        paint_all(canvas, red_stroke(from, {180, 160}, radius));
        for (int k = 0; k <= 20; ++k) {
          const glm::ivec2 at = glm::ivec2(100, 100) + k * glm::ivec2(4, 3) + sign * m * glm::ivec2(-3, 4);
          painted += canvas.pixels[std::size_t(300 * at.y + at.x)].r == 255;
        }
      }
      return painted;
    };
    group.equals(
        fmt::format("a line along (4, 3): 84 pixels at exactly {}, with that radius, and with one less", 5 * m),
        [=] {
          return Values{painted_beside(5 * m, 1) + painted_beside(5 * m, -1),
                        painted_beside(5 * m - 1, 1) + painted_beside(5 * m - 1, -1)};
        },
        {84, 0});
    group.equals(
        fmt::format("the end of a line: pixels at exactly {} from it, with that radius, and with one less", 5 * m),
        [=] {
          Values counts;
          for (const int radius : {5 * m, 5 * m - 1}) {
            double painted = 0;
            Picture canvas = some_canvas(200, 200);
            paint_all(canvas, red_stroke({-far_away, 100}, {100, 100}, radius));
            for (const glm::ivec2& way : {glm::ivec2(5, 0), glm::ivec2(3, 4), glm::ivec2(4, 3), glm::ivec2(4, -3),
                                          glm::ivec2(3, -4), glm::ivec2(0, 5), glm::ivec2(0, -5)}) {
              const glm::ivec2 at = glm::ivec2(100, 100) + m * way;
              painted += canvas.pixels[std::size_t(200 * at.y + at.x)].r == 255;
            }
            counts.push_back(painted);
          }
          return counts;
        },
        {7, 0});
  }
  for (const int radius : {0, 1, 2, 64}) {
    group.equals(fmt::format("lines between corners of +-10 000, radius {}: wrong pixels", radius),
                 [=] {
                   double wrong = 0;
                   const Picture canvas = some_canvas(257, 129);
                   for (const glm::ivec2& end : {glm::ivec2(far_away, far_away), glm::ivec2(far_away, -far_away),
                                                 glm::ivec2(far_away, far_away - 1), glm::ivec2(far_away, 150),
                                                 glm::ivec2(150, far_away), glm::ivec2(far_away, 0)})
                     for (const int sign : {1, -1})
                       wrong += count_wrong(canvas, red_stroke(-sign * end, sign * end, radius));
                   return Values{wrong};
                 },
                 {0});
    group.equals(fmt::format("200 random lines with ends up to +-10 000 away, radius {}: wrong pixels", radius),
                 [=] {
                   const Picture canvas = some_canvas(120, 90);
                   double wrong = 0;
                   for (int i = 0; i < 200; ++i) {
                     Trial t(1210, i);
                     const auto coordinate = [&] { return int(std::lround(t.sign() * t.size_between(0.1, far_away))); };
                     const int x = coordinate(), y = coordinate(), u = coordinate();
                     wrong += count_wrong(canvas, red_stroke({x, y}, {u, coordinate()}, radius));
                   }
                   return Values{wrong};
                 },
                 {0});
    group.equals(
        fmt::format("200 random short lines, radius {}: wrong pixels, and those that differ from `to` to `from`",
                    radius),
        [=] {
          const Picture canvas = some_canvas(50, 40);
          double wrong = 0, differ = 0;
          for (int i = 0; i < 200; ++i) {
            Trial t(1211, i);
            const auto place = [&] {
              const int x = int(t.between(-20, 70));
              return glm::ivec2(x, int(t.between(-20, 60)));
            };
            const glm::ivec2 from = place(), to = place();
            wrong += count_wrong(canvas, red_stroke(from, to, radius));
            Picture one = canvas, other = canvas;
            paint_all(one, red_stroke(from, to, radius));
            paint_all(other, red_stroke(to, from, radius));
            differ += one.pixels != other.pixels;
          }
          return Values{wrong, differ};
        },
        {0, 0});
  }
  group.equals(
      "strokes outside of the canvas, one pixel away: pixels painted",
      [] {
        Picture canvas = some_canvas(40, 30);
        for (const int radius : {0, 5, 64})
          for (const glm::ivec2& by : {glm::ivec2(1, 0), glm::ivec2(0, 1)}) {
            const glm::ivec2 across(by.y, by.x), low = -(radius + 1) * by, high = glm::ivec2(40, 30) * by + radius * by;
            for (const glm::ivec2& side : {low, high})
              paint_all(canvas, red_stroke(side - far_away / 2 * across, side + far_away / 2 * across, radius));
          }
        return Values{count_painted(canvas)};
      },
      {0});
  for (const glm::ivec2& size : {glm::ivec2(1, 1), glm::ivec2(1, 4096), glm::ivec2(4096, 1), glm::ivec2(3, 5)})
    group.equals(fmt::format("a canvas of {} x {}, 300 random strokes: wrong pixels", size.x, size.y),
                 [=] {
                   const Picture canvas = some_canvas(size.x, size.y);
                   return Values{worst_of(300, 1212, [&](Trial& t) {
                     const auto place = [&](int side) { return int(t.between(-10, side + 10)); };
                     const int x = place(size.x), y = place(size.y), u = place(size.x), v = place(size.y);
                     return count_wrong(canvas, red_stroke({x, y}, {u, v}, int(t.size_between(0.5, 65))));
                   })};
                 },
                 {0});
}

void add_colour_rows(Group& group) {
  group.equals(
      "an opacity of 0: bytes that change",
      [] {
        const Picture before = some_canvas(256, 64);
        Picture canvas = before;
        for (int code = 0; code < 256; ++code)
          paint_all(canvas, {.from = {0, 0}, .to = {255, 63}, .radius = 64, .colour = glm::u8vec4(code), .opacity = 0});
        double changed = 0;
        for (std::size_t i = 0; i < canvas.pixels.size(); ++i)
          changed += count_others(values(glm::ivec4(canvas.pixels[i]) - glm::ivec4(before.pixels[i])), {0});
        return Values{changed};
      },
      {0});
  group.equals("an opacity of 255, all codes: colours that are not exactly the stroke's, opacities that change",
               [] {
                 const Picture before = some_canvas(64, 8);
                 double colours = 0, opacities = 0;
                 for (int code = 0; code < 256; ++code) {
                   Picture canvas = before;
                   const glm::u8vec4 colour(code, 255 - code, code / 2, 77);
                   paint_all(canvas, {.from = {0, 4}, .to = {63, 4}, .radius = 8, .colour = colour});
                   for (std::size_t i = 0; i < canvas.pixels.size(); ++i) {
                     colours += glm::u8vec3(canvas.pixels[i]) != glm::u8vec3(colour);
                     opacities += canvas.pixels[i].a != before.pixels[i].a;
                   }
                 }
                 return Values{colours, opacities};
               },
               {0, 0});
  group.equals("even canvases painted with their own colour, all codes, all opacities: those that change",
               [] {
                 double changed = 0;
                 for (int code = 0; code < 256; ++code)
                   for (int opacity = 0; opacity < 256; ++opacity) {
                     const glm::u8vec4 colour(code, 255 - code, code, 31);
                     Picture canvas = even_canvas(1, 1, colour);
                     paint_all(canvas, {.colour = colour, .opacity = opacity});
                     changed += canvas.pixels[0] != colour;
                   }
                 return Values{changed};
               },
               {0});
  group.equals("all opacities, all codes before, every fifth code of the stroke: codes that are not the nearest",
               [] {
                 Picture before = even_canvas(256, 1, {});
                 for (int code = 0; code < 256; ++code)
                   before.pixels[std::size_t(code)] = glm::u8vec4(code, 255 - code, code, code);
                 double wrong = 0;
                 for (int opacity = 0; opacity < 256; ++opacity)
                   for (int code = 0; code < 256; code += 5) {
                     Picture canvas = before;
                     paint_all(canvas, {.from = {0, 0},
                                        .to = {255, 0},
                                        .radius = 0,
                                        .colour = glm::u8vec4(code, code, 255 - code, 0),
                                        .opacity = opacity});
                     for (int old = 0; old < 256; ++old) {
                       const auto mixed = [&](int colour, int ground) {
                         return nearest_code(opacity * colour + (255 - opacity) * ground);
                       };
                       const glm::u8vec4 right(mixed(code, old), mixed(code, 255 - old), mixed(255 - code, old), old);
                       wrong += canvas.pixels[std::size_t(old)] != right;
                     }
                   }
                 return Values{wrong};
               },
               {0});
}

void add_part_rows(Group& group) {
  const Stroke stroke = red_stroke({-5, 3}, {60, 33}, 12);
  group.equals("no rows, at the top, in the middle and at the end: pixels painted",
               [=] {
                 Picture canvas = some_canvas(50, 40);
                 for (const int row : {0, 20, 40}) paint_stroke(canvas, stroke, {row, row}, {});
                 return Values{count_painted(canvas)};
               },
               {0});
  group.same(
      "row by row, from the bottom: as at once",
      [=] {
        Picture canvas = some_canvas(50, 40);
        for (int row = 39; row >= 0; --row) paint_stroke(canvas, stroke, {row, row + 1}, {});
        return all_values(canvas.pixels);
      },
      [=] {
        Picture canvas = some_canvas(50, 40);
        paint_all(canvas, stroke);
        return all_values(canvas.pixels);
      });
  group.equals("each row alone: wrong pixels",
               [=] {
                 double wrong = 0;
                 for (int row = 0; row < 40; ++row)
                   wrong += count_wrong(some_canvas(50, 40), stroke, {row, row + 1}, {});
                 return Values{wrong};
               },
               {0});
  for (const int region : {0, 1, 2, largest_int})
    group.equals(fmt::format("a stroke of region {}, on regions 0, 1, 2 and 2^31 - 1 in turn: wrong pixels", region),
                 [=] {
                   std::vector<int> regions;
                   for (int i = 0; i < 50 * 40; ++i)
                     regions.push_back(std::array{0, 1, 2, largest_int}[std::size_t((i % 50 / 3 + i / 50 / 2) % 4)]);
                   Stroke mine = stroke;
                   mine.region = region;
                   return Values{count_wrong(some_canvas(50, 40), mine, {0, 40}, regions) +
                                 count_wrong(some_canvas(50, 40), mine, {11, 12}, regions)};
                 },
                 {0});
}

}  // namespace

void add_stroke_rows(Table& table) {
  Group group = table.of("paint_stroke");
  group.equals("from (1, 0) to (3, 0) with radius 1: the pixels of the contract",
               [] {
                 Picture canvas = some_canvas(6, 3);
                 paint_all(canvas, red_stroke({1, 0}, {3, 0}, 1));
                 Values painted;
                 for (const glm::u8vec4& p : canvas.pixels) painted.push_back(p.r == 255);
                 return painted;
               },
               {1, 1, 1, 1, 1, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0});
  add_shape_rows(group);
  add_colour_rows(group);
  add_part_rows(group);
}

}  // namespace atelier::stability
