// Parts of the scenes of step 07. Given.
#pragma once

#include "scene/scene.hpp"

namespace atelier {

/// A frame that stands at `at`, turned by quarter turns about y: exact in floats.
Node quarter_turned(const char* name, const glm::dvec3& at, int quarters);

inline constexpr float door_width = 1.5, door_height = 2.25;  // metres

/// Materials of a door.
struct Look {
  int opening = 0;
  int frame = 0;
};
Look add_look(Scene& scene, const glm::vec3& colour, bool two_sided = false);

/// A door: an opening in bars. Returns its node.
int add_door(Scene& scene, Node node, const Look& look, float width = door_width, float height = door_height);

/// Two doors that lead to each other.
void join(Scene& scene, int a, int b, const glm::vec3& colour);

/// A room whose floor is at y = 0, around (x, z): walls that show their insides, and a floor with a pattern.
void add_room(Scene& scene, double x, double z, const glm::vec3& size, int walls, int floor);

/// A material with a pattern of two colours.
int checkered(Scene& scene, const char* name, const Rgba& first, const Rgba& second);

/// A point light that casts no shadow.
void add_lamp(Scene& scene, const glm::dvec3& at, const glm::vec3& colour);

/// A body that goes through a door. Its node is in the door's frame; where it is behind the plane (z < 0) it has gone
/// through, and stands before the exit. Returns its node.
int add_traveller(Scene& scene, int entry, int exit, Mesh mesh, int material, Node node);

}  // namespace atelier
