#include "app/window/controls.hpp"

#include "app/window/frame_times.hpp"
#include "catch.hpp"

namespace {

using namespace atelier;

/// Everything that a series of events means, added up.
Gesture after(std::initializer_list<Event> events) {
  Controls controls;
  Gesture sum;
  for (const Event& event : events) {
    const Gesture gesture = interpret(controls, event);
    sum.turn += gesture.turn;
    sum.pan += gesture.pan;
    sum.dolly += gesture.dolly;
    sum.arrow += gesture.arrow;
    if (gesture.action != Action::none) sum.action = gesture.action, sum.number = gesture.number;
  }
  return sum;
}

Pressed press(Button button, double x, double y, double time = 0) {
  return {button, {x, y}, time};
}

}  // namespace

TEST_CASE("events become gestures", "[controls]") {
  const struct {
    const char* name;
    std::initializer_list<Event> events;
    glm::dvec2 turn, pan;
    double dolly;
    Action action;
  } rows[] = {
      {"a move without a button", {Moved{{5, 5}}}, {}, {}, 0, Action::none},
      {"a left drag turns", {press(Button::left, 10, 10), Moved{{14, 9}}}, {4, -1}, {}, 0, Action::none},
      {"in several moves", {press(Button::left, 0, 0), Moved{{1, 0}}, Moved{{3, 4}}}, {3, 4}, {}, 0, Action::none},
      {"a right drag pans", {press(Button::right, 0, 0), Moved{{2, 3}}}, {}, {2, 3}, 0, Action::none},
      {"a middle drag pans", {press(Button::middle, 0, 0), Moved{{2, 3}}}, {}, {2, 3}, 0, Action::none},
      {"the release ends it",
       {press(Button::left, 0, 0), Moved{{1, 1}}, Released{Button::left}, Moved{{9, 9}}},
       {1, 1},
       {},
       0,
       Action::none},
      {"a second button changes nothing",
       {press(Button::left, 0, 0), press(Button::right, 0, 0), Released{Button::right}, Moved{{2, 0}}},
       {2, 0},
       {},
       0,
       Action::none},
      {"the wheel dollies", {Scrolled{2}, Scrolled{-0.5}}, {}, {}, 1.5, Action::none},
      {"two clicks reset",
       {press(Button::left, 5, 5, 1), Released{Button::left}, press(Button::left, 6, 5, 1.2)},
       {},
       {},
       0,
       Action::reset_camera},
      {"two slow clicks do not",
       {press(Button::left, 5, 5, 1), Released{Button::left}, press(Button::left, 5, 5, 2)},
       {},
       {},
       0,
       Action::none},
      {"two distant clicks do not",
       {press(Button::left, 5, 5, 1), press(Button::left, 50, 5, 1.1)},
       {},
       {},
       0,
       Action::none},
      {"two right clicks do not",
       {press(Button::right, 5, 5, 1), press(Button::right, 5, 5, 1.1)},
       {},
       {},
       0,
       Action::none},
      {"plus comes nearer", {Typed{Key::plus}}, {}, {}, 1, Action::none},
      {"Esc quits", {Typed{Key::escape}}, {}, {}, 0, Action::quit},
      {"S saves", {Typed{Key::s}}, {}, {}, 0, Action::save},
      {"R resets", {Typed{Key::r}}, {}, {}, 0, Action::reset_camera},
      {"H helps", {Typed{Key::h}}, {}, {}, 0, Action::help},
      {"Tab hides", {Typed{Key::tab}}, {}, {}, 0, Action::panel},
      {"Space plays", {Typed{Key::space}}, {}, {}, 0, Action::play},
      {"a lost content means nothing", {Exposed{}}, {}, {}, 0, Action::none},
  };
  for (const auto& row : rows) {
    INFO(row.name);
    const Gesture gesture = after(row.events);
    CHECK(gesture.turn == row.turn);
    CHECK(gesture.pan == row.pan);
    CHECK(gesture.dolly == row.dolly);
    CHECK(gesture.action == row.action);
  }
}

TEST_CASE("a digit names a scene", "[controls]") {
  const Gesture gesture = after({Typed{Key::digit, 4}});
  CHECK(gesture.action == Action::scene);
  CHECK(gesture.number == 4);
}

TEST_CASE("a third click is not another double click", "[controls]") {
  Controls controls;
  interpret(controls, press(Button::left, 0, 0, 0.0));
  CHECK(interpret(controls, press(Button::left, 0, 0, 0.1)).action == Action::reset_camera);
  CHECK(interpret(controls, press(Button::left, 0, 0, 0.2)).action == Action::none);
}

TEST_CASE("opposite arrow keys cancel each other", "[controls]") {
  CHECK(after({Typed{Key::left}, Typed{Key::right}, Typed{Key::up}, Typed{Key::down}}).arrow == glm::dvec2(0));
  CHECK(after({Typed{Key::left}}).arrow == glm::dvec2(-1, 0));
  CHECK(after({Typed{Key::up}}).arrow == glm::dvec2(0, 1));
}

TEST_CASE("one slow frame does not change the median frame time", "[controls]") {
  FrameTimes times;
  CHECK(times.median() == 0);
  times.add(5);
  CHECK(times.median() == 5);
  for (int i = 0; i < 30; ++i) times.add(0.01);
  CHECK(times.median() == 0.01);
  for (int i = 0; i < 31; ++i) times.add(0.02);  // the old ones are forgotten
  CHECK(times.median() == 0.02);
}
