#include "03-shadow-mapping/shadowed_surface.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_access.hpp>

#include "render/cull.hpp"

namespace atelier {

using namespace shadow_mapping;

std::vector<SettingSpec> shadow_settings() {
  return {
      {.name = "shadow.resolution", .fallback = 1024, .low = 1, .high = 8192, .help = "texels along a side of a map"},
      {.name = "shadow.format",
       .fallback = std::string("24"),
       .choices = {"16", "24", "32f"},
       .help = "how depth is stored in a map"},
      {.name = "shadow.bias",
       .fallback = std::string("normal"),
       .choices = {"none", "constant", "slope", "normal", "plane", "front-faces"},
       .help = "what keeps a surface from shading itself"},
      {.name = "shadow.bias_size",
       .fallback = 1.0,
       .low = -16,
       .high = 64,
       .help = "how large the bias is: in texels, times the width of the filter"},
      {.name = "shadow.filter",
       .fallback = std::string("nearest"),
       .choices = {"nearest", "bilinear"},
       .help = "one comparison, or the mixed answers of the four nearest texels"},
      {.name = "shadow.pcf", .fallback = 1, .low = 1, .high = 15, .help = "comparisons along a side of the filter"},
      {.name = "shadow.soft",
       .fallback = std::string("pcf"),
       .choices = {"pcf", "pcss"},
       .help = "a filter of one width, or one as wide as the half-shadow (which reads texels as they are)"},
      {.name = "shadow.samples",
       .fallback = 16,
       .low = 1,
       .high = 1024,
       .help = "of pcss: texels that look for blockers, and comparisons; on a grid the next smaller square number"},
      {.name = "shadow.pattern",
       .fallback = std::string("grid"),
       .choices = {"grid", "random"},
       .help = "where the samples of pcss lie"},
      {.name = "light.width",
       .fallback = 0.0,
       .low = 0,
       .high = 10,
       .help = "of the lights themselves: metres along a side, the tangent of a sun's angle; 0: points"},
      {.name = "shadow.fit",
       .fallback = std::string("scene"),
       .choices = {"fixed", "scene", "casters", "visible"},
       .help = "what a map covers: shadow.reach whatever the scene is, all that casts or receives, what casts, or what "
               "of it matters to the picture"},
      {.name = "shadow.reach",
       .fallback = 10.0,
       .low = 1e-3,
       .high = 1e6,
       .help = "metres around the world's origin that a map covers, where shadow.fit is fixed"},
      {.name = "shadow.update",
       .fallback = std::string("when-moved"),
       .choices = {"always", "when-moved"},
       .help = "when maps are drawn: for every frame, or when what they show has changed"},
      {.name = "shadow.light",
       .fallback = 0,
       .low = 0,
       .high = 63,
       .help =
           "whose shadow the outputs shadow_map, shadow_coordinate and shadow_factor show: the scene's lights from 0"},
  };
}

ShadowedSurface::ShadowedSurface(const LitSurface& lit)
    : lit_(lit),
      showing_(GL_TEXTURE_2D_ARRAY,
               R"(uniform sampler2DArray u_map; uniform int u_layer; uniform vec2 u_size; out vec4 o;
void main() { o = vec4(texture(u_map, vec3(gl_FragCoord.xy / u_size, u_layer)).rrr, 1.0); })") {}

void ShadowedSurface::configure(const Settings& settings) {
  resolution_ = settings.integer("shadow.resolution");
  const std::string& format = settings.choice("shadow.format");
  format_ = GLenum(format == "16"   ? GL_DEPTH_COMPONENT16
                   : format == "24" ? GL_DEPTH_COMPONENT24
                                    : GL_DEPTH_COMPONENT32F);
  const std::string& bias = settings.choice("shadow.bias");
  bias_ = bias == "none"       ? Bias::none
          : bias == "constant" ? Bias::constant
          : bias == "slope"    ? Bias::slope
          : bias == "normal"   ? Bias::normal_offset
          : bias == "plane"    ? Bias::plane
                               : Bias::front_faces;
  bias_size_ = float(settings.real("shadow.bias_size"));
  pcss_ = settings.choice("shadow.soft") == "pcss";
  bilinear_ = settings.choice("shadow.filter") == "bilinear" && !pcss_;
  pcf_ = settings.integer("shadow.pcf");
  random_ = settings.choice("shadow.pattern") == "random";
  samples_ = settings.integer("shadow.samples");
  if (!random_) samples_ = int(std::sqrt(samples_ + 0.5)) * int(std::sqrt(samples_ + 0.5));
  light_width_ = settings.real("light.width");
  const std::string& fit = settings.choice("shadow.fit");
  fit_ = fit == "fixed" ? Fit::fixed : fit == "scene" ? Fit::scene : fit == "casters" ? Fit::casters : Fit::visible;
  reach_ = float(settings.real("shadow.reach"));
  keep_ = settings.choice("shadow.update") == "when-moved";
  shown_light_ = settings.integer("shadow.light");
}

void ShadowedSurface::prepare(Gl&, const Scene& scene) {
  moved(scene);
}

void ShadowedSurface::moved(const Scene&) {
  maps_.clear();
  found_ = false;
}

// ---- Which lights have a map, and of what

namespace {

bool casts(const Scene& scene, const NodePainter::Item& item) {
  return scene.nodes[std::size_t(item.node)].casts_shadow;
}
bool receives(const Scene& scene, const NodePainter::Item& item) {
  return scene.nodes[std::size_t(item.node)].receives_shadow;
}

void append(std::vector<glm::dvec3>& points, const std::vector<glm::dvec3>& more) {
  points.insert(points.end(), more.begin(), more.end());
}

}  // namespace

/// The points that the fits are made from, and the casters.
struct ShadowedSurface::Extents {
  std::vector<glm::dvec3> all, casters, seen;  ///< casters and receivers; casters; what is seen of receivers
  std::vector<NodePainter::Item> casting;
  glm::vec3 origin;  ///< the world's, where the view is camera-relative

  Extents(const Scene& scene, const Viewpoint& viewpoint, std::span<const NodePainter::Item> items, Fit fit)
      : origin(-viewpoint.origin) {
    for (const NodePainter::Item& item : items) {
      if (item.box.empty()) continue;
      const std::vector<glm::dvec3> corners = corners_of(item);
      if (casts(scene, item) || receives(scene, item)) append(all, corners);
      if (casts(scene, item)) append(casters, corners), casting.push_back(item);
      if (fit == Fit::visible && receives(scene, item)) append(seen, visible_corners(item, viewpoint));
    }
  }
};

Sphere ShadowedSurface::covered(const Extents& extents) const {
  if (fit_ == Fit::fixed) return {extents.origin, reach_};
  return *sphere_around(fit_ == Fit::scene ? extents.all : extents.casters);
}

std::optional<LightFrustum> ShadowedSurface::fit_to_sun(const Light& light, const Extents& extents) const {
  if (fit_ != Fit::visible) return fit_sun(light.direction, covered(extents));
  const auto tight = fit_sun_to_both(light.direction, extents.casters, extents.seen);
  if (!tight) return {};
  return snap_to_texels(*tight, resolution_);
}

std::optional<LightFrustum> ShadowedSurface::fit_to_spot(const Light& light, const glm::vec3& position,
                                                         const Extents& extents) const {
  Sphere sphere = covered(extents);
  if (fit_ == Fit::visible) {
    const auto seen = sphere_around(extents.seen);
    if (!seen) return {};
    if (radians_across(*seen, position) < radians_across(sphere, position)) sphere = *seen;
  }
  LightFrustum frustum = fit_spot(position, light.direction, light.outer_angle, sphere);
  // Only casters are drawn: the near plane may be as far as the first of them, which saves digits of every depth.
  const float first = 0.99f * nearest_depth(extents.casters, frustum);
  frustum.near = glm::clamp(first, frustum.near, 0.99f * frustum.far);
  return frustum;
}

std::optional<ShadowedSurface::Mapped> ShadowedSurface::map_for(const Scene& scene, int light,
                                                                const Viewpoint& viewpoint, const NodePainter& painter,
                                                                const Extents& extents) const {
  const Light& source = scene.lights[std::size_t(light)];
  if (!source.casts_shadow || extents.casters.empty()) return {};
  const glm::vec3 position(source.position - viewpoint.origin);
  if (source.type == LightType::spot && shines_past(source, position, *sphere_around(extents.casters))) return {};
  const auto frustum = source.type == LightType::directional ? fit_to_sun(source, extents)
                       : source.type == LightType::spot      ? fit_to_spot(source, position, extents)
                                                             : fit_point(source, position, extents.casting);
  if (!frustum) return {};
  Mapped map{.light = light, .frustum = *frustum};
  map.view = light_view(map.frustum);
  map.projection = light_projection(map.frustum);
  // What stands before the near plane casts its shadow too: only the other five planes can put a caster out of reach.
  LightFrustum deep = map.frustum;
  deep.near = deep.orthographic ? std::min(deep.near, nearest_depth(extents.casters, deep)) : deep.far / 1e5f;
  const glm::mat4 reach = light_projection(deep);
  for (int i = 0; i < int(painter.items().size()); ++i) {
    const NodePainter::Item& item = painter.items()[std::size_t(i)];
    if (casts(scene, item) && !outside_view(reach, map.view, item.model, item.box)) map.casters.push_back(i);
  }
  if (map.casters.empty()) return {};
  return map;
}

void ShadowedSurface::find_maps(const Scene& scene, const Viewpoint& viewpoint, const NodePainter& painter) {
  const Extents extents(scene, viewpoint, painter.items(), fit_);
  std::vector<Mapped> found;
  for (const std::vector<int>* lights : {&lit_.spots(), &lit_.suns(), &lit_.points()})
    for (const int light : *lights)
      if (auto map = map_for(scene, light, viewpoint, painter, extents)) found.push_back(std::move(*map));
  for (std::size_t i = 0; i < found.size() && i < maps_.size(); ++i)
    found[i].drawn = maps_[i].drawn && found[i].light == maps_[i].light && found[i].view == maps_[i].view &&
                     found[i].projection == maps_[i].projection && found[i].casters == maps_[i].casters;
  maps_ = std::move(found);
  found_ = true;
}

// ---- Drawing them

void ShadowedSurface::make_room(Gl& gl) {
  const Room needed{resolution_, int(maps_.size()), format_, bilinear_};
  if (room_ == needed) return;
  room_ = {};  // what the student's function throws or OpenGL refuses must not be taken for good later
  texture_ = {};
  framebuffer_ = {};
  names_ = make_shadow_maps(gl, resolution_, int(maps_.size()), format_, bilinear_);
  texture_ = GlTexture(gl, names_.texture);
  framebuffer_ = GlFramebuffer(gl, names_.framebuffer);
  check_gl_error(
      gl, fmt::format("make_shadow_maps: {} layers of {}x{} texels", maps_.size(), resolution_, resolution_).c_str());
  room_ = needed;
  for (Mapped& map : maps_) map.drawn = false;
}

float ShadowedSurface::texels_moved() const {
  const bool along_normal = bias_ == Bias::normal_offset || bias_ == Bias::plane;  // step 04 has no plane's bias
  return along_normal ? std::abs(bias_size_) * float(pcf_ + (bilinear_ ? 1 : 0)) : 0.0f;
}

/// x, y, width and height.
glm::ivec4 ShadowedSurface::texels_looked_up(const Mapped& map) const {
  const float filter = 0.5f * float(pcf_) + 1, moved = texels_moved();
  if (map.frustum.orthographic) return texels_of(*looked_up_, map.world_to_map(), resolution_, filter + moved);
  // In a pyramid, the tangent of whose half-angle is t, a point at depth z that is moved by A along a normal at the
  // angle a to the axis moves by A (sin^2 a + t sin a cos a) <= A (1 + sqrt(1 + t^2)) / 2 in the map, and comes nearer
  // by at most A / 2, where texels are smaller. A is so many texels, 2 t z / resolution wide each.
  const float t = std::tan(map.frustum.extent), nearer = moved * t / float(resolution_);
  if (nearer >= 0.5f) return {0, 0, resolution_, resolution_};
  const float aside = moved * (1 + std::hypot(1.0f, t)) / 2 / (1 - nearer);
  return texels_of(*looked_up_, map.world_to_map(), resolution_, filter + aside);
}

void ShadowedSurface::draw_map(Gl& gl, int layer, NodePainter& painter) {
  Mapped& map = maps_[std::size_t(layer)];
  if (looked_up_) {
    const glm::ivec4 part = texels_looked_up(map);
    gl.Enable(GL_SCISSOR_TEST);
    gl.Scissor(part.x, part.y, part.z, part.w);
  }
  begin_depth_pass(gl, names_, layer, bias_ == Bias::front_faces);
  static const PassSources pass{.name = "depth pass",
                                .vertex =
                                    "uniform mat4 u_light_view, u_light_projection;\n"
                                    "#include \"03-shadow-mapping/depth_pass.glsl\"\n"
                                    "void main() { gl_Position = depth_pass_position(a_position); }\n",
                                .fragment = "void main() {}\n"};
  painter.paint(pass, map.casters, [&](Binder& binder) {
    binder.set("u_light_view", map.view);
    binder.set("u_light_projection", map.projection);
  });
  gl.Disable(GL_SCISSOR_TEST);
  check_gl_error(gl, "drawing a shadow map");
  map.drawn = !looked_up_;
}

bool ShadowedSurface::shows_shadows(const View& view) const {
  return view.output == "colour" || view.output == "shadow_map" || outputs().contains(view.output);
}

void ShadowedSurface::draw_before(Gl& gl, const Scene& scene, const Viewpoint& viewpoint, NodePainter& painter) {
  shown_ = shows_shadows(viewpoint.view) && viewpoint.view.output != "shadow_map";
  looked_up_.reset();
  if (!shows_shadows(viewpoint.view)) return;
  if (shown_ && !keep_ && !pcss_) looked_up_ = visible_receivers(scene, painter.items(), viewpoint);
  if (!found_ || !keep_ || fit_ == Fit::visible || viewpoint.view.camera_relative) find_maps(scene, viewpoint, painter);
  if (maps_.empty()) return;
  make_room(gl);
  if (!has_room()) return;  // make_shadow_maps is not written yet
  for (int layer = 0; layer < int(maps_.size()); ++layer)
    if (!keep_ || !maps_[std::size_t(layer)].drawn) draw_map(gl, layer, painter);
}

bool ShadowedSurface::draw_instead(Gl& gl, const View& view, const Target& target) {
  if (view.output != "shadow_map") return false;
  const int layer = map_of(shown_light_);
  if (layer < 0 || !has_room()) return true;  // black: this light has no map
  showing_.draw(gl, target, texture_.id(), [&](Uniforms& uniforms) { uniforms.set("u_layer", layer); });
  return true;
}

// ---- Looking them up

int ShadowedSurface::map_of(int light) const {
  for (std::size_t i = 0; i < maps_.size(); ++i)
    if (maps_[i].light == light) return int(i);
  return -1;
}

std::string glsl_list(std::span<const int> lights, const std::function<int(int)>& number) {
  std::string list;
  for (const int light : lights) list += fmt::format("{}{}", list.empty() ? "" : ", ", number(light));
  return list;
}

bool ShadowedSurface::parallel_light_stays_parallel() const {
  return std::all_of(maps_.begin(), maps_.end(), [](const Mapped& map) {
    return !map.frustum.orthographic || glm::row(map.world_to_map(), 3) == glm::vec4(0, 0, 0, 1);
  });
}

Defines ShadowedSurface::structure(bool receives) const {
  Defines d;
  d["SHADOW_LIGHTS"] = std::to_string(has_room() && receives ? maps_.size() : 0);
  d["SPOT_MAPS"] = glsl_list(lit_.spots(), [this](int light) { return map_of(light); });
  d["SUN_MAPS"] = glsl_list(lit_.suns(), [this](int light) { return map_of(light); });
  d["POINT_MAPS"] = glsl_list(lit_.points(), [this](int light) { return map_of(light); });
  if (parallel_light_stays_parallel()) d["PARALLEL"] = "1";
  d["BIAS"] = std::to_string(bias_ == Bias::front_faces ? 0 : int(bias_));
  d["PCF"] = std::to_string(pcf_);
  if (bilinear_) d["COMPARE"] = "1";
  if (pcss_) d["PCSS"] = "1", d["SAMPLES"] = std::to_string(samples_);
  if (pcss_ && random_) d["RANDOM"] = "1";
  return d;
}

Need ShadowedSurface::need(const Scene&, const View& view, const Node& node) const {
  if (!shows_shadows(view)) return {};
  const bool shown = outputs().contains(view.output);
  if (!shown && (maps_.empty() || !has_room() || !node.receives_shadow)) return {};
  Need need{.wanted = true, .structure = structure(node.receives_shadow)};
  if (shown) need.structure["SHOWN_MAP"] = std::to_string(map_of(shown_light_));
  return need;
}

std::map<Slot, SlotCode> ShadowedSurface::slots() const {
  const std::string file = "03-shadow-mapping/shadowed_surface.glsl";
  return {{Slot::shade, {file, "shade_shadowed_surface"}},
          {Slot::visible_from_spot, {file, "spot_visibility"}},
          {Slot::visible_from_sun, {file, "sun_visibility"}}};
}

std::map<std::string, std::string> ShadowedSurface::outputs() const {
  return {{"shadow_factor", "shown_shadow_factor(surface)"}, {"shadow_coordinate", "shown_shadow_coordinate(surface)"}};
}

int ShadowedSurface::lookups_in_a_map() const {
  if (!shown_) return 0;
  return pcss_ ? 2 * samples_ : pcf_ * pcf_ * (bilinear_ ? 4 : 1);  // pcss: blockers, then comparisons
}

void ShadowedSurface::count(SceneCounts& counts) const {
  if (has_room()) counts.lookups += std::int64_t(maps_.size()) * lookups_in_a_map();
}

void ShadowedSurface::bind_view(Binder& binder, const Scene& scene, const Viewpoint& viewpoint) {
  for (std::size_t i = 0; i < maps_.size(); ++i) {
    const LightFrustum& frustum = maps_[i].frustum;
    const std::string name = fmt::format("u_shadow_lights[{}].", i);
    binder.set(name + "world_to_map", maps_[i].world_to_map());
    binder.set(name + "eye", frustum.eye);
    binder.set(name + "direction", frustum.direction);
    binder.set(name + "half_width", frustum.orthographic ? frustum.extent : std::tan(frustum.extent));
    binder.set(name + "near", frustum.near);
    binder.set(name + "far", frustum.far);
    binder.set(name + "width", float(light_width_));
    binder.set(name + "sun", int(frustum.orthographic));
    binder.set(name + "layer", int(i));
  }
  binder.set("u_bias", bias_size_);
  // The products of matrices err by some ten units in the last place of a float near 1, whatever the format.
  binder.set("u_depth_step", 1e-6f + (format_ == GL_DEPTH_COMPONENT16 ? 1.0f / 65535 : 0.0f));
  if (texture_) binder.texture("u_shadow_maps", texture_.id(), GL_TEXTURE_2D_ARRAY);
  if (shown_light_ < int(scene.lights.size())) {
    const Light& light = scene.lights[std::size_t(shown_light_)];
    const bool sun = light.type == LightType::directional;
    binder.set("u_shown_position", glm::vec3(light.position - viewpoint.origin));
    binder.set("u_shown_direction", sun ? -glm::normalize(light.direction) : glm::vec3(0));
  }
}

}  // namespace atelier
