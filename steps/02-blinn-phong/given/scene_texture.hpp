// Textures of a scene in OpenGL, by the student's functions and the setting "texture.filter". Given.
#pragma once

#include <string>

#include "gl/objects.hpp"
#include "scene/scene.hpp"

namespace atelier {

/// `pixels` as a texture with the name and the wrap mode of `texture`, and the filter of `choice`, where "scene"
/// is the texture's own; with mipmaps if it uses them. Changes the texture binding.
GlTexture upload_scene_texture(Gl& gl, const Texture& texture, const Image& pixels, const std::string& choice);

}  // namespace atelier
