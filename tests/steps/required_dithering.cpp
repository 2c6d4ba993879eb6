// Dithering that is not asked for costs nothing; ways that show the same show the same; a pattern that is held by the
// world stays with it when the camera moves.
#include <glm/gtc/matrix_transform.hpp>

#include "catch.hpp"
#include "drawn.hpp"
#include "image/colour.hpp"

using namespace atelier;
using namespace atelier::test;

namespace {

constexpr const char* dither_step = "09-dithering";

Case teapot(std::map<std::string, SettingValue> settings = {}) {
  return picture("teapot", std::move(settings));
}

}  // namespace

TEST_CASE("dithering that is not asked for costs nothing", "[required][09-dithering]") {
  const auto plain = counts_at_rest(dither_step, teapot());
  check_costs(dither_step, {{"no dithering", teapot(), {{"texture_bytes", plain.at("texture_bytes")}}}});
  const auto passes = [&](std::map<std::string, SettingValue> settings) {
    return counts_at_rest(dither_step, teapot(std::move(settings))).at("passes") - plain.at("passes");
  };
  CHECK(passes({{"dither.levels", 4}}) == 0);
  CHECK(passes({{"dither.method", text("bayer")}}) == 1);
  CHECK(passes({{"dither.method", text("bayer")}, {"dither.grey", true}}) == 1);
  CHECK(passes({{"dither.method", text("bayer")}, {"dither.held", text("world")}}) == 3);  // position and normal too
  CHECK(passes({{"dither.method", text("rounded")}, {"dither.held", text("world")}}) == 1);
  CHECK(passes({{"dither.method", text("bayer")}, {"dither.lines", text("black")}}) == 4);  // position and normal too
  const auto textures = [&](std::map<std::string, SettingValue> settings) {
    return counts_at_rest(dither_step, teapot(std::move(settings))).at("texture_bytes") - plain.at("texture_bytes");
  };
  CHECK(textures({{"dither.method", text("rounded")}}) == 0);
  CHECK(textures({{"dither.method", text("bayer")}, {"dither.matrix", text("4")}}) == 4 * 4 * 4);
  CHECK(textures({{"dither.method", text("floyd-steinberg")}}) == 0);
}

TEST_CASE("threads and fast ways change no pixel", "[required][09-dithering]") {
  const auto card = [](std::map<std::string, SettingValue> settings) {
    settings["dither.levels"] = 3;
    return picture("card", std::move(settings));
  };
  const std::string floyd = text("floyd-steinberg"), bayer = text("bayer");
  const auto all = drawn(
      dither_step,
      {card({{"dither.method", floyd}, {"dither.threads", 1}}), card({{"dither.method", floyd}, {"dither.threads", 2}}),
       card({{"dither.method", floyd}, {"dither.threads", 4}}), card({{"dither.method", floyd}, {"dither.fast", true}}),
       card({{"dither.method", bayer}}), card({{"dither.method", bayer}, {"dither.fast", true}})});
  for (const std::size_t i : {1u, 2u, 3u}) CHECK(pixels_apart(all[0].picture, all[i].picture) == 0);
  CHECK(codes_apart(all[4].picture, all[5].picture) < 0.6);  // 127.5 is stored as 128
}

// ---- Motion

namespace {

constexpr glm::ivec2 size(320, 240);
constexpr double fov_y = 55;  // degrees, of the scene

struct Pose {
  glm::dvec3 eye, target;
};

/// The pixel in which a camera sees a point, from the top left.
glm::dvec2 pixel_of(const Pose& pose, const glm::dvec3& point) {
  const glm::dvec3 p(glm::lookAt(pose.eye, pose.target, glm::dvec3(0, 1, 0)) * glm::dvec4(point, 1));
  const double scale = size.y / (2 * std::tan(glm::radians(fov_y / 2))) / -p.z;
  return {size.x / 2.0 + p.x * scale, size.y / 2.0 - p.y * scale};
}

Case seen_from(const Pose& pose, std::map<std::string, SettingValue> settings, const char* output = "colour") {
  Case c = picture("deck", std::move(settings), output);
  c.size = size;
  c.camera.eye = pose.eye;
  c.camera.target = pose.target;
  return c;
}

/// Of the points of surfaces that both cameras see, the fraction that is black in one picture and white in the other.
double flipped(const Pose& before, const Pose& after, std::map<std::string, SettingValue> settings) {
  settings["dither.method"] = text("bayer");
  settings["dither.grey"] = true;
  const auto all = drawn(dither_step, {seen_from(before, settings), seen_from(after, settings),
                                       seen_from(before, {}, "position"), seen_from(after, {}, "position")});
  int seen = 0, changed = 0;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const Rgba& p = all[3].picture.at(x, y);
      const glm::dvec3 point(p.r, p.g, p.b);
      if (point == glm::dvec3(0)) continue;
      const glm::dvec2 place = glm::floor(pixel_of(before, point));
      if (place.x < 0 || place.y < 0 || place.x >= size.x || place.y >= size.y) continue;
      const Rgba& q = all[2].picture.at(int(place.x), int(place.y));
      const double distance = glm::length(point - after.eye);
      if (glm::length(point - glm::dvec3(q.r, q.g, q.b)) > 0.02 * distance) continue;  // hidden before
      ++seen;
      changed += all[0].picture.at(int(place.x), int(place.y)).r != all[1].picture.at(x, y).r;
    }
  REQUIRE(seen > size.x * size.y / 4);
  return double(changed) / seen;
}

double flipped_by(const Pose& before, const Pose& after, const char* held, double cell) {
  return flipped(before, after, {{"dither.held", text(held)}, {"dither.cell", cell}});
}

}  // namespace

TEST_CASE("a pattern that is held stays when the camera moves", "[required][09-dithering]") {
  const Pose still{{0.2, 1.65, 3.6}, {0, 0.8, -3}};
  const auto turned = [&](double degrees) {
    const glm::dvec3 way = still.target - still.eye;
    const double c = std::cos(glm::radians(degrees)), s = std::sin(glm::radians(degrees));
    return Pose{still.eye, still.eye + glm::dvec3(c * way.x + s * way.z, way.y, c * way.z - s * way.x)};
  };
  const auto walked = [&](double metres) {
    const glm::dvec3 step = metres * glm::normalize(still.target - still.eye);
    return Pose{still.eye + step, still.target + step};
  };
  // The handout has these figures.
  const Pose turn = turned(2.3), walk = walked(0.15);
  const double screen = flipped_by(still, turn, "screen", 1), sphere = flipped_by(still, turn, "sphere", 1),
               sphere2 = flipped_by(still, turn, "sphere", 2), sphere4 = flipped_by(still, turn, "sphere", 4);
  INFO("turned by 2.3 degrees: screen " << screen << ", sphere " << sphere << ", cells of 2 pixels " << sphere2
                                        << ", of 4 pixels " << sphere4);
  CHECK(sphere < 0.8 * screen);
  CHECK(sphere2 < 0.6 * sphere);
  CHECK(sphere4 < 0.6 * sphere2);
  const double screen_walk = flipped_by(still, walk, "screen", 2), sphere_walk = flipped_by(still, walk, "sphere", 2),
               world = flipped_by(still, walk, "world", 1), world_turn = flipped_by(still, turn, "world", 1);
  INFO("walked 0.15 metres: screen " << screen_walk << ", sphere, cells of 2 pixels " << sphere_walk
                                     << ", world, cells of 1 to 2 pixels " << world << "; turned: " << world_turn);
  CHECK(world < 0.7 * sphere_walk);
  CHECK(world < 0.7 * screen_walk);
  CHECK(world_turn < 0.8 * screen);
#ifdef SHOW_FLIPS
  CHECK(false);
#endif
}
