// The setting "texture.filter". Given.
#pragma once

#include <string>

#include "scene/scene.hpp"

namespace atelier {

/// The filter of a texture for the setting's value: "scene" leaves the texture's own.
inline Filter chosen_filter(const std::string& choice, Filter of_scene) {
  return choice == "nearest"  ? Filter::nearest
         : choice == "linear" ? Filter::linear
         : choice == "mipmap" ? Filter::mipmap
                              : of_scene;
}

}  // namespace atelier
