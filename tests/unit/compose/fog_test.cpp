// Fog over the scenes of steps 02, 03 and 04: a feature of ten lines, which keeps the effects of the other features.
#include <cmath>

#include "image/colour.hpp"
#include "place.hpp"

namespace {

using namespace atelier;
using namespace atelier::test;

class Fog : public Feature {
  glm::vec3 colour_{0};
  void configure(const Settings& settings) override { colour_ = glm::vec3(settings.colour("fog.colour")); }
  Need need(const Scene&, const View&, const Node&) const override { return {.wanted = true}; }
  std::map<Slot, SlotCode> slots() const override { return {{Slot::modify_shaded, {"05-fog/fog.glsl", "fog"}}}; }
  std::optional<glm::vec3> background(const Scene&, const View&) const override { return colour_; }
  void bind_view(Binder& binder, const Scene&, const Viewpoint&) override { binder.set("u_fog", colour_); }
};
constexpr const char* fog_glsl =
    "uniform vec3 u_fog;\n"
    "vec3 fog(Surface s, vec3 shaded) {\n"
    "  return mix(u_fog, shaded, exp(-0.125 * distance(s.eye_world, s.position_world)));\n"
    "}\n";

}  // namespace

TEST_CASE("fog over a scene keeps the shadows", "[compose]") {
  const struct {
    int step;
    const char* scene;
    const SceneTable& scenes;
  } rows[] = {{2, "teapot", blinn_phong_scenes()}, {3, "teapot", shadow_scenes()}, {4, "lantern", point_scenes()}};
  for (const auto& row : rows) {
    INFO("step 0" << row.step << ", scene " << row.scene);
    Place place({{.name = "fog.colour", .fallback = Colour{0.5f, 0.625f, 0.75f}, .high = 1}});
    const glm::vec3 fog_colour(place.settings.colour("fog.colour"));
    write_file(place.folder.path() / "05-fog" / "fog.glsl", std::string_view(fog_glsl));
    const Scene scene = make_scene(row.scenes, row.scene, place.settings);
    place.open(features_of(row.step));
    const Image plain = place.draw(scene), places = place.draw(scene, "position"), depths = place.draw(scene, "depth");
    FeatureList with_fog = features_of(row.step);
    with_fog.add<Fog>();
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

TEST_CASE("the scenes of the fog test contain shadows", "[compose]") {
  Place place;
  for (const int step : {3, 4}) {
    INFO("step 0" << step);
    const Scene scene = step == 3 ? make_scene(shadow_scenes(), "teapot", place.settings)
                                  : make_scene(point_scenes(), "lantern", place.settings);
    place.open(features_of(step));
    const Image with = place.draw(scene);
    place.open(features_of(2));
    CHECK_FALSE(with == place.draw(scene));
  }
}

TEST_CASE("fog is visible also in a picture encoded by a student's function", "[compose]") {
  Place place({{.name = "fog.colour", .fallback = Colour{0.5f, 0.625f, 0.75f}, .high = 1}});
  write_file(place.folder.path() / "05-fog" / "fog.glsl", std::string_view(fog_glsl));
  const Scene scene = make_scene(blinn_phong_scenes(), "teapot", place.settings);
  FeatureList features = features_of(2);
  features.add<Fog>();
  place.open(std::move(features));
  const Image light = place.draw(scene), encoded = place.draw(scene, "encoded");
  const Rgba seen = light.at(48, 48), codes = encoded.at(48, 48);
  CHECK(codes.r == Approx(srgb_encode(double(seen.r))).margin(1e-5));  // roundings of a power
  CHECK(codes.b == Approx(srgb_encode(double(seen.b))).margin(1e-5));
}
