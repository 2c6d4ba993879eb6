// A fog laid over the scenes of steps 02, 03 and 04: a feature of ten lines, and nothing that another feature has done
// is lost under it.
#include <cmath>

#include "01-transforms/functions.hpp"
#include "02-blinn-phong/lit_surface.hpp"
#include "02-blinn-phong/scenes.hpp"
#include "03-shadow-mapping/scenes.hpp"
#include "03-shadow-mapping/shadowed_surface.hpp"
#include "04-point-shadows/lamp_cones.hpp"
#include "04-point-shadows/point_shadowed_surface.hpp"
#include "04-point-shadows/scenes.hpp"
#include "04-point-shadows/studies.hpp"
#include "base/file.hpp"
#include "catch.hpp"
#include "gl/context.hpp"
#include "render/renderer.hpp"

namespace {

using namespace atelier;

constexpr glm::vec3 fog_colour{0.5f, 0.625f, 0.75f};

class Fog : public Feature {
  Need need(const Scene&, const View&, const Node&) const override { return {.wanted = true}; }
  std::map<Slot, SlotCode> slots() const override { return {{Slot::modify_shaded, {"05-fog/fog.glsl", "fog"}}}; }
  std::optional<glm::vec3> background(const Scene&, const View&) const override { return fog_colour; }
};
constexpr const char* fog_glsl =
    "vec3 fog(Surface s, vec3 shaded) {\n"
    "  return mix(vec3(0.5, 0.625, 0.75), shaded, exp(-0.125 * distance(s.eye_world, s.position_world)));\n"
    "}\n";

using Features = std::vector<std::unique_ptr<Feature>>;

std::vector<SettingSpec> all_settings() {
  std::vector<SettingSpec> all = lit_surface_settings();
  for (const auto& more : {blinn_phong_scene_settings(), shadow_setting_specs(), cube_settings()})
    all.insert(all.end(), more.begin(), more.end());
  const auto add_new = [&](const std::vector<SettingSpec>& more) {
    for (const SettingSpec& spec : more)
      if (std::ranges::none_of(all, [&](const SettingSpec& known) { return known.name == spec.name; }))
        all.push_back(spec);
  };
  add_new(shadow_scene_settings());
  add_new(point_scene_settings());
  add_new(study_settings());
  return all;
}

Features features_of(int step) {
  Features list;
  auto lit = std::make_unique<LitSurface>();
  const DrawnLights& lights = lit->lights();
  list.push_back(std::move(lit));
  static const PointFrusta none;
  if (step == 3) list.push_back(std::make_unique<ShadowedSurface>(lights, none));
  if (step == 4) {
    auto cones = std::make_unique<LampCones>(lights);
    auto maps = std::make_unique<ShadowedSurface>(lights, cones->frusta());
    auto cubes = std::make_unique<PointShadowedSurface>(lights, maps->maps());
    list.push_back(std::move(cones));
    list.push_back(std::move(maps));
    list.push_back(std::move(cubes));
  }
  return list;
}

/// Draws scenes with features of the steps.
struct Place {
  TemporaryFolder folder;
  std::unique_ptr<HeadlessContext> context = make_headless_context();
  Settings settings{all_settings()};
  std::unique_ptr<Renderer> renderer;

  Place() { write_file(folder.path() / "05-fog" / "fog.glsl", std::string_view(fog_glsl)); }
  /// Takes these features from now on.
  void open(Features features) {
    const std::filesystem::path root = ATELIER_SOURCE_DIR;
    renderer = std::make_unique<Renderer>(
        context->gl(), Implementations({{folder.path(), ""}, {root / "solutions", ""}, {root / "steps", ""}}),
        transform_functions(), std::move(features));
    renderer->configure(settings);
  }
  Image draw(const Scene& scene, const char* output = "colour") {
    renderer->prepare(scene);
    const Target target(context->gl(), {.width = 96, .height = 96});
    renderer->render({.camera = scene.camera, .output = output, .cull = true}, target);
    return target.read_colour(context->gl());
  }
};

}  // namespace

TEST_CASE("a fog over a scene changes nothing but what it is: shadows stay", "[compose]") {
  const struct {
    int step;
    const char* scene;
    Scene (*make)(const std::string& name, const Settings& settings);
  } rows[] = {
      {2, "teapot", make_blinn_phong_scene}, {3, "teapot", make_shadow_scene}, {4, "lantern", make_point_scene}};
  for (const auto& row : rows) {
    INFO("step 0" << row.step << ", scene " << row.scene);
    Place place;
    const Scene scene = row.make(row.scene, place.settings);
    place.open(features_of(row.step));
    const Image plain = place.draw(scene), places = place.draw(scene, "position"), depths = place.draw(scene, "depth");
    Features with_fog = features_of(row.step);
    with_fog.push_back(std::make_unique<Fog>());
    place.open(std::move(with_fog));
    const Image fog = place.draw(scene);
    double worst = 0;
    for (int y = 0; y < plain.height(); ++y)
      for (int x = 0; x < plain.width(); ++x) {
        const Rgba c = plain.at(x, y), p = places.at(x, y), f = fog.at(x, y);
        const bool nothing = depths.at(x, y).r == 0;
        const glm::vec3 clean(c.r, c.g, c.b), seen(f.r, f.g, f.b);
        const double way = glm::distance(scene.camera.eye, glm::dvec3(p.r, p.g, p.b));
        const glm::vec3 expected = nothing ? fog_colour : glm::mix(fog_colour, clean, float(std::exp(-0.125 * way)));
        worst = std::max(worst, double(glm::length(seen - expected)));
      }
    CHECK(worst < 1e-5);  // some roundings of numbers up to 1, and those of an exponential
  }
}

TEST_CASE("lights of a step are darkened by shadows, with and without a fog over them", "[compose]") {
  // What the test above compares with must have shadows in it.
  Place place;
  const Scene scene = make_point_scene("lantern", place.settings);
  place.open(features_of(4));
  const Image with = place.draw(scene);
  place.open(features_of(2));
  CHECK_FALSE(with == place.draw(scene));
}
