// Translates mouse and keyboard events to gestures. Independent of the window library.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <variant>

namespace atelier {

enum class Button { left, middle, right };
enum class Key { escape, tab, space, left, right, up, down, plus, minus, h, r, s, digit };

// Positions are in window units (pixels may be smaller), from the upper left corner.
struct Pressed {
  Button button;
  glm::dvec2 position;
  double time;  ///< seconds
};
struct Released {
  Button button;
};
struct Moved {
  glm::dvec2 position;
};
struct Scrolled {
  double steps;  ///< positive away from the user
};
struct Typed {
  Key key;
  int digit = 0;  ///< 1..9, of Key::digit
};
/// The window must be redrawn or has another size.
struct Exposed {};

using Event = std::variant<Pressed, Released, Moved, Scrolled, Typed, Exposed>;

enum class Action { none, quit, help, panel, play, reset_camera, save, scene };

/// The meaning of an event; most members are zero.
struct Gesture {
  glm::dvec2 arrow{0};  ///< arrow keys: x to the right, y up
  glm::dvec2 turn{0};   ///< orbit of the camera about its target, in window units of dragging: x to the right, y down
  glm::dvec2 pan{0};    ///< of the picture, in the same units
  double dolly = 0;     ///< steps towards the target
  Action action = Action::none;
  int number = 0;  ///< of the scene, from 1
};

/// State between events.
struct Controls {
  std::optional<Button> dragging;
  glm::dvec2 last{0};                 ///< where the cursor was
  std::optional<Pressed> last_click;  ///< of the left button
};

/// Left drag turns, right or middle drag pans, the wheel dollies, a double click resets the camera; keys as in
/// `keys_help`. A press begins a drag; only the release of the same button ends it.
Gesture interpret(Controls& controls, const Event& event);

/// A line for each key and gesture: key, tab, meaning.
extern const char* const keys_help;
extern const char* const walking_keys_help;  ///< where the scene is walked through

}  // namespace atelier
