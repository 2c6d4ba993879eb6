// Only required cube maps: one 2D map if casters fit a cone, no cube map for a light without shadows, no drawing into
// faces without casters.
#include "catch.hpp"
#include "drawn.hpp"

using namespace atelier;
using namespace atelier::test;

namespace {

constexpr const char* cubes_step = "04-point-shadows";
constexpr std::int64_t face_bytes = 128 * 128 * 4;  ///< the same of a face
constexpr std::int64_t cone_map_bytes = 256 * 256 * 4;

/// With cubes of 128 texels an edge and maps of 256.
Case lamp_lit(const std::string& scene, std::map<std::string, SettingValue> settings = {}) {
  settings["cube.resolution"] = 128;
  settings["shadow.resolution"] = 256;
  return picture(scene, std::move(settings));
}

const SettingValue never = std::string("never"), six = std::string("six"), all_faces = std::string("all");

}  // namespace

TEST_CASE("lights that need no cube map have none", "[required][04-point-shadows]") {
  const std::vector<Priced> rows = {
      {"casters all round: a cube, one pass for its six faces, one texture",
       lamp_lit("lantern"),
       {{"passes", 2}, {"texture_sources", 1}, {"target_bytes", picture_bytes + 6 * face_bytes}}},
      {"casters within a cone: one map of step 03, and no cube",
       lamp_lit("desk"),
       {{"passes", 2}, {"target_bytes", picture_bytes + cone_map_bytes}}},
      {"the same by a cube",
       lamp_lit("desk", {{"cube.instead", never}}),
       {{"target_bytes", picture_bytes + 6 * face_bytes}}},
      {"no lamp: nothing", lamp_lit("lantern", {{"light.count", 0}}), {{"passes", 1}, {"target_bytes", picture_bytes}}},
      {"two lamps, one of which casts no shadow: one cube",
       lamp_lit("room"),
       {{"lights", 2}, {"passes", 2}, {"target_bytes", picture_bytes + 6 * face_bytes}}},
      {"three lamps: three cubes",
       lamp_lit("touching"),
       {{"lights", 3},
        {"passes", 4},
        {"texture_sources", 3},
        {"target_bytes", picture_bytes + 18 * face_bytes},
        {"lookups", 3}}},
      {"16 bits are half as many bytes",
       lamp_lit("lantern", {{"shadow.format", std::string("16")}}),
       {{"target_bytes", picture_bytes + 3 * face_bytes}}},
  };
  check_costs(cubes_step, rows);
}

TEST_CASE("faces that see no caster are cleared, and not drawn", "[required][04-point-shadows]") {
  const auto all = drawn(cubes_step, {lamp_lit("crates", {{"light.count", 0}}), lamp_lit("crates"),
                                      lamp_lit("crates", {{"cube.passes", six}}),
                                      lamp_lit("crates", {{"cube.passes", six}, {"cube.faces", all_faces}})});
  const auto more = [&](std::size_t i, const char* count) { return all[i].counts.at(count) - all[0].counts.at(count); };
  CHECK(more(1, "draws") == 5);  // crates alone: the walls cast no shadow
  CHECK(more(1, "passes") == 1);
  CHECK(more(3, "draws") == 6 * 5);
  CHECK(more(3, "passes") == 1 + 6);  // one that clears all faces
  CHECK(more(2, "draws") < 2 * 5);    // most crates stand in one face
  CHECK(more(2, "passes") == 1 + 5);  // nothing stands before the lamp: +z
  for (const std::size_t i : {2u, 3u}) CHECK(pixels_apart(all[i].picture, all[1].picture) == 0);
}

TEST_CASE("faces that the picture does not sample are not drawn in every frame", "[required][04-point-shadows]") {
  const SettingValue always = std::string("always"), all_cast = std::string("all");
  std::vector<Case> pictures;
  for (const char* scene : {"cube-room", "lantern", "touching", "crates"})
    for (const char* filter : {"nearest", "bilinear"})
      for (const auto& [pcf, bias] : {std::pair{1, 1.0}, {1, 0.0}, {15, 0.0}, {5, 1.0}}) {
        Case one = lamp_lit(scene, {{"cube.passes", six},
                                    {"scene.casters", all_cast},
                                    {"cube.instead", never},
                                    {"shadow.filter", std::string(filter)},
                                    {"shadow.pcf", pcf},
                                    {"shadow.bias_size", bias}});
        one.settings["cube.resolution"] = 32;  // coarse, so that a face that is missing is many pixels
        pictures.push_back(one);
        one.settings["shadow.update"] = always;
        pictures.push_back(one);
      }
  const auto all = drawn(cubes_step, pictures);
  for (std::size_t i = 0; i < all.size(); i += 2) {
    INFO(pictures[i].scene << ", pair " << i / 2);
    CHECK(pixels_apart(all[i].picture, all[i + 1].picture) == 0);
    CHECK(all[i + 1].counts.at("passes") <= all[i].counts.at("passes"));
  }
  // The camera sees the far wall and boxes to its upper left: nothing below the lamp, and nothing to its right.
  Case fine = pictures[1];
  fine.settings["cube.resolution"] = 512;
  CHECK(drawn(cubes_step, {fine})[0].counts.at("passes") <= all[0].counts.at("passes") - 2);
}

TEST_CASE("cube maps of static scenes are drawn once", "[required][04-point-shadows]") {
  for (const char* scene : {"lantern", "room", "touching", "desk"}) {
    INFO(scene);
    const auto first = drawn(cubes_step, {lamp_lit(scene)})[0].counts;
    const auto later = counts_at_rest(cubes_step, lamp_lit(scene));
    CHECK(first.at("passes") > 1);
    CHECK(later.at("passes") == 1);
    CHECK(later.at("draws") < first.at("draws"));
    CHECK(later.at("allocated_bytes") == 0);
    const auto always = counts_at_rest(cubes_step, lamp_lit(scene, {{"shadow.update", std::string("always")}}));
    CHECK(always.at("passes") == first.at("passes"));
    CHECK(always.at("draws") > later.at("draws"));
    CHECK(always.at("draws") <= first.at("draws"));  // casters that only faces out of sight see are left out
  }
}
