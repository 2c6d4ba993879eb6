// Light culling: no visible light is culled, and as many invisible ones as their sum allows.
#include "scene/light_reach.hpp"

#include <random>

#include "catch.hpp"
#include "scene/depth_range.hpp"

namespace {

using namespace atelier;

Box3 unit_box() {
  Box3 box;
  box.add({-1, -1, -1}), box.add({1, 1, 1});
  return box;
}

/// 1 for every exponent: no normalisation.
double plain(double) {
  return 1;
}

std::vector<int> kept(const std::vector<Light>& lights, glm::dvec3 given_back = glm::dvec3(1)) {
  return lights_that_matter(lights, given_back, unit_box());
}

/// A light at distance `d` from the box, of such a strength that it can give `share` of what is just visible.
Light light_of(double share, double d = 10) {
  return {.position = {1 + d, 0, 0}, .colour = glm::vec3(float(share * least_visible_light * d * d))};
}

}  // namespace

TEST_CASE("the maximum light in a box is that at its nearest point", "[light_reach]") {
  const struct {
    const char* name;
    Light light;
    glm::dvec3 most;
  } rows[] = {
      {"point light 2 m above", {.position = {0, 3, 0}, .colour = {4, 8, 12}}, {1, 2, 3}},
      {"beside a corner, 3 m in each direction", {.position = {4, 4, 4}, .colour = glm::vec3(27)}, glm::dvec3(1)},
      {"within the box: a millimetre counts", {.position = {0.5, 0, 0}, .colour = glm::vec3(1)}, glm::dvec3(1e6)},
      {"all coefficients", {.position = {0, 3, 0}, .colour = glm::vec3(8), .attenuation = {2, 1, 1}}, glm::dvec3(1)},
      {"the sun", {.type = LightType::directional, .colour = {1, 2, 3}}, {1, 2, 3}},
      {"a lamp that is out", {.position = {0, 0, 0}, .colour = glm::vec3(0)}, glm::dvec3(0)},
  };
  for (const auto& row : rows) {
    INFO(row.name);
    const glm::dvec3 most = most_arriving(row.light, unit_box());
    for (int channel = 0; channel < 3; ++channel)
      CHECK(most[channel] == Approx(row.most[channel]).epsilon(1e-9));  // a few roundings of doubles
  }
  CHECK(most_arriving(rows[0].light, Box3{}) == glm::dvec3(0));  // there is nothing to be lit
}

TEST_CASE("a spot light gives no light outside its cone", "[light_reach]") {
  // From 10 m away the sphere around the box, of radius sqrt 3, is seen under asin(sqrt 3 / 10) = 0.1741 radians.
  const auto spot = [](float turned_away, float outer) {
    return Light{.type = LightType::spot,
                 .position = {10, 0, 0},
                 .direction = {-std::cos(turned_away), std::sin(turned_away), 0},
                 .colour = glm::vec3(81),
                 .inner_angle = 0,
                 .outer_angle = outer};
  };
  const struct {
    const char* name;
    Light light;
    bool reaches;
  } rows[] = {
      {"pointed at it", spot(0, 0.1f), true},
      {"just beside", spot(0.28f, 0.1f), false},
      {"just not beside", spot(0.27f, 0.1f), true},
      {"nothing but its axis, aside", spot(0.18f, 0), false},
      {"nothing but its axis, at it", spot(0.17f, 0), true},
      {"turned round", spot(3.1f, 0.5f), false},
      {"turned round, but wider than half a turn", spot(3.1f, 3.0f), true},
      {"all round", spot(3.1f, 3.1415927f), true},
      {"inside the sphere, looking out",
       {.type = LightType::spot, .position = {1.2, 0, 0}, .direction = {1, 0, 0}},
       true},
  };
  for (const auto& row : rows) {
    INFO(row.name);
    CHECK((most_arriving(row.light, unit_box()) != glm::dvec3(0)) == row.reaches);
  }
}

TEST_CASE("the reflected light includes the peak of the highlight", "[light_reach]") {
  const Material dull{.diffuse = {0.5f, 0.25f, 0}},
      shiny{.diffuse = glm::vec3(0), .specular = {0, 0.5f, 1}, .exponent = 92};
  CHECK(most_given_back({dull}, plain) == glm::dvec3(0.5, 0.25, 0));
  CHECK(most_given_back({dull, shiny}, plain) == glm::dvec3(0.5, 0.5, 1));
  const auto usual = [](double n) { return (n + 8) / 8; };
  CHECK(most_given_back({dull, shiny}, usual) == glm::dvec3(0.5, 6.25, 12.5));
  CHECK(most_given_back({}, plain) == glm::dvec3(0));
}

TEST_CASE("lights are culled as long as their sum is invisible", "[light_reach]") {
  const struct {
    const char* name;
    std::vector<Light> lights;
    std::vector<int> kept;
  } rows[] = {
      {"none", {}, {}},
      {"one that is too weak", {light_of(0.9)}, {}},
      {"one that is not", {light_of(1.1)}, {0}},
      {"two that are too weak alone", {light_of(0.6), light_of(0.6)}, {1}},
      {"the weakest go first, whatever their order", {light_of(5), light_of(0.5), light_of(2), light_of(0.4)}, {0, 2}},
      {"a dark one goes for nothing", {light_of(0), light_of(1.1), light_of(0)}, {1}},
      {"a hundred", std::vector<Light>(100, light_of(1.0 / 50)),
       [] {
         std::vector<int> all;
         for (int i = 49; i < 100; ++i) all.push_back(i);
         return all;
       }()},
  };
  for (const auto& row : rows) {
    INFO(row.name);
    CHECK(kept(row.lights) == row.kept);
  }
  CHECK(kept({light_of(0.9)}, glm::dvec3(0.5, 1.2, 0.5)) == std::vector<int>{0});  // one channel is enough
  CHECK(kept({light_of(0.9)}, glm::dvec3(0)).empty());
}

TEST_CASE("a light is tested against the surface including rounding errors", "[light_reach]") {
  // The two translations make 0.3 m; in floats, whose steps are 6 cm at a million metres, 0.3125 m.
  Scene scene;
  scene.meshes.push_back({.vertices = {{.position = {0, 0, 0}}, {.position = {0, 1, 0}}, {.position = {0, 0, 1}}}});
  scene.nodes = {Node{.translation = {1e6, 0, 0}}, Node{.parent = 0, .translation = {-999999.7, 0, 0}, .mesh = 0}};
  const double drawn = double(1e6f + -999999.7f);
  REQUIRE(drawn == 0.3125);
  // 5 cm before the wall's own place it falls short of being seen by a tenth; it is 3.75 cm from the wall that is
  // drawn.
  const double away = 0.05;
  const Light light{.position = {0.3 + away, 0, 0},
                    .colour = glm::vec3(float(0.9 * least_visible_light * away * away))};
  CHECK(lights_that_matter({light}, glm::dvec3(1), bounds(scene)).empty());
  CHECK(lights_that_matter({light}, glm::dvec3(1), box_of_drawn(node_boxes(scene))) == std::vector<int>{0});
  CHECK(box_of_drawn({}).empty());
}

TEST_CASE("in a part of a scene, what the scene leaves out counts", "[light_reach]") {
  const std::vector<Light> lights = {light_of(0.5), light_of(5), light_of(0.3), light_of(0.4)};
  // 0.3 and 0.4 together are invisible, and the 0.5 is one too many.
  const std::vector<int> everywhere = kept(lights);
  CHECK(everywhere == std::vector<int>{0, 1});
  const auto on = [&](const Box3& box) { return lights_that_matter(lights, glm::dvec3(1), box, everywhere); };
  CHECK(on(unit_box()) == everywhere);
  Box3 far;  // from 110 m on, where all give a hundredth and less
  far.add({-101, -1, -1}), far.add({-99, 1, 1});
  CHECK(on(far).empty());
  CHECK(lights_that_matter(lights, glm::dvec3(20), far, everywhere) == std::vector<int>{1});
}

TEST_CASE("no point, normal or eye position in the box sees a culled light", "[light_reach]") {
  std::mt19937 random(4);
  const auto number = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  const auto direction = [&] {
    for (;;) {
      const glm::dvec3 v(number(-1, 1), number(-1, 1), number(-1, 1));
      if (const double l = glm::length(v); l > 0.1 && l < 1) return v / l;
    }
  };
  const Material material{.diffuse = glm::vec3(0.6f), .specular = glm::vec3(0.4f), .exponent = 50};
  const auto lobe = [](double n) { return (n + 8) / 8; };
  const Box3 box = unit_box();
  int left_out = 0;
  for (int trial = 0; trial < 40; ++trial) {
    std::vector<Light> lights;
    for (int i = 0; i < 12; ++i)
      lights.push_back({.type = i % 3 == 0 ? LightType::spot : LightType::point,
                        .position = direction() * number(2, 60),
                        .direction = glm::vec3(direction()),
                        .colour = glm::vec3(float(std::exp(number(-9, 1)))),
                        .attenuation = {0, float(number(0, 0.1)), 1},
                        .inner_angle = 0.1f,
                        .outer_angle = float(number(0.1, 1.5))});
    std::vector<bool> dropped(lights.size(), true);
    for (const int i : lights_that_matter(lights, most_given_back({material}, lobe), box))
      dropped[std::size_t(i)] = false;
    left_out += int(std::count(dropped.begin(), dropped.end(), true));
    for (int point = 0; point < 200; ++point) {
      const glm::dvec3 p(number(-1, 1), number(-1, 1), number(-1, 1)), normal = direction(), to_eye = direction();
      double sum = 0;
      for (std::size_t i = 0; i < lights.size(); ++i) {
        if (!dropped[i]) continue;
        const Light& light = lights[i];
        const double d = glm::distance(light.position, p);
        const glm::dvec3 to_light = (light.position - p) / d;
        const double axis = glm::dot(-to_light, glm::normalize(glm::dvec3(light.direction)));
        if (light.type == LightType::spot && axis < std::cos(double(light.outer_angle))) continue;
        const double cosine = std::max(glm::dot(normal, glm::normalize(to_light + to_eye)), 0.0);
        sum += double(light.colour.r) / (double(light.attenuation.y) * d + d * d) *
               (0.6 + 0.4 * lobe(50) * std::pow(cosine, 50)) * std::max(glm::dot(normal, to_light), 0.0);
      }
      REQUIRE(sum < least_visible_light);
    }
  }
  CHECK(left_out > 100);  // of 480: the check above looks at something
}
