#include "scene_import/gltf_scene.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "scene_import/gltf_file.hpp"
#include "scene_import/gltf_materials.hpp"
#include "scene_import/gltf_mesh.hpp"
#include "scene_import/gltf_skin.hpp"
#include "scene_import/scene_import.hpp"
#include "scene_import/tangents.hpp"

namespace atelier::scene_import {
namespace {

/// One drawable part of a glTF mesh.
struct Part {
  int mesh, material;  ///< in the scene
};

/// Traverses the file once, node by node, and fills the scene.
class GltfReader {
 public:
  GltfReader(GltfFile file, Imported& result)
      : file_(std::move(file)), result_(result), scene_(result.scene), materials_(file_, scene_) {}

  void read();

 private:
  std::vector<int> root_nodes() const;
  int add_node(int index, int parent);
  void place(Node& node, const JsonField& field) const;
  std::vector<Part> read_parts(int mesh, const SkinnedNode* skinned);
  const std::vector<Part>& parts_of(int mesh);
  void add_parts(int node, const std::vector<Part>& parts);
  void read_skinned_meshes();
  int checked_add(Node node);
  void read_camera(const JsonField& field, const glm::dmat4& world);
  void read_light(const JsonField& field, const glm::dmat4& world);
  void read_views_and_lights();

  GltfFile file_;
  Imported& result_;
  Scene& scene_;
  GltfMaterials materials_;
  Budget budget_;
  std::map<int, std::vector<Part>> parts_;      ///< by glTF mesh
  std::vector<std::pair<int, int>> instances_;  ///< glTF node, scene node
  std::vector<std::pair<int, int>> skinned_;    ///< the same, of meshes with a skin
};

void GltfReader::read() {
  struct Step {
    int index, parent;
  };
  const std::size_t count = file_.root().size_or_zero("nodes");
  std::vector<bool> seen(count, false);
  std::vector<Step> steps;
  const std::vector<int> roots = root_nodes();
  for (auto root = roots.rbegin(); root != roots.rend(); ++root) steps.push_back({*root, -1});
  // In the file's order: what is put on the stack last comes first. An explicit stack instead of recursion: a chain of
  // a million nodes must not overflow the call stack.
  while (!steps.empty()) {
    const Step step = steps.back();
    steps.pop_back();
    const JsonField field = file_.root().at("nodes")[std::size_t(step.index)];
    if (seen[step.index]) field.fail("the node has two parents, or is its own ancestor");
    seen[step.index] = true;
    const int node = add_node(step.index, step.parent);
    const auto children = field.find("children");
    for (std::size_t i = children ? children->size() : 0; i > 0; --i)
      steps.push_back({(*children)[i - 1].index(count), node});
  }
  if (file_.root().size_or_zero("animations") > 0)
    file_.notes->add(fmt::format("{}: animations are left out: all is as the nodes place it", file_.name));
  read_views_and_lights();
  read_skinned_meshes();
}

std::vector<int> GltfReader::root_nodes() const {
  const JsonField root = file_.root();
  const std::size_t count = root.size_or_zero("nodes"), scenes = root.size_or_zero("scenes");
  const auto chosen = root.find("scene");
  std::vector<int> roots;
  if (chosen || scenes > 0) {
    const int index = chosen ? chosen->index(scenes) : 0;
    const auto nodes = root.at("scenes")[std::size_t(index)].find("nodes");
    for (std::size_t i = 0; nodes && i < nodes->size(); ++i) roots.push_back((*nodes)[i].index(count));
    return roots;
  }
  // No scene: all nodes without a parent.
  std::vector<bool> is_child(count, false);
  for (std::size_t n = 0; n < count; ++n) {
    const auto children = root.at("nodes")[n].find("children");
    for (std::size_t i = 0; children && i < children->size(); ++i)
      is_child[std::size_t((*children)[i].index(count))] = true;
  }
  for (std::size_t n = 0; n < count; ++n)
    if (!is_child[n]) roots.push_back(int(n));
  return roots;
}

int GltfReader::checked_add(Node node) {
  if (scene_.nodes.size() >= max_import_nodes) file_.root().fail(fmt::format("more than {} nodes", max_import_nodes));
  scene_.nodes.push_back(std::move(node));
  return int(scene_.nodes.size()) - 1;
}

int GltfReader::add_node(int index, int parent) {
  const JsonField field = file_.root().at("nodes")[std::size_t(index)];
  Node node{.name = field.text_or("name", fmt::format("node {}", index)), .parent = parent};
  place(node, field);
  const int added = checked_add(std::move(node));
  instances_.emplace_back(index, added);
  const auto mesh = field.index_or_none("mesh", file_.root().size_or_zero("meshes"));
  const auto skin = field.index_or_none("skin", file_.root().size_or_zero("skins"));
  if (mesh && skin)
    skinned_.emplace_back(index, added);
  else if (mesh)
    add_parts(added, parts_of(*mesh));
  return added;
}

void GltfReader::place(Node& node, const JsonField& field) const {
  if (const auto matrix = field.find("matrix")) {
    const std::vector<double> m = matrix->numbers(16);
    node.matrix.emplace();
    for (int i = 0; i < 16; ++i) (*node.matrix)[i / 4][i % 4] = float(m[std::size_t(i)]);  // both column-major
    return;
  }
  const auto t = field.numbers_or("translation", {0, 0, 0}), s = field.numbers_or("scale", {1, 1, 1});
  const auto q = field.numbers_or("rotation", {0, 0, 0, 1});  // x, y, z, w
  node.translation = {t[0], t[1], t[2]};
  node.scale = glm::vec3(s[0], s[1], s[2]);
  // A unit quaternion is (axis sin(angle/2), cos(angle/2)); atan2 also works if it is not exactly unit length.
  const glm::dvec3 v(q[0], q[1], q[2]);
  const double sine = glm::length(v);
  if (sine == 0 && q[3] == 0) field.fail("the rotation is a quaternion of length zero");
  if (sine == 0) return;
  node.rotation_axis = glm::vec3(v / sine);
  node.rotation_angle = float(2 * std::atan2(sine, q[3]));
}

std::vector<Part> GltfReader::read_parts(int mesh, const SkinnedNode* skinned) {
  const JsonField field = file_.root().at("meshes")[std::size_t(mesh)];
  const std::string name = field.text_or("name", fmt::format("mesh {}", mesh));
  const JsonField primitives = field.at("primitives");
  std::vector<Part> parts;
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    const JsonField primitive = primitives[i];
    const auto material = primitive.index_or_none("material", file_.root().size_or_zero("materials"));
    auto read = read_primitive(file_, primitive, materials_.transform(material), skinned, budget_);
    if (!read) continue;
    read->name = primitives.size() == 1 ? name : fmt::format("{} part {}", name, i);
    const int used = materials_.material(material);
    if (read->tangents.empty() && scene_.materials[used].normal_texture) add_standard_tangents(*read);
    scene_.meshes.push_back(std::move(*read));
    parts.push_back({int(scene_.meshes.size()) - 1, used});
  }
  return parts;
}

const std::vector<Part>& GltfReader::parts_of(int mesh) {
  if (const auto found = parts_.find(mesh); found != parts_.end()) return found->second;
  return parts_[mesh] = read_parts(mesh, nullptr);
}

void GltfReader::add_parts(int node, const std::vector<Part>& parts) {
  // The first part belongs to the node itself, each further one to a child with identity transform.
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const int holder =
        i == 0 ? node : checked_add({.name = fmt::format("{} part {}", scene_.nodes[node].name, i), .parent = node});
    scene_.nodes[holder].mesh = parts[i].mesh;
    scene_.nodes[holder].material = parts[i].material;
  }
}

/// Shapes that follow joints are in the world: each has a root of its own beside the node that names it, which keeps
/// its children. Read last, when all joints are known.
void GltfReader::read_skinned_meshes() {
  if (skinned_.empty()) return;
  const std::vector<glm::dmat4> world = world_matrices_exact(scene_.nodes);
  std::vector<const glm::dmat4*> places(file_.root().size_or_zero("nodes"), nullptr);
  for (const auto& [index, node] : instances_) places[std::size_t(index)] = &world[std::size_t(node)];
  std::map<int, std::optional<Skin>> skins;
  for (const auto& [index, node] : skinned_) {
    const JsonField field = file_.root().at("nodes")[std::size_t(index)];
    const int mesh = field.at("mesh").index(file_.root().size_or_zero("meshes"));
    const int number = field.at("skin").index(file_.root().size_or_zero("skins"));
    if (!skins.contains(number))
      skins[number] = read_skin(file_, number, [&](int joint) { return places[std::size_t(joint)]; });
    if (const std::optional<Skin>& skin = skins[number]) {
      const SkinnedNode skinned{*skin, world[std::size_t(node)]};
      const std::vector<Part> parts = read_parts(mesh, &skinned);
      add_parts(checked_add({.name = scene_.nodes[node].name + " skinned", .translation = skin->origin}), parts);
    } else {
      add_parts(node, parts_of(mesh));
    }
  }
}

void GltfReader::read_views_and_lights() {
  const std::vector<glm::dmat4> world = world_matrices_exact(scene_.nodes);
  for (const auto& [index, node] : instances_) {
    const JsonField field = file_.root().at("nodes")[std::size_t(index)];
    const auto camera = field.index_or_none("camera", file_.root().size_or_zero("cameras"));
    if (camera && !result_.has_camera) read_camera(file_.root().at("cameras")[std::size_t(*camera)], world[node]);

    const auto extensions = field.find("extensions");
    const auto light = extensions ? extensions->find("KHR_lights_punctual") : std::nullopt;
    if (!light) continue;
    const JsonField lights = file_.root().at("extensions").at("KHR_lights_punctual").at("lights");
    read_light(lights[std::size_t(light->at("light").index(lights.size()))], world[node]);
  }
}

/// Cameras and lights look along their node's -z, with +y up.
void GltfReader::read_camera(const JsonField& field, const glm::dmat4& world) {
  const glm::dvec3 ahead = -glm::dvec3(world[2]), up(world[1]);
  if (!(glm::length(ahead) > 0) || !(glm::length(up) > 0)) {
    file_.notes->add(fmt::format("{}: a camera is left out: its node's scale is zero", file_.name));
    return;
  }
  Camera camera;
  camera.eye = glm::dvec3(world[3]);
  camera.target = camera.eye + glm::normalize(ahead);
  camera.up = glm::vec3(glm::normalize(up));
  const std::string type = field.at("type").text();
  if (type == "perspective") {
    const JsonField lens = field.at("perspective");
    constexpr double widest = 179 * std::numbers::pi / 180;
    camera.fov_y = float(lens.at("yfov").number());
    if (!(camera.fov_y > 0 && camera.fov_y <= float(widest)))
      lens.at("yfov").fail(fmt::format("{} radians (allowed: above 0, at most 179 degrees)", camera.fov_y));
    camera.near = float(lens.at("znear").number());
    if (!(camera.near > 0)) lens.at("znear").fail(fmt::format("{} (allowed: above 0)", camera.near));
    camera.far = float(lens.number_or("zfar", 0));  // 0: infinite; set when the scene's size is known
  } else if (type == "orthographic") {
    const JsonField lens = field.at("orthographic");
    camera.projection = Projection::orthographic;
    camera.height = float(2 * std::abs(lens.at("ymag").number()));  // ymag is half the height
    camera.near = float(lens.at("znear").number());
    camera.far = float(lens.at("zfar").number());
    if (!(camera.height > 0)) lens.at("ymag").fail("it must not be zero");
  } else {
    field.at("type").fail(fmt::format("'{}' (allowed: perspective, orthographic)", type));
  }
  scene_.camera = camera;
  result_.has_camera = true;
}

/// KHR_lights_punctual: intensity in candela (point, spot) or lux (directional), used as radiance at one metre.
void GltfReader::read_light(const JsonField& field, const glm::dmat4& world) {
  Light light{.name = field.text_or("name", "light")};
  const std::string type = field.at("type").text();
  if (type == "spot")
    light.type = LightType::spot;
  else if (type == "directional")
    light.type = LightType::directional;
  else if (type != "point")
    field.at("type").fail(fmt::format("'{}' (allowed: point, spot, directional)", type));

  const auto colour = field.numbers_or("color", {1, 1, 1});
  const double intensity = std::max(field.number_or("intensity", 1), 0.0);
  light.colour = float(intensity) * glm::max(glm::vec3(colour[0], colour[1], colour[2]), glm::vec3(0));
  light.position = glm::dvec3(world[3]);
  if (field.find("range"))
    file_.notes->add(
        fmt::format("{}: the range of lights is left out: they reach as far as they are bright", file_.name));
  const glm::dvec3 ahead = -glm::dvec3(world[2]);
  if (glm::length(ahead) > 0) light.direction = glm::vec3(glm::normalize(ahead));
  if (const auto spot = field.find("spot")) {
    const double outer = std::clamp(spot->number_or("outerConeAngle", std::numbers::pi / 4), 0.0, std::numbers::pi / 2);
    light.outer_angle = float(outer);
    light.inner_angle = float(std::clamp(spot->number_or("innerConeAngle", 0), 0.0, outer));
  } else if (light.type == LightType::spot) {
    light.inner_angle = 0;
    light.outer_angle = std::numbers::pi_v<float> / 4;
  }
  scene_.lights.push_back(std::move(light));
}

}  // namespace

Imported read_gltf(const std::filesystem::path& path, Notes& notes) {
  Imported result;
  GltfReader(open_gltf(path, notes), result).read();
  return result;
}

}  // namespace atelier::scene_import
