// Styles that are not asked for cost nothing; threads and the fast stroke change no pixel; what a style promises of
// every picture: an even one stays, six greys, a period, a lens and its inverse.
#include <algorithm>
#include <cmath>
#include <set>

#include "catch.hpp"
#include "drawn.hpp"
#include "image/colour.hpp"

using namespace atelier;
using namespace atelier::test;

namespace {

constexpr const char* style_step = "10-artstyles";
using Choices = std::map<std::string, SettingValue>;

Case styled(const char* scene, const char* style, Choices settings = {}) {
  settings["style.first"] = text(style);
  return picture(scene, std::move(settings));
}

Case all_around(Choices settings = {}) {
  settings["fisheye.lens"] = text("equidistant");
  settings["fisheye.from"] = text("cube");
  settings["fisheye.edge"] = 64;
  Case c = styled("room", "fisheye", std::move(settings));
  c.camera.eye = {0, 1.5, 0.4};
  c.camera.target = {0, 1.4, -1};
  return c;
}

double mean_error(const Image& a, const Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) {
    const Rgba &p = a.pixels()[i], &q = b.pixels()[i];
    sum +=
        std::abs(double(p.r) - double(q.r)) + std::abs(double(p.g) - double(q.g)) + std::abs(double(p.b) - double(q.b));
  }
  return sum / 3 / double(a.pixels().size());
}

}  // namespace

TEST_CASE("styles that are not asked for cost nothing, and each is one pass", "[required][10-artstyles]") {
  const auto plain = counts_at_rest(style_step, picture("room"));
  check_costs(style_step, {{"no style", picture("room"), {{"texture_bytes", plain.at("texture_bytes")}}}});
  const auto passes = [&](Case c) { return counts_at_rest(style_step, c).at("passes") - plain.at("passes"); };
  CHECK(passes(picture("room", {{"paint.grid", 4}, {"toon.outlines", text("both")}})) == 0);
  CHECK(passes(styled("room", "toon")) == 1);
  CHECK(passes(styled("room", "toon", {{"toon.outlines", text("surface")}})) == 3);  // position and normal too
  CHECK(passes(styled("room", "fisheye")) == 1);
  CHECK(passes(styled("room", "aberration")) == 1);
  CHECK(passes(styled("room", "aberration", {{"style.second", text("toon")}})) == 2);
  CHECK(passes(styled("room", "fisheye", {{"fisheye.restored", true}})) == 2);
  CHECK(passes(picture("room", {{"fisheye.restored", true}})) == 0);
}

TEST_CASE("of the six views around the eye those are drawn that the lens sees", "[required][10-artstyles]") {
  const auto views = [&](double angle, const char* faces) {
    return counts_at_rest(style_step, all_around({{"fisheye.angle", angle}, {"fisheye.faces", text(faces)}}))
        .at("views");
  };
  CHECK(views(88, "needed") == 1);  // the scene's own view is not drawn: the six take its place
  CHECK(views(90, "needed") == 5);  // filters read half a texel farther
  CHECK(views(248, "needed") == 5);
  CHECK(views(251, "needed") == 6);
  CHECK(views(90, "all") == 6);
  Case positions = all_around();
  positions.output = "position";
  CHECK(counts_at_rest(style_step, positions).at("views") == 1);
  for (const double angle : {86.0, 89.0, 90.0, 180.0, 249.0, 250.5}) {
    INFO(angle << " degrees");
    const auto both = drawn(style_step, {all_around({{"fisheye.angle", angle}, {"fisheye.faces", text("all")}}),
                                         all_around({{"fisheye.angle", angle}})});
    CHECK(pixels_apart(both[0].picture, both[1].picture) == 0);
  }
}

TEST_CASE("threads and the fast stroke change no pixel", "[required][10-artstyles]") {
  for (const bool confined : {false, true}) {
    const auto card = [&](Choices settings) {
      settings["paint.confined"] = confined;
      settings["paint.border"] = 60;
      return styled("card", "painterly", std::move(settings));
    };
    const auto all = drawn(style_step, {card({{"paint.threads", 1}}), card({{"paint.threads", 2}}),
                                        card({{"paint.threads", 8}}), card({{"paint.fast", true}})});
    for (const std::size_t i : {1u, 2u, 3u}) CHECK(pixels_apart(all[0].picture, all[i].picture) == 0);
  }
  Case narrow = styled("card", "painterly");
  narrow.size = {3, 40};
  Case fast = narrow;
  fast.settings["paint.fast"] = true;
  const auto both = drawn(style_step, {narrow, fast});
  CHECK(pixels_apart(both[0].picture, both[1].picture) == 0);
}

TEST_CASE("a still camera gives a still painting, and each picture its own", "[required][10-artstyles]") {
  Case moved = styled("still-life", "painterly");
  moved.camera.eye = {0.13, 0.95, 2.6};
  const auto all = drawn(style_step, {styled("still-life", "painterly"), styled("still-life", "painterly"), moved});
  CHECK(pixels_apart(all[0].picture, all[1].picture) == 0);
  CHECK(pixels_apart(all[0].picture, all[2].picture) > 5000);
}

TEST_CASE("an even picture stays even in every style", "[required][10-artstyles]") {
  // blocks: everything has the colour of the background.
  const auto all =
      drawn(style_step, {picture("blocks"), styled("blocks", "painterly"),
                         styled("blocks", "painterly", {{"paint.confined", true}}),
                         styled("blocks", "aberration", {{"aberration.turns", 0.3}}), styled("blocks", "toon")});
  for (const std::size_t i : {1u, 2u, 3u}) CHECK(codes_apart(all[0].picture, all[i].picture) < 0.6);
  for (const Rgba& p : all[4].picture.pixels()) CHECK(std::abs(p.r - 0.64f) < 1e-5f);  // 4/5 of the brightness
}

TEST_CASE("toon has six greys where it has no ink", "[required][10-artstyles]") {
  const Drawn toon = drawn(style_step, {styled("still-life", "toon", {{"toon.outlines", text("none")}})}).at(0);
  std::set<int> greys;
  for (const Rgba& p : toon.picture.pixels()) {
    CHECK((p.r == p.g && p.g == p.b));
    const double fifths = 5 * std::sqrt(double(p.r));
    CHECK(std::abs(fifths - std::round(fifths)) < 1e-5);
    greys.insert(int(std::round(fifths)));
  }
  CHECK(greys.size() >= 5);
}

TEST_CASE("lines from surfaces have no gaps, also at corners and in pictures of odd sizes",
          "[required][10-artstyles]") {
  const Choices surface{{"toon.outlines", text("surface")}};
  for (const glm::ivec2 size : {glm::ivec2(160, 120), glm::ivec2(161, 119), glm::ivec2(7, 5), glm::ivec2(1, 1)}) {
    Case lines = styled("blocks", "toon", surface), normals = picture("blocks", {}, "normal");
    lines.size = normals.size = size;
    const auto all = drawn(style_step, {lines, normals});
    const auto differ = [&](glm::ivec2 a, glm::ivec2 b) {
      const Rgba &p = all[1].picture.at(a.x, a.y), &q = all[1].picture.at(b.x, b.y);
      return 2 * std::hypot(p.r - q.r, p.g - q.g, p.b - q.b) > 0.61f;
    };
    int bends = 0, gaps = 0;
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x)
        for (int v = std::max(y - 1, 0); v <= std::min(y + 1, size.y - 1); ++v)
          for (int u = std::max(x - 1, 0); u <= std::min(x + 1, size.x - 1); ++u)
            if (differ({x, y}, {u, v})) {
              ++bends;
              gaps += all[0].picture.at(x, y).r > 0.01f;
            }
    INFO(size.x << " x " << size.y << ": " << bends << " pairs of neighbours");
    CHECK(gaps == 0);
    CHECK((bends > 1000 || size.x < 100));
  }
}

TEST_CASE("the shifts of the channels have a period of one turn, and are zero without an amount",
          "[required][10-artstyles]") {
  const auto at = [](double turns, double amount = 0.05) {
    return styled("still-life", "aberration", {{"aberration.turns", turns}, {"aberration.amount", amount}});
  };
  const auto all = drawn(style_step, {at(0.2), at(1.2), at(0.7), at(0.2, 0), picture("still-life")});
  CHECK(codes_apart(all[0].picture, all[1].picture) < 0.1);
  CHECK(mean_error(all[0].picture, all[2].picture) > 0.002);
  CHECK(codes_apart(all[3].picture, all[4].picture) < 0.1);
}

TEST_CASE("a lens that is undone gives the picture back", "[required][10-artstyles]") {
  const Choices power{{"fisheye.strength", 0.3}},
      equidistant{{"fisheye.lens", text("equidistant")}, {"fisheye.angle", 120.0}};
  for (Choices lens : {power, equidistant}) {
    const Case seen = styled("still-life", "fisheye", lens);
    lens["fisheye.restored"] = true;
    const Case undone = styled("still-life", "fisheye", lens);
    const auto all = drawn(style_step, {picture("still-life"), seen, undone});
    // Filtered twice: what is left is the blur.
    CHECK(mean_error(all[0].picture, all[2].picture) < 0.25 * mean_error(all[0].picture, all[1].picture));
  }
}

TEST_CASE("two styles in a row are the second one of the first one's picture", "[required][10-artstyles]") {
  const Choices both{{"style.second", text("aberration")}};
  Case first = styled("room", "toon", both);
  first.output = "first";
  const auto all = drawn(style_step, {styled("room", "toon"), first, styled("room", "toon", both),
                                      styled("room", "aberration", {{"style.second", text("toon")}})});
  CHECK(pixels_apart(all[0].picture, all[1].picture) == 0);
  CHECK(pixels_apart(all[1].picture, all[2].picture) > 500);
  CHECK(pixels_apart(all[2].picture, all[3].picture) > 500);  // the order matters
  const std::string all_names[] = {"painterly", "toon", "fisheye", "aberration"};
  for (const std::string& a : all_names)
    for (const std::string& b : all_names) {
      INFO(a << ", then " << b);
      const Drawn one = drawn(style_step, {picture("teapot", {{"style.first", a}, {"style.second", b}})}).at(0);
      const auto [least, most] = std::ranges::minmax(one.picture.pixels(), {}, [](const Rgba& p) { return p.r; });
      CHECK(most.r - least.r > 0.1f);
    }
}
