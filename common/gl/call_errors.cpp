#include "gl/call_errors.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "base/printable.hpp"
#include "gl/call_reason.hpp"
#include "gl/gl.hpp"

namespace atelier {
namespace {

/// Every driver's words have the error's name.
GLenum error_in(std::string_view message) {
  constexpr std::array<std::pair<std::string_view, GLenum>, 5> errors = {
      {{"GL_INVALID_ENUM", GL_INVALID_ENUM},
       {"GL_INVALID_VALUE", GL_INVALID_VALUE},
       {"GL_INVALID_OPERATION", GL_INVALID_OPERATION},
       {"GL_INVALID_FRAMEBUFFER_OPERATION", GL_INVALID_FRAMEBUFFER_OPERATION},
       {"GL_OUT_OF_MEMORY", GL_OUT_OF_MEMORY}}};
  for (const auto& [name, error] : errors)
    if (message.find(name) != message.npos) return error;
  return GL_NO_ERROR;
}

}  // namespace

void APIENTRY GlCallErrors::receive(GLenum, GLenum type, GLuint, GLenum, GLsizei, const GLchar* message,
                                    const void* errors) {
  if (type != GL_DEBUG_TYPE_ERROR) return;
  auto& self = *static_cast<GlCallErrors*>(const_cast<void*>(errors));
  if (self.message_.empty()) self.message_ = message;
}

GlCallErrors::~GlCallErrors() {
  if (listening_) gl_.DebugMessageCallback(nullptr, nullptr);  // the context ends after this object
}

void GlCallErrors::listen() {
  if (!gl_.DebugMessageCallback.call || !gl_.DebugMessageControl.call) return;
  gl_.DebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_FALSE);
  gl_.DebugMessageControl(GL_DONT_CARE, GL_DEBUG_TYPE_ERROR, GL_DONT_CARE, 0, nullptr, GL_TRUE);
  gl_.DebugMessageCallback(receive, this);
  gl_.Enable(GL_DEBUG_OUTPUT);
  gl_.Enable(GL_DEBUG_OUTPUT_SYNCHRONOUS);  // from within the call
  listening_ = true;
}

void GlCallErrors::name_call(std::string_view function, std::span<const GlArgument> arguments) {
  constexpr std::size_t longest = 200;  // bytes of the driver's words
  const std::string message = std::exchange(message_, {});
  if (!first_.empty()) return;
  const GlFailedCall call{function, arguments, error_in(message)};
  first_ = in_words(call);  // calls of the next lines do not come here again
  const std::string reason = reason_of(gl_, call);
  first_ += ": " + (reason.empty() ? shorten(printable(message), longest) : reason);
  message_.clear();
}

std::string GlCallErrors::take() {
  return std::exchange(first_, {});
}

}  // namespace atelier
