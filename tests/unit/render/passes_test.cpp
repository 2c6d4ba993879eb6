// What a feature draws before a view and instead of it, and how it returns a light's visibility.
#include "catch.hpp"
#include "pieces.hpp"

namespace {

using namespace atelier;
using namespace atelier::test;

/// Fills a target of its own with the depths of the nodes that it is told, whatever state that leaves behind.
struct DepthPiece : Piece {
  std::vector<int> wanted{0};
  std::vector<ScenePainter::Item> items;
  std::optional<Target> map;
  PassSources pass{
      .name = "pass",
      .vertex = "void main() { gl_Position = clip_position(u_projection, u_view, u_model, a_position); }\n",
      .fragment = "#include \"00-fake/pass.glsl\"\nvoid main() { gl_FragDepth = pass_depth(); }\n"};
  int bound = 0;
  bool instead = false;

  void draw_before(Gl& gl, const Scene&, const Viewpoint& viewpoint, ScenePainter& painter) override {
    items.assign(painter.items().begin(), painter.items().end());
    if (!map) map.emplace(gl, TargetSpec{.width = 16, .height = 16, .colour = ColourFormat::none});
    map->bind(gl);
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthFunc(GL_LESS);
    gl.ClearDepth(1);
    gl.Clear(GL_DEPTH_BUFFER_BIT);
    painter.paint(pass, wanted, [&](Binder& binder) {
      ++bound;
      binder.set("u_view", viewpoint.world_to_view);
      binder.set("u_projection", viewpoint.projection);
    });
    // As untidy as a feature may be.
    gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    gl.DepthMask(GL_FALSE);
    gl.DepthFunc(GL_GREATER);
    gl.Enable(GL_CULL_FACE);
    gl.CullFace(GL_FRONT);
    gl.Enable(GL_DEPTH_CLAMP);
    gl.Viewport(0, 0, 1, 1);
  }
  bool may_draw_instead(const View& view) const override { return instead && view.output == "colour"; }
  bool draw_instead(Gl& gl, const View& view, const Target&) override {
    if (!instead || view.output != "colour") return false;
    gl.ClearColor(1, 0.5f, 0, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    return true;
  }
};

struct DepthStudio {
  Shaders shaders;
  std::unique_ptr<HeadlessContext> context = make_headless_context();
  DepthPiece* piece = nullptr;
  Renderer renderer;
  Target target{context->gl(), {.width = 32, .height = 32}};

  explicit DepthStudio(std::unique_ptr<DepthPiece> made = std::make_unique<DepthPiece>())
      : renderer(context->gl(), shaders.implementations(), fake_transforms(), features(std::move(made))) {
    shaders.write("00-fake/pass.glsl", "float pass_depth() { return 0.25; }\n");
  }
  std::vector<std::unique_ptr<Feature>> features(std::unique_ptr<DepthPiece> made) {
    piece = made.get();
    std::vector<std::unique_ptr<Feature>> list;
    list.push_back(std::move(made));
    return list;
  }
  Image draw(const Scene& scene) {
    renderer.render({.camera = scene.camera}, target);
    return target.read_colour(context->gl());
  }
};

}  // namespace

TEST_CASE("a feature draws before the view without affecting it", "[passes]") {
  DepthStudio studio;
  const Scene scene = triangle_scene();
  studio.renderer.prepare(scene);
  const Image picture = studio.draw(scene);

  // What came before is in the feature's own target: the pass's depth where the triangle is, the clear value elsewhere.
  const Image depths = studio.piece->map->read_depth(studio.context->gl());
  CHECK(depths.at(5, 10).r == Approx(0.25).margin(1e-6));  // 24 bits hold it to 6e-8
  CHECK(depths.at(15, 0).r == 1);
  CHECK(studio.piece->bound == 1);
  REQUIRE(studio.piece->items.size() == 1);
  CHECK(studio.piece->items[0].node == 0);
  CHECK(studio.piece->items[0].box.low == glm::dvec3(-1, -1, 0));
  CHECK(studio.piece->items[0].box.high == glm::dvec3(1, 1, 0));

  // The picture is that of a renderer without features at all.
  Gl& gl = studio.context->gl();
  Renderer bare(gl, studio.shaders.implementations(), fake_transforms(), {});
  bare.prepare(scene);
  const Target fresh(gl, studio.target.spec());
  bare.render({.camera = scene.camera}, fresh);
  CHECK(picture == fresh.read_colour(gl));
  CHECK(picture.at(10, 20) == grey);
}

TEST_CASE("only a pass's nodes are drawn in it, with correct faces if mirrored", "[passes]") {
  DepthStudio studio;
  Scene scene = triangle_scene();
  scene.nodes.push_back({.name = "mirrored", .translation = {0, 0, 0}, .scale = {-1, 1, 1}, .mesh = 0});
  studio.renderer.prepare(scene);
  const auto depth_at = [&](int x, int y) { return studio.piece->map->read_depth(studio.context->gl()).at(x, y).r; };
  studio.piece->wanted = {};
  studio.draw(scene);
  CHECK(studio.piece->bound == 0);
  CHECK(depth_at(4, 10) == 1);
  studio.piece->wanted = {1};
  studio.draw(scene);
  CHECK(depth_at(11, 10) < 1);  // the mirrored triangle fills the lower right
  CHECK(depth_at(4, 5) == 1);
}

TEST_CASE("a feature may fill the target instead of the scene", "[passes]") {
  DepthStudio studio;
  studio.piece->instead = true;
  const Scene scene = triangle_scene();
  studio.renderer.prepare(scene);
  const Image picture = studio.draw(scene);
  CHECK(picture.at(0, 0) == Rgba{1, 0.5f, 0, 1});
  CHECK(picture.at(10, 20) == Rgba{1, 0.5f, 0, 1});
  CHECK(studio.renderer.counts().nodes == 0);
}

TEST_CASE("a pass's changed shader is used, a broken one is reported", "[passes]") {
  DepthStudio studio;
  const Scene scene = triangle_scene();
  studio.renderer.prepare(scene);
  studio.draw(scene);
  const auto depth = [&] {
    studio.draw(scene);
    return studio.piece->map->read_depth(studio.context->gl()).at(5, 10).r;
  };
  studio.shaders.write("00-fake/pass.glsl", "float pass_depth() { return 0.5; }\n");
  CHECK(studio.renderer.reload_changed_shaders().empty());
  CHECK(depth() == Approx(0.5).margin(1e-6));
  studio.shaders.write("00-fake/pass.glsl", "float pass_depth() { return nothing; }\n");
  CHECK(mentions(studio.renderer.reload_changed_shaders(), {"pass.glsl:1", "nothing"}));
  CHECK(depth() == Approx(0.5).margin(1e-6));
}

TEST_CASE("moving lights and nodes are reported to the features", "[passes]") {
  struct Told : Piece {
    int times = 0;
    void moved(const Scene&) override { ++times; }
  };
  Shaders shaders;
  const auto context = make_headless_context();
  auto told = std::make_unique<Told>();
  Told& piece = *told;
  std::vector<std::unique_ptr<Feature>> list;
  list.push_back(std::move(told));
  Renderer renderer(context->gl(), shaders.implementations(), fake_transforms(), std::move(list));
  renderer.nodes_moved();  // there is no scene yet
  CHECK(piece.times == 0);
  const Scene scene = triangle_scene();
  renderer.prepare(scene);
  CHECK(piece.times == 0);
  renderer.nodes_moved();
  renderer.lights_moved();
  CHECK(piece.times == 2);
}
