#include "07-stencil-portals/given/portal_views.hpp"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

#include "07-stencil-portals/stencil_portals.hpp"
#include "render/bind_viewpoint.hpp"

namespace atelier {

using namespace stencil_portals;

std::vector<SettingSpec> portal_settings() {
  return {
      {.name = "portals.depth",
       .fallback = 4,
       .low = 0,
       .high = 255,
       .help = "how many openings are seen through one another; an opening that is deeper shows its plain colour"},
      {.name = "portals.clip",
       .fallback = std::string("distance"),
       .choices = {"none", "discard", "distance", "oblique"},
       .help =
           "how a view loses what stands before the exit: not at all, fragment by fragment, by clip distances, or by "
           "an oblique near plane"},
      {.name = "portals.scissor",
       .fallback = true,
       .help = "draw each view in the rectangle of its opening alone, and none where that is empty"},
      {.name = "portals.smallest",
       .fallback = 1,
       .low = 1,
       .high = 1024,
       .help = "pixels: an opening whose rectangle is narrower or lower shows its plain colour"},
      {.name = "world.camera_relative",
       .fallback = false,
       .help = "translate the world so that the eye is its origin, in double precision, before conversion to float"},
  };
}

namespace {

double distance(const glm::dvec4& plane, const glm::dvec3& point) {
  return glm::dot(plane, glm::dvec4(point, 1));
}

glm::dvec3 eye_of(const Viewpoint& view) {
  return glm::dvec3(glm::inverse(glm::dmat4(view.world_to_view))[3]) + view.origin;
}

}  // namespace

void PortalViews::configure(const Settings& settings) {
  deepest_ = settings.integer("portals.depth");
  smallest_ = settings.integer("portals.smallest");
  scissor_ = settings.flag("portals.scissor");
  const std::string& clip = settings.choice("portals.clip");
  clip_ = clip == "discard"    ? Clip::discard
          : clip == "distance" ? Clip::distance
          : clip == "oblique"  ? Clip::oblique
                               : Clip::none;
}

void PortalViews::prepare(Gl&, const Scene& scene) {
  place(scene);
}

void PortalViews::moved(const Scene& scene) {
  place(scene);
}

void PortalViews::place(const Scene& scene) {
  openings_.clear();
  if (scene.portals.empty()) return;
  const std::vector<glm::dmat4> world = world_matrices_exact(scene.nodes);
  for (const Portal& portal : scene.portals) {
    const Node& node = scene.nodes[std::size_t(portal.node)];
    Opening opening{.node = portal.node, .frame = world[std::size_t(portal.node)], .mirror = !portal.exit};
    opening.exit = world[std::size_t(portal.exit.value_or(portal.node))];
    opening.passage = portal.exit ? portal_passage(opening.frame, opening.exit) : mirror_passage(opening.frame);
    opening.two_sided = scene.materials[std::size_t(node.material)].two_sided;
    opening.colour = portal.colour;
    opening.low = glm::dvec2(std::numeric_limits<double>::infinity());
    opening.high = -opening.low;
    for (const Vertex& vertex : scene.meshes[std::size_t(*node.mesh)].vertices) {
      opening.low = glm::min(opening.low, glm::dvec2(vertex.position));
      opening.high = glm::max(opening.high, glm::dvec2(vertex.position));
    }
    openings_.push_back(opening);
  }
}

bool PortalViews::hides(const Scene& scene, const View&, const Node& node) const {
  return std::ranges::any_of(openings_, [&](const Opening& o) { return &scene.nodes[std::size_t(o.node)] == &node; });
}

/// Of its bounds, counter-clockwise, in the world.
std::vector<glm::dvec4> PortalViews::corners_of(const Opening& opening) const {
  const auto corner = [&](double x, double y) { return opening.frame * glm::dvec4(x, y, 0, 1); };
  const glm::dvec2 &low = opening.low, &high = opening.high;
  return {corner(low.x, low.y), corner(high.x, low.y), corner(high.x, high.y), corner(low.x, high.y)};
}

std::optional<glm::ivec4> PortalViews::rectangle_of(const Opening& opening, const Viewpoint& around,
                                                    const Target& target) const {
  const glm::ivec2 size(target.spec().width, target.spec().height);
  const glm::ivec4 bounds = around.view.scissor.value_or(glm::ivec4(0, 0, size));
  if (!scissor_) return bounds;
  const glm::mat4 to_clip = around.projection * around.world_to_view;
  std::vector<glm::vec4> corners;
  for (const glm::dvec4& corner : corners_of(opening))
    corners.push_back(to_clip * glm::vec4(glm::dvec3(corner) - around.origin, 1));
  return opening_rectangle(corners, size, bounds);
}

View PortalViews::view_through(const Opening& opening, const Viewpoint& around, const glm::dvec4& plane) const {
  // The passage of a world whose origin has moved.
  const glm::dmat4 to_absolute = glm::translate(glm::dmat4(1), around.origin);
  const glm::dmat4 passage = glm::translate(glm::dmat4(1), -around.origin) * opening.passage * to_absolute;
  View view = around.view;
  view.world_to_view = virtual_view(around.world_to_view, passage);
  view.mirrored = around.view.mirrored != opening.mirror;
  view.clip_plane.reset();
  view.projection.reset();
  const glm::dvec3 eye(opening.passage * glm::dvec4(eye_of(around), 1));
  // At the plane itself an oblique near plane leaves no depths: there clip distances take its place.
  const bool at_plane = -distance(plane, eye) < around.view.camera.near;
  if (clip_ == Clip::distance || (clip_ == Clip::oblique && at_plane)) {
    view.clip_plane = plane;
  } else if (clip_ == Clip::oblique) {
    const glm::vec4 in_view = plane_in_view(glm::dvec4(moved_plane(plane, around.origin)), *view.world_to_view);
    view.projection = oblique_projection(projection_, in_view);
  }
  return view;
}

void PortalViews::draw_opening(const Opening& opening, const Viewpoint& around, const Target& target, int item,
                               ScenePainter& painter) {
  const bool from_behind = distance(opening_plane(opening.frame, false), eye_of(around)) < 0;
  if (from_behind && !opening.two_sided) return;
  // Not seen where all of it stands before the exit of the view that is being drawn.
  if (!planes_.empty() && std::ranges::all_of(corners_of(opening), [&](const glm::dvec4& corner) {
        return glm::dot(planes_.back(), corner) <= 0;
      }))
    return;
  const std::optional<glm::ivec4> rectangle = rectangle_of(opening, around, target);
  if (!rectangle) return;
  if (nesting_depth(around.view) >= deepest_ || std::min(rectangle->z, rectangle->w) < smallest_) {
    painter.fill_opening(around, target, item, around.view.output == "colour" ? opening.colour : glm::vec3(0));
    return;
  }
  const glm::dvec4 plane = opening_plane(opening.exit, from_behind);
  View view = view_through(opening, around, plane);
  view.scissor = *rectangle;
  planes_.push_back(plane);
  painter.draw_view_inside(view, around, target, item, {.begin_mark = begin_mark, .begin_restore = begin_restore});
  planes_.pop_back();
}

void PortalViews::draw_inside(Gl&, const Scene&, const Viewpoint& around, const Target& target, ScenePainter& painter) {
  if (!around.view.parent) {
    planes_.clear();
    projection_ = around.projection;
  }
  for (const Opening& opening : openings_)
    for (int item = 0; item < int(painter.items().size()); ++item)
      if (painter.items()[std::size_t(item)].node == opening.node) draw_opening(opening, around, target, item, painter);
}

Need PortalViews::need(const Scene& scene, const View&, const Node&) const {
  return {.wanted = clip_ == Clip::discard && !scene.portals.empty()};
}

std::map<Slot, SlotCode> PortalViews::slots() const {
  return {{Slot::discard_fragment, {"07-stencil-portals/given/portal_views.glsl", "discard_before_exit"}}};
}

void PortalViews::bind_view(Binder& binder, const Scene&, const Viewpoint& viewpoint) {
  // Outside of all openings nothing is cut away.
  const bool outside = planes_.empty() || !viewpoint.view.parent;
  binder.set("u_opening_plane", outside ? glm::vec4(0, 0, 0, 1) : moved_plane(planes_.back(), viewpoint.origin));
}

}  // namespace atelier
