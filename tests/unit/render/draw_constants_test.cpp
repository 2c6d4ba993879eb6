#include "render/draw_constants.hpp"

#include "catch.hpp"
#include "pieces.hpp"

namespace {

using namespace atelier;
using namespace atelier::test;

const Defines by_varyings = {{constants_as_varyings, "1"}},
              with_tangents = {{constants_as_varyings, "1"}, {"TANGENTS", "1"}},
              at_corners = {{constants_as_varyings, "1"}, {"PER_VERTEX", "1"}};

/// One constant of every type.
constexpr const char* all_types = R"(
struct Thing { mat3 turn; bool on; int number; vec2 pair; };
uniform float u_float;
uniform int u_int;
uniform bool u_bool;
uniform vec2 u_vec2;
uniform vec3 u_vec3;
uniform vec4 u_vec4;
uniform mat3 u_mat3;
uniform mat4 u_mat4;
uniform Thing u_things[2];
vec3 shade(Surface s) {
  vec4 sum = u_mat4 * u_vec4 + vec4(u_mat3 * u_vec3, u_float) + float(u_int) * vec4(u_vec2, u_bool ? 0.5 : 0.25, 0.0);
  for (int i = 0; i < 2; ++i)
    sum += vec4(u_things[i].turn[i] * float(u_things[i].number), u_things[i].on ? u_things[i].pair.y : 0.125);
  return sum.xyz + sum.w;
}
)";
const std::vector<DrawConstant> constants_of_all_types = {
    {"float", "u_float"},
    {"int", "u_int"},
    {"bool", "u_bool"},
    {"vec2", "u_vec2"},
    {"vec3", "u_vec3"},
    {"vec4", "u_vec4"},
    {"mat3", "u_mat3"},
    {"mat4", "u_mat4"},
    {"Thing", "u_things", "THINGS", {{"mat3", "turn"}, {"bool", "on"}, {"int", "number"}, {"vec2", "pair"}}}};

void bind_all_types(Binder& binder) {
  binder.set("u_float", 0.3f);
  binder.set("u_int", -7);
  binder.set("u_bool", 1);
  binder.set("u_vec2", glm::vec2(0.1f, -0.2f));
  binder.set("u_vec3", glm::vec3(0.7f, 1.1f, -1.3f));
  binder.set("u_vec4", glm::vec4(0.31f, 0.37f, 0.41f, 0.43f));
  binder.set("u_mat3", glm::mat3(0.1f, 0.2f, 0.3f, 0.5f, 0.7f, 1.1f, 1.3f, 1.7f, 1.9f));
  glm::mat4 counting;
  for (int i = 0; i < 16; ++i) counting[i / 4][i % 4] = 0.013f * float(i * i);
  binder.set("u_mat4", counting);
  for (int i = 0; i < 2; ++i) {
    const std::string name = "u_things[" + std::to_string(i) + "].";
    binder.set(name + "turn", float(i + 1) * glm::mat3(0.2f, 0.3f, 0.5f, 0.7f, 1.1f, 1.3f, 1.7f, 1.9f, 2.3f));
    binder.set(name + "on", i);
    binder.set(name + "number", 16777215 - i);  // the largest that a float holds with all before it
    binder.set(name + "pair", glm::vec2(0, 0.61f));
  }
}

struct Fixture {
  Shaders shaders;
  std::unique_ptr<Piece> piece = piece_for(shaders, Slot::shade, "shade", all_types);
  Fixture() { piece->constants = constants_of_all_types; }
  SurfaceSources assemble(Defines structure, int varyings = 128) {
    structure["THINGS"] = "2";
    return assemble_surface(shaders.find(), transforms_name, {{piece.get()}, std::move(structure), "colour"}, varyings);
  }
};

/// Which of the constants are uniforms of the fragment stage still.
std::vector<std::string> left_as_uniforms(const SurfaceSources& sources) {
  std::vector<std::string> names;
  for (const DrawConstant& c : constants_of_all_types)
    if (sources.fragment.text.find("\nuniform " + c.type + " " + c.name) != std::string::npos) names.push_back(c.name);
  return names;
}

std::vector<std::string> names_of(const std::vector<DrawConstant>& constants) {
  std::vector<std::string> names;
  for (const DrawConstant& constant : constants) names.push_back(constant.name);
  return names;
}

}  // namespace

TEST_CASE("constants are chosen in order, each only if it fits completely", "[draw_constants]") {
  const std::vector<DrawConstant> listed = {{"vec3", "a"},
                                            {"mat4", "b"},
                                            {"Lamp", "c", "LAMPS", {{"vec3", "at"}, {"float", "far"}}},
                                            {"vec3", "a"},
                                            {"float", "d"}};
  using Names = std::vector<std::string>;
  const struct {
    const char* lamps;
    int components;
    Names taken;
  } rows[] = {{"2", 28, {"a", "b", "c", "d"}},
              {"2", 27, {"a", "b", "c"}},
              {"2", 20, {"a", "b", "d"}},
              {"2", 15, {"a", "c", "d"}},
              {"0", 28, {"a", "b", "d"}},
              {"1", 8, {"a", "c", "d"}},
              {"2", 2, {"d"}},
              {"2", 0, {}},
              {"2", -8, {}}};
  for (const auto& row : rows) {
    INFO(row.lamps << " lamps, room for " << row.components);
    CHECK(names_of(constants_that_fit(listed, {{"LAMPS", row.lamps}}, row.components)) == row.taken);
  }
  CHECK(names_of(constants_that_fit(listed, {}, 28)) == Names{"a", "b", "d"});  // without the define: no lamps
}

TEST_CASE("constants are packed without gaps", "[draw_constants]") {
  const std::vector<DrawConstant> constants = {{"vec3", "u_a"}, {"bool", "u_b"}, {"int", "u_c"}};
  const PassedConstants glsl = pass_as_varyings(constants, {}, "\nuniform vec3 u_a;\n");
  CHECK(glsl.vertex_declarations == "uniform bool u_b;\nuniform int u_c;\nflat out vec4 v_constants[2];\n");
  CHECK(glsl.fragment_declarations == "flat in vec4 v_constants[2];\n");
  CHECK(glsl.vertex_statements.ends_with("v_constants[0][3] = float(u_b);\n  v_constants[1][0] = float(u_c);\n"));
  ShaderSource fragment{.text = "\nuniform vec3 u_a;\nuniform bool u_b; // b\nuniform int u_c;\n"};
  make_global(fragment, glsl);
  CHECK(fragment.text ==
        "\nvec3 u_a = vec3(v_constants[0][0], v_constants[0][1], v_constants[0][2]);\n"
        "bool u_b = bool(v_constants[0][3]); // b\nint u_c = int(v_constants[1][0]);\n");
  const PassedConstants nothing = pass_as_varyings({}, {}, "");
  CHECK(nothing.vertex_declarations + nothing.fragment_declarations == "");
}

TEST_CASE("with uniforms, the shaders equal those without draw constants", "[draw_constants]") {
  Fixture f;
  const SurfaceSources listed = f.assemble({});
  CHECK(left_as_uniforms(listed) == names_of(constants_of_all_types));
  f.piece->constants.clear();
  const SurfaceSources plain = f.assemble({});
  CHECK(listed.vertex.text == plain.vertex.text);
  CHECK(listed.fragment.text == plain.fragment.text);
  CHECK(plain.fragment.text.find("v_constants") == std::string::npos);
}

TEST_CASE("as many constants are passed as varyings as the driver supports", "[draw_constants]") {
  Fixture f;
  const auto context = make_headless_context();
  const struct {
    const char* name;
    Defines structure;
    int varyings;
    std::vector<std::string> uniforms;
  } rows[] = {
      // 3 of the eye, 12 of scalars and vectors, 9 and 16 of matrices, 26 of things; beside them 16 of the surface
      {"all", by_varyings, 84, {}},
      {"all but things", by_varyings, 80, {"u_things"}},
      {"what is guaranteed", by_varyings, guaranteed_varyings, {"u_things"}},
      {"the matrix beside tangents", with_tangents, 60, {"u_things"}},
      {"no matrix beside tangents", with_tangents, 59, {"u_mat4", "u_things"}},
      {"nothing", by_varyings, 16, names_of(constants_of_all_types)},
      {"less than nothing", by_varyings, 0, names_of(constants_of_all_types)},
      {"lit at the corners, where all uniforms then are", at_corners, 128, {}},
  };
  for (const auto& row : rows) {
    INFO(row.name);
    const SurfaceSources sources = f.assemble(row.structure, row.varyings);
    CHECK(left_as_uniforms(sources) == row.uniforms);
    const bool any = sources.vertex.text.find("v_constants") != std::string::npos;
    CHECK(any == (row.varyings > 16 && row.structure != at_corners));
    CHECK_NOTHROW(build_program(context->gl(), sources.vertex, sources.fragment));
  }
}

TEST_CASE("constants of every type are passed as varyings with all their bits", "[draw_constants]") {
  Stage stage;
  auto piece = piece_for(stage.shaders, Slot::shade, "shade", all_types);
  piece->constants = constants_of_all_types;
  piece->wants = [](const Material&) { return Need{.wanted = true, .structure = {{"THINGS", "2"}}}; };
  piece->bind = [](Binder& binder, const Viewpoint&) { bind_all_types(binder); };
  stage.open({}, std::move(piece));
  const Image by_uniforms = stage.draw(triangle_scene());
  CHECK(by_uniforms.at(10, 20).r > 1e6f);  // it is the things' numbers that are seen
  stage.renderer->configure(Settings(), {.constants_as_varyings = true});
  CHECK(stage.draw(triangle_scene()) == by_uniforms);
}

TEST_CASE("a constant whose declaration differs from the list is named", "[draw_constants]") {
  Fixture f;
  f.piece->constants = {{"vec4", "u_vec3"}};
  CHECK(mentions(error_of([&] { f.assemble(by_varyings); }), {"u_vec3", "uniform vec4 u_vec3;"}));
  f.piece->constants = {{"Thing", "u_thing", "THINGS", {{"float", "x"}}}};
  CHECK(mentions(error_of([&] { f.assemble(by_varyings); }), {"uniform Thing u_thing["}));
}
