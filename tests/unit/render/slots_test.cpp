// Features compose: the code in a slot, its order, and no lost effects. All tests check pixels.
#include "catch.hpp"
#include "pieces.hpp"

namespace {

using namespace atelier;
using namespace atelier::test;

/// The pixel in the middle of the triangle.
Rgba middle(const Image& image) {
  return image.at(10, 20);
}

const std::string shade_normal = "vec3 shade(Surface s) { return abs(normalize(s.normal_world)); }\n";

}  // namespace

TEST_CASE("a changed normal affects shading and the output of normals", "[slots]") {
  Stage stage;
  auto shading = piece_for(stage.shaders, Slot::shade, "shade", shade_normal);
  auto bump = piece_for(stage.shaders, Slot::modify_surface, "bump",
                        "void bump(inout Surface s) { s.normal_world = vec3(0.6, 0.0, 0.8); }\n");
  stage.open({}, std::move(shading), std::move(bump));
  const Scene scene = triangle_scene();
  const Rgba lit = middle(stage.draw(scene));
  // 0.6 and 0.8 are of unit length to a rounding, and so is what comes of it.
  CHECK(lit.r == Approx(0.6f).margin(1e-6));
  CHECK(lit.b == Approx(0.8f).margin(1e-6));
  const Rgba normal = middle(stage.draw(scene, {.camera = scene.camera, .output = "normal"}));
  CHECK(normal.r == Approx(0.8f).margin(1e-6));
}

TEST_CASE("features fill one slot in the order of the list", "[slots]") {
  const std::string twice = "void twice(inout Surface s) { s.texcoord *= 2.0; }\n",
                    more = "void more(inout Surface s) { s.texcoord += vec2(0.125, 0.0); }\n";
  const auto texcoord = [&](bool twice_first) {
    Stage stage;
    auto one = piece_for(stage.shaders, Slot::displace_texcoord, "twice", twice);
    auto two = piece_for(stage.shaders, Slot::displace_texcoord, "more", more);
    if (twice_first)
      stage.open({}, std::move(one), std::move(two));
    else
      stage.open({}, std::move(two), std::move(one));
    const Scene scene = triangle_scene();
    return middle(stage.draw(scene, {.camera = scene.camera, .output = "texcoord"})).r;
  };
  const float u = [] {
    Stage bare;
    bare.open({});
    const Scene scene = triangle_scene();
    return middle(bare.draw(scene, {.camera = scene.camera, .output = "texcoord"})).r;
  }();
  CHECK(texcoord(true) == 2 * u + 0.125f);
  CHECK(texcoord(false) == 2 * (u + 0.125f));
}

TEST_CASE("texture coordinates are displaced before anything else reads the surface", "[slots]") {
  Stage stage;
  auto reads = piece_for(stage.shaders, Slot::modify_surface, "reads",
                         "void reads(inout Surface s) { s.normal_world = vec3(s.texcoord, 0.0); }\n");
  auto moves = piece_for(stage.shaders, Slot::displace_texcoord, "moves",
                         "void moves(inout Surface s) { s.texcoord = vec2(0.25, 0.5); }\n");
  stage.open({}, std::move(reads), std::move(moves),
             piece_for(stage.shaders, Slot::shade, "shade", "vec3 shade(Surface s) { return s.normal_world; }\n"));
  CHECK(middle(stage.draw(triangle_scene())) == Rgba{0.25f, 0.5f, 0, 1});
}

TEST_CASE("a discarded fragment is missing from every output", "[slots]") {
  Stage stage;
  stage.open({}, piece_for(stage.shaders, Slot::discard_fragment, "holes",
                           "bool holes(Surface s) { return s.texcoord.x < 0.25; }\n"));
  const Scene scene = triangle_scene();
  const Image picture = stage.draw(scene), depth = stage.draw(scene, {.camera = scene.camera, .output = "depth"});
  CHECK(picture.at(5, 20) == dark_blue);
  CHECK(middle(picture) == grey);
  CHECK(depth.at(5, 20).r == 0);
  CHECK(middle(depth).r > 0);
}

TEST_CASE("indirect light is added to the shaded colour, and fog changes the sum", "[slots]") {
  Stage stage;
  auto glow =
      piece_for(stage.shaders, Slot::indirect, "glow", "vec3 glow(Surface s) { return vec3(0.0, 0.25, 0.0); }\n");
  auto fog = piece_for(stage.shaders, Slot::modify_shaded, "fog",
                       "vec3 fog(Surface s, vec3 shaded) { return mix(shaded, vec3(1.0), 0.5); }\n");
  fog->behind = glm::vec3(1);
  auto shade =
      piece_for(stage.shaders, Slot::shade, "shade", "vec3 shade(Surface s) { return vec3(0.5, 0.0, 0.0); }\n");
  stage.open({}, std::move(fog), std::move(glow), std::move(shade));
  const Scene scene = triangle_scene();
  const Image picture = stage.draw(scene);
  CHECK(middle(picture) == Rgba{0.75f, 0.625f, 0.5f, 1});
  CHECK(picture.at(0, 0) == Rgba{1, 1, 1, 1});  // the fog's, not the scene's
  CHECK(stage.draw(scene, {.camera = scene.camera, .output = "position"}).at(0, 0) == Rgba{0, 0, 0, 1});
}

TEST_CASE("vertex lighting is computed per vertex unless a feature changes the surface per pixel", "[slots]") {
  const auto draw = [](bool bump) {
    Stage stage;
    auto shading = piece_for(stage.shaders, Slot::shade, "shade",
                             "vec3 shade(Surface s) { return vec3(step(0.75, s.texcoord.x)); }\n");
    shading->wants = [](const Material&) { return Need{.wanted = true, .structure = {{"PER_VERTEX", "1"}}}; };
    auto fog = piece_for(stage.shaders, Slot::modify_shaded, "fog",
                         "vec3 fog(Surface s, vec3 shaded) { return vec3(shaded.r, 1.0, 0.0); }\n");
    auto bumps = piece_for(stage.shaders, Slot::modify_surface, "bumps", "void bumps(inout Surface s) {}\n");
    bumps->wants = [bump](const Material&) { return Need{.wanted = bump}; };
    stage.open({}, std::move(shading), std::move(fog), std::move(bumps));
    return middle(stage.draw(triangle_scene()));
  };
  const Rgba corners = draw(false), pixels = draw(true);
  CHECK(corners.r > 0.1f);  // between a corner at 1 and two at 0
  CHECK(corners.r < 0.9f);
  CHECK(pixels.r == 0);
  CHECK(corners.g == 1);  // what comes behind light is still worked out for each pixel
  CHECK(pixels.g == 1);
}

TEST_CASE("the features' visibilities of a light are multiplied; the default is 1", "[slots]") {
  const std::string shade =
      "vec3 shade(Surface s) {\n"
      "#ifdef VISIBILITY\n"
      "  vec3 up = vec3(0.0, 1.0, 0.0);\n"
      "  return vec3(visibility_of_point_light(2, s.position_world, up, up),\n"
      "              visibility_of_spot_light(1, s.position_world, up, up),\n"
      "              visibility_of_directional_light(3, s.position_world, up, up));\n"
      "#else\n"
      "  return vec3(0.125);\n"
      "#endif\n"
      "}\n";
  const auto answer = [](const std::string& name, const std::string& value) {
    return "float " + name + "(int light, vec3 position, vec3 normal, vec3 to_light) { return " + value + "; }\n";
  };
  Stage stage;
  auto map = piece_for(stage.shaders, Slot::visible_from_point, "map", answer("map", "0.25 * float(light)"));
  auto cube = piece_for(stage.shaders, Slot::visible_from_point, "cube", answer("cube", "0.5"));
  auto sun = piece_for(stage.shaders, Slot::visible_from_directional, "sun", answer("sun", "0.25 * float(light)"));
  const auto wanted = std::make_shared<bool>(true);
  for (Piece* piece : {map.get(), cube.get(), sun.get()})
    piece->wants = [wanted](const Material&) { return Need{.wanted = *wanted}; };
  stage.open({}, std::move(map), piece_for(stage.shaders, Slot::shade, "shade", shade), std::move(cube),
             std::move(sun));
  CHECK(middle(stage.draw(triangle_scene())) == Rgba{0.25f, 1, 0.75f, 1});
  *wanted = false;  // the code that shades is told that nothing can stand in the way
  CHECK(middle(stage.draw(triangle_scene())) == Rgba{0.125f, 0.125f, 0.125f, 1});
}

TEST_CASE("features receive all lights, including those that others add", "[slots]") {
  struct Adding : Piece {
    int added = 1;
    void add_lights(const Scene&, std::vector<Light>& lights) const override {
      for (int i = 0; i < added; ++i) lights.push_back({.name = "image"});
    }
  };
  struct Listening : Piece {
    std::vector<std::string> names;
    void take_lights(std::span<const Light> lights) override {
      names.clear();
      for (const Light& light : lights) names.push_back(light.name);
    }
  };
  Stage stage;
  auto adding = std::make_unique<Adding>();
  auto listening = std::make_unique<Listening>();
  Adding& adds = *adding;
  const Listening& told = *listening;
  stage.open({}, std::move(listening), std::move(adding));
  Scene scene = triangle_scene();
  scene.lights = {{.name = "lamp"}};
  stage.draw(scene);
  CHECK(told.names == std::vector<std::string>{"lamp", "image"});
  adds.added = 2;
  stage.renderer->lights_moved();
  CHECK(told.names == std::vector<std::string>{"lamp", "image", "image"});
}

TEST_CASE("tangents are a separate attribute if a feature provides them", "[slots]") {
  struct Tangents : Piece {
    std::size_t count = 3;
    std::vector<glm::vec4> tangents(const Scene&, int) const override {
      return std::vector<glm::vec4>(count, glm::vec4(0, 0.5f, 0, -1));
    }
  };
  const auto draw = [](std::size_t count, float scale = 1) {
    Stage stage;
    auto tangents = std::make_unique<Tangents>();
    tangents->count = count;
    stage.shaders.write("00-fake/shade.glsl",
                        "vec3 shade(Surface s) { return vec3(s.tangent_world.xy, -s.tangent_world.w); }\n");
    tangents->filled = {{Slot::shade, {"00-fake/shade.glsl", "shade"}}};
    tangents->wants = [](const Material&) { return Need{.wanted = true, .structure = {{"TANGENTS", "1"}}}; };
    stage.open({}, std::move(tangents));
    Scene scene = triangle_scene();
    scene.nodes[0].scale = {scale, 0.5f, 1};  // a tangent goes with the surface
    return stage.draw(scene).at(scale < 0 ? 21 : 10, 17);
  };
  CHECK(draw(3) == Rgba{0, 1, 1, 1});       // of unit length again
  CHECK(draw(3, -1) == Rgba{0, 1, -1, 1});  // a mirror exchanges the sides of the bitangent
  CHECK(draw(0) == Rgba{0, 0, -1, 1});      // OpenGL's own value where there is no array: (0, 0, 0, 1)
  CHECK(mentions(error_of([&] { draw(2); }), {"triangle", "2 tangents", "3 vertices"}));
}

TEST_CASE("programs are chosen again only if a feature's answers have changed", "[slots]") {
  struct Asked : Piece {
    mutable int times = 0;
    Need need(const Scene&, const View&, const Node&) const override {
      ++times;
      return {.wanted = true};
    }
    bool hidden = false;
    bool hides(const Scene&, const View&, const Node&) const override { return hidden; }
    void hide(bool on) {
      hidden = on;
      structure_changed();
    }
  };
  Stage stage;
  auto asked = std::make_unique<Asked>();
  Asked& piece = *asked;
  stage.open({}, std::move(asked));
  const Scene scene = triangle_scene();
  const View view{.camera = scene.camera};
  CHECK(middle(stage.draw(scene)) == grey);
  CHECK(piece.times == 1);
  stage.draw_again(view);
  CHECK(piece.times == 1);
  stage.draw_again({.camera = scene.camera, .output = "normal"});  // another kind of view
  CHECK(piece.times == 2);
  piece.hide(true);
  CHECK(middle(stage.draw_again(view)) == dark_blue);
  piece.hide(false);
  CHECK(middle(stage.draw_again(view)) == grey);
  stage.renderer->configure(Settings());
  stage.draw_again(view);
  CHECK(piece.times == 4);
  stage.renderer->nodes_moved();
  stage.draw_again(view);
  CHECK(piece.times == 5);
}

TEST_CASE("an 8-bit target shows NaN as magenta, a float target keeps it", "[slots]") {
  Stage stage;
  stage.open({},
             piece_for(stage.shaders, Slot::shade, "shade",
                       "uniform float u_zero;\nvec3 shade(Surface s) { return vec3(0.25, u_zero / u_zero, 1.0); }\n"));
  const Scene scene = triangle_scene();
  for (const ColourFormat format : {ColourFormat::rgba8, ColourFormat::srgb8}) {
    stage.spec.colour = format;
    CHECK(middle(stage.draw(scene)) == Rgba{1, 0, 1, 1});
  }
  stage.spec.colour = ColourFormat::rgba32f;
  CHECK(std::isnan(middle(stage.draw(scene)).g));
}
