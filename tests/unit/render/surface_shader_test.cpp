#include "render/surface_shader.hpp"

#include "catch.hpp"
#include "pieces.hpp"

namespace {

using namespace atelier;
using namespace atelier::test;

struct Fixture {
  Shaders shaders;
  Piece plain, tint, glow;
  Fixture() {
    shaders.write("00-fake/tint.glsl", "vec3 tint(Surface surface) { return vec3(1.0, 0.0, 0.0); } // TINT\n");
    shaders.write("00-fake/glow.glsl", "vec3 glow(Surface surface) { return vec3(0.0, 1.0, 0.0); } // GLOW\n");
    tint.filled = {{Slot::shade, {"00-fake/tint.glsl", "tint"}}};
    tint.shown = {{"tinting", "tint(surface).rrr"}};
    glow.filled = {{Slot::shade, {"00-fake/glow.glsl", "glow"}}};
  }
  SurfaceSources assemble(const SurfaceKey& key) { return assemble_surface(shaders.find(), transforms_name, key); }
};

bool contains(const ShaderSource& source, std::string_view words) {
  return source.text.find(words) != std::string::npos;
}

}  // namespace

TEST_CASE("the surface shader contains only the features in use", "[surface_shader]") {
  Fixture f;
  const struct {
    const char* name;
    SurfaceKey key;
    std::vector<const char*> in_vertex, in_fragment, in_neither;
  } rows[] = {
      {"no feature: a grey silhouette",
       {{}, {}, "colour"},
       {"clip_position"},
       {"shaded = vec3(0.5);"},
       {"TINT", "GLOW"}},
      {"a feature that shades nothing", {{&f.plain}, {}, "colour"}, {}, {"shaded = vec3(0.5);"}, {"TINT", "GLOW"}},
      {"a shaded surface",
       {{&f.tint}, {}, "colour"},
       {},
       {"TINT", "tint(surface)"},
       {"GLOW", "shaded = vec3(0.5);", "v_shaded"}},
      {"lit per vertex",
       {{&f.tint}, {{"PER_VERTEX", "1"}}, "colour"},
       {"TINT", "v_shaded", "tint(surface)"},
       {"v_shaded"},
       {"GLOW"}},
      {"an intermediate", {{}, {}, "depth"}, {}, {"gl_FragCoord.z"}, {"TINT"}},
      {"an intermediate is never per vertex",
       {{&f.tint}, {{"PER_VERTEX", "1"}}, "normal"},
       {},
       {"encode_direction(surface.normal_world)"},
       {"v_shaded"}},
      {"a feature's own intermediate", {{&f.tint}, {}, "tinting"}, {}, {"tint(surface).rrr"}, {"GLOW"}},
      {"two-sided", {{}, {{"TWO_SIDED", "1"}}, "colour"}, {}, {"#define TWO_SIDED 1"}, {"TINT"}},
  };
  for (const auto& row : rows) {
    INFO(row.name);
    const SurfaceSources sources = f.assemble(row.key);
    for (const char* words : row.in_vertex) CHECK(contains(sources.vertex, words));
    for (const char* words : row.in_fragment) CHECK(contains(sources.fragment, words));
    for (const char* words : row.in_neither) {
      INFO(words);
      CHECK_FALSE(contains(sources.vertex, words));
      CHECK_FALSE(contains(sources.fragment, words));
    }
  }
  CHECK_FALSE(contains(f.assemble({{&f.tint}, {{"PER_VERTEX", "1"}}, "colour"}).fragment, "TINT"));
  CHECK_FALSE(contains(f.assemble({{&f.tint}, {}, "colour"}).vertex, "TINT"));
  CHECK_FALSE(contains(f.assemble({{}, {}, "colour"}).fragment, "#define"));
}

TEST_CASE("every variant compiles and links", "[surface_shader]") {
  Fixture f;
  const auto context = make_headless_context();
  for (const auto& features : {std::vector<const Feature*>{}, {&f.plain}, {&f.tint}})
    for (const Defines& structure : {Defines{}, {{"PER_VERTEX", "1"}}, {{"TWO_SIDED", "1"}}})
      for (const char* output : {"colour", "depth", "normal", "position", "texcoord"}) {
        INFO(features.size() << " features, " << output);
        const SurfaceSources sources = f.assemble({features, structure, output});
        CHECK_NOTHROW(build_program(context->gl(), sources.vertex, sources.fragment));
      }
}

TEST_CASE("an unknown output is refused with the known ones", "[surface_shader]") {
  Fixture f;
  const std::string words = error_of([&] { f.assemble({{&f.tint}, {}, "shadow"}); });
  CHECK(mentions(words, {"shadow", "colour", "depth", "normal", "position", "texcoord", "tinting"}));
  CHECK(mentions(error_of([&] { f.assemble({{}, {}, "tinting"}); }), {"tinting"}));  // not wanted: not there
}

TEST_CASE("two features that shade the same surface are refused and named", "[surface_shader]") {
  Fixture f;
  const std::string words = error_of([&] { f.assemble({{&f.tint, &f.glow}, {}, "colour"}); });
  CHECK(mentions(words, {"tint", "00-fake/tint.glsl", "glow", "00-fake/glow.glsl", "modify_shaded"}));
}

TEST_CASE("of two features with the same output, the last is used", "[surface_shader]") {
  Fixture f;
  f.plain.shown = {{"tinting", "vec3(0.75)"}};
  CHECK(contains(f.assemble({{&f.tint, &f.plain}, {}, "tinting"}).fragment, "vec4(vec3(0.75), 1.0)"));
}

TEST_CASE("a missing include is named", "[surface_shader]") {
  Fixture f;
  f.tint.filled = {{Slot::shade, {"00-fake/gone.glsl", "tint"}}};
  CHECK(mentions(error_of([&] { f.assemble({{&f.tint}, {}, "colour"}); }), {"00-fake/gone.glsl"}));
}

TEST_CASE("keys depend on features, structure and output", "[surface_shader]") {
  Piece one, two;
  const SurfaceKey key{{&one}, {{"A", "1"}}, "colour"};
  const auto differ = [](const SurfaceKey& a, const SurfaceKey& b) { return a < b || b < a; };
  CHECK_FALSE(differ(key, key));
  CHECK(differ(key, {{&two}, {{"A", "1"}}, "colour"}));
  CHECK(differ(key, {{&one, &two}, {{"A", "1"}}, "colour"}));
  CHECK(differ(key, {{&one}, {{"A", "2"}}, "colour"}));
  CHECK(differ(key, {{&one}, {{"A", "1"}, {"B", "1"}}, "colour"}));
  CHECK(differ(key, {{&one}, {{"A", "1"}}, "depth"}));
}

TEST_CASE("the renderer lists its own outputs", "[surface_shader]") {
  Fixture f;
  const auto outputs = surface_outputs();
  CHECK(outputs.size() == 4);
  for (const std::string& output : outputs) CHECK_NOTHROW(f.assemble({{}, {}, output}));
}
