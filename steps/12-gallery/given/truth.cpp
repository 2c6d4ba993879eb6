#include "12-gallery/given/truth.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "03-shadow-mapping/given/truth.hpp"
#include "05-normal-mapping/given/truth.hpp"
#include "06-parallax-mapping/given/relief_surface.hpp"
#include "06-parallax-mapping/given/truth.hpp"
#include "09-dithering/given/truth.hpp"
#include "10-artstyles/given/truth.hpp"
#include "12-gallery/given/exact_hall.hpp"
#include "12-gallery/given/previews.hpp"
#include "12-gallery/given/room_styles.hpp"
#include "12-gallery/given/scenes.hpp"
#include "app/picture.hpp"
#include "base/error.hpp"
#include "scene/builder.hpp"
#include "scene/shapes.hpp"

namespace atelier {

namespace {

// ---- The hall

/// The exact wall.
oracle::Shape round_wall(const Scene& scene, const Node& wall) {
  float repeat = 0;
  for (const Vertex& vertex : scene.meshes[std::size_t(*wall.mesh)].vertices)
    repeat = std::max(repeat, vertex.texcoord.x);
  return {
      .surface =
          oracle::CylinderWall{.radius = hall_radius, .height = hall_height, .inside = true, .repeat = double(repeat)},
      .object_to_world = glm::rotate(glm::dmat4(1), -glm::half_pi<double>(), glm::dvec3(0, 1, 0)),  // u = 0 at +z
      .material = wall.material};
}

// ---- Pictures of rooms

Camera exact_preview_camera(const glm::dmat4& exit) {
  const glm::dvec3 centre(exit[3]), ahead(exit[2]);
  return {.eye = centre - preview_distance * ahead,
          .target = centre,
          .up = {0, 1, 0},
          .fov_y = float(2 * std::atan(painting_half_size.y / preview_distance)),
          .near = float(preview_distance),
          .far = preview_far};
}

/// What a camera in a room, or in the hall, sees.
struct Seen {
  const Settings& settings;
  int room;

  gallery::Style style() const {
    if (!settings.flag("gallery.styles") || room < 0) return gallery::Style::none;
    return gallery::Style(room);
  }

  /// From the truth without style to that of the requested output: "colour", "relief", "relief_height", and all others.
  SceneTruth through(SceneTruth truth, TruthRequest request) const {
    const Settings own = settings_of(style(), settings);
    if (request.output == "relief_height") {
      const Camera camera = truth.camera.value_or(apply(request.camera, truth.scene.camera));
      truth.shading.surface = height_in_view(camera, recorded_range(settings));
      set_background(truth.scene, glm::vec3(0));
      truth.output = request.output = "colour";
      return style() == gallery::Style::fisheye ? in_styles(std::move(truth), request, own) : truth;
    }
    if (request.output == "relief") return in_styles(std::move(truth), request, own);
    if (request.output != "colour") return truth;
    return style() == gallery::Style::floyd_steinberg ? in_few_levels(std::move(truth), request, own)
                                                      : in_styles(std::move(truth), request, own);
  }
};

/// The scene of a truth, and what it needs to record the previews.
class Studio {
 public:
  Studio(SceneTruth& truth, const TruthRequest& request, const Settings& settings)
      : truth_(truth),
        request_(request),
        settings_(settings),
        plain_(truth),
        world_(world_matrices_exact(truth.scene.nodes)),
        camera_(apply(request.camera, truth.scene.camera)) {}

  /// Replaces the plain canvases of all paintings that may be in view by their pictures.
  void hang() {
    const int visited = settings_.integer("gallery.room");
    for (int i = 0; i < paintings_in_hall; ++i) hang(i, i, paintings_in_hall);
    hang(paintings_in_hall, gallery::hall, std::max(visited, 0));
  }

 private:
  std::size_t node_of(int painting) const {
    const auto& nodes = truth_.scene.nodes;
    return std::size_t(std::ranges::find(nodes, painting_name(painting), &Node::name) - nodes.begin());
  }

  /// Whether a painting's front is seen from the eye, and part of it lies ahead.
  bool may_be_in_view(const glm::dmat4& frame) const {
    if (glm::dot(glm::dvec3(frame[2]), camera_.eye - glm::dvec3(frame[3])) <= 0) return false;
    for (const double x : {-1.0, 1.0}) {
      const glm::dvec3 side(frame * glm::dvec4(x * painting_half_size.x, 0, 0, 1));
      if (glm::dot(side - camera_.eye, camera_.target - camera_.eye) > 0) return true;
    }
    return false;
  }

  Image recorded(int room, const Camera& camera, const char* output) const {
    TruthRequest request = request_;
    const int size = settings_.integer("preview.size");
    request.size = {size, size};
    request.output = output;
    request.samples = 1;
    request.progress = nullptr;
    SceneTruth truth = plain_;
    truth.camera = camera;
    truth.output.clear();
    return trace_scene(Seen{settings_, room}.through(std::move(truth), request), request, {}, settings_);
  }

  void hang(int painting, int room, int exit) {
    Node& node = truth_.scene.nodes[node_of(painting)];
    const glm::dmat4& frame = world_[node_of(painting)];
    const bool portal = std::ranges::any_of(truth_.scene.portals,
                                            [&](const Portal& p) { return std::size_t(p.node) == node_of(painting); });
    if (portal || !may_be_in_view(frame)) return;
    const Camera camera = exact_preview_camera(world_[node_of(exit)]);
    const Material& material = truth_.scene.materials[std::size_t(node.material)];
    const auto set = [&](const TextureIndex& index, const char* output) {
      truth_.scene.textures[std::size_t(*index)].pixels = recorded(room, camera, output);
    };
    set(material.diffuse_texture, "colour");
    if (!settings_.flag("preview.relief")) return;
    set(material.normal_texture, "relief");
    set(material.height_texture, "relief_height");
    if (settings_.choice("parallax.method") == "none" || settings_.real("parallax.depth") == 0) return;
    // A plane that lies on the floor is turned up to stand in the frame.
    Node plane = node;
    plane.mesh = add_mesh(
        truth_.scene, make_plane({.width = float(2 * painting_half_size.x), .depth = float(2 * painting_half_size.y)}));
    const glm::dmat4 upright = glm::rotate(glm::dmat4(1), glm::half_pi<double>(), glm::dvec3(1, 0, 0));
    truth_.shapes.push_back(relief_shape(truth_.scene, plane, frame * upright, settings_));
    truth_.shapes.back().casts_shadow = false;
    truth_.scene.nodes[node_of(painting)].mesh.reset();
  }

  SceneTruth& truth_;
  const TruthRequest& request_;
  const Settings& settings_;
  SceneTruth plain_;  ///< whose paintings are plain canvases
  std::vector<glm::dmat4> world_;
  Camera camera_;
};

}  // namespace

SceneTruth gallery_truth(const TruthRequest& request, const Settings& settings, std::optional<Scene> model) {
  if (settings.real("walk.seconds") > 0)
    throw Error("walk.seconds above 0 has no ground truth: the walk depends on your functions");
  const bool imported = model.has_value();
  const int segments = settings.integer("hall.segments");
  if (!model) model = gallery_with(exact_hall(segments), settings);
  TruthRequest before = request;
  if (request.output == "relief" || request.output == "relief_height") before.output = "colour";
  SceneTruth truth = normal_mapping_truth(before, settings, std::move(model));
  use_shadows(truth.shading, settings);
  if (imported) return truth;
  const int most = settings.integer("preview.most");
  if (most > 0 && most < paintings_in_hall)
    throw Error(
        fmt::format("preview.most={} has no ground truth, as previews are then recorded over several frames; 0 "
                    "has one, and {} and more",
                    most, paintings_in_hall));
  truth.shading.portal_depth = settings.integer("portals.depth");
  const auto wall = std::ranges::find(truth.scene.nodes, "wall", &Node::name);
  truth.shapes.push_back(round_wall(truth.scene, *wall));
  wall->mesh.reset();
  if (most > 0) Studio(truth, request, settings).hang();
  return Seen{settings, settings.integer("gallery.room")}.through(std::move(truth), request);
}

}  // namespace atelier
