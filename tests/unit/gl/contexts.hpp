// Every test that draws does so in memory by OSMesa and by EGL: both must behave alike.
#pragma once

#include <memory>

#include "base/error.hpp"
#include "catch.hpp"
#include "gl/context.hpp"

namespace atelier::test {

/// The context, or none with a warning that always shows where this machine lacks that kind.
inline std::unique_ptr<HeadlessContext> context_if_there(ContextKind kind) {
  try {
    return make_headless_context(kind);
  } catch (const Error& error) {
    WARN("skipped on " << to_string(kind) << ": " << error.what());
    return nullptr;
  }
}

/// Runs `test(gl)` on each kind in turn; fails where there is none at all.
template <class Test>
void on_every_context(Test&& test) {
  int made = 0;
  for (const ContextKind kind : {ContextKind::osmesa, ContextKind::egl}) {
    const auto context = context_if_there(kind);
    if (!context) continue;
    ++made;
    INFO("context " << to_string(kind));
    test(context->gl());
    CHECK_NOTHROW(check_gl_error(context->gl(), "a test"));
  }
  REQUIRE(made > 0);
}

}  // namespace atelier::test
