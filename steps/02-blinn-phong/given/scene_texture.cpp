#include "02-blinn-phong/given/scene_texture.hpp"

#include "02-blinn-phong/blinn_phong.hpp"
#include "gl/debug.hpp"

namespace atelier {

namespace {

Filter chosen_filter(const std::string& choice, Filter of_scene) {
  return choice == "nearest"  ? Filter::nearest
         : choice == "linear" ? Filter::linear
         : choice == "mipmap" ? Filter::mipmap
                              : of_scene;
}

}  // namespace

GlTexture upload_scene_texture(Gl& gl, const Texture& texture, const Image& pixels, const std::string& choice) {
  const Filter filter = chosen_filter(choice, texture.filter);
  const std::vector<Image> levels =
      filter == Filter::mipmap ? blinn_phong::mipmaps(pixels) : std::vector<Image>{pixels};
  GlTexture uploaded(gl, blinn_phong::upload_texture(gl, levels, texture.wrap, filter));
  label(gl, GL_TEXTURE, uploaded.id(), texture.name);
  return uploaded;
}

}  // namespace atelier
