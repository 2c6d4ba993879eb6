// Debug groups and labels: what reaches the driver, and what is counted for a group.
#include "gl/debug.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>
#include <deque>
#include <string>
#include <vector>

#include "base/file.hpp"
#include "catch.hpp"
#include "contexts.hpp"
#include "gl/objects.hpp"
#include "gl/query.hpp"
#include "gl/shader.hpp"
#include "gl/target.hpp"
#include "shader_text.hpp"

using namespace atelier;
using atelier::test::on_every_context;
using atelier::test::shader_text;

namespace {

/// Two targets and a program, to make passes and draws with.
struct Easel {
  Gl& gl;
  GlProgram program;
  GlVertexArray corners;
  Target one, other;
  explicit Easel(Gl& context)
      : gl(context),
        program(build_program(gl, shader_text("void main() { gl_Position = vec4(0); }"),
                              shader_text("out vec4 o; void main() { o = vec4(1); }"))),
        corners(gl),
        one(gl, {.width = 4, .height = 4}),
        other(gl, {.width = 4, .height = 4}) {
    gl.UseProgram(program.id());
    gl.BindVertexArray(corners.id());
    one.bind(gl);
    gl.restart_counts();
  }
  ~Easel() {
    gl.BindVertexArray(0);
    gl.UseProgram(0);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  }
  void draw(int triangles) { gl.DrawArrays(GL_TRIANGLES, 0, 3 * triangles); }
};

/// A line a group: two blanks for each depth, its name, passes, draws and triangles.
std::string told(const std::vector<GlGroup>& groups) {
  std::string text;
  for (const GlGroup& group : groups)
    text += fmt::format("{}{} {} {} {}\n", std::string(2 * std::size_t(group.depth), ' '), group.name, group.passes,
                        group.draws, group.triangles);
  return text;
}

std::string label_of(Gl& gl, GLenum kind, GLuint id) {
  std::string text(std::size_t(gl.debug_limits().label), '\0');
  GLsizei length = 0;
  gl.GetObjectLabel(kind, id, GLsizei(text.size()), &length, text.data());
  return text.substr(0, std::size_t(length));
}

/// Groups of the driver that are open; the unnamed one around all is not counted.
int open_in_driver(const Gl& gl) {
  return integer_of(gl, GL_DEBUG_GROUP_STACK_DEPTH) - 1;
}

/// What the process writes to its standard output and error while `action` runs, below all streams.
template <class Action>
std::string written_during(Action&& action) {
  const TemporaryFolder folder("atelier-debug-test");
  const auto path = folder.path() / "written";
  std::FILE* const file = std::fopen(path.c_str(), "w");
  REQUIRE(file);
  std::fflush(nullptr);
  const int out = dup(STDOUT_FILENO), error = dup(STDERR_FILENO);
  dup2(fileno(file), STDOUT_FILENO);
  dup2(fileno(file), STDERR_FILENO);
  action();
  std::fflush(nullptr);
  dup2(out, STDOUT_FILENO);
  dup2(error, STDERR_FILENO);
  close(out);
  close(error);
  std::fclose(file);
  return read_file(path);
}

}  // namespace

TEST_CASE("groups count their own work and that of nested groups", "[debug]") {
  on_every_context([](Gl& gl) {
    Easel easel(gl);
    {
      const DebugGroup frame(gl, "frame");
      {
        const DebugGroup maps(gl, "maps");
        {
          const DebugGroup first(gl, "first");
          easel.one.bind(gl);
          gl.Clear(GL_DEPTH_BUFFER_BIT);
          easel.draw(2);
          easel.draw(3);
        }
        {
          const DebugGroup second(gl, "second");
          easel.other.bind(gl);
          gl.Clear(GL_DEPTH_BUFFER_BIT);
        }
      }
      const DebugGroup scene(gl, "scene");
      easel.one.bind(gl);
      easel.draw(10);
      {
        const DebugGroup sky(gl, "sky");  // draws on in the pass around it
        easel.draw(1);
      }
      CHECK(told(gl.groups()) ==
            "frame 3 4 16\n"
            "  maps 2 2 5\n"
            "    first 1 2 5\n"
            "    second 1 0 0\n"
            "  scene 1 2 11\n"
            "    sky 0 1 1\n");  // two of them are still open
      easel.draw(100);
    }
    easel.draw(1000);  // in no group
    CHECK(told(gl.groups()) ==
          "frame 3 5 116\n"
          "  maps 2 2 5\n"
          "    first 1 2 5\n"
          "    second 1 0 0\n"
          "  scene 1 3 111\n"
          "    sky 0 1 1\n");
    CHECK(gl.counts().triangles == 1116);
  });
}

TEST_CASE("fragments are counted on request, for the groups that draw them", "[debug]") {
  on_every_context([](Gl& gl) {
    const GlProgram program = build_program(
        gl,
        shader_text("void main() { gl_Position = vec4(2 * (gl_VertexID % 2) - 1, 4 * (gl_VertexID / 2) - 1, 0, 1);\n"
                    "              if (gl_VertexID == 1) gl_Position.x = 3; }"),
        shader_text("out vec4 o; void main() { if (gl_FragCoord.x < 1) discard; o = vec4(1); }"));
    const GlVertexArray corners(gl);
    const Target target(gl, {.width = 4, .height = 4});
    gl.UseProgram(program.id());
    gl.BindVertexArray(corners.id());
    target.bind(gl);
    const auto draw = [&] { gl.DrawArrays(GL_TRIANGLES, 0, 3); };
    gl.restart_counts();
    draw();
    CHECK_FALSE(gl.counts().fragments);
    gl.count_fragments(true);
    draw();  // before the restart
    gl.restart_counts();
    {
      const DebugGroup frame(gl, "frame");
      draw();
      {
        const DebugGroup scissored(gl, "scissored");
        gl.Enable(GL_SCISSOR_TEST);
        gl.Scissor(0, 0, 4, 1);
        draw();
        draw();
        gl.Disable(GL_SCISSOR_TEST);
      }
      { const DebugGroup nothing(gl, "nothing"); }
      draw();
    }
    draw();  // in no group
    CHECK(gl.counts().fragments == 3 * 12 + 2 * 3);
    const std::vector<GlGroup> groups = gl.groups();
    REQUIRE(groups.size() == 3);
    CHECK(groups[0].fragments == 2 * 12 + 2 * 3);
    CHECK(groups[1].fragments == 2 * 3);
    CHECK(groups[2].fragments == 0);
    gl.count_fragments(false);
    draw();
    CHECK_FALSE(gl.counts().fragments);
    CHECK_NOTHROW(check_gl_error(gl, "counting fragments"));
    gl.BindVertexArray(0);
    gl.UseProgram(0);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  });
}

TEST_CASE("a restart removes ended groups, and resets the counts of open ones", "[debug]") {
  on_every_context([](Gl& gl) {
    Easel easel(gl);
    { const DebugGroup ended(gl, "ended"); }
    {
      const DebugGroup around(gl, "around");
      { const DebugGroup ended(gl, "ended too"); }
      const DebugGroup open(gl, "open");
      easel.draw(5);
      gl.restart_counts();
      CHECK(told(gl.groups()) == "around 0 0 0\n  open 0 0 0\n");
      easel.draw(7);
      CHECK(told(gl.groups()) == "around 1 1 7\n  open 1 1 7\n");
    }
    const DebugGroup next(gl, "next");
    CHECK(told(gl.groups()) == "around 1 1 7\n  open 1 1 7\nnext 0 0 0\n");
  });
}

TEST_CASE("groups end with their scope, also after an exception", "[debug]") {
  on_every_context([](Gl& gl) {
    gl.restart_counts();
    try {
      const DebugGroup outer(gl, "outer");
      const DebugGroup inner(gl, "inner");
      if (gl.PushDebugGroup.call) CHECK(open_in_driver(gl) == 2);
      throw Error("on the way");
    } catch (const Error&) {
    }
    if (gl.PushDebugGroup.call) CHECK(open_in_driver(gl) == 0);
    const DebugGroup next(gl, "next");
    CHECK(told(gl.groups()) == "outer 0 0 0\n  inner 0 0 0\nnext 0 0 0\n");
  });
}

TEST_CASE("many groups, deep nesting and long names are not errors", "[debug]") {
  on_every_context([](Gl& gl) {
    Easel easel(gl);
    const std::string long_name(std::size_t(gl.debug_limits().message) + 100, 'x');
    {
      std::deque<DebugGroup> open;
      for (int depth = 0; depth < 300; ++depth) open.emplace_back(gl, depth == 7 ? long_name : "deep");
      easel.draw(1);
      if (gl.PushDebugGroup.call) CHECK(open_in_driver(gl) == gl.debug_limits().group_depth - 1);
      CHECK_NOTHROW(check_gl_error(gl, "opening groups"));
      while (!open.empty()) open.pop_back();  // in the order in which scopes end
    }
    if (gl.PushDebugGroup.call) CHECK(open_in_driver(gl) == 0);
    CHECK_NOTHROW(check_gl_error(gl, "closing groups"));
    const std::vector<GlGroup> groups = gl.groups();
    REQUIRE(groups.size() == 256);
    CHECK(groups[7].name == long_name);
    CHECK(groups[255] == GlGroup{.depth = 255, .name = "deep", .passes = 1, .draws = 1, .triangles = 1});
    const DebugGroup unlisted(gl, "one too many");
    easel.draw(1);
    CHECK(gl.groups() == groups);
    gl.restart_counts();
    const DebugGroup listed(gl, "the first of a new frame");
    CHECK(told(gl.groups()) == "  the first of a new frame 0 0 0\n");  // in one that was begun before
  });
}

TEST_CASE("labels reach the driver", "[debug]") {
  on_every_context([](Gl& gl) {
    if (!gl.ObjectLabel.call) SKIP_TEST("this driver has no KHR_debug");
    const GlBuffer buffer(gl);
    const GlFramebuffer framebuffer(gl);
    const GlProgram program(gl);
    const GlRenderbuffer renderbuffer(gl);
    const GlTexture texture(gl);
    const GlVertexArray vertex_array(gl);
    gl.BindBuffer(GL_ARRAY_BUFFER, buffer.id());
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    gl.BindRenderbuffer(GL_RENDERBUFFER, renderbuffer.id());
    gl.BindTexture(GL_TEXTURE_CUBE_MAP, texture.id());
    gl.BindVertexArray(vertex_array.id());
    const struct {
      const char* name;
      GLenum kind;
      GLuint id;
    } rows[] = {
        {"corners", GL_BUFFER, buffer.id()},      {"maps' framebuffer", GL_FRAMEBUFFER, framebuffer.id()},
        {"depth pass", GL_PROGRAM, program.id()}, {"samples", GL_RENDERBUFFER, renderbuffer.id()},
        {"a cube", GL_TEXTURE, texture.id()},     {"teapot", GL_VERTEX_ARRAY, vertex_array.id()},
    };
    for (const auto& row : rows) {
      INFO(row.name);
      CHECK(label_of(gl, row.kind, row.id).empty());
      label(gl, row.kind, row.id, row.name);
      CHECK(label_of(gl, row.kind, row.id) == row.name);
    }
    gl.BindVertexArray(0);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);

    const Target target(gl, {.width = 2, .height = 2}), depth_alone(gl, {.colour = ColourFormat::none});
    label(gl, target, "picture");
    label(gl, depth_alone, "map");
    CHECK(label_of(gl, GL_FRAMEBUFFER, target.framebuffer()) == "picture");
    CHECK(label_of(gl, GL_TEXTURE, target.colour_texture()) == "picture: colour");
    CHECK(label_of(gl, GL_TEXTURE, target.depth_texture()) == "picture: depth");
    CHECK(label_of(gl, GL_TEXTURE, depth_alone.depth_texture()) == "map: depth");
  });
}

TEST_CASE("a label is truncated to the driver's limit, between characters", "[debug]") {
  on_every_context([](Gl& gl) {
    if (!gl.ObjectLabel.call) SKIP_TEST("this driver has no KHR_debug");
    const GlProgram program(gl);
    const auto longest = std::size_t(gl.debug_limits().label) - 1;
    const struct {
      const char* name;
      std::string text, kept;
    } rows[] = {
        {"empty", "", ""},
        {"as long as it may be", std::string(longest, 'a'), std::string(longest, 'a')},
        {"one byte longer", std::string(longest + 1, 'a'), std::string(longest, 'a')},
        {"far longer", std::string(100 * longest, 'a'), std::string(longest, 'a')},
        {"a character of two bytes across the end", std::string(longest - 1, 'a') + "\u00e9",
         std::string(longest - 1, 'a')},
        {"a character of four bytes across the end", std::string(longest - 3, 'a') + "\U0001F4A1",
         std::string(longest - 3, 'a')},
        {"no UTF-8 at all", std::string(longest + 5, '\x80'), ""},
    };
    for (const auto& row : rows) {
      INFO(row.name);
      label(gl, GL_PROGRAM, program.id(), "before");
      label(gl, GL_PROGRAM, program.id(), row.text);
      CHECK(label_of(gl, GL_PROGRAM, program.id()) == row.kept);
      CHECK_NOTHROW(check_gl_error(gl, row.name));
    }
  });
}

TEST_CASE("an invalid object gets no label and raises no error", "[debug]") {
  on_every_context([](Gl& gl) {
    GLuint deleted = 0;
    {
      const GlTexture texture(gl);
      gl.BindTexture(GL_TEXTURE_2D, texture.id());
      deleted = texture.id();
    }
    const GlTexture never_bound(gl);
    const GlVertexArray array(gl);
    gl.BindVertexArray(array.id());
    const struct {
      const char* name;
      GLenum kind;
      GLuint id;
    } rows[] = {
        {"none", GL_TEXTURE, 0},
        {"the default framebuffer", GL_FRAMEBUFFER, 0},
        {"never made", GL_BUFFER, 4711},
        {"never made, a program", GL_PROGRAM, 4711},
        {"deleted", GL_TEXTURE, deleted},
        {"a name that no texture has yet", GL_TEXTURE, never_bound.id()},
        {"an object of another kind", GL_RENDERBUFFER, array.id()},
        {"no kind of object", GL_DEPTH_TEST, array.id()},
    };
    for (const auto& row : rows) {
      INFO(row.name);
      label(gl, row.kind, row.id, "nobody");
      CHECK_NOTHROW(check_gl_error(gl, row.name));
    }
    gl.BindVertexArray(0);
  });
}

TEST_CASE("without KHR_debug nothing reaches the driver, but groups are counted", "[debug]") {
  on_every_context([](Gl& gl) {
    const bool there = gl.PushDebugGroup.call;
    gl.ObjectLabel.call = nullptr;
    gl.PushDebugGroup.call = nullptr;
    gl.PopDebugGroup.call = nullptr;
    Easel easel(gl);
    {
      const DebugGroup frame(gl, "frame");
      easel.draw(3);
      if (there) CHECK(open_in_driver(gl) == 0);
    }
    CHECK(told(gl.groups()) == "frame 1 1 3\n");
    label(gl, GL_PROGRAM, easel.program.id(), "unheard");
    if (there) CHECK(label_of(gl, GL_PROGRAM, easel.program.id()).empty());
  });
}

TEST_CASE("debug functions are loaded if the driver announces them", "[debug]") {
  on_every_context([](Gl& gl) {
    const bool expected = gl.version() >= 43 || gl.has_extension("GL_KHR_debug");
    CHECK((gl.ObjectLabel.call != nullptr) == expected);
    CHECK((gl.GetObjectLabel.call != nullptr) == expected);
    CHECK((gl.PushDebugGroup.call != nullptr) == expected);
    CHECK((gl.PopDebugGroup.call != nullptr) == expected);
    // The least that the extension promises.
    if (expected) CHECK(gl.debug_limits().label >= 256);
    if (expected) CHECK(gl.debug_limits().message >= 1);
    if (expected) CHECK(gl.debug_limits().group_depth >= 64);
  });
}

TEST_CASE("group names are not printed", "[debug]") {
  on_every_context([](Gl& gl) {
    const std::string written = written_during([&] {
      Easel easel(gl);
      const DebugGroup frame(gl, "frame");
      label(gl, easel.one, "picture");
      easel.draw(1);
      gl.Finish();
    });
    CHECK(written.empty());
  });
}
