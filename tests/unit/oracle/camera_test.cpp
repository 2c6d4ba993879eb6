// The ray of a pixel, and the depth of a point.
#include <glm/gtc/matrix_transform.hpp>

#include "catch.hpp"
#include "pieces.hpp"

namespace atelier::test {
namespace {

using oracle::CameraRays;

Camera perspective_camera() {
  return {.eye = {3, 2, 5}, .target = {-1, 0.5, -2}, .fov_y = 1.1f, .near = 0.25f, .far = 40};
}

Camera orthographic_camera() {
  Camera camera = perspective_camera();
  camera.projection = Projection::orthographic;
  camera.height = 6;
  camera.near = -3;
  return camera;
}

/// The matrices of OpenGL's own conventions, from glm, in double precision.
glm::dmat4 clip_from_world(const Camera& camera, double aspect) {
  const glm::dmat4 view = glm::lookAt(camera.eye, camera.target, glm::dvec3(camera.up));
  const double half = double(camera.height) / 2;
  return (camera.projection == Projection::perspective
              ? glm::perspective(double(camera.fov_y), aspect, double(camera.near), double(camera.far))
              : glm::ortho(-half * aspect, half * aspect, -half, half, double(camera.near), double(camera.far))) *
         view;
}

}  // namespace

TEST_CASE("a point on a pixel's ray is projected into that pixel, at that depth", "[camera]") {
  const glm::ivec2 size(37, 20);
  for (const Camera& camera : {perspective_camera(), orthographic_camera()}) {
    const CameraRays rays(camera, size);
    const glm::dmat4 clip_from = clip_from_world(camera, double(size.x) / size.y);
    Dice dice;
    for (int i = 0; i < 200; ++i) {
      const glm::dvec2 pixel(dice.next() * size.x, dice.next() * size.y);
      const oracle::Ray ray = rays.through(pixel);
      const double z = ray.least + dice.next() * (ray.most - ray.least);
      const glm::dvec4 clip = clip_from * glm::dvec4(ray.at(z), 1);
      const glm::dvec3 device = glm::dvec3(clip) / clip.w;
      // Twenty roundings of numbers up to 40, divided by a near plane of 0.25.
      CHECK(std::abs((device.x + 1) / 2 * size.x - pixel.x) < 1e-11);
      CHECK(std::abs((1 - device.y) / 2 * size.y - pixel.y) < 1e-11);  // row 0 on top
      CHECK(std::abs((device.z + 1) / 2 - rays.depth(z, false)) < 1e-13);
    }
  }
}

TEST_CASE("depth runs from plane to plane, normal or reversed", "[camera]") {
  for (const Camera& camera : {perspective_camera(), orthographic_camera()}) {
    const CameraRays rays(camera, {8, 8});
    const double near = camera.near, far = camera.far;
    CHECK(rays.depth(near, false) == 0);
    CHECK(rays.depth(far, false) == Approx(1).epsilon(1e-15));
    CHECK(rays.depth(near, true) == Approx(1).epsilon(1e-15));
    CHECK(rays.depth(far, true) == 0);
    for (const double z : {near + 0.1, 1.0, 7.0, 39.0})
      CHECK(std::abs(rays.depth(z, true) + rays.depth(z, false) - 1) < 1e-15);
  }
  Camera endless = perspective_camera();
  endless.far = std::numeric_limits<float>::infinity();
  CHECK(CameraRays(endless, {8, 8}).depth(10, true) == 0.025);
  CHECK(CameraRays(endless, {8, 8}).depth(10, false) == 0.975);
}

TEST_CASE("nothing before the near plane or behind the far plane is seen", "[camera]") {
  Scene scene = dark_scene();
  add_object(scene, make_plane({.width = 100, .depth = 100}), 0);
  const oracle::World world(scene);
  Camera camera{.eye = {0, 2, 0}, .target = {0, 0, 0}, .up = {0, 0, -1}, .near = 1, .far = 3};
  const auto sees = [&] { return world.seen(CameraRays(camera, {1, 1}).through({0.5, 0.5})).has_value(); };
  CHECK(sees());
  camera.near = 2.01f;
  CHECK_FALSE(sees());
  camera.near = 1, camera.far = 1.99f;
  CHECK_FALSE(sees());
}

TEST_CASE("a ray along a direction of view space is that of the pixel which shows it", "[camera]") {
  const Camera camera{.eye = {1, 2, 3}, .target = {4, -1, 2}, .up = {0.2f, 1, 0}, .fov_y = 1.2f};
  const glm::ivec2 size(40, 30);
  const CameraRays rays(camera, size);
  const double above = std::tan(double(camera.fov_y) / 2);
  for (const glm::dvec2 pixel : {glm::dvec2(0, 0), glm::dvec2(20, 15), glm::dvec2(33.5, 7.25)}) {
    const glm::dvec3 direction((2 * pixel.x - size.x) / size.y * above, (size.y - 2 * pixel.y) / size.y * above, -1);
    CHECK(glm::length(rays.along(direction).direction - rays.through(pixel).direction) < 1e-14);
  }
  CHECK(glm::dot(rays.along({0, 0, 1}).direction, camera.target - camera.eye) < 0);  // behind the eye
}

TEST_CASE("a lens replaces the projection", "[camera]") {
  Scene scene = dark_scene();
  scene.background = glm::vec3(0.5f);
  scene.ambient = glm::vec3(1);
  add_object(scene, make_plane({.width = 100, .depth = 100}), 0);
  const oracle::World world(scene);
  oracle::PictureRequest request{.camera = {.eye = {1, 2, 0}, .target = {1, 2, -1}, .near = 0.1f, .far = 1000},
                                 .size = {4, 4},
                                 .output = oracle::Output::position};
  // Each place looks straight down, but the left half sees nothing.
  request.lens = [](const glm::dvec2& place) {
    return place.x < 0.5 ? std::optional<glm::dvec3>() : glm::dvec3(0, -3, 0);
  };
  const Image positions = oracle::trace(world, request);
  CHECK(positions.at(0, 1) == Rgba{0, 0, 0, 1});
  CHECK(positions.at(3, 1).r == 1);
  CHECK(std::abs(positions.at(3, 1).g) < 1e-6f);
  // The near plane is at multiples of the direction's length: the floor is 2 m away.
  request.camera.near = 0.66f;
  CHECK(oracle::trace(world, request).at(3, 1).r == 1);
  request.camera.near = 0.7f;
  CHECK(oracle::trace(world, request).at(3, 1).r == 0);
  request.output = oracle::Output::colour;
  CHECK(oracle::trace(world, request).at(0, 1) == Rgba{0, 0, 0, 1});  // not the background
  request.output = oracle::Output::depth;
  CHECK_THROWS_AS(oracle::trace(world, request), Error);
}

TEST_CASE("a camera that looks along its up vector uses the axis of the contract", "[camera]") {
  const struct {
    const char* name;
    glm::dvec3 target;
    glm::vec3 up;
    glm::dvec3 upwards;  ///< the way that is up in the picture
  } rows[] = {
      // |direction| is (0, 1, 0): x has the smallest component, and comes before z.
      {"straight down", {0, -5, 0}, {0, 1, 0}, {1, 0, 0}},  {"straight up", {0, 5, 0}, {0, 1, 0}, {1, 0, 0}},
      {"along x", {5, 0, 0}, {1, 0, 0}, {0, 1, 0}},         {"no up vector", {0, 0, -5}, {0, 0, 0}, {1, 0, 0}},
      {"up at a slant", {0, 0, -5}, {0, 3, -4}, {0, 1, 0}},
  };
  for (const auto& row : rows) {
    INFO(row.name);
    const CameraRays rays({.eye = {0, 0, 0}, .target = row.target, .up = row.up}, {2, 2});
    const glm::dvec3 up = rays.through({1, 0}).direction - rays.through({1, 2}).direction;
    CHECK(glm::length(glm::normalize(up) - row.upwards) < 1e-15);
  }
}

}  // namespace atelier::test
