#include "04-point-shadows/point_shadowed_surface.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "render/cull.hpp"

namespace atelier {

using namespace point_shadows;

std::vector<SettingSpec> cube_settings() {
  return {
      {.name = "cube.resolution", .fallback = 512, .low = 1, .high = 4096, .help = "texels along an edge of a cube"},
      {.name = "cube.passes",
       .fallback = std::string("one"),
       .choices = {"one", "six"},
       .help = "how a cube is drawn: all faces at once by a geometry shader, or one after the other"},
      {.name = "cube.faces",
       .fallback = std::string("needed"),
       .choices = {"needed", "all"},
       .help = "which faces are drawn: those that see a caster and, where cubes are drawn for every frame, something "
               "that is seen in the picture; or all"},
      {.name = "cube.instead",
       .fallback = std::string("cone"),
       .choices = {"cone", "never"},
       .help = "what serves a lamp whose casters fit a cone: one map of step 03, or never anything but a cube"},
  };
}

void PointShadowedSurface::configure(const Settings& settings) {
  ShadowedSurface::configure(settings);
  edge_ = settings.integer("cube.resolution");
  layered_ = settings.choice("cube.passes") == "one";
  every_face_ = settings.choice("cube.faces") == "all";
  cones_ = settings.choice("cube.instead") == "cone";
}

void PointShadowedSurface::moved(const Scene& scene) {
  ShadowedSurface::moved(scene);
  cubes_found_ = false;
}

// ---- Which lamps have what

namespace {

/// The distance from a point to the farthest corner of an item's box.
double farthest_corner(const NodePainter::Item& item, const glm::dvec3& from) {
  double farthest = 0;
  for (const glm::dvec3& corner : corners_of(item)) farthest = std::max(farthest, glm::distance(corner, from));
  return farthest;
}

}  // namespace

std::optional<shadow_mapping::LightFrustum> PointShadowedSurface::fit_point(
    const Light&, const glm::vec3& position, std::span<const NodePainter::Item> casters) const {
  if (!cones_) return {};
  std::vector<Sphere> spheres;
  for (const NodePainter::Item& item : casters)
    if (const auto sphere = sphere_around(corners_of(item))) spheres.push_back(*sphere);
  // Radians, 63 degrees: up to 68, whose tangent is sqrt(6), a map has finer texels than a cube of as many.
  constexpr float widest = 1.1f;
  const auto cone = cone_around(position, spheres, widest);
  if (!cone) return {};
  float near = 1e30f, far = 0;
  for (const Sphere& sphere : spheres) {
    const float depth = glm::dot(sphere.centre - position, cone->axis);
    near = std::min(near, depth - sphere.radius);
    far = std::max(far, depth + sphere.radius);
  }
  return shadow_mapping::LightFrustum{.eye = position,
                                      .direction = cone->axis,
                                      .extent = std::max(cone->half_angle, 1e-3f),
                                      .near = std::max(0.99f * near, far / 1000),
                                      .far = far};
}

/// Whether anything in the picture is looked up in a face.
bool PointShadowedSurface::is_looked_up(const glm::mat4& face) const {
  if (every_face_ || !looked_up()) return true;
  // Where a grid of texels that is square to the direction lies across an edge, a step along it is up to sqrt(2) texels
  // of the face wide, and one along its diagonal 2. A normal moves a point by up to sqrt(2) texels aside. Both hold
  // while the steps are short against the distance.
  const float texel = 2 / float(edge_), steps = 0.71f * float(pcf() - 1) + texels_moved();
  if (steps * texel > 0.5f) return true;
  return looks_into(*looked_up(), face, texel * (float(pcf() + 1) + 1.42f * texels_moved()));
}

std::optional<PointShadowedSurface::Cubed> PointShadowedSurface::cube_for(const Scene& scene, int light,
                                                                          const Viewpoint& viewpoint,
                                                                          const NodePainter& painter) const {
  const Light& source = scene.lights[std::size_t(light)];
  if (!source.casts_shadow || has_map(light)) return {};
  Cubed cube{.light = light, .position = glm::vec3(source.position - viewpoint.origin)};
  double far = 0;
  for (int i = 0; i < int(painter.items().size()); ++i) {
    const NodePainter::Item& item = painter.items()[std::size_t(i)];
    if (!scene.nodes[std::size_t(item.node)].casts_shadow || item.box.empty()) continue;
    cube.casters.push_back(i);
    far = std::max(far, farthest_corner(item, glm::dvec3(cube.position)));
  }
  if (cube.casters.empty() || far == 0) return {};
  cube.far = float(1.001 * far);  // floats must not put the farthest caster beyond
  cube.near = cube.far * 1e-5f;   // nothing is lost by a near plane this near: it is distances that are stored
  const glm::mat4 projection = face_projection(cube.near, cube.far);
  for (int face = 0; face < 6; ++face) {
    const glm::mat4 view = face_view(cube.position, face);
    if (!is_looked_up(view)) continue;
    for (const int i : cube.casters) {
      const NodePainter::Item& item = painter.items()[std::size_t(i)];
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

void PointShadowedSurface::find_cubes(const Scene& scene, const Viewpoint& viewpoint, const NodePainter& painter) {
  cubes_.clear();
  for (const int light : lit().points())
    if (int(cubes_.size()) < most_cubes)
      if (auto cube = cube_for(scene, light, viewpoint, painter)) cubes_.push_back(std::move(*cube));
  cubes_found_ = true;
}

// ---- Drawing them

bool PointShadowedSurface::make_room(Gl& gl, std::size_t cube) {
  if (rooms_.size() <= cube) rooms_.resize(cube + 1);
  Room& room = rooms_[cube];
  if (room.made() && room.edge == edge_ && room.format == format() && room.compare == compares()) return true;
  room = {};  // what the student's function throws or OpenGL refuses must not be taken for good later
  Room made{.names = make_cube_map(gl, edge_, format(), compares()),
            .edge = edge_,
            .format = format(),
            .compare = compares()};
  made.texture = GlTexture(gl, made.names.texture);
  made.framebuffer = GlFramebuffer(gl, made.names.framebuffer);
  check_gl_error(gl, fmt::format("make_cube_map: six faces of {0}x{0} texels", edge_).c_str());
  room = std::move(made);
  cubes_[cube].drawn = false;
  return room.made();
}

namespace {

/// The cube pass, in the form that a geometry shader spreads over all faces, or for one face at a time.
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

void PointShadowedSurface::draw_cube(Gl& gl, std::size_t index, NodePainter& painter) {
  static const PassSources all_at_once = cube_pass(true), one_by_one = cube_pass(false);
  Cubed& cube = cubes_[index];
  const CubeMap& names = rooms_[index].names;
  std::array<glm::mat4, 6> matrices;
  for (int face = 0; face < 6; ++face)
    matrices[std::size_t(face)] = face_projection(cube.near, cube.far) * face_view(cube.position, face);
  const auto bind_light = [&](Binder& binder) {
    binder.set("u_light_position", cube.position);
    binder.set("u_far", cube.far);
  };
  begin_cube_pass(gl, names, -1, culls_front_faces());
  if (layered_) {
    painter.paint(all_at_once, cube.casters, [&](Binder& binder) {
      bind_light(binder);
      for (std::size_t face = 0; face < 6; ++face) {
        binder.set(fmt::format("u_face_matrices[{}]", face), matrices[face]);
        binder.set(fmt::format("u_face_wanted[{}]", face), cube.seen[face].empty() ? 0.0f : 1.0f);
      }
    });
  } else {
    for (std::size_t face = 0; face < 6; ++face) {
      if (cube.seen[face].empty()) continue;  // cleared above with all others
      begin_cube_pass(gl, names, int(face), culls_front_faces());
      painter.paint(one_by_one, cube.seen[face], [&](Binder& binder) {
        bind_light(binder);
        binder.set("u_face_matrix", matrices[face]);
      });
    }
  }
  check_gl_error(gl, "drawing a cube of shadow maps");
  cube.drawn = keeps_maps();  // else only what this frame's picture asks
}

void PointShadowedSurface::draw_before(Gl& gl, const Scene& scene, const Viewpoint& viewpoint, NodePainter& painter) {
  ShadowedSurface::draw_before(gl, scene, viewpoint, painter);
  if (!shows_shadows(viewpoint.view)) return;
  if (!cubes_found_ || !keeps_maps() || viewpoint.view.camera_relative) find_cubes(scene, viewpoint, painter);
  for (std::size_t i = 0; i < cubes_.size(); ++i) {
    if (!make_room(gl, i)) continue;
    if (!keeps_maps() || !cubes_[i].drawn) draw_cube(gl, i, painter);
  }
}

namespace {

/// Three columns, two rows: +x -x +y above, -y +z -z below, each as it is stored, first row at the bottom.
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

PointShadowedSurface::PointShadowedSurface(const LitSurface& lit)
    : ShadowedSurface(lit), showing_cube_(GL_TEXTURE_CUBE_MAP, six_faces) {}

bool PointShadowedSurface::draw_instead(Gl& gl, const View& view, const Target& target) {
  const int cube = cube_of(shown_light());
  if (view.output != "shadow_map" || cube < 0) return ShadowedSurface::draw_instead(gl, view, target);
  showing_cube_.draw(gl, target, rooms_[std::size_t(cube)].texture.id());
  return true;
}

// ---- Looking them up

int PointShadowedSurface::cube_of(int light) const {
  for (std::size_t i = 0; i < cubes_.size() && i < rooms_.size(); ++i)
    if (cubes_[i].light == light && rooms_[i].made()) return int(i);
  return -1;
}

Need PointShadowedSurface::need(const Scene& scene, const View& view, const Node& node) const {
  if (!shows_shadows(view)) return {};
  Need need = ShadowedSurface::need(scene, view, node);
  const bool cubes = node.receives_shadow && std::any_of(cubes_.begin(), cubes_.end(),
                                                         [&](const Cubed& cube) { return cube_of(cube.light) >= 0; });
  if (!need.wanted && !cubes) return {};
  if (!need.wanted) need = {.wanted = true, .structure = structure(node.receives_shadow)};
  need.structure["CUBES"] = std::to_string(cubes ? cubes_.size() : 0);
  need.structure["POINT_CUBES"] = glsl_list(lit().points(), [this](int light) { return cube_of(light); });
  if (need.structure.contains("SHOWN_MAP")) need.structure["SHOWN_CUBE"] = std::to_string(cube_of(shown_light()));
  return need;
}

std::map<Slot, SlotCode> PointShadowedSurface::slots() const {
  auto slots = ShadowedSurface::slots();
  slots[Slot::visible_from_point] = {"04-point-shadows/point_shadowed_surface.glsl", "point_visibility"};
  return slots;
}

std::map<std::string, std::string> PointShadowedSurface::outputs() const {
  return {{"shadow_factor", "shown_factor(surface)"}, {"shadow_coordinate", "shown_coordinate(surface)"}};
}

void PointShadowedSurface::bind_view(Binder& binder, const Scene& scene, const Viewpoint& viewpoint) {
  ShadowedSurface::bind_view(binder, scene, viewpoint);
  for (std::size_t i = 0; i < cubes_.size(); ++i) {
    const std::string name = fmt::format("u_cube_lights[{}].", i);
    binder.set(name + "position", cubes_[i].position);
    binder.set(name + "far", cubes_[i].far);
    binder.set(name + "cube", int(i));
    if (i < rooms_.size() && rooms_[i].made())
      binder.texture(fmt::format("u_cube_{}", i), rooms_[i].texture.id(), GL_TEXTURE_CUBE_MAP);
  }
}

void PointShadowedSurface::count(SceneCounts& counts) const {
  ShadowedSurface::count(counts);
  for (const Cubed& cube : cubes_)
    if (cube_of(cube.light) >= 0) counts.lookups += lookups_in_a_map();
}

}  // namespace atelier
