#include "drawn.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/file.hpp"
#include "case/exchange.hpp"
#include "catch.hpp"
#include "command.hpp"
#include "image/colour.hpp"

namespace atelier::test {

using nlohmann::json;

namespace {

std::string solutions_path() {
  return (folders().implementations() / "solutions").string() + ":" + folders().solutions().string();
}

}  // namespace

std::vector<Drawn> drawn(const std::string& step, std::vector<Case> pictures) {
  const TemporaryFolder folder("atelier-steps-test");
  json cases = json::array();
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    pictures[i].name = std::to_string(i);
    cases.push_back(to_json(pictures[i]));
  }
  const auto job = folder.path() / "job.json";
  write_file(job, json{{"cases", cases}}.dump());
  const Finished finished =
      run_process({.arguments = {folders().program(step).string(), "--cases", job.string(), "--out",
                                 folder.path().string(), "--stats", "--implementations", solutions_path()}});
  INFO(finished.output);
  REQUIRE(finished.ok());
  std::vector<Drawn> all;
  for (const Case& picture : pictures) {
    INFO("picture " << picture.name << ", " << picture.scene << ": "
                    << read_case_error(folder.held(), picture.name + ".error"));
    REQUIRE(std::filesystem::exists(folder.path() / (picture.name + ".stats")));
    const json stats = json::parse(read_file(folder.path() / (picture.name + ".stats")));
    all.push_back({read_pixels(folder.held(), picture.name + ".pixels", picture.size), stats["counts"]});
  }
  return all;
}

void check_costs(const std::string& step, const std::vector<Priced>& rows) {
  std::vector<Case> pictures;
  for (const Priced& row : rows) pictures.push_back(row.picture);
  const std::vector<Drawn> all = drawn(step, pictures);
  for (std::size_t i = 0; i < all.size(); ++i)
    for (const auto& [count, expected] : rows[i].costs) {
      INFO(rows[i].name << ": " << count);
      CHECK(all[i].counts.at(count) == expected);
    }
}

std::map<std::string, std::int64_t> counts_at_rest(const std::string& step, const Case& picture) {
  const TemporaryFolder folder("atelier-steps-test");
  std::vector<std::string> arguments = {folders().program(step).string(),
                                        "--scene",
                                        picture.scene,
                                        "--output",
                                        picture.output,
                                        "--size",
                                        std::to_string(picture.size.x) + "x" + std::to_string(picture.size.y),
                                        "--repeat",
                                        "2",
                                        "--out",
                                        (folder.path() / "a.exr").string(),
                                        "--stats",
                                        "--json",
                                        "--implementations",
                                        solutions_path()};
  for (const auto& [name, value] : picture.settings)
    arguments.insert(arguments.end(), {"--set", name + "=" + setting_text(value)});
  for (const auto& [option, place] : {std::pair("--eye", picture.camera.eye), {"--target", picture.camera.target}})
    if (place) arguments.insert(arguments.end(), {option, fmt::format("{},{},{}", place->x, place->y, place->z)});
  const Finished finished = run_process({.arguments = arguments});
  INFO(finished.output);
  REQUIRE(finished.ok());
  return json::parse(finished.output)["counts"];
}

Case picture(const std::string& scene, std::map<std::string, SettingValue> settings, const std::string& output) {
  Case made;
  made.scene = scene;
  made.size = {160, 120};
  made.settings = std::move(settings);
  made.output = output;
  return made;
}

namespace {

/// The largest difference of a channel after encoding, in units of 1/255.
double codes_between(const Rgba& p, const Rgba& q) {
  const auto apart = [](float x, float y) { return 255 * std::abs(srgb_encode(double(x)) - srgb_encode(double(y))); };
  return std::max({apart(p.r, q.r), apart(p.g, q.g), apart(p.b, q.b)});
}

}  // namespace

double codes_apart(const Image& a, const Image& b) {
  REQUIRE(a.same_size(b));
  double most = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i)
    most = std::max(most, codes_between(a.pixels()[i], b.pixels()[i]));
  return most;
}

int pixels_a_code_apart(const Image& a, const Image& b) {
  REQUIRE(a.same_size(b));
  int different = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) different += codes_between(a.pixels()[i], b.pixels()[i]) >= 1;
  return different;
}

int pixels_apart(const Image& a, const Image& b) {
  int different = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) different += a.pixels()[i] != b.pixels()[i];
  return different;
}

}  // namespace atelier::test
