#include "app/list.hpp"

#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "fake_step.hpp"

namespace {

using namespace atelier;
using test::mentions;

/// The line of `text` that holds `word`.
std::string line_with(const std::string& text, const std::string& word) {
  const auto at = text.find(word);
  if (at == std::string::npos) return {};
  const auto begin = text.rfind('\n', at) + 1;
  return text.substr(begin, text.find('\n', at) - begin);
}

}  // namespace

TEST_CASE("the text list names everything that can be requested", "[list]") {
  const std::string text = list_as_text(test::FakeStep().description());
  CHECK(mentions(text, {"00-fake: A step for tests", "box", "ring", "--scene", "--set", "--output", "twice"}));
  CHECK(mentions(line_with(text, "tint.brightness"), {"0..4", "default 0.5"}));
  CHECK(mentions(line_with(text, "tint.colour"), {"red, blue", "default red"}));
  CHECK(mentions(line_with(text, "tint.glow"), {"R,G,B in linear light, each 0..2", "#rrggbb", "default 0,0,0"}));
  CHECK(mentions(line_with(text, "draw.wireframe"), {"on, off", "default off"}));
  CHECK(mentions(line_with(text, "  normal"), {"data"}));
  CHECK(mentions(line_with(text, "  colour "), {"linear colour"}));
}

TEST_CASE("the JSON list has the same content", "[list]") {
  const StepDescription description = test::FakeStep().description();
  const auto json = nlohmann::json::parse(list_as_json(description));
  CHECK(json["name"] == "00-fake");
  CHECK(json["scenes"] == nlohmann::json({"box", "ring"}));
  CHECK(json["probes"] == nlohmann::json({"twice"}));
  REQUIRE(json["settings"].size() == description.settings.size());
  for (std::size_t i = 0; i < description.settings.size(); ++i) {
    const SettingSpec& spec = description.settings[i];
    const auto& setting = json["settings"][i];
    INFO(spec.name);
    CHECK(setting["name"] == spec.name);
    CHECK(setting["help"] == spec.help);
    CHECK(setting["allowed"] == allowed_values(spec));
    CHECK(setting.contains("range") == (spec.high > spec.low));
    CHECK(setting.contains("choices") == !spec.choices.empty());
  }
  const struct {
    const char* name;
    nlohmann::json fallback, range;
  } rows[] = {{"tint.brightness", 0.5, {0.0, 4.0}},
              {"segments", 48, {3.0, 4096.0}},
              {"tint.glow", {0.0, 0.0, 0.0}, {0.0, 2.0}}};
  for (const auto& row : rows) {
    INFO(row.name);
    const auto setting = std::find_if(json["settings"].begin(), json["settings"].end(),
                                      [&](const auto& each) { return each["name"] == row.name; });
    REQUIRE(setting != json["settings"].end());
    CHECK((*setting)["default"] == row.fallback);
    CHECK((*setting)["range"] == row.range);
  }
  REQUIRE(json["outputs"].size() == 5);
  CHECK(json["outputs"][0]["name"] == "colour");
  CHECK(json["outputs"][1]["encoding"] == "data");
}

TEST_CASE("a step without settings or probes lists none", "[list]") {
  const StepDescription bare{.name = "00-bare", .title = "Nothing", .scenes = {"one"}};
  CHECK(list_as_text(bare).find("Probes") == std::string::npos);
  CHECK(nlohmann::json::parse(list_as_json(bare))["settings"].empty());
}
