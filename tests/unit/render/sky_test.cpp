// The sky behind a view's surfaces: the same as the ray tracer's, in every kind of view.
#include "scene/sky.hpp"
#include <utility>

#include "catch.hpp"
#include "gl/query.hpp"
#include "nesting.hpp"
#include "oracle/oracle.hpp"
#include "pieces.hpp"
#include "scene/noise.hpp"

namespace {

using namespace atelier;
using namespace atelier::test;

/// Coordinates on a face are floats of 8 texels, and neighbours differ by up to 1: errors of some 1e-6.
constexpr double sky_tolerance = 1e-4;

/// Texels without any order: a wrong face, column or row is another colour.
std::shared_ptr<const Sky> speckled_sky() {
  int texel = 0;
  return std::make_shared<const Sky>(make_sky(8, [&](const glm::dvec3&) {
    ++texel;
    return glm::dvec3(hash01(1, texel, 0), hash01(1, texel, 1), hash01(1, texel, 2));
  }));
}

/// A sky and nothing else.
Scene open_air() {
  Scene scene{.name = "open air"};
  scene.background = {1, 0, 1};
  scene.sky = speckled_sky();
  scene.camera = {.eye = {0.3, 0.2, 3}, .target = {0.1, 0, 0}, .fov_y = 1.2f, .near = 0.5f, .far = 50};
  return scene;
}

/// A window in the plane z = 0, 1 m to each side, which leads to an exit 20 m away that is turned, or mirrors.
Scene air_with_window(bool mirror) {
  Scene scene = open_air();
  const auto corner = [](float x, float y) { return Vertex{{x, y, 0}, {0, 0, 1}, {0, 0}}; };
  scene.meshes = {{.name = "window",
                   .vertices = {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)},
                   .indices = {0, 1, 2, 0, 2, 3}}};
  scene.materials = {Material{}};
  scene.nodes = {Node{.name = "window", .mesh = 0},
                 Node{.name = "exit", .translation = {20, 1, 5}, .rotation_axis = {1, 2, 0}, .rotation_angle = 1.2f}};
  scene.portals = {{.node = 0}};
  if (!mirror) scene.portals[0].exit = 1;
  return scene;
}

Image traced(const Scene& scene, const TargetSpec& spec, oracle::Output output = oracle::Output::colour) {
  oracle::PictureRequest request{.camera = scene.camera, .size = {spec.width, spec.height}, .output = output};
  request.shading.portal_depth = 1;
  return oracle::trace(oracle::World(scene), request);
}

double largest_gap(const Image& a, const Image& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) {
    const Rgba &p = a.pixels()[i], &q = b.pixels()[i];
    largest = std::max({largest, std::abs(double(p.r) - q.r), std::abs(double(p.g) - q.g), std::abs(double(p.b) - q.b),
                        std::abs(double(p.a) - q.a)});
  }
  return largest;
}

/// Shows what is behind the scene's portal, which node 0 is; the view inside is one as step 07 makes it, or stranger.
struct SkyWindow : Piece {
  bool clips_all = false;  ///< a clip plane that leaves no surface
  bool oblique = false;    ///< another row of z in the projection

  bool needs_stencil(const Scene&) const override { return true; }
  bool hides(const Scene&, const View&, const Node& node) const override { return node.name == "window"; }
  void draw_inside(Gl&, const Scene& scene, const Viewpoint& around, const Target& target,
                   ScenePainter& painter) override {
    if (around.view.parent || scene.portals.empty()) return;
    const bool mirror = !scene.portals[0].exit;
    const std::vector<glm::dmat4> world = world_matrices_exact(scene.nodes);
    const glm::dmat4 turn = glm::scale(glm::dmat4(1), mirror ? glm::dvec3(1, 1, -1) : glm::dvec3(-1, 1, -1));
    const glm::dmat4 passage = world[mirror ? 0 : 1] * turn * glm::inverse(world[0]);
    View inside = around.view;
    inside.world_to_view = glm::mat4(glm::dmat4(around.world_to_view) * glm::inverse(passage));
    inside.mirrored = mirror;
    if (clips_all) inside.clip_plane = glm::dvec4(0, 0, 0, -1);
    if (oblique) {
      inside.projection = around.projection;
      for (int column = 0; column < 4; ++column) (*inside.projection)[column][2] = 0.1f * float(column + 1);
    }
    painter.draw_view_inside(inside, around, target, 0, nesting());
  }
};

struct SkyStage : Stage {
  SkyWindow* const window;
  SkyStage() : SkyStage(std::make_unique<SkyWindow>()) {}

 private:
  explicit SkyStage(std::unique_ptr<SkyWindow> made) : window(made.get()) {
    open({}, piece_for(shaders, Slot::shade, "grey", "vec3 grey(Surface s) { return vec3(0.5); }\n"), std::move(made));
  }
};

/// How often a cube map was bound, through a Gl whose calls go through `counted_binding`.
int cubes_bound = 0;
PFNGLBINDTEXTUREPROC uncounted_binding = nullptr;
void counted_binding(GLenum target, GLuint texture) {
  cubes_bound += target == GL_TEXTURE_CUBE_MAP;
  uncounted_binding(target, texture);
}

}  // namespace

TEST_CASE("the sky is the ray tracer's, for every camera", "[sky]") {
  struct Row {
    const char* name;
    std::function<void(Camera&, View&)> change;
  };
  const Row rows[] = {
      {"as it is", [](Camera&, View&) {}},
      {"upwards", [](Camera& c, View&) { c.target = c.eye + glm::dvec3(0.1, 3, -0.2); }},
      {"downwards, rolled",
       [](Camera& c, View&) {
         c.target = {2, -5, 4}, c.up = {1, 0.5f, 0};
       }},
      {"wide", [](Camera& c, View&) { c.fov_y = 2.6f; }},
      {"narrow", [](Camera& c, View&) { c.fov_y = 0.01f; }},
      {"orthographic", [](Camera& c, View&) { c.projection = Projection::orthographic; }},
      {"far from the origin",
       [](Camera& c, View& v) {
         c.eye += glm::dvec3(1e6, 0, -1e6), c.target += glm::dvec3(1e6, 0, -1e6);
         v.camera_relative = true;
       }},
      {"edges only", [](Camera&, View& v) { v.wireframe = true; }},
      {"reversed depth", [](Camera&, View& v) { v.reversed_depth = true; }},
      {"reversed depth, orthographic",
       [](Camera& c, View& v) { c.projection = Projection::orthographic, v.reversed_depth = true; }},
  };
  SkyStage stage;
  stage.spec = {.width = 48, .height = 32, .depth = DepthFormat::depth32f_stencil8};
  for (const Row& row : rows) {
    INFO(row.name);
    Scene scene = open_air();
    View view;
    row.change(scene.camera, view);
    if (view.reversed_depth && !stage.gl().ClipControl.call) continue;
    view.camera = scene.camera;
    CHECK(largest_gap(stage.draw(scene, view), traced(scene, stage.spec)) < sky_tolerance);
    CHECK(stage.renderer->counts().skies == 1);
  }
}

TEST_CASE("the sky is behind all surfaces, and changes no depth", "[sky]") {
  SkyStage stage;
  Scene scene = open_air();
  scene.meshes = {triangle()};
  scene.materials = {Material{.two_sided = true}};
  scene.nodes = {Node{.name = "it", .mesh = 0},
                 Node{.name = "far away, and with a plane of its own at which nothing ends",
                      .translation = {9, 7, -46},
                      .scale = glm::vec3(8),
                      .mesh = 0,
                      .kept = glm::dvec4(0, 0, 0, 1)}};
  for (const bool reversed : {false, true}) {
    if (reversed && !stage.gl().ClipControl.call) continue;
    stage.spec.depth = reversed ? DepthFormat::depth32f_stencil8 : DepthFormat::depth24_stencil8;
    const Target target(stage.gl(), stage.spec);
    const View view{.camera = scene.camera, .reversed_depth = reversed};
    const auto depths = [&] {
      stage.renderer->prepare(scene);
      stage.renderer->render(view, target);
      return target.read_depth(stage.gl());
    };
    const Image with_sky = depths();
    const Image seen = target.read_colour(stage.gl());
    const Image sky = traced(scene, stage.spec), things = traced(scene, stage.spec, oracle::Output::thing);
    int covered = 0;
    for (int y = 0; y < stage.spec.height; ++y)
      for (int x = 0; x < stage.spec.width; ++x) {
        const bool surface = things.at(x, y).r != 0;
        covered += surface;
        const Rgba expected = surface ? grey : sky.at(x, y);
        INFO(x << ", " << y);
        CHECK(std::abs(double(seen.at(x, y).r) - expected.r) < sky_tolerance);
      }
    CHECK(covered > 40);
    const std::shared_ptr<const Sky> taken = std::exchange(scene.sky, nullptr);
    CHECK(depths() == with_sky);
    scene.sky = taken;
  }
}

TEST_CASE("a view inside another has the sky of its own directions", "[sky]") {
  const struct {
    const char* name;
    bool mirror, clips_all, oblique, reversed;
  } rows[] = {
      {"portal", false, false, false, false},
      {"mirror", true, false, false, false},
      {"behind a clip plane", false, true, false, false},
      {"oblique near plane", false, false, true, false},
      {"mirror, oblique", true, false, true, false},
      {"reversed depth", false, false, false, true},
  };
  SkyStage stage;
  stage.spec.depth = DepthFormat::depth32f_stencil8;
  for (const auto& row : rows) {
    INFO(row.name);
    if (row.reversed && !stage.gl().ClipControl.call) continue;
    const Scene scene = air_with_window(row.mirror);
    stage.window->clips_all = row.clips_all;
    stage.window->oblique = row.oblique;
    const Image seen = stage.draw(scene, {.camera = scene.camera, .reversed_depth = row.reversed});
    CHECK(largest_gap(seen, traced(scene, stage.spec)) < sky_tolerance);
    CHECK(largest_gap(seen, traced(open_air(), stage.spec)) > 0.1);  // the window shows something else
    CHECK(stage.renderer->counts().skies == 2);
  }
}

TEST_CASE("a view's scissor bounds its sky", "[sky]") {
  SkyStage stage;
  const Scene scene = open_air();
  stage.prepared = scene;
  stage.renderer->prepare(stage.prepared);
  const Target target(stage.gl(), stage.spec);
  stage.renderer->render({.camera = scene.camera}, target);
  const Image all = target.read_colour(stage.gl());
  View view{.camera = scene.camera};
  view.camera.target = {0, 3, 0};
  view.scissor = glm::ivec4(0, 0, 16, 32);
  stage.renderer->render(view, target);
  const Image left = target.read_colour(stage.gl());
  CHECK_FALSE(left.at(15, 16) == all.at(15, 16));
  for (int x = 16; x < 32; ++x) CHECK(left.at(x, 16) == all.at(x, 16));
}

TEST_CASE("the sky is a part of colour alone, and a feature's background replaces it", "[sky]") {
  SkyStage stage;
  const Scene scene = open_air();
  CHECK(stage.draw(scene, {.camera = scene.camera, .output = "normal"}) == Image(32, 32, {0, 0, 0, 1}));
  CHECK(stage.renderer->counts().skies == 0);
  stage.window->behind = glm::vec3(0.25f);
  CHECK(stage.draw(scene) == Image(32, 32, {0.25f, 0.25f, 0.25f, 1}));
  CHECK(stage.renderer->counts().skies == 0);
}

TEST_CASE("the sky's texture is made and bound once, and only for a scene with a sky", "[sky]") {
  SkyStage stage;
  Gl& gl = stage.gl();
  uncounted_binding = gl.BindTexture.call;
  gl.BindTexture.call = counted_binding;
  cubes_bound = 0;
  const auto bound = [&] {
    gl.ActiveTexture(GLenum(GL_TEXTURE0 + integer_of(gl, GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS) - 1));
    const GLint cube = integer_of(gl, GL_TEXTURE_BINDING_CUBE_MAP);
    gl.ActiveTexture(GL_TEXTURE0);
    return cube;
  };
  const Target target(gl, stage.spec);
  const auto frame_of = [&](const Scene& scene) {
    gl.restart_counts();
    stage.renderer->render({.camera = scene.camera}, target);
    return gl.counts();
  };

  Scene without = open_air();
  without.sky.reset();
  stage.renderer->prepare(without);
  CHECK(frame_of(without).draws == 0);
  CHECK(stage.renderer->counts().skies == 0);
  CHECK(cubes_bound == 0);
  CHECK(gl.counts().texture_bytes == 0);

  const Scene with = open_air();
  stage.renderer->prepare(with);
  CHECK(cubes_bound == 1);
  CHECK(integer_of(gl, GL_ACTIVE_TEXTURE) == GL_TEXTURE0);
  frame_of(with);  // builds the program
  for (int frame = 0; frame < 3; ++frame) {
    const GlCounts counts = frame_of(with);
    CHECK(counts.draws == 1);
    CHECK(counts.attributes == 0);
    CHECK(counts.texture_sources == 1);
    CHECK(counts.texture_bytes == 6 * 8 * 8 * 16);
    CHECK(counts.allocated_bytes == 0);
    CHECK(counts.programs_linked == 0);
  }
  CHECK(cubes_bound == 1);
  const GLint first = bound();
  CHECK(first != 0);

  const Scene another = open_air();
  stage.renderer->prepare(another);
  CHECK(cubes_bound == 2);
  CHECK(bound() != 0);
  CHECK(gl.counts().texture_bytes == 6 * 8 * 8 * 16);  // the first is freed

  stage.renderer->prepare(without);
  CHECK(bound() == 0);
  CHECK(gl.counts().texture_bytes == 0);
  check_gl_error(gl, "preparing scenes with and without a sky");
}

TEST_CASE("other cube maps are seamless or not, as before", "[sky]") {
  SkyStage stage;
  for (const bool seamless : {false, true}) {
    if (seamless) stage.gl().Enable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    stage.draw(open_air());
    CHECK(bool(stage.gl().IsEnabled(GL_TEXTURE_CUBE_MAP_SEAMLESS)) == seamless);
  }
}
