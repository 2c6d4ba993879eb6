// Unused features cost nothing, and culling of invisible things changes no pixel by 1/255.
#include <cmath>
#include <map>
#include <set>

#include "base/file.hpp"
#include "catch.hpp"
#include "command.hpp"
#include "drawn.hpp"
#include "scene/builtin.hpp"

using namespace atelier;
using namespace atelier::test;
using nlohmann::json;

TEST_CASE("unused features cost nothing", "[required][02-blinn-phong]") {
  const std::vector<Priced> rows = {
      {"no textures: nothing held, nothing looked up, no texture coordinate read",
       picture("facets"),
       {{"texture_bytes", 0}, {"texture_sources", 0}, {"attributes", 2}}},
      {"two textures", picture("tiles"), {{"texture_sources", 2}, {"attributes", 3}}},
      {"an output that needs no texture", picture("tiles", {}, "normal"), {{"texture_sources", 0}, {"attributes", 2}}},
      {"an output that needs no normal", picture("facets", {}, "texcoord"), {{"attributes", 2}}},
      {"one material: one variant", picture("facets"), {{"variants", 1}, {"program_switches", 1}}},
      {"one surface with a highlight, one without", picture("spots"), {{"variants", 2}}},
      {"no highlight: no table for its power",
       picture("tiles", {{"specular.power", std::string("table")}}),
       {{"texture_sources", 2}}},
      {"a highlight by a table",
       picture("facets", {{"specular.power", std::string("table")}}),
       {{"texture_sources", 1}, {"texture_bytes", 256 * 16}}},
      {"no light", picture("facets", {{"light.count", 0}}), {{"lights", 0}, {"passes", 1}}},
      {"one light", picture("facets"), {{"lights", 1}}},
      {"sixty-four lights are one pass", picture("festival"), {{"lights", 64}, {"passes", 1}, {"lights_culled", 0}}},
      {"nothing stands before a light: what receives shadows has no code for it", picture("blinds"), {{"variants", 1}}},
      {"blinds: a variant more, for what receives shadows",
       picture("blinds", {{"light.blind", true}}),
       {{"variants", 2}}},
      {"blinds and no light before which they could hang",
       picture("blinds", {{"light.blind", true}, {"light.count", 0}}),
       {{"variants", 1}}},
      {"one target of floats and 24 bits of depth", picture("facets"), {{"target_bytes", picture_bytes}}},
      {"nothing is made in a frame", picture("tiles"), {{"allocated_bytes", 0}}},
  };
  check_costs("02-blinn-phong", rows);
}

TEST_CASE("textures that no material of a step samples are not uploaded", "[required][02-blinn-phong]") {
  // The hall's bricks have normals and heights too, for later steps.
  const Scene hall = make_builtin_scene("hall");
  std::set<int> used;
  std::int64_t without = 0;
  for (const Material& material : hall.materials) {
    if (material.normal_texture) ++without;
    for (const TextureIndex& index : {material.diffuse_texture, material.specular_texture})
      if (index) used.insert(*index);
  }
  REQUIRE(without > 0);
  std::int64_t bytes = 0;
  for (const int index : used) {
    const Texture& texture = hall.textures[std::size_t(index)];
    const bool chain = texture.filter == Filter::mipmap;
    int width = texture.pixels.width(), height = texture.pixels.height();
    for (bool more = true; more; width = std::max(width / 2, 1), height = std::max(height / 2, 1)) {
      bytes += 16LL * width * height;
      more = chain && (width > 1 || height > 1);
    }
  }
  const auto all = drawn("02-blinn-phong", {picture("hall"), picture("facets")});
  CHECK(all[0].counts.at("texture_bytes") == bytes);
  CHECK(all[0].counts.at("texture_sources") == std::int64_t(used.size()));
  CHECK(all[1].counts.at("texture_bytes") == 0);  // the scene before it has left nothing behind
}

TEST_CASE("lights with an invisible effect are culled", "[required][02-blinn-phong]") {
  std::vector<Case> pictures;
  for (const char* normalisation : {"none", "n+8"})
    for (const bool cull : {false, true})
      pictures.push_back(
          picture("quay", {{"light.cull", cull}, {"specular.normalisation", std::string(normalisation)}}));
  const auto all = drawn("02-blinn-phong", pictures);
  for (const std::size_t i : {0u, 2u}) {
    CHECK(all[i].counts.at("lights") == 63);
    CHECK(all[i].counts.at("lights_culled") == 0);
    CHECK(all[i + 1].counts.at("lights") == 1);
    CHECK(all[i + 1].counts.at("lights_culled") == 62);
    CHECK(codes_apart(all[i].picture, all[i + 1].picture) < 1);
    CHECK(pixels_apart(all[i].picture, all[i + 1].picture) > 0);  // they did shine
  }

  // Where all lights matter, all are drawn, and not a bit changes.
  for (const char* scene : {"teapot", "materials", "lights", "spots", "festival", "edges", "room"}) {
    INFO(scene);
    const auto both = drawn("02-blinn-phong", {picture(scene, {{"light.cull", false}}), picture(scene)});
    CHECK(both[1].counts.at("lights_culled") == 0);
    CHECK(pixels_apart(both[0].picture, both[1].picture) == 0);
  }
}

TEST_CASE("nodes outside the view are not drawn", "[required][01-transforms]") {
  const struct {
    const char* scene;
    glm::dvec3 eye, target;
    double offset = 0;  // metres
    bool fewer = true;  // nodes are left out
  } rows[] = {
      {"spiral", {1, 4, 2}, {0, 4.5, 0}},
      {"robot", {0, 1.5, 1.6}, {0.3, 1.6, 0}},
      {"room", {0, 1.6, 2}, {-3, 1.5, -1}},
      {"slats", {0, 0, -500}, {0, 1, -501}},
      // A million metres away floats draw things 6 cm and more from where they are: what is beside the view by less
      // than some ten metres is in doubt, and all of this still life is.
      {"far",
       {1000000.9266576935, 250001.92469784393, -499997.55440105987},
       {1000002.3040763983, 249999.3198918291, -500000.6963344282},
       1e6,
       false},
  };
  for (const auto& row : rows) {
    INFO(row.scene);
    Case all = picture(row.scene, {{"world.offset", row.offset}});
    all.camera.eye = row.eye;
    all.camera.target = row.target;
    Case fewer = all, fewer_relative = all, all_relative = all;
    fewer.settings["draw.cull"] = true;
    all_relative.settings["world.camera_relative"] = true;
    fewer_relative.settings["draw.cull"] = true;
    fewer_relative.settings["world.camera_relative"] = true;
    const auto pictures = drawn("01-transforms", {all, fewer, all_relative, fewer_relative});
    if (row.fewer) CHECK(pictures[1].counts.at("draws") < pictures[0].counts.at("draws"));
    CHECK(pictures[1].counts.at("draws") + pictures[1].counts.at("nodes_culled") == pictures[0].counts.at("draws"));
    CHECK(pixels_apart(pictures[0].picture, pictures[1].picture) == 0);
    if (row.offset == 0) CHECK(pictures[3].counts.at("draws") == pictures[1].counts.at("draws"));
    CHECK(pixels_apart(pictures[2].picture, pictures[3].picture) == 0);
  }
}

TEST_CASE("near and far that fit the scene improve depth precision", "[required][01-transforms]") {
  // The slats stand 20 m to 5 km away behind a near plane of a centimetre; pairs are a ten-thousandth of their distance
  // apart. Reversed depth in floats orders all of them (steps of 6e-8 of the distance): it is the truth here.
  const auto slats = [](const char* format, bool fit) {
    return picture("slats", {{"depth.format", std::string(format)}, {"camera.fit_depth", fit}});
  };
  const auto all = drawn("01-transforms", {slats("24", false), slats("24", true), slats("16", false), slats("16", true),
                                           slats("32f-reversed", false), slats("32f-reversed", true)});
  const auto wrong = [&](std::size_t i) { return pixels_apart(all[i].picture, all[4].picture); };
  INFO("pixels of the wrong slat: 24 bits " << wrong(0) << ", fitted " << wrong(1) << "; 16 bits " << wrong(2)
                                            << ", fitted " << wrong(3));
  CHECK(wrong(0) > 100);
  CHECK(wrong(1) == 0);  // n = 20 m: steps of z / n 2^-24 = 1.5e-5 of the distance at 5 km
  CHECK(wrong(3) < wrong(2));
  CHECK(wrong(5) == 0);

  // Not "stretched": it has a solid pressed flat, whose front and back lie in one plane and quarrel in any depth.
  for (const char* scene : {"robot", "teapot", "hall", "spiral", "far", "plan", "room"}) {
    INFO(scene);
    const auto both = drawn("01-transforms", {picture(scene), picture(scene, {{"camera.fit_depth", true}})});
    CHECK(codes_apart(both[0].picture, both[1].picture) < 1);
  }
}

TEST_CASE("a wall with the computed number of pieces looks round", "[required][01-transforms]") {
  const auto hall = [](int segments, int fit) {
    Case made = picture("hall", {{"hall.segments", segments}, {"hall.fit", fit}}, "normal");
    made.size = {320, 240};
    return made;
  };
  const auto all = drawn("01-transforms", {hall(4096, 0), hall(64, 240), hall(12, 0), hall(64, 480)});
  // Where the wall ends, from above and from below, in each column: floor and ceiling have vertical normals.
  const auto edges = [](const Image& image) {
    std::vector<int> rows;
    for (int x = 0; x < image.width(); ++x) {
      const auto wall = [&](int y) { return std::abs(image.at(x, y).g - 0.5f) < 0.25f; };
      int top = 0, bottom = image.height() - 1;
      while (top < bottom && !wall(top)) ++top;
      while (bottom > top && !wall(bottom)) --bottom;
      rows.push_back(top), rows.push_back(bottom);
    }
    return rows;
  };
  const auto truth = edges(all[0].picture);
  const auto farthest = [&](const Image& image) {
    int most = 0;
    const auto rows = edges(image);
    for (std::size_t i = 0; i < rows.size(); ++i) most = std::max(most, std::abs(rows[i] - truth[i]));
    return most;
  };
  // Half a pixel moves an edge by one row at the most.
  CHECK(farthest(all[1].picture) <= 1);
  CHECK(farthest(all[2].picture) > 1);
  const auto triangles = [&](std::size_t i) { return all[i].counts.at("triangles"); };
  CHECK(triangles(1) < triangles(0) / 40);
  // Twice the pixels take sqrt 2 of the pieces; floor and ceiling are 4 triangles; a piece more by rounding up.
  CHECK(std::abs(double(triangles(3) - 4) - std::sqrt(2.0) * double(triangles(1) - 4)) <= 2 * 2);
}

TEST_CASE("a static scene computes no matrices", "[required][01-transforms]") {
  const TemporaryFolder folder("atelier-steps-test");
  const auto counts = [&](std::vector<std::string> more) {
    std::vector<std::string> arguments = {
        folders().program("01-transforms").string(), "--scene", "spiral", "--size", "64x48", "--out",
        (folder.path() / "a.exr").string(),          "--stats", "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Finished finished = run_process({.arguments = arguments});
    INFO(finished.output);
    REQUIRE(finished.ok());
    return json::parse(finished.output);
  };
  const json first = counts({}), later = counts({"--repeat", "3"});
  CHECK(first["counts"]["matrices"] == 200);  // a world and a normal matrix for each of a hundred boxes
  CHECK_FALSE(first.contains("frames"));
  CHECK(later["counts"]["matrices"] == 0);
  CHECK(later["frames"]["count"] == 3);
  CHECK(later["counts"]["draws"] == first["counts"]["draws"]);
  CHECK(counts({"--repeat", "3", "--set", "world.camera_relative=on"})["counts"]["matrices"] == 0);  // the eye rests
}
