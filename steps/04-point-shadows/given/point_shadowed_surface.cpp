#include "04-point-shadows/given/point_shadowed_surface.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "gl/debug.hpp"
#include "render/cull.hpp"

namespace atelier {

using namespace point_shadows;

std::vector<SettingSpec> cube_settings() {
  return {
      {.name = "cube.resolution", .fallback = 512, .low = 1, .high = 4096, .help = "texels along an edge of a cube"},
      {.name = "cube.passes",
       .fallback = std::string("one"),
       .choices = {"one", "six"},
       .help = "how a cube is drawn: all faces in one pass by a geometry shader, or in six passes"},
      {.name = "cube.faces",
       .fallback = std::string("needed"),
       .choices = {"needed", "all"},
       .help = "which faces are drawn: those that see a caster and, with shadow.update = always, a visible receiver; "
               "or all"},
      {.name = "cube.instead",
       .fallback = std::string("cone"),
       .choices = {"cone", "never"},
       .help = "what a light uses whose casters fit into a cone: one map of step 03 (cone), or a cube all the same "
               "(never)"},
  };
}

void PointShadowedSurface::configure(const Settings& settings) {
  settings_ = shadow_settings(settings);
  edge_ = settings.integer("cube.resolution");
  layered_ = settings.choice("cube.passes") == "one";
  every_face_ = settings.choice("cube.faces") == "all";
}

void PointShadowedSurface::moved(const Scene&) {
  cubes_.clear();
  found_ = false;
}

// ---- Which lights have a cube

namespace {

/// The distance from a point to the farthest corner of an item's box.
double farthest_corner(const ScenePainter::Item& item, const glm::dvec3& from) {
  double farthest = 0;
  for (const glm::dvec3& corner : corners_of(item)) farthest = std::max(farthest, glm::distance(corner, from));
  return farthest;
}

/// Whether all of an item is farther away than this: beyond its box's bounding sphere at least.
bool beyond(const ScenePainter::Item& item, const glm::dvec3& from, double reach) {
  const auto corners = corners_of(item);
  const glm::dvec3 centre = (glm::dvec3(corners.front()) + glm::dvec3(corners.back())) / 2.0;
  double radius = 0;
  for (const glm::dvec3& corner : corners) radius = std::max(radius, glm::distance(corner, centre));
  return glm::distance(centre, from) - radius > reach;
}

}  // namespace

/// Whether any visible receiver samples a face.
bool PointShadowedSurface::is_sampled(const glm::mat4& face) const {
  if (every_face_ || !maps_.visible_receivers) return true;
  // At a cube edge, a step of the texel grid perpendicular to the direction is up to sqrt(2) texels of the face, and a
  // diagonal step 2 texels. The normal offset moves a point sideways by up to sqrt(2) texels. Both hold if the steps
  // are short compared with the distance.
  const float texel = 2 / float(edge_), steps = 0.71f * float(settings_.pcf - 1) + texels_moved(settings_);
  if (steps * texel > 0.5f) return true;
  return looks_into(*maps_.visible_receivers, face,
                    texel * (float(settings_.pcf + 1) + 1.42f * texels_moved(settings_)));
}

std::optional<PointShadowedSurface::Cubed> PointShadowedSurface::cube_for(const Scene& scene, int light,
                                                                          const Viewpoint& viewpoint,
                                                                          const ScenePainter& painter) const {
  const Light& source = lights_.light(light);
  if (!source.casts_shadow || source.passage || maps_.layer_of(light) >= 0) return {};
  Cubed cube{.light = light, .position = glm::vec3(source.position - viewpoint.origin)};
  double far = 0;
  for (int i = 0; i < int(painter.items().size()); ++i) {
    const ScenePainter::Item& item = painter.items()[std::size_t(i)];
    if (!casts(scene, item) || item.box.empty()) continue;
    if (beyond(item, glm::dvec3(cube.position), lights_.reach[std::size_t(light)])) continue;  // shadows nothing lit
    cube.casters.push_back(i);
    far = std::max(far, farthest_corner(item, glm::dvec3(cube.position)));
  }
  if (cube.casters.empty() || far == 0) return {};
  cube.far = float(1.001 * far);  // so that float error does not put the farthest caster behind it
  cube.near = cube.far * 1e-5f;   // a very small near plane costs no precision, since distances are stored
  const glm::mat4 projection = face_projection(cube.near, cube.far);
  for (int face = 0; face < 6; ++face) {
    const glm::mat4 view = face_view(cube.position, face);
    if (!is_sampled(view)) continue;
    for (const int i : cube.casters) {
      const ScenePainter::Item& item = painter.items()[std::size_t(i)];
      if (every_face_ || !outside_view(projection, view, item.model, item.box))
        cube.seen[std::size_t(face)].push_back(i);
    }
  }
  std::erase_if(cube.casters, [&](int i) {
    return std::ranges::none_of(cube.seen,
                                [&](const std::vector<int>& seen) { return std::ranges::count(seen, i) > 0; });
  });
  return cube;
}

void PointShadowedSurface::find_cubes(const Scene& scene, const Viewpoint& viewpoint, const ScenePainter& painter) {
  cubes_.clear();
  for (const int light : lights_.points)
    if (int(cubes_.size()) < most_cubes)
      if (auto cube = cube_for(scene, light, viewpoint, painter)) cubes_.push_back(std::move(*cube));
  found_ = true;
}

// ---- Drawing them

bool PointShadowedSurface::allocate(Gl& gl, std::size_t cube) {
  if (allocations_.size() <= cube) allocations_.resize(cube + 1);
  Allocation& allocation = allocations_[cube];
  if (allocation.is_allocated() && allocation.edge == edge_ && allocation.format == settings_.format &&
      allocation.compare == settings_.bilinear)
    return true;
  allocation = {};  // reset first, in case the student's function throws or OpenGL reports an error
  Allocation created{.names = make_cube_map(gl, edge_, settings_.format, settings_.bilinear),
                     .edge = edge_,
                     .format = settings_.format,
                     .compare = settings_.bilinear};
  created.texture = GlTexture(gl, created.names.texture);
  created.framebuffer = GlFramebuffer(gl, created.names.framebuffer);
  check_gl_error(gl, fmt::format("make_cube_map: six faces of {0}x{0} texels", edge_).c_str());
  const std::string name = name_of(lights_, cubes_[cube].light, "shadow cube");
  label(gl, GL_TEXTURE, created.texture.id(), name);
  label(gl, GL_FRAMEBUFFER, created.framebuffer.id(), name);
  allocation = std::move(created);
  cubes_[cube].drawn = false;
  return allocation.is_allocated();
}

namespace {

/// The cube pass, either layered by a geometry shader or for one face at a time.
PassSources cube_pass(bool layered) {
  const std::string include = "#include \"04-point-shadows/cube_pass.glsl\"\n";
  PassSources pass{.name = "cube pass"};
  pass.fragment =
      "#define FRAGMENT\nuniform vec3 u_light_position;\nuniform float u_far;\nin vec3 g_position_world;\n" + include +
      "void main() { gl_FragDepth = stored_distance(g_position_world, u_light_position, u_far); }\n";
  if (!layered) {
    pass.vertex =
        "uniform mat4 u_face_matrix;\nout vec3 g_position_world;\n"
        "void main() {\n"
        "  g_position_world = world_position(u_model, a_position);\n"
        "  gl_Position = u_face_matrix * vec4(g_position_world, 1.0);\n"
        "}\n";
    return pass;
  }
  pass.vertex = "out vec3 v_corner_world;\nvoid main() { v_corner_world = world_position(u_model, a_position); }\n";
  pass.geometry =
      "#define GEOMETRY\nlayout(triangles) in;\nlayout(triangle_strip, max_vertices = 18) out;\n"
      "in vec3 v_corner_world[];\nout vec3 g_position_world;\n"
      "uniform mat4 u_face_matrices[6];\nuniform float u_face_wanted[6];\n" +
      include + "void main() { draw_in_faces(); }\n";
  return pass;
}

}  // namespace

void PointShadowedSurface::draw_cube(Gl& gl, std::size_t index, ScenePainter& painter) {
  static const PassSources all_at_once = cube_pass(true), one_by_one = cube_pass(false);
  Cubed& cube = cubes_[index];
  const DebugGroup group(gl, name_of(lights_, cube.light, "shadow cube"));
  const CubeMap& names = allocations_[index].names;
  std::array<glm::mat4, 6> matrices;
  for (int face = 0; face < 6; ++face)
    matrices[std::size_t(face)] = face_projection(cube.near, cube.far) * face_view(cube.position, face);
  const auto bind_light = [&](Binder& binder) {
    binder.set("u_light_position", cube.position);
    binder.set("u_far", cube.far);
  };
  begin_cube_pass(gl, names, -1, settings_.culls_front_faces());
  const bool ends =
      std::ranges::any_of(cube.casters, [&](int i) { return painter.items()[std::size_t(i)].kept.has_value(); });
  if (layered_ && !ends) {  // a geometry shader would draw beyond the planes at which nodes end
    painter.paint(all_at_once, cube.casters, [&](Binder& binder) {
      bind_light(binder);
      for (std::size_t face = 0; face < 6; ++face) {
        binder.set(fmt::format("u_face_matrices[{}]", face), matrices[face]);
        binder.set(fmt::format("u_face_wanted[{}]", face), cube.seen[face].empty() ? 0.0f : 1.0f);
      }
    });
  } else {
    for (std::size_t face = 0; face < 6; ++face) {
      if (cube.seen[face].empty()) continue;  // already cleared above
      begin_cube_pass(gl, names, int(face), settings_.culls_front_faces());
      painter.paint(one_by_one, cube.seen[face], [&](Binder& binder) {
        bind_light(binder);
        binder.set("u_face_matrix", matrices[face]);
      });
    }
  }
  check_gl_error(gl, "drawing a cube of shadow maps");
  cube.drawn = settings_.keep;  // otherwise only what this frame needs is drawn
}

void PointShadowedSurface::draw_before(Gl& gl, const Scene& scene, const Viewpoint& viewpoint, ScenePainter& painter) {
  const bool shown = shows_shadows(viewpoint.view) && viewpoint.view.output != "shadow_map";
  shown_ |= shown;
  if (!shows_shadows(viewpoint.view)) return;
  const bool keep = settings_.keep;
  if (!found_ || !keep || viewpoint.view.camera_relative) find_cubes(scene, viewpoint, painter);
  for (std::size_t i = 0; i < cubes_.size(); ++i) {
    if (!allocate(gl, i)) continue;
    if (!keep || !cubes_[i].drawn) draw_cube(gl, i, painter);
  }
  if (Defines now = structure(); now != structure_) {
    structure_ = std::move(now);
    structure_changed();
  }
}

namespace {

/// Three columns, two rows: +x -x +y above, -y +z -z below, each unmodified, first row at the bottom.
constexpr const char* six_faces = R"(uniform samplerCube u_map; uniform vec2 u_size; out vec4 o;
void main() {
  vec2 place = gl_FragCoord.xy / u_size * vec2(3.0, 2.0);
  int face = int(place.x) + (place.y < 1.0 ? 3 : 0);
  vec2 st = fract(place) * 2.0 - 1.0;
  vec3 direction = face == 0 ? vec3(1.0, -st.y, -st.x) : face == 1 ? vec3(-1.0, -st.y, st.x)
                 : face == 2 ? vec3(st.x, 1.0, st.y)   : face == 3 ? vec3(st.x, -1.0, -st.y)
                 : face == 4 ? vec3(st.x, -st.y, 1.0)  : vec3(-st.x, -st.y, -1.0);
  o = vec4(texture(u_map, direction).rrr, 1.0);
})";

}  // namespace

PointShadowedSurface::PointShadowedSurface(const DrawnLights& lights, const FrameMaps& maps)
    : lights_(lights), maps_(maps), showing_cube_(GL_TEXTURE_CUBE_MAP, six_faces) {}

bool PointShadowedSurface::draw_instead(Gl& gl, const View& view, const Target& target) {
  const int cube = cube_of(settings_.shown_light);
  if (view.output != "shadow_map" || cube < 0) return false;
  showing_cube_.draw(gl, target, allocations_[std::size_t(cube)].texture.id());
  return true;
}

// ---- Sampling them

int PointShadowedSurface::cube_of(int light) const {
  for (std::size_t i = 0; i < cubes_.size() && i < allocations_.size(); ++i)
    if (cubes_[i].light == light && allocations_[i].is_allocated()) return int(i);
  return -1;
}

bool PointShadowedSurface::any_cube() const {
  return std::ranges::any_of(cubes_, [this](const Cubed& cube) { return cube_of(cube.light) >= 0; });
}

/// The #defines of surfaces that receive shadows. Only the shadow outputs use SHOWN_CUBE.
Defines PointShadowedSurface::structure() const {
  Defines d = filter_structure(settings_);
  d["CUBES"] = std::to_string(any_cube() ? cubes_.size() : 0);
  d["POINT_CUBES"] = glsl_list(lights_.points, [this](int light) { return cube_of(light); });
  d["SHOWN_CUBE"] = std::to_string(cube_of(settings_.shown_light));
  return d;
}

Need PointShadowedSurface::need(const Scene&, const View& view, const Node& node) const {
  // Step 03 shows the output of a light without a cube.
  const bool alone = shows_shadows_alone(view);
  const bool wanted = alone ? cube_of(settings_.shown_light) >= 0 : any_cube() && node.receives_shadow;
  if (!shows_shadows(view) || !wanted) return {};
  Need need{.wanted = true, .structure = structure_};
  if (!node.receives_shadow) need.structure["CUBES"] = "0";
  if (!alone) need.structure.erase("SHOWN_CUBE");
  return need;
}

std::map<Slot, SlotCode> PointShadowedSurface::slots() const {
  return {
      {Slot::visible_from_point, {"04-point-shadows/given/point_shadowed_surface.glsl", "point_visibility_by_cube"}}};
}

std::map<std::string, std::string> PointShadowedSurface::outputs() const {
  return {{"shadow_factor", "shown_cube_factor(surface)"}, {"shadow_coordinate", "shown_cube_coordinate(surface)"}};
}

std::vector<DrawConstant> PointShadowedSurface::draw_constants() const {
  std::vector<DrawConstant> constants = bias_constants();
  constants.push_back(
      {"CubeLight", "u_cube_lights", "CUBES", {{"vec3", "position"}, {"float", "far"}, {"int", "cube"}}});
  return constants;
}

void PointShadowedSurface::bind_view(Binder& binder, const Scene&, const Viewpoint&) {
  bind_bias(binder, settings_);
  for (std::size_t i = 0; i < cubes_.size(); ++i) {
    const std::string name = fmt::format("u_cube_lights[{}].", i);
    binder.set(name + "position", cubes_[i].position);
    binder.set(name + "far", cubes_[i].far);
    binder.set(name + "cube", int(i));
    if (i < allocations_.size() && allocations_[i].is_allocated())
      binder.texture(fmt::format("u_cube_{}", i), allocations_[i].texture.id(), GL_TEXTURE_CUBE_MAP);
  }
}

void PointShadowedSurface::count(SceneCounts& counts) const {
  if (!shown_) return;
  std::int64_t most = 0;
  for (const std::vector<int>& lights : lights_.together)
    most = std::max<std::int64_t>(most, std::ranges::count_if(lights, [&](int light) { return cube_of(light) >= 0; }));
  counts.lookups += most * lookups_in_a_map(settings_);
}

}  // namespace atelier
