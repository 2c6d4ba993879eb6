// An importer's messages about what it fixed or left out.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace atelier::scene_import {

/// Collects sentences: no duplicates, at most a hundred, so that a file cannot flood the terminal.
class Notes {
 public:
  void add(std::string sentence) {
    if (sentences_.size() < 100 && std::ranges::find(sentences_, sentence) == sentences_.end())
      sentences_.push_back(std::move(sentence));
  }
  const std::vector<std::string>& sentences() const { return sentences_; }

 private:
  std::vector<std::string> sentences_;
};

}  // namespace atelier::scene_import
