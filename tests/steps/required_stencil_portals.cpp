// Portals that are not seen cost nothing, and going through one is not seen.
#include <cmath>

#include "catch.hpp"
#include "drawn.hpp"

using namespace atelier;
using namespace atelier::test;

namespace {

constexpr const char* portal_step = "07-stencil-portals";

Case seen_from(Case picture, const glm::dvec3& eye, const glm::dvec3& target) {
  picture.camera.eye = eye;
  picture.camera.target = target;
  return picture;
}

Case rooms(std::map<std::string, SettingValue> settings = {}) {
  return picture("rooms", std::move(settings));
}

/// How many pixels differ by more than this, summed over their channels: linear light.
int pixels_that_differ(const Image& a, const Image& b, float by) {
  int count = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) {
    const Rgba &p = a.pixels()[i], &q = b.pixels()[i];
    count += std::abs(p.r - q.r) + std::abs(p.g - q.g) + std::abs(p.b - q.b) > by;
  }
  return count;
}

}  // namespace

TEST_CASE("openings that cannot be seen cost nothing", "[required][07-stencil-portals]") {
  const glm::dvec3 eye(0.5, 1.5, 3);
  check_costs(portal_step,
              {
                  {"one view inside another", rooms({{"portals.depth", 1}}), {{"nodes", 32}}},
                  {"behind the eye", seen_from(rooms(), eye, {0.5, 1.5, 8}), {{"nodes", 16}, {"passes", 1}}},
                  {"from behind a door that is open on one side",
                   seen_from(rooms(), {0.5, 1.5, -3}, {0.5, 1.5, 3}),
                   {{"nodes", 16}, {"passes", 1}}},
                  {"no depth: plain colours", rooms({{"portals.depth", 0}}), {{"nodes", 16}}},
                  {"a chain ends where rectangles are small",
                   picture("corridor", {{"portals.depth", 16}, {"portals.smallest", 16}}),
                   {{"nodes", 22}}},
                  {"a chain of 16", picture("corridor", {{"portals.depth", 16}}), {{"nodes", 187}}},
                  {"no portal: the cube of the lamp and the frame", picture("room"), {{"passes", 2}}},
              });
}

TEST_CASE("light and bodies that do not go through cost nothing", "[required][07-stencil-portals]") {
  const auto astride = [](double way, bool lights) {
    return picture("astride", {{"body.way", way}, {"portals.lights", lights}, {"portals.depth", 0}});
  };
  check_costs(portal_step,
              {
                  {"lights of the scene alone", astride(0.5, false), {{"lights", 2}}},
                  {"and two images of each", astride(0.5, true), {{"lights", 6}}},
                  {"a body before the door", astride(0, false), {{"nodes", 13}}},
                  {"a body in the door, in two parts", astride(0.5, false), {{"nodes", 14}}},
                  {"a body that has gone through", astride(1, false), {{"nodes", 13}}},
                  {"lights that cast no shadow", picture("rooms", {{"portals.lights", true}}), {{"lookups", 0}}},
                  {"no sky", rooms(), {{"skies", 0}}},
              });
}

TEST_CASE("a scissor changes no pixel", "[required][07-stencil-portals]") {
  for (const char* scene : {"rooms", "corridor", "rolled", "mirror", "gate"}) {
    INFO(scene);
    const auto both = drawn(portal_step, {picture(scene), picture(scene, {{"portals.scissor", false}})});
    CHECK(pixels_apart(both[0].picture, both[1].picture) == 0);
  }
}

TEST_CASE("whoever goes through a door sees the same before and after", "[required][07-stencil-portals]") {
  // The door at (0, 1.25, -2) leads to one at (41, 1.25, 1) that faces -x. Straight ahead all of it is exact in floats,
  // so the frames are the same to the last bit; to the side the two view matrices are rounded each in its own way.
  struct Look {
    glm::dvec3 ahead, ahead_there;
    int apart;  ///< pixels: the strict profile's budget
  };
  const Look looks[] = {{{0, 0, -1}, {-1, 0, 0}, 0}, {{1, 0, -1}, {-1, 0, -1}, 4}, {{-1, 0, -2}, {-2, 0, 1}, 4}};
  for (const char* clip : {"discard", "distance", "oblique"}) {
    for (const Look& look : looks) {
      INFO(clip << ", ahead " << look.ahead.x << " " << look.ahead.z);
      constexpr double hair = 1.0 / 4096;
      const glm::dvec3 before(0, 1.25, -2 + hair), after(41 + hair, 1.25, 1);
      const auto both = drawn(
          portal_step, {seen_from(rooms({{"portals.clip", std::string(clip)}}), before, before + look.ahead),
                        seen_from(rooms({{"portals.clip", std::string(clip)}}), after, after + look.ahead_there)});
      CHECK(pixels_that_differ(both[0].picture, both[1].picture, 0.01f) <= look.apart);
      if (look.apart == 0) CHECK(pixels_apart(both[0].picture, both[1].picture) == 0);
    }
  }
}

TEST_CASE("a visitor's way has no jump at a tilted door", "[required][07-stencil-portals]") {
  // Frame by frame along the way, closest around the door: what changes from one frame to the next changes by little.
  std::vector<Case> frames;
  for (int i = 0; i <= 40; ++i) frames.push_back(picture("rolled", {{"visitor.way", 0.70 + 0.005 * i}}));
  const auto all = drawn(portal_step, frames);
  int largest = 0;
  for (std::size_t i = 1; i < all.size(); ++i) {
    largest = std::max(largest, pixels_that_differ(all[i - 1].picture, all[i].picture, 0.15f));
  }
  // Edges move by a pixel or two: at most an eighth of the picture. A frame that shows the wrong place is another one.
  CHECK(largest < 160 * 120 / 8);
  CHECK(largest > 0);
}

TEST_CASE("a visitor goes through a two-sided gate from behind", "[required][07-stencil-portals]") {
  // The gate is at 3.7 / 5.5 = 0.67273 of the way: the frames are 0.15 mm before it and 0.4 mm behind it.
  const auto both =
      drawn(portal_step, {picture("gate", {{"visitor.way", 0.6727}}), picture("gate", {{"visitor.way", 0.6728}})});
  // Edges fall on the other side of a pixel's middle. The ground alone, which is another one, fills more than this.
  CHECK(pixels_that_differ(both[0].picture, both[1].picture, 0.15f) < 160 * 120 / 16);
}

TEST_CASE("255 levels are the most, and nothing is left behind the last", "[required][07-stencil-portals]") {
  // The last openings are smaller than a pixel, so the last level but one shows the same.
  const auto deep = drawn(
      portal_step, {picture("corridor", {{"portals.depth", 255}}), picture("corridor", {{"portals.depth", 254}})});
  CHECK(pixels_that_differ(deep[0].picture, deep[1].picture, 0.01f) <= 1);
  CHECK(deep[0].counts.at("nodes") == 256 * 11);  // every level draws the hall's eleven nodes
}
