// The features of a renderer, in the order in which they are called.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "render/feature.hpp"

namespace atelier {

class FeatureList {
 public:
  /// Constructs a feature at the end of the list. Its address stays valid for the renderer's lifetime, so later
  /// features may keep references to its data.
  template <class F, class... Arguments>
  F& add(Arguments&&... arguments) {
    auto feature = std::make_unique<F>(std::forward<Arguments>(arguments)...);
    F& added = *feature;
    features_.push_back(std::move(feature));
    return added;
  }

  /// Moves all features out.
  std::vector<std::unique_ptr<Feature>> take() { return std::move(features_); }

 private:
  std::vector<std::unique_ptr<Feature>> features_;
};

}  // namespace atelier
