#include "gl/context.hpp"

#include <cstdlib>
#include <fstream>
#include <thread>

#include "catch.hpp"
#include "contexts.hpp"
#include "gl/target.hpp"

using namespace atelier;
using atelier::test::context_if_there;
using atelier::test::error_of;
using atelier::test::mentions;
using atelier::test::on_every_context;

namespace {

/// A line of /proc/self/status, such as the resident memory "VmRSS:" in kB or the count of "Threads:".
long status_of_process(const std::string& field) {
  std::ifstream file("/proc/self/status");
  for (std::string word; file >> word;)
    if (word == field) {
      long value = 0;
      file >> value;
      return value;
    }
  return 0;
}

/// One environment variable taken away, and given back at the end of the scope.
class WithoutVariable {
 public:
  explicit WithoutVariable(const char* name) : name_(name) {
    if (const char* value = std::getenv(name)) value_ = value, was_set_ = true;
    ::unsetenv(name);
  }
  ~WithoutVariable() {
    if (was_set_) ::setenv(name_, value_.c_str(), 1);
  }

 private:
  const char* name_;
  std::string value_;
  bool was_set_ = false;
};

}  // namespace

TEST_CASE("Kinds of contexts are named and parsed") {
  for (const ContextKind kind : {ContextKind::osmesa, ContextKind::egl, ContextKind::window})
    CHECK(parse_context_kind(to_string(kind)) == kind);
  for (const char* wrong : {"", "OSMESA", "glx", "osmesa "}) {
    INFO(wrong);
    CHECK(mentions(error_of([&] { parse_context_kind(wrong); }), {wrong, "osmesa", "egl", "window"}));
  }
}

TEST_CASE("A context has OpenGL 3.3 core or newer and names the driver") {
  on_every_context([](Gl& gl) {
    CHECK(gl.version() >= 33);
    CHECK(mentions(gl.description(), {"Core Profile", ", "}));
    GLint profile = 0;
    gl.GetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    CHECK((profile & GL_CONTEXT_CORE_PROFILE_BIT) != 0);
    CHECK((gl.ClipControl.call != nullptr) == (gl.version() >= 45 || gl.has_extension("GL_ARB_clip_control")));
    CHECK_FALSE(gl.has_extension("GL_ATELIER_no_such_extension"));
    CHECK_FALSE(gl.has_extension(""));
  });
}

TEST_CASE("The default is the first available kind") {
  const auto context = make_headless_context();
  CHECK(context->kind() != ContextKind::window);
}

TEST_CASE("A thread has one context at a time, and each thread its own") {
  const auto first = make_headless_context();
  CHECK(mentions(error_of([] { make_headless_context(); }), {"already"}));
  std::string message = "not run";
  std::thread([&] { message = error_of([] { make_headless_context(); }); }).join();
  CHECK(message.empty());
  GLint version = 0;
  first->gl().GetIntegerv(GL_MAJOR_VERSION, &version);  // the first is still current here
  CHECK(version >= 3);
}

TEST_CASE("Creating and destroying contexts fifty times leaks nothing") {
  for (const ContextKind kind : {ContextKind::osmesa, ContextKind::egl}) {
    INFO(to_string(kind));
    const auto round = [&] {
      if (const auto context = context_if_there(kind)) Target target(context->gl(), {.width = 256, .height = 256});
    };
    for (int warm_up = 0; warm_up < 10; ++warm_up) round();
    const long memory = status_of_process("VmRSS:"), threads = status_of_process("Threads:");
    for (int i = 0; i < 50; ++i) round();
    // The allocator keeps some pages. One lost target alone is 0.5 MB: fifty would be 25 MB; measured growth is
    // below 1.
    CHECK(status_of_process("VmRSS:") - memory < 8 * 1024);
    CHECK(status_of_process("Threads:") == threads);
  }
}

TEST_CASE("Without a display, a window's context suggests a fix") {
  const WithoutVariable x11("DISPLAY"), wayland("WAYLAND_DISPLAY");
  CHECK(mentions(error_of([] { make_headless_context(ContextKind::window); }), {"xvfb-run", "osmesa", "egl"}));
  CHECK(error_of([] { make_headless_context(); }).empty());  // the failed one has not kept the thread
}

TEST_CASE("Without a current window context no scale is reported") {
  CHECK(mentions(error_of([] { window_content_scale(); }), {"no window's context"}));
  const auto context = make_headless_context();
  if (context->kind() != ContextKind::window)
    CHECK(mentions(error_of([] { window_content_scale(); }), {"no window's context"}));
}

TEST_CASE("With a display a hidden window draws like the others") {
  if (!std::getenv("DISPLAY")) SKIP_TEST("no display: run under xvfb-run to try a window's context");
  const auto context = make_headless_context(ContextKind::window);
  CHECK(context->kind() == ContextKind::window);
  CHECK(window_content_scale() > 0);
  CHECK(context->gl().version() >= 33);
  const Target target(context->gl(), {.width = 3, .height = 2});
  target.bind(context->gl());
  context->gl().ClearColor(0.25f, 2.0f, -1.0f, 1.0f);
  context->gl().Clear(GL_COLOR_BUFFER_BIT);
  CHECK(target.read_colour(context->gl()).at(2, 1) == Rgba{0.25f, 2.0f, -1.0f, 1.0f});
}
