// Compiling shaders: errors at the author's line, and uniforms by name.
#include "gl/shader.hpp"

#include "base/file.hpp"
#include "catch.hpp"
#include "contexts.hpp"
#include "gl/full_screen.hpp"
#include "gl/target.hpp"
#include "shader_text.hpp"

using namespace atelier;
using atelier::test::error_of;
using atelier::test::mentions;
using atelier::test::on_every_context;
using atelier::test::shader_text;

namespace {

const std::string corner = "void main() { gl_Position = vec4(0, 0, 0, 1); }\n";
const std::string white = "out vec4 o;\nvoid main() { o = vec4(1); }\n";

/// What build_program says to a fragment shader made of `files`, main.glsl first.
std::string refusal(Gl& gl, const std::map<std::string, std::string>& files, const Defines& defines = {}) {
  const TemporaryFolder folder;
  for (const auto& [name, glsl] : files) write_file(folder.path() / name, glsl);
  const ShaderSource fragment =
      assemble_shader([&](const std::string& name) { return folder.path() / name; }, "main.glsl", defines);
  return error_of([&] { build_program(gl, shader_text(corner), fragment); });
}

/// The only pixel that a program draws over everything.
Rgba drawn(Gl& gl, GLuint program) {
  const Target target(gl, {.depth = DepthFormat::none});
  target.bind(gl);
  gl.UseProgram(program);
  draw_triangle_by_id(gl);
  return target.read_colour(gl).at(0, 0);
}

}  // namespace

TEST_CASE("An error is reported at the author's line, through two levels of includes") {
  on_every_context([](Gl& gl) {
    const std::string lit = "// a comment\n#include \"deep/noise.glsl\"\nfloat lit() { return noise(); }\n";
    const std::string main = "#include \"lit.glsl\"\nout vec4 o;\nvoid main() {\n  o = vec4(lit());\n}\n";
    const std::string good = "float noise() { return 0.5; }\n";
    struct Row {
      const char* name;
      std::map<std::string, std::string> files;
      const char* place;
    };
    const Row rows[] = {
        {"innermost file",
         {{"main.glsl", main}, {"lit.glsl", lit}, {"deep/noise.glsl", "\n\n\nfloat noise() { return wrong; }\n"}},
         "deep/noise.glsl:4: "},
        {"middle file, after its include",
         {{"main.glsl", main}, {"lit.glsl", lit + "float other() { return wrong; }"}, {"deep/noise.glsl", good}},
         "lit.glsl:4: "},
        {"outer file, after its include",
         {{"main.glsl", main + "float other() { return wrong; }\n"}, {"lit.glsl", lit}, {"deep/noise.glsl", good}},
         "main.glsl:6: "},
        {"last line without a newline",
         {{"main.glsl", main + "wrong"}, {"lit.glsl", lit}, {"deep/noise.glsl", good}},
         "main.glsl:6: "},
        {"Windows line ends",
         {{"main.glsl", "out vec4 o;\r\nvoid main() {\r\n  o = wrong;\r\n}\r\n"}},
         "main.glsl:3: "},
        {"after a comment that begins behind an include",
         {{"main.glsl", "#include \"lit.glsl\" /* one\ntwo */\nwrong\n"}, {"lit.glsl", lit}, {"deep/noise.glsl", good}},
         "main.glsl:3: "},
    };
    for (const Row& row : rows) {
      INFO(row.name);
      const std::string message = refusal(gl, row.files);
      INFO(message);
      CHECK(message.rfind(row.place, 0) == 0);
      CHECK(mentions(message, {"error"}));
    }
  });
}

TEST_CASE("An empty shader, a type that does not exist and a broken define are refused") {
  on_every_context([](Gl& gl) {
    CHECK(mentions(refusal(gl, {{"main.glsl", ""}}), {"main"}));
    CHECK(refusal(gl, {{"main.glsl", "out vec4 o;\nuniform samplerBufferNone t;\nvoid main() {}\n"}}) != "");
    CHECK(mentions(refusal(gl, {{"main.glsl", white}}, {{"o", "1 +"}}), {":1: "}));
  });
}

TEST_CASE("Stages that do not link are named") {
  on_every_context([](Gl& gl) {
    const std::string message = error_of([&] {
      build_program(gl, shader_text("out vec3 v_a;\n" + corner, "surface vertex shader"),
                    shader_text("in vec4 v_a;\nout vec4 o;\nvoid main() { o = v_a; }\n", "surface fragment shader"));
    });
    CHECK(mentions(message, {"surface vertex shader", "surface fragment shader", "v_a"}));
  });
}

TEST_CASE("A refused shader leaves no binding and no error") {
  on_every_context([](Gl& gl) {
    for (int round = 0; round < 3; ++round) CHECK(refusal(gl, {{"main.glsl", "wrong\n"}}) != "");
    CHECK(drawn(gl, build_program(gl, shader_text(full_screen_vertex_text), shader_text(white)).id()) ==
          Rgba{1, 1, 1, 1});
  });
}

TEST_CASE("A geometry shader is used if it is given") {
  on_every_context([](Gl& gl) {
    const ShaderSource geometry = shader_text(
        "layout(triangles) in;\nlayout(triangle_strip, max_vertices = 3) out;\nflat out float v_seen;\n"
        "void main() {\n  for (int i = 0; i < 3; ++i) {\n    v_seen = 0.5;\n"
        "    gl_Position = gl_in[i].gl_Position;\n    EmitVertex();\n  }\n}\n");
    const ShaderSource fragment =
        shader_text("flat in float v_seen;\nout vec4 o;\nvoid main() { o = vec4(v_seen); }\n");
    const GlProgram program = build_program(gl, shader_text(full_screen_vertex_text), fragment, &geometry);
    CHECK(drawn(gl, program.id()) == Rgba{0.5f, 0.5f, 0.5f, 0.5f});
  });
}

TEST_CASE("Defines reach the shader") {
  on_every_context([](Gl& gl) {
    const ShaderSource fragment =
        shader_text("out vec4 o;\nvoid main() { o = vec4(SHADE, 1); }\n", "test", {{"SHADE", "vec3(0.25, 0.5, 0.75)"}});
    CHECK(drawn(gl, build_program(gl, shader_text(full_screen_vertex_text), fragment).id()) ==
          Rgba{0.25f, 0.5f, 0.75f, 1});
  });
}

TEST_CASE("Uniforms of every type are set by name, and unused names are ignored") {
  on_every_context([](Gl& gl) {
    const ShaderSource fragment = shader_text(
        "uniform int u_int;\nuniform bool u_bool;\nuniform float u_float;\nuniform vec2 u_two;\nuniform vec3 u_three;\n"
        "uniform vec4 u_four;\nuniform mat3 u_matrix3;\nuniform mat4 u_matrix4;\nout vec4 o;\n"
        "void main() {\n"
        "  o = vec4(u_bool ? float(u_int) : -1.0, u_float + u_two.y, u_three.z + u_four.w,\n"
        "           u_matrix3[0][2] + u_matrix4[3][1]);\n}\n");
    const GlProgram program = build_program(gl, shader_text(full_screen_vertex_text), fragment);
    Uniforms uniforms(gl, program.id());
    gl.UseProgram(program.id());
    uniforms.set("u_int", 7);
    uniforms.set("u_bool", true);
    uniforms.set("u_float", 0.5f);
    uniforms.set("u_two", glm::vec2(0, 2));
    uniforms.set("u_three", glm::vec3(0, 0, 4));
    uniforms.set("u_four", glm::vec4(0, 0, 0, 8));
    glm::mat3 three(0);
    three[0][2] = 16;
    glm::mat4 four(0);
    four[3][1] = 32;
    uniforms.set("u_matrix3", three);
    uniforms.set("u_matrix4", four);
    uniforms.set("u_unused", 1.0f);
    CHECK(uniforms.location("u_unused") == -1);
    CHECK(uniforms.location("u_int") >= 0);
    CHECK(drawn(gl, program.id()) == Rgba{7, 2.5f, 12, 48});
  });
}
