// Small things to draw and to draw with, shared by the tests of the renderer.
#pragma once

#include <functional>
#include <memory>

#include "base/file.hpp"
#include "fake_transforms.hpp"
#include "gl/context.hpp"
#include "render/renderer.hpp"

namespace atelier::test {

/// A feature that is whatever a test says.
struct Piece : Feature {
  std::function<Need(const Material&)> wants = [](const Material&) { return Need{.wanted = true}; };
  std::map<Slot, SlotCode> filled;
  std::map<std::string, std::string> shown;
  std::vector<DrawConstant> constants;
  std::function<void(Binder&, const Viewpoint&)> bind = [](Binder&, const Viewpoint&) {};
  std::vector<ChainPass> chain;
  std::optional<glm::vec3> behind;
  int prepared = 0, configured = 0, views = 0, materials = 0;

  void configure(const Settings&) override { ++configured; }
  void prepare(Gl&, const Scene&) override { ++prepared; }
  Need need(const Scene& scene, const View&, const Node& node) const override {
    return wants(scene.materials[std::size_t(node.material)]);
  }
  std::map<Slot, SlotCode> slots() const override { return filled; }
  std::map<std::string, std::string> outputs() const override { return shown; }
  std::vector<DrawConstant> draw_constants() const override { return constants; }
  std::vector<ChainPass> passes(const Scene&, const View&) const override { return chain; }
  std::optional<glm::vec3> background(const Scene&, const View&) const override { return behind; }
  void bind_view(Binder& binder, const Scene&, const Viewpoint& viewpoint) override {
    ++views;
    bind(binder, viewpoint);
  }
  void bind_material(Binder&, const Scene&, const Material&) override { ++materials; }
};

/// Shader files in a folder of their own, as an implementation of steps.
struct Shaders {
  TemporaryFolder folder;
  Shaders() { write(transforms_name, transforms_glsl); }
  Implementations implementations() const { return Implementations({{folder.path(), ""}}); }
  FindFile find() const {
    return [all = implementations()](const std::string& name) {
      return name == "surface.glsl" ? std::filesystem::path(ATELIER_SOURCE_DIR) / "common/render/shaders/surface.glsl"
                                    : all.find(name);
    };
  }

  /// Each writing gets another time of change: a test is faster than some file systems' clocks.
  void write(const std::string& name, std::string_view text) {
    const auto file = folder.path() / name;
    write_file(file, text);
    std::filesystem::last_write_time(file, std::filesystem::last_write_time(file) + std::chrono::seconds(++writes_));
  }

 private:
  int writes_ = 0;
};

/// A triangle in the plane z = 0 that faces +z: corners (-1,-1), (1,-1), (-1,1).
inline Mesh triangle() {
  const auto corner = [](float x, float y) { return Vertex{{x, y, 0}, {0, 0, 1}, {(x + 1) / 2, (y + 1) / 2}}; };
  return {.name = "triangle", .vertices = {corner(-1, -1), corner(1, -1), corner(-1, 1)}, .indices = {0, 1, 2}};
}

/// The triangle, seen straight on from z = 3 so that it fills much of the picture; background dark blue.
inline Scene triangle_scene() {
  Scene scene{.name = "triangle"};
  scene.meshes = {triangle()};
  scene.materials = {Material{}};
  scene.nodes = {Node{.name = "it", .mesh = 0}};
  scene.camera = {.eye = {0, 0, 3}, .near = 0.5f, .far = 10};
  scene.background = {0, 0, 0.25f};
  return scene;
}

inline const Rgba dark_blue{0, 0, 0.25f, 1}, grey{0.5f, 0.5f, 0.5f, 1};

/// A renderer with features on a context of its own, and a target.
struct Stage {
  Shaders shaders;
  std::unique_ptr<HeadlessContext> context = make_headless_context();
  Scene prepared;  ///< drawn last: the renderer does not keep one
  std::unique_ptr<Renderer> renderer;
  TargetSpec spec{.width = 32, .height = 32, .depth = DepthFormat::depth24_stencil8};

  Gl& gl() { return context->gl(); }
  /// `features` in order; the pointers stay theirs.
  template <class... Features>
  void open(ChainFunctions chain, std::unique_ptr<Features>... features) {
    std::vector<std::unique_ptr<Feature>> list;
    (list.push_back(std::move(features)), ...);
    renderer = std::make_unique<Renderer>(gl(), shaders.implementations(), fake_transforms(), std::move(list), chain);
  }
  Image draw(const Scene& drawn, View view) {
    prepared = drawn;
    renderer->prepare(prepared);
    return draw_again(view);
  }
  Image draw_again(const View& view) {
    const Target target(gl(), spec);
    renderer->render(view, target);
    return target.read_colour(gl());
  }
  Image draw(const Scene& scene) { return draw(scene, {.camera = scene.camera}); }
};

/// A feature that fills one slot with a function of this text.
inline std::unique_ptr<Piece> piece_for(Shaders& shaders, Slot slot, const std::string& function,
                                        const std::string& text) {
  const std::string file = "00-fake/" + function + ".glsl";
  shaders.write(file, text);
  auto piece = std::make_unique<Piece>();
  piece->filled = {{slot, {file, function}}};
  return piece;
}

}  // namespace atelier::test
