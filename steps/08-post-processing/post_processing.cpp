#include "08-post-processing/post_processing.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

namespace atelier::post_processing {

// TODO(08-post-processing): what your functions below share, if anything

int next_target(int source) {
  // TODO(08-post-processing): the other one
  return source;
}

void draw_full_screen(Gl& gl) {
  // TODO(08-post-processing): an empty vertex array, three vertices
  static_cast<void>(gl);
}

std::vector<Pass> passes_for(const Look& look) {
  // TODO(08-post-processing): those that change something, from light to display
  static_cast<void>(look);
  return {};
}

std::vector<float> gaussian_weights(float sigma) {
  // TODO(08-post-processing): the bell, and what it sums to
  static_cast<void>(sigma);
  return {1};
}

ColourTable read_table(std::string_view text) {
  // TODO(08-post-processing): line by line
  static_cast<void>(text);
  return {.size = 2, .colours = std::vector<glm::vec3>(8, glm::vec3(0.5f))};
}

std::string write_table(const ColourTable& table) {
  // TODO(08-post-processing): the keywords that say something, then the colours
  static_cast<void>(table);
  return {};
}

}  // namespace atelier::post_processing
