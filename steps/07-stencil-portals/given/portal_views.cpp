#include "07-stencil-portals/given/portal_views.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

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

constexpr int most_views = 10000;  ///< of a picture: some seconds

double distance(const glm::dvec4& plane, const glm::dvec3& point) {
  return glm::dot(plane, glm::dvec4(point, 1));
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
  openings_ = openings_of(scene);
}

void PortalViews::moved(const Scene& scene) {
  openings_ = openings_of(scene);
}

bool PortalViews::hides(const Scene& scene, const View&, const Node& node) const {
  return std::ranges::any_of(openings_, [&](const Opening& o) { return &scene.nodes[std::size_t(o.node)] == &node; });
}

std::optional<glm::ivec4> PortalViews::rectangle_of(const Opening& opening, const Viewpoint& around,
                                                    const Target& target) const {
  const glm::ivec2 size(target.spec().width, target.spec().height);
  const glm::ivec4 bounds = around.view.scissor.value_or(glm::ivec4(0, 0, size));
  if (!scissor_) return bounds;
  const glm::mat4 to_clip = around.projection * around.world_to_view;
  std::vector<glm::vec4> corners;
  for (const glm::dvec4& corner : opening.corners())
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
  view.openings_clip_plane.reset();
  if (clip_ != Clip::none) view.openings_clip_plane = plane;
  view.eye = glm::dvec3(opening.passage * glm::dvec4(around.exact_eye, 1));
  // At the plane itself an oblique near plane leaves no depths: there clip distances take its place.
  const bool at_plane = -distance(plane, *view.eye) < around.view.camera.near;
  if (clip_ == Clip::distance || (clip_ == Clip::oblique && at_plane)) {
    view.clip_plane = plane;
  } else if (clip_ == Clip::oblique) {
    const glm::vec4 in_view = plane_in_view(glm::dvec4(moved_plane(plane, around.origin)), *view.world_to_view);
    view.projection = oblique_projection(projection_, in_view);
  }
  return view;
}

/// Whether part of an opening stands behind an exit. The opening of the exit itself does not, whatever rounding says.
bool PortalViews::seen_from(const Exit& exit, const Opening& opening) {
  if (opening.node == exit.node) return false;
  return std::ranges::any_of(opening.corners(),
                             [&](const glm::dvec4& corner) { return glm::dot(exit.plane, corner) > 0; });
}

void PortalViews::draw_opening(const Opening& opening, const Viewpoint& around, const Target& target, int item,
                               ScenePainter& painter) {
  const bool behind = distance(opening_plane(opening.frame, false), around.exact_eye) < 0;
  if (behind && !opening.two_sided) return;
  if (!exits_.empty() && !seen_from(exits_.back(), opening)) return;
  const std::optional<glm::ivec4> rectangle = rectangle_of(opening, around, target);
  if (!rectangle || beyond_far_plane(opening.corners(), around)) return;
  if (nesting_depth(around.view) >= deepest_ || std::min(rectangle->z, rectangle->w) < smallest_) {
    painter.fill_opening(around, target, item, around.view.output == "colour" ? opening.colour : glm::vec3(0));
    return;
  }
  if (++views_ > most_views)
    throw Error(
        fmt::format("portals.depth={} needs more than {} views in this picture; lower it, raise "
                    "portals.smallest, or set portals.scissor=on",
                    deepest_, most_views));
  const glm::dvec4 plane = opening_plane(opening.exit, behind);
  View view = view_through(opening, around, plane);
  view.scissor = *rectangle;
  exits_.push_back({opening.exit_node, plane});
  painter.draw_view_inside(view, around, target, item, {.begin_mark = begin_mark, .begin_restore = begin_restore});
  exits_.pop_back();
}

void PortalViews::draw_inside(Gl&, const Scene&, const Viewpoint& around, const Target& target, ScenePainter& painter) {
  if (!around.view.parent) {
    exits_.clear();
    views_ = 0;
    projection_ = around.projection;
  }
  for (const Opening& opening : openings_)
    for (int item = 0; item < int(painter.items().size()); ++item)
      if (painter.items()[std::size_t(item)].node == opening.node) draw_opening(opening, around, target, item, painter);
}

Need PortalViews::need(const Scene&, const View& view, const Node&) const {
  return {.wanted = clip_ == Clip::discard && view.openings_clip_plane};
}

std::map<Slot, SlotCode> PortalViews::slots() const {
  return {{Slot::discard_fragment, {"07-stencil-portals/given/portal_views.glsl", "discard_before_exit"}}};
}

void PortalViews::bind_view(Binder& binder, const Scene&, const Viewpoint& viewpoint) {
  if (const auto& plane = viewpoint.view.openings_clip_plane)
    binder.set("u_opening_plane", moved_plane(*plane, viewpoint.origin));
}

}  // namespace atelier
