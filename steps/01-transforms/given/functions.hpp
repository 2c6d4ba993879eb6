// Table of step 01's functions, which every later program passes to the renderer. Given.
#pragma once

#include "01-transforms/transforms.hpp"

namespace atelier {

inline TransformFunctions transform_functions() {
  return {.compose = transforms::compose,
          .world_matrices = transforms::world_matrices,
          .look_at = transforms::look_at,
          .perspective = transforms::perspective,
          .perspective_reversed = transforms::perspective_reversed,
          .orthographic = transforms::orthographic,
          .normal_matrix = transforms::normal_matrix,
          .relative_to_eye = transforms::relative_to_eye,
          .upload_mesh = transforms::upload_mesh,
          .set_wireframe = transforms::set_wireframe,
          .glsl = "01-transforms/transforms.glsl"};
}

}  // namespace atelier
