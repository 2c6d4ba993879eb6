// What a picture is drawn with in the tests of drawing: a painter over the fake step.
#pragma once

#include <memory>
#include <optional>

#include "app/picture.hpp"
#include "base/file.hpp"
#include "fake_step.hpp"
#include "gl/context.hpp"

namespace atelier::test {

/// A painter over the fake step, with its shaders in a folder of its own.
struct Studio {
  TemporaryFolder folder;
  std::unique_ptr<HeadlessContext> context = make_headless_context();
  FakeStep step;
  std::optional<Painter> painter;
  Studio() {
    write_fake_shaders(folder.path());
    painter.emplace(step, *context, Implementations({{folder.path(), ""}}));
  }
};

inline Case small_picture() {
  Case picture;
  picture.name = "picture";
  picture.size = {32, 24};
  return picture;
}

}  // namespace atelier::test
