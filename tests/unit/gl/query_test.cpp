#include "gl/query.hpp"

#include "catch.hpp"
#include "contexts.hpp"
#include "gl/objects.hpp"

using namespace atelier;
using atelier::test::on_every_context;

TEST_CASE("OpenGL state is read back as it was set") {
  on_every_context([](Gl& gl) {
    gl.DepthFunc(GL_GEQUAL);
    CHECK(integer_of(gl, GL_DEPTH_FUNC) == GL_GEQUAL);
    gl.DepthFunc(GL_LESS);
    CHECK(integer_of(gl, GL_DEPTH_FUNC) == GL_LESS);
  });
}

TEST_CASE("a texture's parameters are returned in the requested order") {
  on_every_context([](Gl& gl) {
    const GlTexture texture(gl);
    gl.BindTexture(GL_TEXTURE_2D, texture.id());
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_R32F, 5, 3, 0, GL_RED, GL_FLOAT, nullptr);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_MIRRORED_REPEAT);
    CHECK(texture_parameters(gl, GL_TEXTURE_2D, {GL_TEXTURE_WRAP_T, GL_TEXTURE_MAG_FILTER}) ==
          std::vector<GLint>{GL_MIRRORED_REPEAT, GL_NEAREST});
    CHECK(level_parameters(gl, GL_TEXTURE_2D, {GL_TEXTURE_HEIGHT, GL_TEXTURE_WIDTH, GL_TEXTURE_INTERNAL_FORMAT}) ==
          std::vector<GLint>{3, 5, GL_R32F});
    gl.BindTexture(GL_TEXTURE_2D, 0);
  });
}
