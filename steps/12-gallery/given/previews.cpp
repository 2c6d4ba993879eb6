#include "12-gallery/given/previews.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "06-parallax-mapping/given/relief_surface.hpp"
#include "07-stencil-portals/given/openings.hpp"
#include "07-stencil-portals/stencil_portals.hpp"
#include "12-gallery/given/scenes.hpp"
#include "base/error.hpp"
#include "gl/debug.hpp"
#include "render/scene_painter.hpp"

namespace atelier {

std::vector<SettingSpec> preview_settings() {
  return {
      {.name = "preview.size", .fallback = 256, .low = 16, .high = 1024, .help = "pixels: a side of a preview"},
      {.name = "preview.most",
       .fallback = paintings_in_hall,
       .low = 0,
       .high = paintings_in_hall + 1,
       .help = "how many previews a frame records at most"},
      {.name = "preview.update",
       .fallback = std::string("when-moved"),
       .choices = {"always", "when-moved"},
       .help = "whether rooms count as new in every frame, or only after something has moved or a setting has changed"},
      {.name = "preview.relief",
       .fallback = true,
       .help = "record normals and heights too, so that paintings have a relief"},
  };
}

std::vector<SettingSpec> gallery_relief_settings() {
  std::vector<SettingSpec> specs = parallax_settings();
  for (SettingSpec& spec : specs) {
    if (spec.name == "recorded.nearest") spec.fallback = preview_distance;
    if (spec.name == "recorded.farthest") spec.fallback = preview_distance + bedroom_size.z;
  }
  return specs;
}

void Previews::configure(const Settings& settings) {
  size_ = settings.integer("preview.size");
  most_ = settings.integer("preview.most");
  relief_ = settings.flag("preview.relief");
  always_ = settings.choice("preview.update") == "always";
}

void Previews::prepare(Gl&, const Scene& scene) {
  for (std::size_t i = 0; i < paintings_.size(); ++i) {
    Painting& painting = paintings_[i];
    const auto node = std::ranges::find(scene.nodes, painting_name(int(i)), &Node::name);
    painting.material = node == scene.nodes.end() ? -1 : node->material;
    // A frame must not depend on what was drawn before the scene was loaded, nor keep its memory.
    painting.framebuffer = {};
    painting.textures = {};
    painting.preview = {};
    painting.state = {};
  }
  moved(scene);
}

void Previews::moved(const Scene& scene) {
  ++version_;
  const std::vector<glm::dmat4> world = world_matrices_exact(scene.nodes);
  const auto frame_of = [&](int painting) {
    const auto node = std::ranges::find(scene.nodes, painting_name(painting), &Node::name);
    return node == scene.nodes.end() ? glm::dmat4(1) : world[std::size_t(node - scene.nodes.begin())];
  };
  const glm::dmat4 door = frame_of(paintings_in_hall);
  for (int i = 0; i < int(paintings_.size()); ++i) {
    Painting& painting = paintings_[std::size_t(i)];
    const bool is_door = i == paintings_in_hall;
    painting.frame = frame_of(i);
    painting.leads_to = is_door ? gallery::hall : i;
    painting.exit = door;
    painting.portal = std::ranges::any_of(scene.portals, [&](const Portal& portal) {
      return scene.nodes[std::size_t(portal.node)].name == painting_name(i);
    });
  }
}

/// The door leads out of the painting of the room in which the visitor is.
void Previews::turn_door() {
  Painting& door = paintings_.back();
  const glm::dmat4& exit = paintings_[std::size_t(std::max(styles_.visited(), 0))].frame;
  if (exit == door.exit) return;
  door.exit = exit;
  door.state.recorded = false;
}

bool Previews::in_view(const Painting& painting, const Viewpoint& viewpoint) const {
  if (glm::dot(stencil_portals::opening_plane(painting.frame, false), glm::dvec4(viewpoint.exact_eye, 1)) <= 0)
    return false;
  const auto corners = Opening{.frame = painting.frame, .half_size = painting_half_size}.corners();
  if (beyond_far_plane(corners, viewpoint)) return false;
  const glm::mat4 to_clip = viewpoint.projection * viewpoint.world_to_view;
  std::vector<glm::vec4> in_clip_space;
  for (const glm::dvec4& corner : corners)
    in_clip_space.push_back(to_clip * glm::vec4(glm::dvec3(corner) - viewpoint.origin, 1));
  constexpr glm::ivec2 fine(16384, 16384);  // as finely as any picture's pixels
  return stencil_portals::opening_rectangle(in_clip_space, fine, {0, 0, fine}).has_value();
}

void Previews::allocate(Gl& gl, Painting& painting) {
  GLint has = 0;
  if (painting.textures[0]) {
    gl.BindTexture(GL_TEXTURE_2D, painting.textures[0].id());
    gl.GetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &has);
    gl.BindTexture(GL_TEXTURE_2D, 0);
  }
  if (has == size_) return;
  // The old ones are deleted first, also in case the student's function throws.
  painting.framebuffer = {};
  painting.textures = {};
  painting.state = {};
  painting.preview = gallery::make_preview(gl, size_);
  for (std::size_t i = 0; i < painting.textures.size(); ++i)
    painting.textures[i] = GlTexture(gl, painting.preview.textures[i]);
  painting.framebuffer = GlFramebuffer(gl, painting.preview.framebuffer);
  check_gl_error(gl, fmt::format("make_preview: {0} x {0} pixels", size_).c_str());
}

void Previews::record(Gl& gl, Painting& painting, const Viewpoint& viewpoint, bool stencil, ScenePainter& painter) {
  allocate(gl, painting);
  const auto& names = painting.preview.textures;
  if (!painting.preview.framebuffer || std::ranges::count(names, 0u) > 0) return;  // nothing is written yet
  View view{.camera = gallery::preview_camera(painting.exit, painting_half_size, preview_distance, preview_far),
            .camera_relative = viewpoint.view.camera_relative,
            .cull = true};
  styles_.show(painting.leads_to);
  const auto target =
      painter.targets().take(TargetSpec{.width = size_,
                                        .height = size_,
                                        .colour = ColourFormat::rgba16f,
                                        .depth = stencil ? DepthFormat::depth24_stencil8 : DepthFormat::depth24});
  const auto record_output = [&](gallery::Map map, const char* output) {
    view.output = output;
    painter.draw_view(view, *target);
    gallery::record(gl, painting.preview, map, target->framebuffer());
    check_gl_error(gl, "record");
  };
  record_output(gallery::Map::colour, "colour");
  if (relief_) {
    record_output(gallery::Map::normal, "relief");
    record_output(gallery::Map::height, "relief_height");
  }
  styles_.show(styles_.visited());
  painting.state.recorded = true;
  painting.state.recorded_of = version_;
  painting.state.frames_since = 0;
}

void Previews::draw_views(Gl& gl, const Scene& scene, const Viewpoint& viewpoint, ScenePainter& painter) {
  const DebugGroup group(gl, "previews");
  if (always_) ++version_;
  turn_door();
  std::vector<gallery::PreviewState> states;
  for (Painting& painting : paintings_) {
    ++painting.state.frames_since;
    painting.state.version = version_;
    painting.state.visible = painting.material >= 0 && !painting.portal && in_view(painting, viewpoint);
    states.push_back(painting.state);
  }
  const std::vector<int> wanted = gallery::previews_to_record(states, most_);
  more_wanted_ = always_ || gallery::previews_to_record(states, int(states.size())).size() > wanted.size();
  for (const int i : wanted) {
    if (i < 0 || i >= int(paintings_.size()))
      throw Error(fmt::format("previews_to_record returns {}; there are previews 0 to {}", i, paintings_.size() - 1));
    record(gl, paintings_[std::size_t(i)], viewpoint, !scene.portals.empty(), painter);
  }
}

Need Previews::need(const Scene& scene, const View&, const Node& node) const {
  return {.wanted = std::ranges::any_of(paintings_, [&](const Painting& p) { return p.material == node.material; }) &&
                    !scene.materials.empty()};
}

void Previews::bind_material(Binder& binder, const Scene& scene, const Material& material) {
  const int index = int(&material - scene.materials.data());
  const auto painting = std::ranges::find(paintings_, index, &Painting::material);
  if (painting == paintings_.end() || !painting->state.recorded) return;
  binder.texture("u_diffuse_map", painting->preview.textures[0]);
  if (!relief_) return;
  binder.texture("u_normal_map", painting->preview.textures[1]);
  binder.texture("u_height_map", painting->preview.textures[2]);
}

}  // namespace atelier
