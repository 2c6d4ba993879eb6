#include "scene/box.hpp"

#include <cmath>

#include "catch.hpp"
#include "scene/scene.hpp"

using namespace atelier;

TEST_CASE("a box's corners are numbered by bits: x, y, z", "[scene]") {
  const Box3 box{{1, 2, 3}, {4, 5, 6}};
  const auto corners = corners_of(box);
  CHECK(corners[0] == glm::dvec3(1, 2, 3));
  CHECK(corners[1] == glm::dvec3(4, 2, 3));
  CHECK(corners[2] == glm::dvec3(1, 5, 3));
  CHECK(corners[4] == glm::dvec3(1, 2, 6));
  CHECK(corners[7] == glm::dvec3(4, 5, 6));
  const auto moved = corners_of(box, glm::dmat4(2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 10, 0, -3, 1));
  CHECK(moved[0] == glm::dvec3(12, 2, 0));
  CHECK(moved[7] == glm::dvec3(18, 5, 3));
}

TEST_CASE("a box and a sphere around points contain them all; around none they are empty", "[scene]") {
  const std::vector<glm::dvec3> points = {{0, 0, 0}, {2, 0, 0}, {1, 4, -6}};
  const Box3 box = box_around(points);
  CHECK(box.low == glm::dvec3(0, 0, -6));
  CHECK(box.high == glm::dvec3(2, 4, 0));
  const Ball ball = ball_around(points);
  CHECK(ball.centre == glm::dvec3(1, 2, -3));
  CHECK(ball.radius == std::sqrt(14.0));  // of the first two; the third is sqrt(13) away
  CHECK(box_around(std::vector<glm::dvec3>{}).empty());
  CHECK(ball_around({}).radius == 0);
  CHECK(ball_around({}).centre == glm::dvec3(0));
}

TEST_CASE("a mesh's box, transformed, and a box around boxes", "[scene]") {
  const Mesh mesh{.vertices = {Vertex{.position = {3, 1, 2}}, Vertex{.position = {0, 5, 2}}}};
  const Box3 box = box_around(mesh),
             moved = box_around(mesh, glm::dmat4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 7, 1));
  CHECK(box.low == glm::dvec3(0, 1, 2));
  CHECK(box.high == glm::dvec3(3, 5, 2));
  CHECK(moved.low == glm::dvec3(0, 1, 9));
  Box3 both;
  for (const Box3& part : {Box3{}, box, moved}) both.add(part);
  CHECK(both.low == glm::dvec3(0, 1, 2));
  CHECK(both.high == glm::dvec3(3, 5, 9));
}
