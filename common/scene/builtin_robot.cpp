// A figure with jointed limbs: an example of a node hierarchy.
#include "scene/builder.hpp"
#include "scene/builtin_scenes.hpp"
#include "scene/shapes.hpp"
#include "scene/textures.hpp"

namespace atelier::builtin {
namespace {

constexpr glm::vec3 x_axis{1, 0, 0}, y_axis{0, 1, 0}, z_axis{0, 0, 1};

/// The figure's materials and its two shapes, of size 1 m. Joints have position and rotation; each visible part is a
/// leaf with its own scale, so that scales do not affect other limbs.
struct Kit {
  Scene& scene;
  int shell, steel, eyes;
  int box, rod;

  /// A joint at `at` (metres, in the parent's space), turned by `angle` degrees about `axis`.
  int joint(const std::string& name, int parent, const glm::dvec3& at, const glm::vec3& axis = x_axis,
            double angle = 0) const {
    return add_node(
        scene,
        {.name = name, .parent = parent, .translation = at, .rotation_axis = axis, .rotation_angle = degrees(angle)});
  }

  void part(int parent, int mesh, int material, const glm::dvec3& at, const glm::vec3& size) const {
    add_node(scene, {.name = scene.nodes[parent].name + " part",
                     .parent = parent,
                     .translation = at,
                     .scale = size,
                     .mesh = mesh,
                     .material = material});
  }
};

/// Angles in degrees; a limb that hangs straight down has all zero.
struct ArmPose {
  double raise, swing, bend, twist;
  glm::vec3 bend_axis;
};

void add_arm(const Kit& kit, int torso, const std::string& side, double x, const ArmPose& pose) {
  const int shoulder = kit.joint(side + " shoulder", torso, {x, 0.6, 0}, z_axis, pose.raise);
  kit.part(shoulder, kit.rod, kit.steel, {0, -0.1, 0}, {0.2f, 0.2f, 0.2f});
  const int upper_arm = kit.joint(side + " upper arm", shoulder, {0, -0.06, 0}, x_axis, pose.swing);
  kit.part(upper_arm, kit.box, kit.shell, {0, -0.26, 0}, {0.15f, 0.4f, 0.17f});
  const int elbow = kit.joint(side + " elbow", upper_arm, {0, -0.5, 0}, pose.bend_axis, pose.bend);
  kit.part(elbow, kit.rod, kit.steel, {0, -0.07, 0}, {0.13f, 0.14f, 0.13f});
  const int forearm = kit.joint(side + " forearm", elbow, {0, -0.05, 0});
  kit.part(forearm, kit.box, kit.shell, {0, -0.24, 0}, {0.13f, 0.36f, 0.14f});
  const int hand = kit.joint(side + " hand", forearm, {0, -0.44, 0}, y_axis, pose.twist);
  kit.part(hand, kit.box, kit.steel, {0, -0.04, 0}, {0.12f, 0.1f, 0.06f});
  for (const double finger : {-1.0, 1.0}) {
    const int knuckle = kit.joint(side + " finger", hand, {0.04 * finger, -0.08, 0}, z_axis, 16 * finger);
    kit.part(knuckle, kit.rod, kit.steel, {0, -0.16, 0}, {0.035f, 0.16f, 0.035f});
  }
}

void add_leg(const Kit& kit, int pelvis, const std::string& side, double x, double swing, double bend) {
  const int hip = kit.joint(side + " hip", pelvis, {x, -0.1, 0}, x_axis, swing);
  kit.part(hip, kit.box, kit.shell, {0, -0.24, 0}, {0.19f, 0.42f, 0.22f});
  const int knee = kit.joint(side + " knee", hip, {0, -0.5, 0}, x_axis, bend);
  kit.part(knee, kit.rod, kit.steel, {0, -0.06, 0}, {0.15f, 0.14f, 0.15f});
  kit.part(knee, kit.box, kit.shell, {0, -0.25, 0}, {0.17f, 0.38f, 0.2f});
  const int foot = kit.joint(side + " foot", knee, {0, -0.46, 0}, x_axis, -swing - bend);  // flat on the ground
  kit.part(foot, kit.box, kit.steel, {0, 0, 0.07}, {0.2f, 0.1f, 0.4f});
}

void add_figure(const Kit& kit) {
  // The head is listed before its parent torso, and the torso before pelvis and root: parents may be anywhere in the
  // list, so code that computes world matrices must not rely on their order.
  const int neck = kit.joint("neck", -1, {0, 0.72, 0}, y_axis, 22);
  const int head = kit.joint("head", neck, {0, 0.12, 0}, x_axis, 8);
  const int torso = kit.joint("torso", -1, {0, 0.1, 0}, x_axis, 4);
  const int pelvis = kit.joint("pelvis", -1, {0, 1.12, 0}, y_axis, -14);
  const int root = kit.joint("robot", -1, {0, 0, 0}, y_axis, 18);
  kit.scene.nodes[neck].parent = torso;
  kit.scene.nodes[torso].parent = pelvis;
  kit.scene.nodes[pelvis].parent = root;

  kit.part(neck, kit.rod, kit.steel, {0, 0, 0}, {0.14f, 0.14f, 0.14f});
  kit.part(head, kit.box, kit.shell, {0, 0.2, 0}, {0.46f, 0.36f, 0.4f});
  kit.part(head, kit.box, kit.eyes, {0, 0.24, 0.2}, {0.3f, 0.07f, 0.03f});
  kit.part(torso, kit.box, kit.shell, {0, 0.36, 0}, {0.72f, 0.7f, 0.42f});
  kit.part(torso, kit.box, kit.steel, {0, 0.42, 0.21}, {0.42f, 0.3f, 0.03f});
  kit.part(pelvis, kit.box, kit.steel, {0, 0, 0}, {0.5f, 0.2f, 0.34f});
  add_arm(kit, torso, "right", -0.44, {.raise = -14, .swing = -12, .bend = -38, .twist = 0, .bend_axis = x_axis});
  add_arm(kit, torso, "left", 0.44, {.raise = 118, .swing = 0, .bend = 48, .twist = 60, .bend_axis = z_axis});
  add_leg(kit, pelvis, "right", -0.18, 9, 5);
  add_leg(kit, pelvis, "left", 0.18, -9, 6);
}

}  // namespace

Scene robot() {
  Scene scene;
  const Image squares = make_checker({.squares = 2, .first = {0.3f, 0.3f, 0.31f}, .second = {0.22f, 0.23f, 0.25f}});
  const int ground = add_material(
      scene, {.name = "ground", .diffuse = {1, 1, 1}, .diffuse_texture = add_texture(scene, "squares", squares)});
  add_object(scene, make_plane({.width = 12, .depth = 12, .repeat = {12, 12}}), ground, {.name = "ground"});

  const Kit kit{
      .scene = scene,
      .shell = add_material(scene, plastic("shell", {0.85f, 0.42f, 0.06f}, 60)),
      .steel = add_material(scene, metal("steel", glm::vec3(0.82f), 40)),
      .eyes = add_material(scene, {.name = "eyes", .diffuse = glm::vec3(0), .emission = {0.1f, 0.7f, 0.9f}}),
      .box = add_mesh(scene, make_box()),
      .rod = add_mesh(scene, make_cylinder({.radius = 0.5f, .height = 1, .segments = 32})),
  };
  add_figure(kit);

  add_light(scene, {.name = "key", .position = {-2.5, 4.5, 4}, .colour = glm::vec3(28, 27, 25)});
  add_light(scene, {.name = "fill", .position = {4, 2, 2}, .colour = glm::vec3(3.2f, 4, 5.2f), .casts_shadow = false});
  scene.ambient = glm::vec3(0.06f);
  scene.background = {0.1f, 0.13f, 0.18f};
  scene.camera = {.eye = {0.6, 1.9, 5.4}, .target = {0.15, 1.28, 0}, .fov_y = degrees(36), .near = 0.2f, .far = 30};
  return scene;
}

}  // namespace atelier::builtin
