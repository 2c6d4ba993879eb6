// Shadows on a smooth body of few facets: the map holds facets, while normals are interpolated.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "base/file.hpp"
#include "base/process.hpp"
#include "case/exchange.hpp"
#include "catch.hpp"
#include "command.hpp"
#include "drawn.hpp"

using namespace atelier;
using namespace atelier::test;

namespace {

/// A ball of radius 1 m with 8 rings of 12 facets and smooth normals, as an OBJ file.
std::string ball() {
  constexpr int rings = 8, sides = 12;
  std::string text = "s 1\n";
  for (int ring = 0; ring <= rings; ++ring)
    for (int side = 0; side < sides; ++side) {
      const double down = std::numbers::pi * ring / rings, round = 2 * std::numbers::pi * side / sides;
      text += fmt::format("v {:.6f} {:.6f} {:.6f}\n", std::sin(down) * std::cos(round), std::cos(down),
                          std::sin(down) * std::sin(round));
    }
  for (int ring = 0; ring < rings; ++ring)
    for (int side = 0; side < sides; ++side) {
      const int a = ring * sides + side + 1, b = ring * sides + (side + 1) % sides + 1;
      if (ring > 0) text += fmt::format("f {} {} {}\n", a, b, b + sides);
      if (ring + 1 < rings) text += fmt::format("f {} {} {}\n", a, b + sides, a + sides);
    }
  return text;
}

Image true_factor(const Case& picture) {
  const TemporaryFolder folder("atelier-facets");
  Case named = picture;
  named.name = "truth";
  const auto job = folder.path() / "job.json";
  nlohmann::json cases = nlohmann::json::array();
  cases.push_back(to_json(named));
  write_file(job, nlohmann::json{{"cases", cases}}.dump());
  const Finished finished = run_process({.arguments = {folders().program("03-shadow-mapping").string(), "--truth",
                                                       "--cases", job.string(), "--out", folder.path().string()}});
  INFO(finished.output);
  REQUIRE(finished.ok());
  return read_pixels(folder.held(), "truth.pixels", picture.size);
}

}  // namespace

TEST_CASE("a smooth ball of few facets casts no false shadow on itself", "[03-shadow-mapping]") {
  const TemporaryFolder folder;
  const auto file = folder.path() / "ball.obj";
  write_file(file, ball());
  std::vector<Case> pictures;
  for (const char* const bias : {"normal", "slope", "plane"}) {
    pictures.push_back(picture(file.string(), {{"shadow.bias", text(bias)}}, "shadow_factor"));
    pictures.back().size = {320, 240};
  }
  const Image truth = true_factor(pictures.front());
  const std::vector<Drawn> all = drawn("03-shadow-mapping", pictures);
  for (std::size_t i = 0; i < all.size(); ++i) {
    int lit = 0, falsely_dark = 0, dark = 0, falsely_lit = 0;
    for (std::size_t pixel = 0; pixel < truth.pixels().size(); ++pixel) {
      const float expected = truth.pixels()[pixel].r, factor = all[i].picture.pixels()[pixel].r;
      lit += expected == 1, dark += expected == 0;
      falsely_dark += expected == 1 && factor == 0, falsely_lit += expected == 0 && factor == 1;
    }
    INFO(std::get<std::string>(pictures[i].settings.at("shadow.bias"))
         << ": of " << lit << " lit pixels " << falsely_dark << " are dark, of " << dark << " dark ones " << falsely_lit
         << " are lit");
    CHECK(lit > 10'000);
    CHECK(falsely_dark == 0);
    CHECK(falsely_lit < dark / 50);
  }
}
