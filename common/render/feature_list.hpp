// The features of a renderer, in the order in which they are asked.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "render/feature.hpp"

namespace atelier {

class FeatureList {
 public:
  /// Makes a feature behind all others; it stays where it is as long as the renderer, so that later ones may hold
  /// references to what it hands out.
  template <class F, class... Arguments>
  F& add(Arguments&&... arguments) {
    auto feature = std::make_unique<F>(std::forward<Arguments>(arguments)...);
    F& added = *feature;
    features_.push_back(std::move(feature));
    return added;
  }

  /// Hands all of them over.
  std::vector<std::unique_ptr<Feature>> take() { return std::move(features_); }

 private:
  std::vector<std::unique_ptr<Feature>> features_;
};

}  // namespace atelier
