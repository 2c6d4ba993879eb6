// A view inside a view, marked in the stencil buffer: a portal through which the scene is seen from elsewhere.
#include "catch.hpp"
#include "gl/full_screen.hpp"
#include "gl/state.hpp"
#include "nesting.hpp"
#include "pieces.hpp"

namespace {

using namespace atelier;
using namespace atelier::test;

/// Shows each node in the colour of its material.
struct Flat : Piece {
  void bind_material(Binder& binder, const Scene&, const Material& material) override {
    binder.set("u_colour", material.diffuse);
  }
};

/// The node called "window" shows what a camera moved by `shift` sees, `depth` views deep.
struct Window : Piece {
  glm::vec3 shift{0};
  int deepest = 1;
  std::optional<glm::dvec4> clip;
  bool mirror = false;
  NestingFunctions functions = nesting();
  int window = 0;  ///< its node

  bool needs_stencil(const Scene&) const override { return true; }
  bool hides(const Scene&, const View&, const Node& node) const override { return node.name == "window"; }
  void draw_inside(Gl&, const Scene&, const Viewpoint& around, const Target& target, ScenePainter& painter) override {
    if (nesting_depth(around.view) >= deepest) return;
    View inside = around.view;
    inside.world_to_view = glm::translate(around.world_to_view, shift);
    if (mirror) inside.world_to_view = glm::scale(*inside.world_to_view, glm::vec3(-1, 1, 1));
    inside.mirrored = around.view.mirrored != mirror;
    inside.clip_plane = clip;
    for (int i = 0; i < int(painter.items().size()); ++i)
      if (painter.items()[std::size_t(i)].node == window)
        painter.draw_view_inside(inside, around, target, i, functions);
  }
};

Mesh square(float half) {
  const auto corner = [&](float x, float y) { return Vertex{{x, y, 0}, {0, 0, 1}, {0, 0}}; };
  return {.name = "square",
          .vertices = {corner(-half, -half), corner(half, -half), corner(half, half), corner(-half, half)},
          .indices = {0, 1, 2, 0, 2, 3}};
}

constexpr glm::vec3 red{1, 0, 0}, green{0, 1, 0};

/// A window, 1 m to each side, at the origin; a red square far to the right, out of sight, that the window's view shows
/// where it is shifted by 10 m; the eye 3 m before it, and the picture 3 m high at the window.
Scene window_scene() {
  Scene scene{.name = "window"};
  scene.meshes = {square(1), square(4)};
  scene.materials = {Material{.name = "none"}, Material{.name = "red", .diffuse = red},
                     Material{.name = "green", .diffuse = green}};
  scene.nodes = {Node{.name = "window", .mesh = 0},
                 Node{.name = "elsewhere", .translation = {10, 0, -1}, .mesh = 1, .material = 1}};
  scene.camera = {.eye = {0, 0, 3}, .fov_y = 2 * std::atan(0.5f), .near = 0.5f, .far = 50};
  scene.background = {0, 0, 0.25f};
  return scene;
}

/// Flat colours, and behind them the features of a test.
struct FlatStage : Stage {
  template <class... Features>
  explicit FlatStage(std::unique_ptr<Features>... features) {
    shaders.write("00-fake/flat.glsl", "uniform vec3 u_colour;\nvec3 flat_colour(Surface s) { return u_colour; }\n");
    auto flat = std::make_unique<Flat>();
    flat->filled = {{Slot::shade, {"00-fake/flat.glsl", "flat_colour"}}};
    open({}, std::move(flat), std::move(features)...);
  }
};

/// A window of this kind that shows what is elsewhere.
template <class Kind = Window>
std::unique_ptr<Kind> window_to_elsewhere() {
  auto window = std::make_unique<Kind>();
  window->shift = {-10, 0, 0};
  return window;
}

struct WindowStage : FlatStage {
  WindowStage() : WindowStage(window_to_elsewhere()) {}
  Window* const window;

 private:
  explicit WindowStage(std::unique_ptr<Window> made) : WindowStage(made.get(), std::move(made)) {}
  WindowStage(Window* seen, std::unique_ptr<Window>&& made) : FlatStage(std::move(made)), window(seen) {}
};

bool is(const Rgba& pixel, const glm::vec3& colour) {
  return pixel.r == colour.r && pixel.g == colour.g && pixel.b == colour.b;
}
const glm::vec3 behind{0, 0, 0.25f};

}  // namespace

TEST_CASE("a portal shows another view, only in its own area", "[nested]") {
  WindowStage stage;
  const Image picture = stage.draw(window_scene());
  CHECK(is(picture.at(16, 16), red));
  CHECK(is(picture.at(2, 16), behind));
  CHECK(is(picture.at(16, 2), behind));
  // 2 m of 3 m: 21.33 of 32 pixels either way; their middles are inside from pixel 5 to 26.
  int inside = 0;
  for (const Rgba& pixel : picture.pixels()) inside += is(pixel, red);
  CHECK(inside == 22 * 22);
  CHECK(stage.renderer->needs_stencil());
}

TEST_CASE("objects in front of a portal cover it, and it covers those behind it", "[nested]") {
  WindowStage stage;
  Scene scene = window_scene();
  scene.meshes.push_back(square(0.25f));
  scene.nodes.push_back({.name = "before", .translation = {-0.5, 0, 0.5}, .mesh = 2, .material = 2});
  scene.nodes.push_back({.name = "behind", .translation = {0.5, 0, -0.5}, .mesh = 2, .material = 2});
  const Image picture = stage.draw(scene);
  CHECK(is(picture.at(9, 16), green));
  CHECK(is(picture.at(21, 16), red));
}

TEST_CASE("a portal's depth is written, for later drawing", "[nested]") {
  // A second feature draws a square behind the first window's plane, after it: nothing of it may be seen.
  struct Later : Piece {
    float z = -0.25f;
    void draw_inside(Gl& gl, const Scene&, const Viewpoint& around, const Target&, ScenePainter& painter) override {
      if (around.view.parent) return;
      const PassSources pass{.name = "later",
                             .vertex =
                                 "uniform float u_z;\nvoid main() { gl_Position = u_projection * u_view * "
                                 "vec4(a_position.xy * 0.25, u_z, 1.0); }\n",
                             .fragment = "out vec4 o; void main() { o = vec4(0.0, 1.0, 0.0, 1.0); }\n"};
      const int first = 0;
      gl.Enable(GL_DEPTH_TEST);
      painter.paint(pass, std::span(&first, 1), [&](Binder& binder) {
        binder.set("u_view", around.world_to_view);
        binder.set("u_projection", around.projection);
        binder.set("u_z", z);
      });
    }
  };
  for (const float z : {-0.25f, 0.25f}) {
    auto later = std::make_unique<Later>();
    later->z = z;
    FlatStage stage(window_to_elsewhere(), std::move(later));
    CHECK(is(stage.draw(window_scene()).at(16, 16), z < 0 ? red : green));
  }
}

TEST_CASE("nested portals are drawn up to the feature's depth", "[nested]") {
  // A green wall stands left of the window, from -2 to -1 m, where the picture begins at -1.5. Each view shows the
  // world 0.25 m farther right, its window too: another quarter of a metre of the wall, to the right of the one before.
  const auto green_pixels = [](int deepest) {
    WindowStage stage;
    stage.window->shift = {0.25f, 0, 0};
    stage.window->deepest = deepest;
    Scene scene = window_scene();
    scene.nodes.push_back(
        {.name = "wall", .translation = {-1.5, 0, 0}, .scale = {0.5, 1, 1}, .mesh = 0, .material = 2});
    const Image picture = stage.draw(scene);
    int count = 0;
    for (int x = 0; x < 32; ++x) count += is(picture.at(x, 16), green);
    return count;
  };
  // Middles of pixels stand at (x + 1/2) * 3 / 32 - 1.5 m: five of them before -1, then three, three and two.
  const int expected[] = {5, 8, 11, 13};
  for (int deepest = 0; deepest <= 3; ++deepest) CHECK(green_pixels(deepest) == expected[deepest]);
}

TEST_CASE("a clip plane removes what is in front of a portal's view", "[nested]") {
  const auto middle = [](std::optional<glm::dvec4> clip, bool relative) {
    WindowStage stage;
    stage.window->clip = clip;
    Scene scene = window_scene();
    scene.nodes.push_back({.name = "in the way", .translation = {10, 0, 1}, .mesh = 0, .material = 2});
    View view{.camera = scene.camera, .camera_relative = relative};
    return stage.draw(scene, view).at(16, 16);
  };
  const glm::dvec4 behind_the_plane(0, 0, -1, 0);  // z <= 0 is kept
  CHECK(is(middle({}, false), green));
  CHECK(is(middle(behind_the_plane, false), red));
  CHECK(is(middle(behind_the_plane, true), red));  // the plane is one of the world, wherever that is moved
  CHECK(is(middle(glm::dvec4(0, 0, -1, 2), false), green));
}

TEST_CASE("a mirrored view swaps front and back faces", "[nested]") {
  const auto middle = [](bool mirror) {
    WindowStage stage;
    stage.window->mirror = mirror;
    stage.window->shift = mirror ? glm::vec3(10, 0, 0) : glm::vec3(-10, 0, 0);
    return stage.draw(window_scene()).at(16, 16);
  };
  CHECK(is(middle(false), red));
  CHECK(is(middle(true), red));
}

TEST_CASE("a portal shows the same with reversed depth", "[nested]") {
  WindowStage stage;
  if (!stage.gl().ClipControl.call) return;
  Scene scene = window_scene();
  scene.nodes.push_back({.name = "behind", .translation = {0.5, 0, -0.5}, .mesh = 0, .material = 2});
  const Image plain = stage.draw(scene);
  stage.spec.depth = DepthFormat::depth32f_stencil8;
  CHECK(stage.draw(scene, {.camera = scene.camera, .reversed_depth = true}) == plain);
}

TEST_CASE("maps of a mirrored view are drawn with unchanged front faces", "[nested]") {
  // A feature draws a pass that culls back faces before a view of its own that is mirrored.
  struct Mirrored : Piece {
    std::optional<Target> map, target;
    void draw_views(Gl& gl, const Scene& scene, const Viewpoint& viewpoint, ScenePainter& painter) override {
      if (!target) target.emplace(gl, TargetSpec{.width = 8, .height = 8});
      View view{.camera = scene.camera};
      view.world_to_view = glm::scale(viewpoint.world_to_view, glm::vec3(-1, 1, 1));
      view.mirrored = true;
      painter.draw_view(view, *target);
      painter.draw_view(view, *target);
    }
    void draw_before(Gl& gl, const Scene&, const Viewpoint& viewpoint, ScenePainter& painter) override {
      if (!viewpoint.view.mirrored) return;
      if (!map) map.emplace(gl, TargetSpec{.width = 8, .height = 8});
      map->bind(gl);
      gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
      gl.Enable(GL_CULL_FACE);
      const PassSources pass{.name = "front",
                             .vertex = "void main() { gl_Position = vec4(a_position.xy, 0.0, 1.0); }\n",
                             .fragment = "out vec4 o; void main() { o = vec4(1.0); }\n"};
      const int first = 0;
      painter.paint(pass, std::span(&first, 1), [](Binder&) {});
    }
  };
  Stage stage;
  auto mirrored = std::make_unique<Mirrored>();
  const Mirrored& seen = *mirrored;
  stage.open({}, std::move(mirrored));
  stage.draw(window_scene());
  CHECK(seen.map->read_colour(stage.gl()).at(4, 4).r == 1);
}

TEST_CASE("a scissor limits a view inside another", "[nested]") {
  struct Cut : Window {
    void draw_inside(Gl& gl, const Scene& scene, const Viewpoint& around, const Target& target,
                     ScenePainter& painter) override {
      if (around.view.parent) return;
      View cut = around.view;
      cut.scissor = glm::ivec4(0, 0, 16, 32);
      Window::draw_inside(gl, scene, {cut, around.world_to_view, around.projection, around.eye, around.origin}, target,
                          painter);
    }
  };
  FlatStage stage(window_to_elsewhere<Cut>());
  const Image picture = stage.draw(window_scene());
  CHECK(is(picture.at(15, 16), red));
  CHECK(is(picture.at(16, 16), behind));
}

TEST_CASE("a view inside another needs a stencil buffer, and 8 bits count to 255", "[nested]") {
  WindowStage stage;
  stage.spec.depth = DepthFormat::depth24;
  CHECK(mentions(error_of([&] { stage.draw(window_scene()); }), {"stencil", "depth24"}));
  stage.spec.depth = DepthFormat::depth24_stencil8;
  stage.window->functions.begin_mark = nullptr;
  CHECK(mentions(error_of([&] { stage.draw(window_scene()); }), {"step 07"}));
  stage.window->functions = nesting();
  stage.window->deepest = 300;
  CHECK(mentions(error_of([&] { stage.draw(window_scene()); }), {"255", "8-bit"}));
}

TEST_CASE("a feature draws whole views into targets of its own before the frame", "[nested]") {
  struct Preview : Piece {
    std::optional<Target> target;
    int asked = 0;
    void draw_views(Gl& gl, const Scene& scene, const Viewpoint&, ScenePainter& painter) override {
      ++asked;
      if (!target) target.emplace(gl, TargetSpec{.width = 8, .height = 8});
      View view{.camera = scene.camera};
      view.camera.eye.x = view.camera.target.x = 10;
      painter.draw_view(view, *target);
    }
  };
  auto preview = std::make_unique<Preview>();
  const Preview& seen = *preview;
  FlatStage stage(std::move(preview));
  Scene scene = window_scene();
  scene.nodes[0].material = 2;
  const Image picture = stage.draw(scene);
  CHECK(is(picture.at(16, 16), green));
  CHECK(is(seen.target->read_colour(stage.gl()).at(4, 4), red));
  CHECK(seen.asked == 1);
}

TEST_CASE("six views fill the sides of a cube, as OpenGL looks them up", "[nested]") {
  // A ball of six squares around the origin, each in the colour of the direction that it stands in.
  struct AllRound : Piece {
    std::vector<Image> sides;
    std::vector<Rgba> looked_up;
    void draw_views(Gl& gl, const Scene& scene, const Viewpoint&, ScenePainter& painter) override {
      const auto cube = painter.targets().take(CubeTargetSpec{.edge = 8});
      static const glm::vec3 ahead[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
      static const glm::vec3 up[] = {{0, -1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}, {0, -1, 0}, {0, -1, 0}};
      sides.clear();
      for (int side = 0; side < 6; ++side) {
        View view{.camera = scene.camera};
        view.world_to_view = glm::lookAt(glm::vec3(0), ahead[side], up[side]);
        view.projection = glm::perspective(glm::radians(90.0f), 1.0f, 0.5f, 10.0f);
        painter.draw_view(view, cube->face(side));
        sides.push_back(cube->face(side).read_colour(gl));
      }
      look_up(gl, cube->texture());
    }
    /// In all six directions, by a shader.
    void look_up(Gl& gl, GLuint cube) {
      const auto stage = [](const std::string& text) {
        return assemble_shader_text([](const std::string&) { return std::filesystem::path(); }, text, "cube", {});
      };
      const GlProgram program =
          build_program(gl, stage(full_screen_vertex_text),
                        stage("uniform samplerCube u_cube; out vec4 o;\n"
                              "void main() {\n"
                              "  int i = int(gl_FragCoord.x); vec3 d = vec3(0.0); d[i / 2] = i % 2 == 0 ? 1.0 : -1.0;\n"
                              "  o = texture(u_cube, d);\n"
                              "}\n"));
      const Target row(gl, {.width = 6, .height = 1, .depth = DepthFormat::none});
      reset_state(gl);
      row.bind(gl);
      gl.UseProgram(program.id());
      gl.BindTexture(GL_TEXTURE_CUBE_MAP, cube);
      Uniforms(gl, program.id()).set("u_cube", 0);
      draw_triangle_by_id(gl);
      const Image read = row.read_colour(gl);
      looked_up.assign(read.pixels().begin(), read.pixels().end());
    }
  };
  auto round = std::make_unique<AllRound>();
  const AllRound& seen = *round;
  FlatStage stage(std::move(round));
  Scene scene = window_scene();
  scene.materials.clear();
  scene.nodes.clear();
  for (int side = 0; side < 6; ++side) {
    const float sign = side % 2 == 0 ? 1.0f : -1.0f;
    glm::dvec3 place(0);
    place[side / 2] = 2 * sign;
    glm::vec3 colour(0.25f);
    colour[side / 2] = side % 2 == 0 ? 1.0f : 0.5f;
    scene.materials.push_back({.name = "side", .diffuse = colour, .two_sided = true});
    Node node{.name = "side", .translation = place, .mesh = 0, .material = side};
    if (side / 2 == 0) node.rotation_axis = {0, 1, 0}, node.rotation_angle = glm::radians(90.0f);
    if (side / 2 == 1) node.rotation_axis = {1, 0, 0}, node.rotation_angle = glm::radians(90.0f);
    scene.nodes.push_back(node);
  }
  stage.draw(scene);
  REQUIRE(seen.sides.size() == 6);
  for (int side = 0; side < 6; ++side) {
    INFO("side " << side);
    const glm::vec3 colour = scene.materials[std::size_t(side)].diffuse;
    CHECK(is(seen.sides[std::size_t(side)].at(4, 4), colour));
    CHECK(is(seen.looked_up.at(std::size_t(side)), colour));
  }
}
