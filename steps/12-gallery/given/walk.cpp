#include "12-gallery/given/walk.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace atelier {

std::vector<SettingSpec> walk_settings() {
  return {{.name = "walk.seconds",
           .fallback = 0.0,
           .low = 0,
           .high = 600,
           .help = "how long the visitor has walked through all rooms, by a script; 0: no walk, the camera's place"}};
}

namespace {

constexpr double tick = 1.0 / 60;            // seconds
constexpr double eye_above_centre = 0.725;   // metres
constexpr double clearance = 0.05;           // metres, between a visitor who has come out and the painting's plane
constexpr double jump = 2;                   // m/s
constexpr double pace = 1.6, turning = 2.5;  // m/s and radians/s, of the script

glm::dvec3 ahead_of(double heading) {
  return {-std::sin(heading), 0, -std::cos(heading)};
}

double heading_of(const glm::dvec3& direction) {
  return std::atan2(-direction.x, -direction.z);
}

/// The angle from one heading to another, the shorter way.
double turn_between(double from, double to) {
  return std::remainder(to - from, glm::two_pi<double>());
}

}  // namespace

Ground::Ground(int segments)
    : hall_(walls_of_hall(segments)), bedroom_(walls_of_bedroom()), paintings_(students_paintings(segments)) {}

/// Carries a guest who touches a painting through it.
void Ground::go_through_doors(Guest& guest) const {
  const gallery::Visitor before = guest.visitor;
  const auto enter = [&](const glm::dmat4& entry, const glm::dmat4& exit, int room) {
    guest.visitor = gallery::gone_through(before, entry, exit, room, clearance, jump);
    guest.heading += turn_between(heading_of(-glm::dvec3(entry[2])), heading_of(glm::dvec3(exit[2])));
  };
  if (before.room == gallery::hall) {
    for (int i = 0; i < paintings_in_hall; ++i)
      if (const glm::dmat4& painting = paintings_[std::size_t(i)];
          gallery::touches(painting, painting_half_size, before.position))
        return enter(painting, door_frame(), i);
  } else if (gallery::touches(door_frame(), painting_half_size, before.position)) {
    enter(door_frame(), paintings_[std::size_t(std::clamp(before.room, 0, paintings_in_hall - 1))], gallery::hall);
  }
}

Guest Ground::after(Guest guest, const glm::dvec2& walking, double seconds) const {
  while (seconds > 0) {
    const double step = std::min(seconds, tick);
    const glm::dvec3 ahead = ahead_of(guest.heading), right(-ahead.z, 0, ahead.x);
    const glm::dvec3 velocity = walking.x * right + walking.y * ahead;
    gallery::Visitor& visitor = guest.visitor;
    visitor = gallery::moved(visitor, {velocity.x, velocity.z}, step);
    visitor.position = gallery::held(visitor.room == gallery::hall ? hall_ : bedroom_, visitor.position);
    go_through_doors(guest);
    seconds -= step;
  }
  return guest;
}

Guest Ground::start() {
  return {.visitor = {.position = {0, gallery::visitor_half_size.y, 0}}};
}

/// What the guest does next: into room `next`, a few steps there, back to the hall and to its middle.
struct Ground::Script {
  int next = 0;
  bool turned_back = false;
};

void Ground::advance(Guest& guest, Script& script, double seconds) const {
  const gallery::Visitor& visitor = guest.visitor;
  const bool in_hall = visitor.room == gallery::hall;
  glm::dvec3 goal(0);
  if (in_hall && script.turned_back) {  // to the middle
    if (glm::length(glm::dvec2(visitor.position.x, visitor.position.z)) < 3.2) {
      script.turned_back = false;
      ++script.next;
    }
  } else if (in_hall) {
    goal = glm::dvec3(paintings_[std::size_t(script.next % paintings_in_hall)][3]);
  } else {
    if (visitor.position.z < bedroom_centre.z + 0.3) script.turned_back = true;
    // In every second room to a place behind the wall on the left, and so along it.
    const double aside = script.next % 2 == 0 ? -0.3 : -3;
    goal = script.turned_back ? glm::dvec3(door_frame()[3]) : bedroom_centre + glm::dvec3(aside, 0, -0.4);
  }
  const glm::dvec3 way = goal - visitor.position;
  const double turn = turn_between(guest.heading, heading_of(glm::dvec3(way.x, 0, way.z)));
  guest.heading += std::clamp(turn, -turning * seconds, turning * seconds);
  guest = after(guest, {0, std::abs(turn) < 0.5 ? pace * std::cos(turn) : 0}, seconds);
}

Guest Ground::walked(double seconds) const {
  Guest guest = start();
  Script script;
  for (int i = 0; i < int(std::floor(seconds / tick)); ++i) advance(guest, script, tick);
  return guest;
}

std::vector<Ground::Entry> Ground::diary(int count, double step) const {
  Guest guest = start();
  Script script;
  std::vector<Entry> entries;
  for (int i = 0; int(entries.size()) < count; ++i) {
    if (i * tick >= double(entries.size()) * step - 1e-9)
      entries.push_back({i * tick, guest.visitor.position, guest.visitor.room});
    advance(guest, script, tick);
  }
  return entries;
}

Camera eyes_of(const Guest& guest, Camera camera) {
  const glm::dvec3 level = ahead_of(guest.heading);
  camera.eye = guest.visitor.position + glm::dvec3(0, eye_above_centre, 0);
  camera.target = camera.eye + std::cos(guest.pitch) * level + glm::dvec3(0, std::sin(guest.pitch), 0);
  camera.up = {0, 1, 0};
  return camera;
}

int visited_room(const Settings& settings) {
  const double seconds = settings.real("walk.seconds");
  if (seconds == 0) return settings.integer("gallery.room");
  return Ground(settings.integer("hall.segments")).walked(seconds).visitor.room;
}

Camera guests_camera(const Scene&, const Camera& camera, const Settings& settings) {
  const double seconds = settings.real("walk.seconds");
  if (seconds == 0) return camera;
  return eyes_of(Ground(settings.integer("hall.segments")).walked(seconds), camera);
}

Walker walk(const Walker& walker, const Walking& walking, double seconds, Settings& settings) {
  const Ground ground(settings.integer("hall.segments"));
  const double script = settings.real("walk.seconds");
  Guest guest = ground.walked(script);
  if (script == 0) {
    const glm::dvec3 look = glm::normalize(walker.camera.target - walker.camera.eye);
    guest = {.visitor = {.position = walker.camera.eye - glm::dvec3(0, eye_above_centre, 0),
                         .velocity = walker.velocity,
                         .room = settings.integer("gallery.room")},
             .heading = heading_of(look),
             .pitch = std::asin(look.y)};
  }
  guest.heading += walking.turn.x;
  guest.pitch = std::clamp(guest.pitch + walking.turn.y, -1.5, 1.5);
  guest = ground.after(guest, walking.velocity, seconds);
  settings.set("gallery.room", std::clamp(guest.visitor.room, -1, paintings_in_hall - 1));
  settings.set("walk.seconds", 0.0);
  const bool flies = guest.visitor.position.y > gallery::visitor_half_size.y || guest.visitor.velocity.y > 0;
  return {.camera = eyes_of(guest, walker.camera), .velocity = flies ? guest.visitor.velocity : glm::dvec3(0)};
}

}  // namespace atelier
