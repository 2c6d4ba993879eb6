#include "app/window/controls.hpp"

namespace atelier {
namespace {

constexpr double double_click_seconds = 0.35, double_click_distance = 4;  // window units

bool is_double_click(const std::optional<Pressed>& before, const Pressed& now) {
  return before && now.time - before->time <= double_click_seconds &&
         glm::distance(before->position, now.position) <= double_click_distance;
}

Gesture press(Controls& controls, const Pressed& event) {
  Gesture gesture;
  if (!controls.dragging) controls.dragging = event.button;
  controls.last = event.position;
  if (event.button != Button::left) return gesture;
  if (is_double_click(controls.last_click, event)) {
    gesture.action = Action::reset_camera;
    controls.last_click.reset();  // a third click starts a new double click
  } else {
    controls.last_click = event;
  }
  return gesture;
}

Gesture move(Controls& controls, const Moved& event) {
  Gesture gesture;
  const glm::dvec2 way = event.position - controls.last;
  controls.last = event.position;
  if (controls.dragging) (*controls.dragging == Button::left ? gesture.turn : gesture.pan) = way;
  return gesture;
}

Gesture type(const Typed& event) {
  switch (event.key) {
    case Key::escape:
      return {.action = Action::quit};
    case Key::tab:
      return {.action = Action::panel};
    case Key::space:
      return {.action = Action::play};
    case Key::left:
      return {.arrow = {-1, 0}};
    case Key::right:
      return {.arrow = {1, 0}};
    case Key::up:
      return {.arrow = {0, 1}};
    case Key::down:
      return {.arrow = {0, -1}};
    case Key::plus:
      return {.dolly = 1};
    case Key::minus:
      return {.dolly = -1};
    case Key::h:
      return {.action = Action::help};
    case Key::r:
      return {.action = Action::reset_camera};
    case Key::s:
      return {.action = Action::save};
    case Key::digit:
      return {.action = Action::scene, .number = event.digit};
  }
  return {};
}

}  // namespace

Gesture interpret(Controls& controls, const Event& event) {
  if (const auto* pressed = std::get_if<Pressed>(&event)) return press(controls, *pressed);
  if (const auto* moved = std::get_if<Moved>(&event)) return move(controls, *moved);
  if (const auto* scrolled = std::get_if<Scrolled>(&event)) return {.dolly = scrolled->steps};
  if (const auto* typed = std::get_if<Typed>(&event)) return type(*typed);
  if (const auto* released = std::get_if<Released>(&event); released && controls.dragging == released->button)
    controls.dragging.reset();
  return {};
}

#define OTHER_KEYS                                \
  "double click, R\tback to the scene's camera\n" \
  "1 to 9\tanother scene\n"                       \
  "Space\tstart or stop the animation\n"          \
  "S\tsave the picture as PNG\n"                  \
  "Tab\tshow or hide the panel\n"                 \
  "H\tthis help\n"                                \
  "Esc\tquit\n"

const char* const keys_help =
    "left drag, arrows\torbit the target\n"
    "wheel, + and -\tmove closer or away\n"
    "right or middle drag\tpan\n" OTHER_KEYS;

const char* const walking_keys_help =
    "up and down\twalk\n"
    "left and right, left drag\tlook around\n"
    "wheel, + and -\twalk\n"
    "right or middle drag\tstep aside\n" OTHER_KEYS;

}  // namespace atelier
