// The three functions behind make_headless_context, each in its own file.
#pragma once

#include <memory>

#include "gl/context.hpp"

namespace atelier {

std::unique_ptr<HeadlessContext> make_osmesa_context();
std::unique_ptr<HeadlessContext> make_egl_context();
std::unique_ptr<HeadlessContext> make_window_context();

/// Guards that a thread has at most one context: Mesa's libraries share the current context, so two contexts on one
/// thread disturb each other. Each context holds one of these for longer than its own lifetime.
class CurrentContext {
 public:
  CurrentContext();  ///< throws Error if this thread has a context
  ~CurrentContext();
  CurrentContext(const CurrentContext&) = delete;
  CurrentContext& operator=(const CurrentContext&) = delete;
};

}  // namespace atelier
