#include "gl/depth_textures.hpp"

#include "base/error.hpp"
#include "catch.hpp"
#include "contexts.hpp"
#include "gl/query.hpp"

using namespace atelier;
using atelier::test::error_of;
using atelier::test::mentions;
using atelier::test::on_every_context;

TEST_CASE("Depth textures hold the depths that they were given") {
  on_every_context([](Gl& gl) {
    const std::vector<float> layers = {0, 0.25f, 0.5f, 0.75f, 1, 0.125f, 0.375f, 0.625f};
    const GlTexture two = make_depth_layers(gl, 2, layers);
    CHECK(read_depth_layers(gl, two.id()) == layers);

    const std::vector<float> faces = even_faces(2, {0, 0.125f, 0.25f, 0.5f, 0.75f, 1});
    CHECK(faces.size() == 24);
    const GlTexture cube = make_depth_cube(gl, 2, faces, true);
    CHECK(read_depth_cube(gl, cube.id()) == faces);
    CHECK(integer_of(gl, GL_TEXTURE_BINDING_2D_ARRAY) == 0);
    CHECK(integer_of(gl, GL_TEXTURE_BINDING_CUBE_MAP) == 0);
  });
}

TEST_CASE("Incomplete layers and cubes are refused") {
  on_every_context([](Gl& gl) {
    const std::vector<float> five(5, 0.5f);
    CHECK(mentions(error_of([&] { make_depth_layers(gl, 2, five); }), {"5 depths", "2 x 2"}));
    CHECK(mentions(error_of([&] { make_depth_layers(gl, 0, {}); }), {"0 depths"}));
    CHECK(mentions(error_of([&] { make_depth_cube(gl, 1, five); }), {"5 depths", "six faces"}));
  });
}

TEST_CASE("A framebuffer for depth alone is complete once a layer is attached") {
  on_every_context([](Gl& gl) {
    const GlTexture layer = make_depth_layers(gl, 4, std::vector<float>(16, 1.0f));
    const GlFramebuffer framebuffer = make_depth_framebuffer(gl);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    gl.FramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, layer.id(), 0, 0);
    CHECK(gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  });
}
