// A visitor's walk through all rooms of the gallery, by a script, with the student's functions. Given.
#pragma once

#include <string>
#include <vector>

#include "12-gallery/gallery.hpp"
#include "12-gallery/given/plan.hpp"
#include "app/step_program.hpp"
#include "case/settings.hpp"
#include "scene/scene.hpp"

namespace atelier {

/// "walk.seconds".
std::vector<SettingSpec> walk_settings();

/// A visitor who looks somewhere.
struct Guest {
  gallery::Visitor visitor;
  double heading = 0;  ///< radians, counter-clockwise seen from above; 0: towards -z
  double pitch = 0;    ///< radians above the horizon
};

/// The gallery as visitors meet it: its walls and paintings.
class Ground {
 public:
  explicit Ground(int segments);

  /// The guest after `seconds` at this velocity over the floor (x to the right of where they look, y ahead; m/s). Goes
  /// in steps of 1/60 s or less; who touches a painting from its front goes through it.
  Guest after(Guest guest, const glm::dvec2& walking, double seconds) const;

  /// Where the walk begins: in the middle of the hall.
  static Guest start();

  /// The guest after this time of the walk through all rooms.
  Guest walked(double seconds) const;

  /// One for each entry.
  struct Entry {
    double seconds = 0;
    glm::dvec3 position{0};
    int room = gallery::hall;
  };
  /// The walk, at multiples of `step` seconds.
  std::vector<Entry> diary(int count, double step) const;

 private:
  struct Script;
  void go_through_doors(Guest& guest) const;
  void advance(Guest& guest, Script& script, double seconds) const;

  std::vector<glm::dvec4> hall_, bedroom_;
  std::array<glm::dmat4, paintings_in_hall> paintings_;
};

/// The camera of a guest's eyes.
Camera eyes_of(const Guest& guest, Camera camera);

/// Where the visitor is by the settings: in a room, or in gallery::hall.
int visited_room(const Settings& settings);

/// The camera of a frame: the visitor's eyes, if the settings say that there is a walk.
Camera guests_camera(const Scene& scene, const Camera& camera, const Settings& settings);

/// What the window's controls do: the same as `after`. Sets "gallery.room".
Walker walk(const Walker& walker, const Walking& walking, double seconds, Settings& settings);

}  // namespace atelier
