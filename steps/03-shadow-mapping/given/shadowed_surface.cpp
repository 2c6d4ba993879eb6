#include "03-shadow-mapping/given/shadowed_surface.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_access.hpp>

#include "gl/debug.hpp"
#include "render/cull.hpp"

namespace atelier {

using namespace shadow_mapping;

ShadowedSurface::ShadowedSurface(const DrawnLights& lights, const PointFrusta& points)
    : lights_(lights),
      points_(points),
      showing_(GL_TEXTURE_2D_ARRAY,
               R"(uniform sampler2DArray u_map; uniform int u_layer; uniform vec2 u_size; out vec4 o;
void main() { o = vec4(texture(u_map, vec3(gl_FragCoord.xy / u_size, u_layer)).rrr, 1.0); })") {}

void ShadowedSurface::configure(const Settings& settings) {
  settings_ = shadow_settings(settings);
}

void ShadowedSurface::prepare(Gl&, const Scene& scene) {
  moved(scene);
}

void ShadowedSurface::moved(const Scene&) {
  frame_.maps.clear();
  found_ = false;
}

// ---- Which lights have a map, and its frustum

namespace {

void append(std::vector<glm::dvec3>& points, std::span<const glm::dvec3> more) {
  points.insert(points.end(), more.begin(), more.end());
}

}  // namespace

/// The points that the frusta are fitted to.
struct ShadowedSurface::Extents {
  std::vector<glm::dvec3> all, casters, seen;  ///< casters and receivers; casters; visible receivers
  glm::vec3 origin;                            ///< the origin of a camera-relative view

  Extents(const Scene& scene, const Viewpoint& viewpoint, std::span<const ScenePainter::Item> items,
          ShadowSettings::Fit fit)
      : origin(-viewpoint.origin) {
    for (const ScenePainter::Item& item : items) {
      if (item.box.empty()) continue;
      const std::array<glm::dvec3, 8> corners = corners_of(item);
      if (casts(scene, item) || receives(scene, item)) append(all, corners);
      if (casts(scene, item)) append(casters, corners);
      if (fit == ShadowSettings::Fit::visible && receives(scene, item)) append(seen, visible_corners(item, viewpoint));
    }
  }
};

Sphere ShadowedSurface::covered(const Extents& extents) const {
  if (settings_.fit == ShadowSettings::Fit::fixed) return {extents.origin, settings_.reach};
  return *sphere_around(settings_.fit == ShadowSettings::Fit::scene ? extents.all : extents.casters);
}

std::optional<LightFrustum> ShadowedSurface::fit_to_directional(const Light& light, const Extents& extents) const {
  if (settings_.fit != ShadowSettings::Fit::visible) return fit_directional(light.direction, covered(extents));
  const auto tight = fit_directional_to_both(light.direction, extents.casters, extents.seen);
  if (!tight) return {};
  return snap_to_texels(*tight, settings_.resolution);
}

std::optional<LightFrustum> ShadowedSurface::fit_to_spot(const Light& light, const glm::vec3& position,
                                                         const Extents& extents) const {
  Sphere sphere = covered(extents);
  if (settings_.fit == ShadowSettings::Fit::visible) {
    const auto seen = sphere_around(extents.seen);
    if (!seen) return {};
    if (radians_across(*seen, position) < radians_across(sphere, position)) sphere = *seen;
  }
  LightFrustum frustum = fit_spot(position, light.direction, light.outer_angle, sphere);
  // Only casters are drawn: move the near plane to the first of them, for better depth precision.
  const float first = 0.99f * nearest_depth(extents.casters, frustum);
  frustum.near = glm::clamp(first, frustum.near, 0.99f * frustum.far);
  return frustum;
}

std::optional<LightFrustum> ShadowedSurface::frustum_of(int light, const glm::vec3& position,
                                                        const Extents& extents) const {
  const Light& source = lights_.light(light);
  if (source.passage) return frustum_through(source, -glm::dvec3(extents.origin), extents.all);
  if (source.type == LightType::directional) return fit_to_directional(source, extents);
  if (source.type == LightType::spot) return fit_to_spot(source, position, extents);
  const auto found = points_.find(light);
  return found != points_.end() ? std::optional(found->second) : std::nullopt;
}

std::optional<MappedLight> ShadowedSurface::map_for(const Scene& scene, int light, const Viewpoint& viewpoint,
                                                    const ScenePainter& painter, const Extents& extents) const {
  const Light& source = lights_.light(light);
  if (!source.casts_shadow || extents.casters.empty()) return {};
  const glm::vec3 position(source.position - viewpoint.origin);
  if (source.type == LightType::spot && !source.passage &&
      shines_past(source, position, *sphere_around(extents.casters)))
    return {};
  const auto frustum = frustum_of(light, position, extents);
  if (!frustum) return {};
  MappedLight map{.light = light, .frustum = *frustum};
  map.view = light_view(map.frustum);
  map.projection = light_projection(map.frustum);
  if (source.passage) map.passage = moved_passage(*source.passage, viewpoint.origin);
  find_casters(scene, painter, extents, map);
  if (map.casters.empty() && map.carried.empty()) return {};
  return map;
}

/// Those that the light's frustum contains.
void ShadowedSurface::find_casters(const Scene& scene, const ScenePainter& painter, const Extents& extents,
                                   MappedLight& map) const {
  // Casters in front of the near plane also cast shadows: cull with the other five planes only.
  LightFrustum deep = map.frustum;
  deep.near = deep.orthographic ? std::min(deep.near, nearest_depth(extents.casters, deep)) : deep.far / 1e5f;
  const glm::mat4 reach = light_projection(deep);
  const std::optional<Passage>& passage = lights_.light(map.light).passage;
  for (int i = 0; i < int(painter.items().size()); ++i) {
    const ScenePainter::Item& item = painter.items()[std::size_t(i)];
    if (!casts(scene, item)) continue;
    const bool exit = passage && item.node == passage->exit, entry = passage && item.node == passage->entry;
    if (!exit && !outside_view(reach, map.view, item.model, item.box)) map.casters.push_back(i);
    if (!passage || entry) continue;
    // A box has no near plane that all casters before the entry are behind: keep them all.
    if (deep.orthographic || !outside_view(reach, map.view * map.passage->through, item.model, item.box))
      map.carried.push_back(i);
  }
}

void ShadowedSurface::find_maps(const Scene& scene, const Viewpoint& viewpoint, const ScenePainter& painter) {
  const Extents extents(scene, viewpoint, painter.items(), settings_.fit);
  std::vector<MappedLight> found;
  for (const std::vector<int>* lights : {&lights_.spots, &lights_.directional, &lights_.points})
    for (const int light : *lights)
      if (auto map = map_for(scene, light, viewpoint, painter, extents)) found.push_back(std::move(*map));
  for (std::size_t i = 0; i < found.size() && i < frame_.maps.size(); ++i)
    found[i].drawn = frame_.maps[i].drawn && found[i].light == frame_.maps[i].light &&
                     found[i].view == frame_.maps[i].view && found[i].projection == frame_.maps[i].projection &&
                     found[i].casters == frame_.maps[i].casters && found[i].carried == frame_.maps[i].carried;
  frame_.maps = std::move(found);
  found_ = true;
}

// ---- Drawing them

void ShadowedSurface::allocate(Gl& gl) {
  const Allocation needed{settings_.resolution, int(frame_.maps.size()), settings_.format, settings_.bilinear};
  if (allocation_ == needed) return;
  allocation_ = {};  // reset first, in case the student's function throws or OpenGL reports an error
  texture_ = {};
  framebuffer_ = {};
  names_ = make_shadow_maps(gl, settings_.resolution, int(frame_.maps.size()), settings_.format, settings_.bilinear);
  texture_ = GlTexture(gl, names_.texture);
  framebuffer_ = GlFramebuffer(gl, names_.framebuffer);
  check_gl_error(gl, fmt::format("make_shadow_maps: {} layers of {}x{} texels", frame_.maps.size(),
                                 settings_.resolution, settings_.resolution)
                         .c_str());
  label(gl, GL_TEXTURE, texture_.id(), "shadow maps");
  label(gl, GL_FRAMEBUFFER, framebuffer_.id(), "shadow maps");
  allocation_ = needed;
  for (MappedLight& map : frame_.maps) map.drawn = false;
}

/// x, y, width and height.
glm::ivec4 ShadowedSurface::texels_to_draw(const MappedLight& map) const {
  const float filter = 0.5f * float(settings_.pcf) + 1, moved = texels_moved(settings_);
  if (map.frustum.orthographic)
    return texels_of(*frame_.visible_receivers, map.world_to_map(), settings_.resolution, filter + moved);
  // In a perspective frustum with tangent t of its half-angle, moving a point at depth z by A along a normal at the
  // angle a to the axis moves it by A (sin^2 a + t sin a cos a) <= A (1 + sqrt(1 + t^2)) / 2 in the map, and closer by
  // at most A / 2, where texels are smaller. A is given in texels, each 2 t z / resolution wide.
  const float t = std::tan(map.frustum.extent), nearer = moved * t / float(settings_.resolution);
  if (nearer >= 0.5f) return {0, 0, settings_.resolution, settings_.resolution};
  const float aside = moved * (1 + std::hypot(1.0f, t)) / 2 / (1 - nearer);
  return texels_of(*frame_.visible_receivers, map.world_to_map(), settings_.resolution, filter + aside);
}

namespace {

/// The depth pass, of whole nodes or of what is on the positive side of a plane.
PassSources depth_pass(bool clipped) {
  PassSources pass{.name = "depth pass",
                   .vertex =
                       "uniform mat4 u_light_view, u_light_projection;\n"
                       "#ifdef CLIPPED\nuniform vec4 u_clip_plane;\n#endif\n"
                       "#include \"03-shadow-mapping/depth_pass.glsl\"\n"
                       "void main() {\n"
                       "  gl_Position = depth_pass_position(a_position);\n"
                       "#ifdef CLIPPED\n"
                       "  gl_ClipDistance[0] = dot(u_clip_plane, vec4(world_position(u_model, a_position), 1.0));\n"
                       "#endif\n"
                       "}\n",
                   .fragment = "void main() {}\n"};
  if (clipped) pass.structure["CLIPPED"] = "1";
  return pass;
}

}  // namespace

void ShadowedSurface::paint_casters(Gl& gl, const MappedLight& map, ScenePainter& painter) const {
  const auto paint = [&](const std::vector<int>& casters, const glm::mat4& view, const glm::vec4* plane) {
    painter.paint(depth_pass(plane), casters, [&](Binder& binder) {
      binder.set("u_light_view", view);
      binder.set("u_light_projection", map.projection);
      if (plane) binder.set("u_clip_plane", *plane);
    });
  };
  if (!map.passage) return paint(map.casters, map.view, nullptr);
  const MovedPassage& passage = *map.passage;
  gl.Enable(GL_CLIP_DISTANCE0);
  paint(map.casters, map.view, &passage.exit_plane);
  const bool mirrors = glm::determinant(glm::mat3(passage.through)) < 0;
  if (mirrors && settings_.culls_front_faces()) gl.CullFace(GL_BACK);
  paint(map.carried, map.view * passage.through, &passage.entry_plane);
  gl.Disable(GL_CLIP_DISTANCE0);
}

void ShadowedSurface::draw_map(Gl& gl, int layer, ScenePainter& painter) {
  MappedLight& map = frame_.maps[std::size_t(layer)];
  const DebugGroup group(gl, name_of(lights_, map.light, "shadow map"));
  if (frame_.visible_receivers) {
    const glm::ivec4 part = texels_to_draw(map);
    gl.Enable(GL_SCISSOR_TEST);
    gl.Scissor(part.x, part.y, part.z, part.w);
  }
  begin_depth_pass(gl, names_, layer, settings_.culls_front_faces());
  paint_casters(gl, map, painter);
  gl.Disable(GL_SCISSOR_TEST);
  check_gl_error(gl, "drawing a shadow map");
  map.drawn = !frame_.visible_receivers;
}

void ShadowedSurface::draw_before(Gl& gl, const Scene& scene, const Viewpoint& viewpoint, ScenePainter& painter) {
  const bool shown = shows_shadows(viewpoint.view) && viewpoint.view.output != "shadow_map";
  shown_ |= shown;
  frame_.visible_receivers.reset();
  if (!shows_shadows(viewpoint.view)) return;
  const bool keep = settings_.keep;
  if (shown && !keep && !settings_.pcss)
    frame_.visible_receivers = visible_receivers(scene, painter.items(), viewpoint);
  if (!found_ || !keep || settings_.fit == ShadowSettings::Fit::visible || viewpoint.view.camera_relative)
    find_maps(scene, viewpoint, painter);
  if (!frame_.maps.empty()) allocate(gl);
  if (is_allocated())  // false if make_shadow_maps is not written yet
    for (int layer = 0; layer < int(frame_.maps.size()); ++layer)
      if (!keep || !frame_.maps[std::size_t(layer)].drawn) draw_map(gl, layer, painter);
  if (Defines now = structure(); now != structure_) {
    structure_ = std::move(now);
    structure_changed();
  }
}

bool ShadowedSurface::draw_instead(Gl& gl, const View& view, const Target& target) {
  if (view.output != "shadow_map") return false;
  const int layer = frame_.layer_of(settings_.shown_light);
  if (layer < 0 || !is_allocated()) return true;  // black: this light has no map
  showing_.draw(gl, target, texture_.id(), [&](Uniforms& uniforms) { uniforms.set("u_layer", layer); });
  return true;
}

// ---- Sampling them

std::string name_of(const DrawnLights& lights, int light, std::string_view what) {
  const std::string& name = lights.light(light).name;
  return fmt::format("{} of light {}{}", what, light, name.empty() ? "" : " (" + name + ")");
}

int FrameMaps::layer_of(int light) const {
  for (std::size_t i = 0; i < maps.size(); ++i)
    if (maps[i].light == light) return int(i);
  return -1;
}

bool ShadowedSurface::directional_projections_are_affine() const {
  return std::all_of(frame_.maps.begin(), frame_.maps.end(), [](const MappedLight& map) {
    return !map.frustum.orthographic || glm::row(map.world_to_map(), 3) == glm::vec4(0, 0, 0, 1);
  });
}

/// The #defines of surfaces that receive shadows. Only the shadow outputs use SHOWN_MAP.
Defines ShadowedSurface::structure() const {
  Defines d = filter_structure(settings_);
  const auto layer = [this](int light) { return frame_.layer_of(light); };
  d["SHADOW_LIGHTS"] = std::to_string(is_allocated() ? frame_.maps.size() : 0);
  d["SPOT_MAPS"] = glsl_list(lights_.spots, layer);
  d["DIRECTIONAL_MAPS"] = glsl_list(lights_.directional, layer);
  d["POINT_MAPS"] = glsl_list(lights_.points, layer);
  if (directional_projections_are_affine()) d["PARALLEL"] = "1";
  d["SHOWN_MAP"] = std::to_string(layer(settings_.shown_light));
  return d;
}

Need ShadowedSurface::need(const Scene&, const View& view, const Node& node) const {
  const bool alone = shows_shadows_alone(view);
  const bool maps = !frame_.maps.empty() && is_allocated() && node.receives_shadow;
  if (!shows_shadows(view) || (!alone && !maps)) return {};
  Need need{.wanted = true, .structure = structure_};
  if (!node.receives_shadow) need.structure["SHADOW_LIGHTS"] = "0";
  if (!alone) need.structure.erase("SHOWN_MAP");
  return need;
}

std::map<Slot, SlotCode> ShadowedSurface::slots() const {
  const std::string file = "03-shadow-mapping/given/shadowed_surface.glsl";
  return {{Slot::visible_from_point, {file, "point_visibility_by_map"}},
          {Slot::visible_from_spot, {file, "spot_visibility_by_map"}},
          {Slot::visible_from_directional, {file, "directional_visibility_by_map"}}};
}

std::map<std::string, std::string> ShadowedSurface::outputs() const {
  return {{"shadow_factor", "shown_shadow_factor(surface)"}, {"shadow_coordinate", "shown_shadow_coordinate(surface)"}};
}

void ShadowedSurface::count(SceneCounts& counts) const {
  if (is_allocated() && shown_) counts.lookups += std::int64_t(frame_.maps.size()) * lookups_in_a_map(settings_);
}

std::vector<DrawConstant> ShadowedSurface::draw_constants() const {
  std::vector<DrawConstant> constants = bias_constants();
  constants.push_back({"ShadowLight",
                       "u_shadow_lights",
                       "SHADOW_LIGHTS",
                       {{"mat4", "world_to_map"},
                        {"vec3", "eye"},
                        {"vec3", "direction"},
                        {"float", "half_width"},
                        {"float", "near"},
                        {"float", "far"},
                        {"float", "width"},
                        {"bool", "directional"},
                        {"int", "layer"}}});
  return constants;
}

void ShadowedSurface::bind_view(Binder& binder, const Scene&, const Viewpoint& viewpoint) {
  for (std::size_t i = 0; i < frame_.maps.size(); ++i) {
    const LightFrustum& frustum = frame_.maps[i].frustum;
    const std::string name = fmt::format("u_shadow_lights[{}].", i);
    binder.set(name + "world_to_map", frame_.maps[i].world_to_map());
    binder.set(name + "eye", frustum.eye);
    binder.set(name + "direction", frustum.direction);
    binder.set(name + "half_width", frustum.orthographic ? frustum.extent : std::tan(frustum.extent));
    binder.set(name + "near", frustum.near);
    binder.set(name + "far", frustum.far);
    binder.set(name + "width", float(settings_.light_width));
    binder.set(name + "directional", int(frustum.orthographic));
    binder.set(name + "layer", int(i));
  }
  bind_bias(binder, settings_);
  if (texture_) binder.texture("u_shadow_maps", texture_.id(), GL_TEXTURE_2D_ARRAY);
  if (settings_.shown_light < int(lights_.all.size())) {
    const Light& light = lights_.light(settings_.shown_light);
    const bool directional = light.type == LightType::directional;
    binder.set("u_shown_position", glm::vec3(light.position - viewpoint.origin));
    binder.set("u_shown_direction", directional ? -glm::normalize(light.direction) : glm::vec3(0));
  }
}

}  // namespace atelier
