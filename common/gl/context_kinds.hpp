// The three makers behind make_headless_context, each in a file of its own.
#pragma once

#include <memory>

#include "gl/context.hpp"

namespace atelier {

std::unique_ptr<HeadlessContext> make_osmesa_context();
std::unique_ptr<HeadlessContext> make_egl_context();
std::unique_ptr<HeadlessContext> make_window_context();

/// A thread has one current context, and two that are made on it disturb each other (Mesa's libraries share the notion
/// of 'current'). Each context holds one of these from before its making to after its end.
class CurrentContext {
 public:
  CurrentContext();  ///< throws Error where this thread has a context
  ~CurrentContext();
  CurrentContext(const CurrentContext&) = delete;
  CurrentContext& operator=(const CurrentContext&) = delete;
};

}  // namespace atelier
