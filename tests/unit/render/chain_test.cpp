// Post-processing: passes of shaders and of the CPU, their inputs, and skipped passes.
#include "catch.hpp"
#include "gl/full_screen.hpp"
#include "image/colour.hpp"
#include "pieces.hpp"

namespace {

using namespace atelier;
using namespace atelier::test;

/// What a step teaches of chains: two targets by turns, one triangle over everything.
ChainFunctions chain_functions(Shaders& shaders) {
  shaders.write("00-fake/full_screen.glsl",
                "vec2 full_screen_corner(int i) { return vec2(i == 1 ? 3.0 : -1.0, i == 2 ? 3.0 : -1.0); }\n");
  return {.next_target = [](int source) { return source == 0 ? 1 : 0; },
          .draw_full_screen = draw_triangle_by_id,
          .glsl = "00-fake/full_screen.glsl"};
}

/// A pass whose GLSL is `expression` over `c`, the colour so far.
ChainPass shader_pass(Shaders& shaders, const std::string& name, const std::string& expression) {
  const std::string file = "00-fake/" + name + ".glsl";
  shaders.write(
      file, "vec4 " + name + "(vec2 texcoord) { vec4 c = texture(u_picture, texcoord); return " + expression + "; }\n");
  return {.name = name, .code = {file, name}};
}

struct ChainStage : Stage {
  Piece* piece = nullptr;
  ChainStage() {
    auto made = std::make_unique<Piece>();
    piece = made.get();
    open(chain_functions(shaders), std::move(made));
  }
  Rgba middle(const std::string& output = "colour") {
    const Scene scene = triangle_scene();
    return draw(scene, {.camera = scene.camera, .output = output}).at(10, 20);
  }
};

}  // namespace

TEST_CASE("a chain of two passes runs in order, and each is an output", "[chain]") {
  ChainStage stage;
  stage.piece->chain = {shader_pass(stage.shaders, "halved", "vec4(c.rgb * 0.5, 1.0)"),
                        shader_pass(stage.shaders, "raised", "vec4(c.rgb + vec3(0.25, 0.0, 0.0), 1.0)")};
  CHECK(stage.middle() == Rgba{0.5f, 0.25f, 0.25f, 1});
  CHECK(stage.middle("raised") == stage.middle());
  CHECK(stage.middle("halved") == Rgba{0.25f, 0.25f, 0.25f, 1});
  CHECK(stage.middle("normal").b == 1);  // an intermediate of the scene goes through no chain
}

TEST_CASE("a chain keeps every pixel where it is", "[chain]") {
  ChainStage stage;
  const Scene scene = triangle_scene();
  stage.piece->chain = {shader_pass(stage.shaders, "same", "c"), shader_pass(stage.shaders, "again", "c"),
                        shader_pass(stage.shaders, "still", "c")};
  const auto chained = stage.piece->chain;
  for (const glm::ivec2 size : {glm::ivec2(32, 32), glm::ivec2(33, 7), glm::ivec2(1, 1)}) {
    stage.spec.width = size.x, stage.spec.height = size.y;
    stage.piece->chain = {};
    const Image plain = stage.draw(scene);
    stage.piece->chain = chained;
    CHECK(stage.draw(scene) == plain);
  }
}

TEST_CASE("passes that change nothing are skipped, and so is a chain of them", "[chain]") {
  ChainStage stage;
  ChainPass nothing = shader_pass(stage.shaders, "nothing", "vec4(1.0)");
  nothing.identity = true;
  const auto passes = [&] {
    stage.draw(triangle_scene());
    stage.gl().restart_counts();
    stage.draw_again({.camera = triangle_scene().camera});
    return stage.gl().counts().passes;
  };
  stage.piece->chain = {nothing};
  CHECK(stage.middle() == grey);
  CHECK(stage.middle("nothing") == grey);
  CHECK(passes() == 1);  // the scene's alone, straight into the picture
  stage.piece->chain = {nothing, shader_pass(stage.shaders, "halved", "vec4(c.rgb * 0.5, 1.0)"), nothing};
  CHECK(stage.middle() == Rgba{0.25f, 0.25f, 0.25f, 1});
  CHECK(passes() == 2);
}

TEST_CASE("outputs that a pass reads are drawn as separate views", "[chain]") {
  ChainStage stage;
  ChainPass reading = shader_pass(stage.shaders, "reading", "vec4(texture(u_normal, texcoord).rgb, 1.0)");
  reading.reads = {"normal"};
  stage.piece->chain = {reading};
  CHECK(stage.middle().b == 1);
  stage.gl().restart_counts();
  stage.draw_again({.camera = triangle_scene().camera});
  CHECK(stage.gl().counts().passes == 3);  // scene, normals, pass
  ChainPass both = reading;
  both.name = "both";
  stage.piece->chain = {reading, both};
  stage.draw(triangle_scene());
  stage.gl().restart_counts();
  stage.draw_again({.camera = triangle_scene().camera});
  CHECK(stage.gl().counts().passes == 4);  // the normals once
}

TEST_CASE("a pass can read the scene before the first pass, and no other pass", "[chain]") {
  ChainStage stage;
  ChainPass sum = shader_pass(stage.shaders, "sum", "vec4(c.rgb + texture(u_colour, texcoord).rgb, 1.0)");
  sum.reads = {"colour"};
  stage.piece->chain = {shader_pass(stage.shaders, "halved", "vec4(c.rgb * 0.5, 1.0)"), sum};
  CHECK(stage.middle() == Rgba{0.75f, 0.75f, 0.75f, 1});
  stage.gl().restart_counts();
  stage.draw_again({.camera = triangle_scene().camera});
  CHECK(stage.gl().counts().passes == 3);  // the scene is drawn once
  stage.piece->chain[1].reads = {"halved"};
  CHECK(mentions(error_of([&] { stage.middle(); }), {"halved", "this scene offers"}));
}

TEST_CASE("a pass that begins a picture takes the place of the scene and of the passes before it", "[chain]") {
  ChainStage stage;
  const auto passes = [&] {
    stage.draw(triangle_scene());
    stage.gl().restart_counts();
    stage.draw_again({.camera = triangle_scene().camera});
    return stage.gl().counts().passes;
  };
  stage.shaders.write("00-fake/begin.glsl", "vec4 begin(vec2 texcoord) { return vec4(0.25, 0.5, 0.75, 1.0); }\n");
  ChainPass begin{.name = "begin", .begins = true, .code = {"00-fake/begin.glsl", "begin"}};
  const ChainPass halved = shader_pass(stage.shaders, "halved", "vec4(c.rgb * 0.5, 1.0)");
  ChainPass sum = shader_pass(stage.shaders, "sum", "vec4(c.rgb + texture(u_colour, texcoord).rgb, 1.0)");
  sum.reads = {"colour"};
  stage.piece->chain = {halved, begin};
  CHECK(stage.middle() == Rgba{0.25f, 0.5f, 0.75f, 1});
  CHECK(passes() == 1);
  stage.piece->chain = {halved, begin, halved, sum};  // "colour" is what has begun
  CHECK(stage.middle() == Rgba{0.375f, 0.75f, 1.125f, 1});
  CHECK(passes() == 3);
  CHECK(stage.middle("begin") == Rgba{0.25f, 0.5f, 0.75f, 1});
  begin.reads = {"colour"};  // which is itself
  stage.piece->chain = {begin};
  CHECK(mentions(error_of([&] { stage.middle(); }), {"begin", "does not read 'colour'"}));
  stage.piece->chain = {{.name = "paint", .begins = true, .on_bytes = [](ByteImage&, const PassInputs&) {}}};
  CHECK(mentions(error_of([&] { stage.middle(); }), {"paint", "must be a shader"}));
}

TEST_CASE("a pass reads the nearest texel, or filters linearly", "[chain]") {
  ChainStage stage;
  // Half a pixel to the right of this one.
  stage.shaders.write(
      "00-fake/aside.glsl",
      "vec4 aside(vec2 texcoord) { return texture(u_picture, texcoord + vec2(0.4 / u_size.x, 0.0)); }\n");
  ChainPass aside{.name = "aside", .code = {"00-fake/aside.glsl", "aside"}};
  const auto mixed = [&] {
    const Scene scene = triangle_scene();
    int count = 0;
    for (const Rgba& pixel : stage.draw(scene).pixels()) count += pixel != grey && pixel != dark_blue;
    return count;
  };
  const int plain = mixed();
  stage.piece->chain = {aside};
  CHECK(mixed() == plain);
  stage.piece->chain[0].smooth = true;
  CHECK(mixed() > plain + 5);  // along the edges
  stage.piece->chain[0].smooth = false;
  CHECK(mixed() == plain);  // the target's filter is what it was
}

TEST_CASE("a chain can read from and write to a multisampled target", "[chain]") {
  ChainStage stage;
  stage.spec.samples = 4;
  const Image plain = stage.draw(triangle_scene());
  stage.piece->chain = {shader_pass(stage.shaders, "same", "c")};
  CHECK(stage.draw(triangle_scene()) == plain);
  int mixed = 0;
  for (const Rgba& pixel : plain.pixels()) mixed += pixel != grey && pixel != dark_blue;
  CHECK(mixed > 5);  // along the edges
}

TEST_CASE("a pass of the CPU works on floats or on bytes", "[chain]") {
  ChainStage stage;
  ChainPass floats{.name = "floats", .reads = {"depth"}};
  floats.on_floats = [](Image& picture, const PassInputs& inputs) {
    for (int y = 0; y < picture.height(); ++y)
      for (int x = 0; x < picture.width(); ++x)
        if (inputs.at("depth").at(x, y).r > 0) picture.at(x, y).r += 2;
  };
  ChainPass bytes{.name = "bytes"};
  bytes.on_bytes = [](ByteImage& picture, const PassInputs&) { picture.rgba[0] = 255; };
  stage.piece->chain = {floats};
  const Scene scene = triangle_scene();
  CHECK(stage.middle() == Rgba{2.5f, 0.5f, 0.5f, 1});
  CHECK(stage.draw(scene).at(0, 0) == dark_blue);
  stage.piece->chain = {floats, bytes};
  const Image picture = stage.draw(scene);
  CHECK(picture.at(0, 0).r == 1);                            // the first byte is the upper left pixel's red
  CHECK(picture.at(10, 20).r == 1);                          // bytes end at 255
  CHECK(picture.at(10, 20).g == Approx(0.5).margin(0.003));  // half a code: a 255th is 0.006 of light there
  stage.piece->chain = {bytes, shader_pass(stage.shaders, "halved", "vec4(c.rgb * 0.5, 1.0)")};
  CHECK(stage.draw(scene).at(0, 0).r == 0.5f);
}

TEST_CASE("pictures between passes have the requested format", "[chain]") {
  ChainStage stage;
  stage.piece->chain = {shader_pass(stage.shaders, "bright", "vec4(4.0, 0.3, 1.0 / 3.0, 1.0)"),
                        shader_pass(stage.shaders, "same", "c")};
  const struct {
    ColourFormat format;
    float bright;
    double error;  ///< of 0.3 and 1/3, relative: none; 2^-10, since drivers may truncate; half a code of sRGB
  } rows[] = {{ColourFormat::rgba32f, 4, 1e-7}, {ColourFormat::rgba16f, 4, 0.001}, {ColourFormat::srgb8, 1, 0.007}};
  for (const auto& row : rows) {
    INFO(int(row.format));
    stage.renderer->configure(Settings(), {.chain_format = row.format});
    const Rgba pixel = stage.middle();
    CHECK(pixel.r == row.bright);
    CHECK(pixel.g == Approx(0.3).epsilon(row.error));
    CHECK(pixel.b == Approx(1.0 / 3).epsilon(row.error));
  }
}

TEST_CASE("targets are borrowed, reused, and freed if unused", "[chain]") {
  const auto context = make_headless_context();
  TargetPool pool(context->gl());
  const TargetSpec spec{.width = 4, .height = 4};
  {
    const auto one = pool.take(spec), two = pool.take(spec);
    CHECK(one != two);
    CHECK(pool.size() == 2);
  }
  CHECK(pool.take(spec));
  CHECK(pool.size() == 2);
  pool.end_frame();
  const auto kept = pool.take(spec);
  pool.end_frame();
  pool.end_frame();
  CHECK(pool.size() == 1);  // one was not used in a whole frame; the other is in somebody's hands
}

TEST_CASE("a chain creates no targets if nothing has changed", "[chain]") {
  ChainStage stage;
  stage.piece->chain = {shader_pass(stage.shaders, "halved", "c * 0.5"), shader_pass(stage.shaders, "same", "c")};
  const View view{.camera = triangle_scene().camera};
  stage.draw(triangle_scene());
  const Target target(stage.gl(), stage.spec);
  stage.gl().restart_counts();
  stage.renderer->render(view, target);
  CHECK(stage.gl().counts().allocated_bytes == 0);
}

TEST_CASE("the results of a student's chain functions are checked", "[chain]") {
  ChainStage stage;
  const Scene scene = triangle_scene();
  const std::vector<ChainPass> two = {shader_pass(stage.shaders, "same", "c"),
                                      shader_pass(stage.shaders, "again", "c")};
  const auto refused = [&](ChainFunctions functions) {
    auto piece = std::make_unique<Piece>();
    piece->chain = two;
    stage.open(functions, std::move(piece));
    return error_of([&] { stage.draw(scene); });
  };
  CHECK(mentions(refused({}), {"chain", "step 08"}));
  ChainFunctions third = chain_functions(stage.shaders);
  third.next_target = [](int) { return 2; };
  CHECK(mentions(refused(third), {"next_target(-1) is 2", "0 and 1"}));
  auto piece = std::make_unique<Piece>();
  ChainPass grows{.name = "grows"};
  grows.on_floats = [](Image& picture, const PassInputs&) { picture = Image(5, 5); };
  piece->chain = {grows};
  stage.open(chain_functions(stage.shaders), std::move(piece));
  CHECK(mentions(error_of([&] { stage.draw(scene); }), {"grows", "5x5", "32x32"}));
}
