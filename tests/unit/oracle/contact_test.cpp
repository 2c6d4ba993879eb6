// Self-shadowing and contact shadows, in worlds of a millimetre and of a hundred kilometres.
#include "catch.hpp"
#include "pieces.hpp"

namespace atelier::test {
namespace {

using oracle::Shading;
using oracle::Shadows;
using oracle::visibility;
using oracle::World;

/// A floor of 20 x 20 squares around the origin, and perhaps a box on it, `size` metres a side: turned out of all axes,
/// and shifted. Lengths and places in the floor's own space are in units of the size.
class Ground {
 public:
  Ground(double size, const glm::dvec3& shift, bool with_box) : size_(size), scene_(dark_scene()) {
    add_node(scene_, {.translation = shift * size,
                      .rotation_axis = {1, 2, -3},
                      .rotation_angle = 0.8f,
                      .scale = glm::vec3(float(size))});
    add_object(scene_, make_plane({.width = 20, .depth = 20, .columns = 7, .rows = 5}), 0, {.parent = 0});
    if (with_box) add_object(scene_, make_box({}), 0, {.parent = 0, .translation = {0, 0.5, 0}});
    to_world_ = world_matrices_exact(scene_.nodes)[0];
  }

  const Scene& scene() const { return scene_; }
  double size() const { return size_; }
  glm::dvec3 place(const glm::dvec3& at) const { return glm::dvec3(to_world_ * glm::dvec4(at, 1)); }
  glm::dvec3 way(const glm::dvec3& to) const { return glm::normalize(glm::dvec3(to_world_ * glm::dvec4(to, 0))); }

  /// A point of the floor as a ray from above sees it: its place is rounded as in a picture.
  oracle::SurfacePoint floor_at(const World& world, double x, double z) const {
    const auto seen = world.seen({place({x, 3, z}), -way({0, 1, 0})});
    REQUIRE(seen);
    return *seen;
  }

  /// Of one kind, towards whose middle one goes from the floor's origin; `distance` in sizes.
  Light light(LightType type, const glm::dvec3& towards, double distance) const {
    return {.type = type, .position = place(glm::normalize(towards) * distance), .direction = glm::vec3(-way(towards))};
  }

 private:
  double size_;
  Scene scene_;
  glm::dmat4 to_world_{1};
};

constexpr double sizes[] = {1e-3, 1, 1e5};
const glm::dvec3 shifts[] = {{0, 0, 0}, {30, -70, 50}};

}  // namespace

TEST_CASE("a plane at grazing light does not shade itself, at any scale", "[shadow]") {
  // A tenth of a degree above the floor. The light's own extent must stay above the horizon: half a milliradian does.
  const double climb = 0.1 * pi / 180;
  for (const double size : sizes)
    for (const glm::dvec3& shift : shifts) {
      const Ground ground(size, shift, false);
      const World world(ground.scene());
      Dice dice;
      for (int i = 0; i < 200; ++i) {
        const double turn = 2 * pi * dice.next();
        const glm::dvec3 towards(std::cos(climb) * std::cos(turn), std::sin(climb), std::cos(climb) * std::sin(turn));
        // Near the world's origin coordinates are small, and what is off by rounding in a large plane is not.
        const double reach = i % 2 == 0 ? 9 : 1e-5;
        const auto point = ground.floor_at(world, reach * (2 * dice.next() - 1), reach * (2 * dice.next() - 1));
        for (const LightType type : {LightType::point, LightType::spot, LightType::directional}) {
          INFO("size " << size << ", shift " << shift.x << ", point " << i << ", light " << int(type));
          // So far that it stands at 89.9 degrees to a third from everywhere on the floor.
          const Light light = ground.light(type, towards, 40);
          CHECK(visibility(world, point, light, {.shadows = Shadows::hard}) == 1);
          const double width = type == LightType::directional ? 5e-4 : 5e-4 * 30 * size;
          CHECK(visibility(world, point, light, {.shadows = Shadows::soft, .light_width = width, .light_samples = 8}) ==
                1);
        }
      }
    }
}

TEST_CASE("a box's shadow begins at the box, at any scale", "[shadow]") {
  for (const double size : sizes)
    for (const glm::dvec3& shift : shifts) {
      const Ground ground(size, shift, true);
      const World world(ground.scene());
      for (const LightType type : {LightType::point, LightType::spot, LightType::directional})
        for (const double along : {-0.4, 0.0, 0.45}) {
          INFO("size " << size << ", shift " << shift.x << ", light " << int(type) << ", at " << along);
          // The light stands towards -x, 40 degrees high: dark towards +x, right from the box's foot.
          const Light light = ground.light(type, {-1, std::tan(40 * pi / 180), 0.05}, 50);
          const Shading hard{.shadows = Shadows::hard};
          const Shading soft{.shadows = Shadows::soft,
                             .light_width = type == LightType::directional ? 0.01 : 0.5 * size,
                             .light_samples = 8};
          const auto dark_side = ground.floor_at(world, 0.5 + 1e-6, along),
                     lit_side = ground.floor_at(world, -0.5 - 1e-6, along);
          CHECK(visibility(world, dark_side, light, hard) == 0);
          CHECK(visibility(world, dark_side, light, soft) == 0);
          CHECK(visibility(world, lit_side, light, hard) == 1);
          CHECK(visibility(world, lit_side, light, soft) == 1);
        }
    }
}

TEST_CASE("a surface does not hide a light on it, at any scale", "[shadow]") {
  for (const double size : sizes)
    for (const glm::dvec3& shift : shifts) {
      const Ground ground(size, shift, false);
      const World world(ground.scene());
      Dice dice;
      for (int i = 0; i < 100; ++i) {
        INFO("size " << size << ", shift " << shift.x << ", point " << i);
        const double x = 8 * dice.next() - 4, z = 8 * dice.next() - 4;
        const Light light{.type = LightType::spot,
                          .position = ground.place({dice.next(), 0, dice.next()}),
                          .direction = glm::vec3(ground.way({0, 1, 0}))};
        const oracle::SurfacePoint above{.position = ground.place({x, 2, z}), .flat_normal = -ground.way({0, 1, 0})};
        // Of a light with an extent one half would stand below: its direction is three floats, by which it leans.
        const Shading hard{.shadows = Shadows::hard};
        CHECK(visibility(world, above, light, hard) == 1);
        CHECK(visibility(world, ground.floor_at(world, x, z), light, hard) == 1);
      }
    }
}

}  // namespace atelier::test
