#include "app/window/loop.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/error.hpp"
#include "gl/debug.hpp"
#include "image_io/image_io.hpp"

namespace atelier {
namespace {

using namespace std::chrono_literals;

constexpr auto look_interval = 250ms;  ///< between checks of files
constexpr auto notice_time = 4s;
constexpr int settling_rounds = 3;  ///< Dear ImGui reacts to some events only in the second frame after them

/// An unused name in the current folder: "01-transforms-teapot-colour.png", then "-2" and so on.
std::filesystem::path free_name(const Viewer& viewer) {
  const std::string stem = fmt::format("{}-{}-{}", viewer.description().name,
                                       std::filesystem::path(viewer.scene()).stem().string(), viewer.output());
  std::filesystem::path file = stem + ".png";
  for (int i = 2; std::filesystem::exists(file); ++i) file = fmt::format("{}-{}.png", stem, i);
  return file;
}

}  // namespace

WindowOptions options_from_environment() {
  WindowOptions options;
  if (const char* text = std::getenv("ATELIER_WINDOW_FRAMES")) {
    int frames = 0, used = 0;
    if (std::sscanf(text, "%d%n", &frames, &used) != 1 || text[used] || frames < 1)
      throw Error(fmt::format("ATELIER_WINDOW_FRAMES={}: must be a number of frames, 1 or more", text));
    options.frames = frames;
  }
  if (const char* text = std::getenv("ATELIER_WINDOW_SAVE")) options.save = text;
  if (const char* text = std::getenv("ATELIER_WINDOW_PLACE")) {
    glm::ivec2 place;
    int used = 0;
    if (std::sscanf(text, "%d,%d%n", &place.x, &place.y, &used) != 2 || text[used])
      throw Error(fmt::format("ATELIER_WINDOW_PLACE={}: must be two integers as X,Y", text));
    options.place = place;
  }
  return options;
}

Window::Window(const WindowRequest& request, const WindowOptions& options)
    : request_(request),
      options_(options),
      program_file_(this_program()),
      display_(request.line.picture.size + glm::ivec2(panel_width, 0), request.identity.name, options.place),
      program_(request.make()),
      viewer_(*program_, display_.gl(), request.implementations, request.line),
      presenter_(display_.gl()),
      panel_(make_panel(display_)),
      libraries_(step_libraries(request.identity, request.implementations)),
      shaders_(step_shaders(request.implementations)) {}

std::optional<CommandLine> Window::run() {
  display_.show();
  rounds_left_ = settling_rounds;
  while (!quit_ && !restart_) {
    handle(display_.wait(waiting_time()));
    let_time_pass();
    look_at_files();
    if (rounds_left_ > 0) draw_round();
    quit_ |= display_.wants_to_close() || (options_.frames && frames_ >= *options_.frames);
  }
  if (restart_ && !quit_) return restart_command_line();
  return {};
}

double Window::waiting_time() const {
  if (rounds_left_ > 0 || viewer_.moving() || options_.frames) return 0;
  return std::chrono::duration<double>(look_interval).count();
}

// ---- User input

void Window::handle(const std::vector<Event>& events) {
  if (!events.empty()) rounds_left_ = settling_rounds;
  for (const Event& event : events) {
    // A drag that began in the picture continues over the panel, and vice versa.
    const bool of_mouse = std::holds_alternative<Pressed>(event) || std::holds_alternative<Scrolled>(event);
    if (of_mouse && panel_->wants_mouse()) continue;
    if (std::holds_alternative<Typed>(event) && panel_->wants_keyboard()) continue;
    execute(interpret(controls_, event));
  }
}

void Window::execute(const Gesture& gesture) {
  const double height = display_.size().y;
  if (gesture.turn != glm::dvec2(0)) viewer_.turn(gesture.turn, height);
  if (gesture.pan != glm::dvec2(0)) viewer_.pan(gesture.pan, height);
  if (gesture.dolly != 0) viewer_.dolly(gesture.dolly);
  if (gesture.arrow != glm::dvec2(0)) viewer_.arrow(gesture.arrow);
  execute(gesture.action, gesture.number);
}

void Window::execute(Action action, int number) {
  const auto& scenes = viewer_.description().scenes;
  switch (action) {
    case Action::none:
      return;
    case Action::quit:
      quit_ = true;
      return;
    case Action::help:
      state_.help = !state_.help;
      return;
    case Action::panel:
      state_.visible = !state_.visible;
      return;
    case Action::play:
      viewer_.play(!viewer_.playing());
      return;
    case Action::reset_camera:
      viewer_.reset_camera();
      return;
    case Action::save:
      save_picture();
      return;
    case Action::scene:
      if (number <= int(scenes.size())) viewer_.choose_scene(scenes[std::size_t(number - 1)]);
      return;
  }
}

void Window::save_picture() {
  if (!viewer_.picture()) return notify("there is no picture to save yet");
  try {
    const auto file = free_name(viewer_);
    write_image(file, viewer_.picture()->read_colour(display_.gl()), {.encoding = viewer_.encoding()});
    notify(fmt::format("saved {}", file.string()));
  } catch (const Error& error) {
    notify(fmt::format("not saved: {}", error.what()));
  }
}

void Window::notify(const std::string& words) {
  state_.notice = words;
  notice_end_ = Clock::now() + notice_time;
}

// ---- Without user input

void Window::let_time_pass() {
  const auto now = Clock::now();
  // Moving or covering a window may block the loop: do not let the animation jump.
  viewer_.advance(std::min(std::chrono::duration<double>(now - last_round_).count(), 0.1));
  last_round_ = now;
  if (viewer_.moving() || options_.frames) rounds_left_ = std::max(rounds_left_, 1);
  if (!state_.notice.empty() && now >= notice_end_) {
    state_.notice.clear();
    rounds_left_ = settling_rounds;
  }
}

void Window::look_at_files() {
  if (Clock::now() < last_look_ + look_interval) return;
  last_look_ = Clock::now();
  if (viewer_.reload_shaders()) rounds_left_ = settling_rounds;
  if (shaders_.settled_change(step_shaders(request_.implementations)) && viewer_.retry())
    rounds_left_ = settling_rounds;
  look_at_code();
}

void Window::look_at_code() {
  const Snapshot now = step_libraries(request_.identity, request_.implementations);
  if (now.size() < request_.identity.libraries.size() || !libraries_.settled_change(now)) return;
  viewer_.trouble.code = why_not_loadable(program_file_, request_.line);
  restart_ = viewer_.trouble.code.empty();
  rounds_left_ = settling_rounds;
}

CommandLine Window::restart_command_line() const {
  CommandLine line = viewer_.command_line(request_.line);
  const glm::ivec2 content = display_.size() - glm::ivec2(std::lround(panel_->width(state_)), 0);
  line.picture.size = glm::clamp(glm::ivec2(glm::dvec2(content) / display_.text_scale() + 0.5), 1, 4096);
  return line;
}

// ---- Drawing

glm::ivec2 Window::picture_pixels(glm::ivec2 window) const {
  const double pixels_a_unit = double(window.x) / std::max(display_.size().x, 1);
  const int panel = int(std::lround(panel_->width(state_) * pixels_a_unit));
  return {std::max(window.x - panel, 1), window.y};
}

void Window::draw_round() {
  --rounds_left_;
  const glm::ivec2 window = display_.pixels();
  if (window.x < 1 || window.y < 1) return;  // iconified
  state_.keys = viewer_.walked() ? walking_keys_help : keys_help;
  if (panel_->update(viewer_, state_)) rounds_left_ = std::max(rounds_left_, 1);
  const glm::ivec2 picture = picture_pixels(window);
  viewer_.resize(picture);
  if (viewer_.draw()) rounds_left_ = std::max(rounds_left_, 1);  // the panel's statistics have changed

  Gl& gl = display_.gl();
  display_.bind();
  gl.Viewport(0, 0, window.x, window.y);
  gl.ClearColor(0, 0, 0, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  if (viewer_.picture()) presenter_.draw(*viewer_.picture(), viewer_.encoding(), {{0, 0}, picture});
  {
    const DebugGroup group(gl, "panel");
    panel_->draw();
  }
  ++frames_;
  if (options_.frames == frames_ && !options_.save.empty())
    write_image(options_.save, read_framebuffer(gl, window), {.encoding = Encoding::srgb});
  display_.present();
  retitle();
}

void Window::retitle() {
  std::string title = fmt::format("{} - {}", viewer_.description().name, viewer_.scene());
  if (viewer_.trouble.any()) title += " - error";
  if (title != title_) display_.set_title(title_ = title);
}

}  // namespace atelier
