// The cost of a frame: it is lower if a scene has less or has not moved.
#include <random>

#include "catch.hpp"
#include "pieces.hpp"
#include "render/cull.hpp"

namespace {

using namespace atelier;
using namespace atelier::test;

/// How often the functions of step 01 have been called since the last look.
struct Calls {
  int compose = 0, world = 0, normal = 0;
} calls;

TransformFunctions counting_transforms() {
  TransformFunctions functions = fake_transforms();
  functions.compose = [](const glm::vec3& translation, const glm::vec3& axis, float angle, const glm::vec3& scale) {
    ++calls.compose;
    return fake_compose(translation, axis, angle, scale);
  };
  functions.world_matrices = [](std::span<const Joint> joints) {
    ++calls.world;
    return fake_world_matrices(joints);
  };
  functions.normal_matrix = [](const glm::mat4& model) {
    ++calls.normal;
    return glm::inverseTranspose(glm::mat3(model));
  };
  return functions;
}

struct CountingStudio {
  Shaders shaders;
  std::unique_ptr<HeadlessContext> context = make_headless_context();
  Renderer renderer{context->gl(), shaders.implementations(), counting_transforms(), {}};
  Target target{context->gl(), {.width = 64, .height = 48}};
  Image draw(const View& view) {
    calls = {};
    context->gl().restart_counts();
    renderer.render(view, target);
    return target.read_colour(context->gl());
  }
};

/// Triangles at these places, below one group.
Scene triangles(const std::vector<glm::dvec3>& places) {
  Scene scene = triangle_scene();
  scene.nodes = {Node{.name = "group"}};
  for (const glm::dvec3& place : places) scene.nodes.push_back({.parent = 0, .translation = place, .mesh = 0});
  return scene;
}

}  // namespace

TEST_CASE("matrices are computed once, and again only if they change", "[counts]") {
  CountingStudio studio;
  Scene scene = triangles({{0, 0, 0}, {0.5, 0, 0}});
  studio.renderer.prepare(scene);
  View view{.camera = scene.camera};
  const Image first = studio.draw(view);
  CHECK(calls.compose == 3);
  CHECK(calls.world == 1);
  CHECK(calls.normal == 2);
  CHECK(studio.renderer.counts().matrices == 3 + 2);

  const auto nothing_computed = [&] {
    return calls.compose + calls.world + calls.normal == 0 && studio.renderer.counts().matrices == 0;
  };
  CHECK(studio.draw(view) == first);
  CHECK(nothing_computed());
  view.camera.eye = {0.5, 0, 3};  // another camera, and the same world
  const Image moved = studio.draw(view);
  CHECK(nothing_computed());
  CHECK_FALSE(moved == first);

  scene.nodes[2].translation.y = 0.5;
  CHECK(studio.draw(view) == moved);  // not told
  studio.renderer.nodes_moved();
  CHECK_FALSE(studio.draw(view) == moved);
  CHECK(studio.renderer.counts().matrices == 5);
  studio.renderer.prepare(scene);
  studio.draw(view);
  CHECK(studio.renderer.counts().matrices == 5);  // another scene, for all that the renderer knows
}

TEST_CASE("views are counted, with the pixels that they are drawn in", "[counts]") {
  CountingStudio studio;
  const Scene scene = triangles({{0, 0, 0}});
  studio.renderer.prepare(scene);
  View view{.camera = scene.camera};
  studio.draw(view);
  CHECK(studio.renderer.counts().views == 1);
  CHECK(studio.renderer.counts().view_pixels == 64 * 48);
  view.scissor = glm::ivec4(8, 4, 16, 10);
  studio.draw(view);
  CHECK(studio.renderer.counts().views == 1);
  CHECK(studio.renderer.counts().view_pixels == 16 * 10);
}

TEST_CASE("camera-relative matrices follow the eye", "[counts]") {
  CountingStudio studio;
  const Scene scene = triangles({{0.25, 0, 0}});
  studio.renderer.prepare(scene);
  const View plain{.camera = scene.camera};
  View relative = plain;
  relative.camera_relative = true;
  // Quarters and whole numbers are exact in floats: moved by the eye or not, the picture is the same.
  const Image expected = studio.draw(plain);
  CHECK(studio.draw(relative) == expected);
  CHECK(studio.renderer.counts().matrices == 3);
  CHECK(studio.draw(relative) == expected);
  CHECK(studio.renderer.counts().matrices == 0);
  CHECK(studio.draw(plain) == expected);
  CHECK(studio.renderer.counts().matrices == 3);

  View elsewhere = plain;
  elsewhere.camera.eye = {0.5, 0.25, 4};
  const Image there = studio.draw(elsewhere);
  elsewhere.camera_relative = true;
  CHECK(studio.draw(elsewhere) == there);
  CHECK(studio.renderer.counts().matrices == 3);
}

TEST_CASE("an exception in a student's function has no side effects", "[counts]") {
  CountingStudio studio;
  Scene scene = triangles({{0, 0, 0}});
  studio.renderer.prepare(scene);
  const View view{.camera = scene.camera};
  static bool fails;
  fails = true;
  TransformFunctions functions = fake_transforms();
  functions.world_matrices = [](std::span<const Joint> joints) {
    if (fails) throw std::invalid_argument("not yet");
    return fake_world_matrices(joints);
  };
  Renderer renderer(studio.context->gl(), studio.shaders.implementations(), functions, {});
  renderer.prepare(scene);
  CHECK_THROWS_AS(renderer.render(view, studio.target), std::invalid_argument);
  fails = false;
  renderer.render(view, studio.target);
  CHECK(studio.target.read_colour(studio.context->gl()) == studio.draw(view));
}

TEST_CASE("nodes outside the view are culled, and no pixel changes", "[counts]") {
  const struct {
    const char* name;
    glm::dvec3 place;
    bool seen;
  } rows[] = {
      // From (0, 0, 3) at 45 degrees; the triangle reaches from -1 to 1 in x and y.
      {"before the eye", {0, 0, 0}, true},
      {"partly beyond the right edge", {2, 0, 0}, true},
      {"far to the right", {6, 0, 0}, false},
      {"far to the left", {-6, 0, 0}, false},
      {"far above", {0, 6, 0}, false},
      {"far below", {0, -6, 0}, false},
      {"behind the eye", {0, 0, 5}, false},
      {"nearer than the near plane", {0, 0, 2.9}, false},
      {"beyond the far plane", {0, 0, -20}, false},
  };
  // The scene and its camera stand that far from the origin, metres. There floats lose the place of things (to 6 cm at
  // a million metres), and a node near an edge of the view may be drawn: whether it is left out is no matter then.
  for (const double far : {0.0, 1e4, 1e6})
    for (const bool reversed : {false, true})
      for (const bool orthographic : {false, true})
        for (const auto& row : rows) {
          CountingStudio studio;
          if (reversed && !studio.context->gl().ClipControl.call) continue;
          INFO(row.name << ", " << far << " m away, reversed " << reversed << ", orthographic " << orthographic);
          Scene scene = triangles({{0.25, 0.25, 0.25}, row.place});
          const glm::dvec3 offset = far * glm::dvec3(1, 0.25, -0.5);
          scene.nodes[0].translation = offset;
          scene.camera.eye += offset;
          scene.camera.target += offset;
          if (orthographic) scene.camera.projection = Projection::orthographic;
          studio.renderer.prepare(scene);
          View view{.camera = scene.camera, .reversed_depth = reversed};
          const Image all = studio.draw(view);
          CHECK(studio.context->gl().counts().draws == 2);
          CHECK(studio.renderer.counts().nodes_culled == 0);
          view.cull = true;
          CHECK(studio.draw(view) == all);
          CHECK(studio.renderer.counts().nodes == 2);
          if (row.seen || far == 0) CHECK(studio.renderer.counts().nodes_culled == (row.seen ? 0 : 1));
          CHECK(studio.context->gl().counts().draws == 2 - studio.renderer.counts().nodes_culled);
        }
}

TEST_CASE("nodes that rounding moves into the view are not culled, also far from the origin", "[counts]") {
  std::mt19937 random(3);
  const auto number = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  const auto point = [&](double size) {
    return glm::dvec3(number(-size, size), number(-size, size), number(-size, size));
  };
  const struct {
    double far;      // metres from the origin
    bool misplaced;  // floats are so coarse there that they put points into the view that are outside
  } rows[] = {{0, false}, {1e4, false}, {1e6, true}};
  for (const auto& row : rows) {
    INFO(row.far << " m away");
    int outside = 0, misplaced = 0, lost = 0;
    for (int trial = 0; trial < 20000; ++trial) {
      const glm::dvec3 offset = row.far * glm::dvec3(1, 0.25, -0.5);
      const glm::mat4 model = fake_compose(glm::vec3(offset + point(3)), glm::vec3(0, 1, 0), float(number(0, 6)),
                                           glm::vec3(float(number(0.5, 2)))),
                      view = glm::lookAt(glm::vec3(offset + point(8)), glm::vec3(offset), glm::vec3(0, 1, 0)),
                      projection = glm::perspective(0.8f, 1.5f, 0.1f, 100.0f);
      const glm::vec3 corner(point(1));
      const auto inside = [](const auto& c) {
        return std::abs(c.x) <= c.w && std::abs(c.y) <= c.w && std::abs(c.z) <= c.w;
      };
      const bool drawn = inside(projection * (view * (model * glm::vec4(corner, 1))));
      const bool exact =
          inside(glm::dmat4(projection) * (glm::dmat4(view) * (glm::dmat4(model) * glm::dvec4(glm::dvec3(corner), 1))));
      Box3 box;
      box.add(glm::dvec3(corner));
      const bool left_out = outside_view(projection, view, model, box);
      lost += drawn && left_out;
      outside += left_out;
      misplaced += drawn && !exact;
    }
    CHECK(lost == 0);
    if (row.far < 1e6) CHECK(outside > 1000);  // it leaves out something; a million metres away ten count for nothing
    if (row.misplaced) CHECK(misplaced > 0);
  }
}

TEST_CASE("a box is outside only if all of it is", "[counts]") {
  const glm::mat4 projection = glm::perspective(1.0f, 1.0f, 0.5f, 10.0f), here(1);
  const auto box = [](glm::dvec3 low, glm::dvec3 high) {
    Box3 made;
    made.add(low), made.add(high);
    return made;
  };
  const auto outside = [&](const Box3& seen) { return outside_view(projection, here, here, seen); };
  CHECK_FALSE(outside(box({-100, -100, -100}, {100, 100, 100})));  // all around the eye
  CHECK_FALSE(outside(box({-100, -1, -5}, {100, 1, -4})));         // across the view, no corner in it
  CHECK_FALSE(outside(box({-1, -1, -30}, {1, 1, 30})));            // from behind the eye into the view
  CHECK(outside(box({-1, -1, 1}, {1, 1, 30})));
  CHECK(outside(Box3{}));
  CHECK(outside(box({4, 0, -5}, {5, 1, -4})));
  // tan(0.5) = 0.5463: at depth 4 the view ends at 2.185.
  CHECK(outside(box({2.19, 0, -4}, {5, 1, -4})));
  CHECK_FALSE(outside(box({2.18, 0, -4}, {5, 1, -4})));
}
