// Whole pictures against formulas for each pixel.
#include "catch.hpp"
#include "pieces.hpp"
#include "scene/builtin.hpp"

namespace atelier::test {
namespace {

using oracle::Output;
using oracle::Shadows;
using oracle::trace;
using oracle::World;

constexpr double float_rounding = 0x1p-23;  ///< of a picture's floats, relative, with one bit to spare

/// Pixels whose first channel is further off `expected(x, y)` than `tolerance` of it, or NaN. Floats below 1e-38 lose
/// digits one by one.
template <class Expected>
int wrong_pixels(const Image& image, double tolerance, Expected&& expected) {
  int wrong = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const double value = expected(x, y);
      if (!(std::abs(image.at(x, y).r - value) <= tolerance * std::abs(value) + 1e-38)) ++wrong;
    }
  return wrong;
}

}  // namespace

TEST_CASE("a sphere lit from the camera equals its formula, pixel by pixel", "[picture]") {
  Scene scene = dark_scene({0.5f, 0.5f, 0.5f});
  scene.materials[0].specular = glm::vec3(0.25f);
  scene.materials[0].exponent = 40;
  scene.materials[0].emission = glm::vec3(0.125f);
  scene.ambient = glm::vec3(0.25f);
  scene.background = glm::vec3(2);
  scene.lights = {{.type = LightType::directional, .direction = {0, -1, 0}}};
  const World world(scene, {{.surface = oracle::Sphere{1}}});
  const int pixels = 64;
  Camera camera = map_camera(2.5f);
  camera.eye.y = 1e7;  // so far that all directions to it are one
  camera.near = 1e6f, camera.far = 2e7f;
  const auto cosine = [&](int x, int y) {  // N.L = N.H
    const glm::dvec2 p = on_map(x, y, pixels, 2.5);
    const double r2 = glm::dot(p, p);
    return r2 < 1 ? std::sqrt(1 - r2) : -1.0;
  };
  const auto diffuse = [&](double c) { return 0.5 * 0.25 + 0.5 * c; };
  const auto specular = [&](double c) { return 0.25 * std::pow(c, 40) * c; };
  const struct {
    const char* name;
    Output output;
    std::function<double(double)> on_sphere;
    double behind;
  } rows[] = {
      {"colour", Output::colour, [&](double c) { return diffuse(c) + specular(c) + 0.125; }, 2},
      {"diffuse", Output::diffuse, diffuse, 0},
      {"specular", Output::specular, specular, 0},
      {"normal, x", Output::normal, {}, 0},
  };
  for (const auto& row : rows) {
    INFO(row.name);
    const Image image = trace(world, {.camera = camera, .size = {pixels, pixels}, .output = row.output});
    // Directions to the eye differ by 1e-7, which the exponent multiplies by 40; from so far a double knows the sphere
    // to 1e-9 m.
    CHECK(wrong_pixels(image, 1e-5, [&](int x, int y) {
            const double c = cosine(x, y);
            if (c < 0) return row.behind;
            return row.on_sphere ? row.on_sphere(c) : on_map(x, y, pixels, 2.5).x / 2 + 0.5;
          }) == 0);
  }
}

TEST_CASE("a plane under a point light and under spots", "[picture]") {
  const Scene scene = [] {
    Scene made = dark_scene(glm::vec3(0.8f));
    made.lights = {{.position = {0.3, 1.5, -0.2}, .colour = glm::vec3(3)}};
    return made;
  }();
  const int pixels = 65;
  const double metres = 4;
  const auto image_of = [&](const Scene& lit) {
    return trace(World(lit, {ground(10)}), {.camera = map_camera(float(metres)), .size = {pixels, pixels}});
  };
  const auto lit = [&](int x, int y) {  // colour / d^2, times the cosine h / d
    const glm::dvec2 aside = on_map(x, y, pixels, metres) - glm::dvec2(0.3, -0.2);
    const double h = 1.5, d2 = glm::dot(aside, aside) + h * h;
    return double(0.8f) * 3 / d2 * h / std::sqrt(d2);
  };
  CHECK(wrong_pixels(image_of(scene), float_rounding, lit) == 0);

  for (const double degree : {20.0, 45.0}) {
    Scene spot = scene;
    spot.lights[0].type = LightType::spot;
    spot.lights[0].inner_angle = spot.lights[0].outer_angle = degrees(degree);
    // Lit within the circle of radius h tan(angle); no pixel's middle lies within 1e-6 m of it.
    CHECK(wrong_pixels(image_of(spot), float_rounding, [&](int x, int y) {
            const double r = glm::length(on_map(x, y, pixels, metres) - glm::dvec2(0.3, -0.2));
            return r < 1.5 * std::tan(double(degrees(degree))) ? lit(x, y) : 0.0;
          }) == 0);
  }
}

TEST_CASE("a sphere's hard shadow is a disc", "[picture]") {
  const double height = 4, middle = 1.5, radius = 0.5, metres = 4;
  const int pixels = 101;
  Scene scene = dark_scene();
  scene.lights = {{.position = {0, height, 0}, .colour = glm::vec3(16)}};
  glm::dmat4 place(1);
  place[3] = {0, middle, 0, 1};
  oracle::Shape ball{.surface = oracle::Sphere{radius}, .object_to_world = place};
  // The light touches the sphere along a cone of sine R / (H - c), and the cone meets the ground in a circle.
  const double rim = height * radius / std::sqrt((height - middle) * (height - middle) - radius * radius);
  const auto dark_beyond_ball = [&](const oracle::Shape& caster, const oracle::Shape& floor, bool on) {
    const Image image =
        trace(World(scene, {floor, caster}), {.camera = map_camera(float(metres)),
                                              .size = {pixels, pixels},
                                              .shading = {.shadows = on ? Shadows::hard : Shadows::none}});
    int wrong = 0, dark = 0;
    for (int y = 0; y < pixels; ++y)
      for (int x = 0; x < pixels; ++x) {
        const double r = glm::length(on_map(x, y, pixels, metres));
        if (r <= radius) continue;  // the camera sees the ball itself
        wrong += (image.at(x, y).r == 0) != (r < rim);
        dark += image.at(x, y).r == 0;
      }
    return std::pair(wrong, dark);
  };
  const auto [wrong, dark] = dark_beyond_ball(ball, ground(10), true);
  CHECK(wrong == 0);
  CHECK(dark > 200);
  CHECK(dark_beyond_ball(ball, ground(10), false).second == 0);
  oracle::Shape ghost = ball, aloof = ground(10);
  ghost.casts_shadow = false;
  aloof.receives_shadow = false;
  CHECK(dark_beyond_ball(ghost, ground(10), true).second == 0);
  CHECK(dark_beyond_ball(ball, aloof, true).second == 0);
  scene.lights[0].casts_shadow = false;
  CHECK(dark_beyond_ball(ball, ground(10), true).second == 0);
}

TEST_CASE("no lit surface shades itself", "[picture]") {
  // Every face that a light reaches stays lit: convex bodies, far from the origin and near it, light at grazing angles.
  for (const double offset : {0.0, 1e6}) {
    Scene scene = dark_scene();
    add_object(scene, make_box({}), 0, {.translation = {offset, 0, 0}, .rotation_angle = 0.4f});
    scene.lights = {{.position = {offset + 40, 0.501, 3}, .colour = glm::vec3(1000)},
                    {.type = LightType::directional, .direction = {-1, -0.01f, -0.3f}}};
    scene.camera = {.eye = {offset + 2, 2, 2}, .target = {offset, 0, 0}};
    const World world(scene);
    const auto picture = [&](Shadows shadows) {
      return trace(world, {.camera = scene.camera, .size = {96, 96}, .shading = {.shadows = shadows}});
    };
    CHECK(picture(Shadows::hard) == picture(Shadows::none));
  }
}

TEST_CASE("the picture depends neither on the number of threads nor on the world's position", "[picture]") {
  Scene scene = make_builtin_scene("primitives");
  const auto picture = [](const Scene& traced, int threads, Output output) {
    return trace(World(traced), {.camera = traced.camera,
                                 .size = {96, 64},
                                 .output = output,
                                 .shading = {.shadows = Shadows::hard},
                                 .position_origin = traced.camera.eye,
                                 .threads = threads});
  };
  const Image one = picture(scene, 1, Output::colour);
  for (const int threads : {2, 5, 100}) CHECK(picture(scene, threads, Output::colour) == one);

  const Image near = picture(scene, 0, Output::position), near_things = picture(scene, 0, Output::thing);
  const glm::dvec3 offset(1e6, -2.5e5, 5e5);
  for (Node& node : scene.nodes)
    if (node.parent < 0) node.translation += offset;
  scene.camera.eye += offset;
  scene.camera.target += offset;
  CHECK(picture(scene, 0, Output::thing) == near_things);
  const Image far = picture(scene, 0, Output::position);
  double worst = 0;
  for (std::size_t i = 0; i < near.pixels().size(); ++i) {
    const Rgba &a = near.pixels()[i], &b = far.pixels()[i];
    worst = std::max({worst, std::abs(double(a.r - b.r)), std::abs(double(a.g - b.g)), std::abs(double(a.b - b.b))});
  }
  // A double's ulp at 1e6 m is 1.2e-10 m; floats of distances up to 10 m are rounded to 1e-6 m. On the floor, seen at
  // 10 degrees, positions move six times as far as the ray.
  CHECK(worst < 2e-6);
}

TEST_CASE("a pixel is the mean of its samples", "[picture]") {
  Scene scene = dark_scene();
  scene.materials[0].emission = glm::vec3(1);
  add_object(scene, make_plane({.width = 1, .depth = 1}), 0);
  // Of the one pixel, 3 m wide, the square metre in the middle is bright: a ninth; 3 x 3 samples say just that.
  const World world(scene);
  const auto mean = [&](int samples) {
    return trace(world, {.camera = map_camera(3), .size = {1, 1}, .samples = samples}).at(0, 0).r;
  };
  CHECK(mean(1) == 1);
  CHECK(mean(3) == 1 / 9.0f);
  CHECK(mean(64) == Approx(1 / 9.0).margin(2.0 / 64));  // a row of samples at most falls on the wrong side
}

TEST_CASE("the data outputs give positions and nodes", "[picture]") {
  Scene scene = dark_scene();
  add_object(scene, make_plane({.width = 2, .depth = 2}), 0);
  add_object(scene, make_plane({.width = 1, .depth = 1}), 0, {.translation = {0, 0.5, 0}});
  const World world(scene);
  const auto at = [&](Output output, int x, int y) {
    return trace(world, {.camera = map_camera(4), .size = {8, 8}, .output = output}).at(x, y);
  };
  CHECK(at(Output::thing, 0, 0) == Rgba{0, 0, 0, 1});
  CHECK(at(Output::thing, 2, 2) == Rgba{1, 1, 1, 1});
  CHECK(at(Output::thing, 4, 4) == Rgba{2, 2, 2, 1});
  CHECK(at(Output::position, 2, 2) == Rgba{-0.75f, 0, -0.75f, 1});
  CHECK(at(Output::texcoord, 2, 2) == Rgba{0.125f, 0.875f, 0, 1});
  CHECK(at(Output::normal, 2, 2) == Rgba{0.5f, 1, 0.5f, 1});
  CHECK(at(Output::depth, 2, 2).r == Approx(99 / 199.0));
  CHECK(at(Output::depth, 0, 0).r == 0);
}

TEST_CASE("nothing to see: the background", "[picture]") {
  Scene scene = dark_scene();
  scene.background = {0.25f, 0.5f, 0.75f};
  const Image image = trace(World(scene), {.camera = scene.camera, .size = {3, 2}, .samples = 2});
  CHECK(image == Image(3, 2, {0.25f, 0.5f, 0.75f, 1}));
}

TEST_CASE("values out of range are refused, and exceptions are passed on", "[picture]") {
  Scene scene = dark_scene();
  const World world(scene, {ground(1000)});
  const oracle::PictureRequest request{.camera = map_camera(4), .size = {16, 16}};
  auto with = [&](auto&& change) {
    oracle::PictureRequest changed = request;
    change(changed);
    return error_of([&] { trace(world, changed); });
  };
  CHECK(mentions(with([](auto& r) { r.samples = 0; }), {"samples", "64 x 64"}));
  CHECK(mentions(with([](auto& r) { r.samples = 65; }), {"65 x 65 samples"}));
  CHECK_FALSE(with([](auto& r) { r.size = {0, 16}; }).empty());
  for (const int threads : {1, 4})
    CHECK(with([&](auto& r) {
            r.threads = threads;
            r.shading.surface = [](const World&, const oracle::SurfacePoint&, const glm::dvec3&) -> glm::dvec3 {
              throw Error("no such colour");
            };
          }) == "no such colour");
  CHECK(mentions(error_of([] { oracle::output_named("shadow"); }), {"'shadow'", "colour", "depth", "thing"}));

  std::vector<double> told;
  with([&](auto& r) { r.threads = 1, r.progress = [&](double done) { told.push_back(done); }; });
  CHECK(told.size() == 16);
  CHECK(std::is_sorted(told.begin(), told.end()));
  CHECK(told.back() == 1);
}

}  // namespace atelier::test
