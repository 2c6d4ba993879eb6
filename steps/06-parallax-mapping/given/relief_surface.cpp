#include "06-parallax-mapping/given/relief_surface.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "02-blinn-phong/given/scene_texture.hpp"
#include "05-normal-mapping/given/mesh_tangents.hpp"
#include "base/error.hpp"

namespace atelier {

std::vector<SettingSpec> parallax_settings() {
  return {
      {.name = "parallax.method",
       .fallback = std::string("occlusion"),
       .choices = {"none", "offset", "steep", "occlusion", "relief"},
       .help = "how the ray from the eye is followed into the relief"},
      {.name = "parallax.depth",
       .fallback = 0.06,
       .low = 0,
       .high = 0.2,
       .help = "depth of the relief, as a fraction of the texture's side; 0: no relief"},
      {.name = "parallax.layers",
       .fallback = 32,
       .low = 1,
       .high = 256,
       .help = "steps along the ray; with parallax.adaptive at most"},
      {.name = "parallax.adaptive",
       .fallback = false,
       .help = "as many steps as the ray crosses pixels, instead of a fixed number"},
      {.name = "parallax.between",
       .fallback = std::string("secant"),
       .choices = {"secant", "mean"},
       .help = "occlusion: where in the last step the ray meets the relief"},
      {.name = "parallax.bisections", .fallback = 6, .low = 0, .high = 16, .help = "relief: halvings of the last step"},
      {.name = "parallax.shadow_samples",
       .fallback = 0,
       .low = 0,
       .high = 256,
       .help = "steps from the relief towards each light; 0: the relief casts no shadow on itself"},
      {.name = "parallax.edges",
       .fallback = std::string("repeat"),
       .choices = {"repeat", "discard"},
       .help = "what a ray sees that leaves the relief through a side: more of it, or what is behind it"},
      {.name = "parallax.write_depth",
       .fallback = false,
       .help = "store the depth of the relief, so that other surfaces can intersect it"},
      {.name = "parallax.silhouette",
       .fallback = false,
       .help =
           "steep, occlusion, relief: rays follow a curved surface (curved_hit), and those that miss the relief show "
           "what is behind it"},
      {.name = "recorded.nearest", .fallback = 1.0, .low = 0, .high = 1e6, .help = "recorded_height: metres of 1"},
      {.name = "recorded.farthest", .fallback = 8.0, .low = 1e-3, .high = 1e6, .help = "recorded_height: metres of 0"},
  };
}

std::vector<OutputSpec> parallax_outputs() {
  return {
      {"recorded_height", Encoding::data, "nearness as a height, 0 to 1: a height map of what is seen", Stage::aside}};
}

glm::dvec2 recorded_range(const Settings& settings) {
  const glm::dvec2 range(settings.real("recorded.nearest"), settings.real("recorded.farthest"));
  if (!(float(range.x) < float(range.y)))
    throw Error(fmt::format("recorded.farthest: {} (allowed: more than recorded.nearest, {})", range.y, range.x));
  return range;
}

void ReliefSurface::configure(const Settings& settings) {
  const std::string& method = settings.choice("parallax.method");
  method_ = method == "offset"      ? Method::offset
            : method == "steep"     ? Method::steep
            : method == "occlusion" ? Method::occlusion
            : method == "relief"    ? Method::relief
                                    : Method::none;
  depth_ = float(settings.real("parallax.depth"));
  layers_ = settings.integer("parallax.layers");
  adaptive_ = settings.flag("parallax.adaptive");
  mean_ = settings.choice("parallax.between") == "mean";
  bisections_ = settings.integer("parallax.bisections");
  shadow_samples_ = settings.integer("parallax.shadow_samples");
  discard_ = settings.choice("parallax.edges") == "discard";
  write_depth_ = settings.flag("parallax.write_depth");
  silhouette_ = settings.flag("parallax.silhouette") && method_ != Method::none && method_ != Method::offset;
  derivatives_ = settings.choice("normal.tangents") == "derivative";
  filter_ = settings.choice("texture.filter");
  recorded_ = glm::vec2(recorded_range(settings));
}

bool ReliefSurface::has_relief(const Scene& scene, const Material& material) const {
  if (method_ == Method::none || depth_ == 0 || !material.height_texture) return false;
  const auto heights = scene.textures[std::size_t(*material.height_texture)].pixels.pixels();
  return std::any_of(heights.begin(), heights.end(), [](const Rgba& texel) { return texel.r != 1; });
}

std::vector<glm::vec4> ReliefSurface::tangents(const Scene& scene, int mesh) const {
  if (derivatives_) return {};
  return mesh_tangents(scene, mesh, [&](const Material& material) { return has_relief(scene, material); });
}

void ReliefSurface::prepare(Gl& gl, const Scene& scene) {
  heights_.clear();
  for (const Node& node : scene.nodes) {
    const Material& material = scene.materials[std::size_t(node.material)];
    if (!node.mesh || !has_relief(scene, material) || heights_.contains(*material.height_texture)) continue;
    const Texture& texture = scene.textures[std::size_t(*material.height_texture)];
    heights_.emplace(*material.height_texture, upload_scene_texture(gl, texture, texture.pixels, filter_));
  }
  edges_ = edges_of(scene);
}

/// Of all surfaces with a relief together.
glm::vec4 ReliefSurface::edges_of(const Scene& scene) const {
  glm::vec2 low(1e30f), high(-1e30f);
  for (const Node& node : scene.nodes) {
    if (!node.mesh || !has_relief(scene, scene.materials[std::size_t(node.material)])) continue;
    for (const Vertex& vertex : scene.meshes[std::size_t(*node.mesh)].vertices)
      low = glm::min(low, vertex.texcoord), high = glm::max(high, vertex.texcoord);
  }
  return {low, high};
}

Need ReliefSurface::need(const Scene& scene, const View& view, const Node& node) const {
  const bool recorded = view.output == "recorded_height";
  const bool relief = has_relief(scene, scene.materials[std::size_t(node.material)]);
  Need need{.wanted = relief || recorded};
  Defines& d = need.structure;
  if (recorded) d["RECORDED_HEIGHTS"] = "1";
  if (!relief) return need;
  d["RELIEF"] = "1";
  d[derivatives_ ? "DERIVATIVE_TANGENTS" : "TANGENTS"] = "1";
  d["METHOD"] = std::to_string(int(method_));
  if (adaptive_) d["ADAPTIVE"] = "1";
  if (mean_) d["MEAN"] = "1";
  if (method_ == Method::relief) d["BISECTIONS"] = std::to_string(bisections_);
  if (discard_) d["DISCARD_EDGES"] = "1";
  if (write_depth_) d["FRAGMENT_DEPTH"] = "1";
  if (silhouette_) d["SILHOUETTE"] = "1";
  const bool lit = view.output == "colour" || view.output == "diffuse" || view.output == "specular";
  if (shadow_samples_ > 0 && lit) d["SHADOW_SAMPLES"] = std::to_string(shadow_samples_);
  return need;
}

std::map<Slot, SlotCode> ReliefSurface::slots() const {
  const std::string file = "06-parallax-mapping/given/relief_surface.glsl";
  std::map<Slot, SlotCode> slots = {{Slot::displace_texcoord, {file, "find_relief"}}};
  if (discard_ || silhouette_) slots[Slot::discard_fragment] = {file, "discard_outside_relief"};
  if (shadow_samples_ > 0)
    for (const Slot slot : {Slot::visible_from_point, Slot::visible_from_spot, Slot::visible_from_directional})
      slots[slot] = {file, "light_on_relief"};
  return slots;
}

std::map<std::string, std::string> ReliefSurface::outputs() const {
  return {{"recorded_height", "vec3(recorded_height_of(surface))"}};
}

std::vector<DrawConstant> ReliefSurface::draw_constants() const {
  std::vector<DrawConstant> constants = {{"float", "u_depth"}, {"int", "u_layers"}};
  if (discard_) constants.push_back({"vec4", "u_edges"});
  return constants;
}

void ReliefSurface::bind_view(Binder& binder, const Scene&, const Viewpoint&) {
  binder.set("u_depth", depth_);
  binder.set("u_layers", layers_);
  binder.set("u_recorded", recorded_);
}

void ReliefSurface::bind_material(Binder& binder, const Scene&, const Material& material) {
  if (!material.height_texture) return;
  const auto map = heights_.find(*material.height_texture);
  if (map == heights_.end()) return;
  binder.texture("u_height_map", map->second.id());
  binder.set("u_edges", edges_);
}

void ReliefSurface::count(SceneCounts& counts) const {
  if (heights_.empty()) return;
  const int march = method_ == Method::offset ? 1 : layers_ + 1;
  const int refine = silhouette_                              ? 0
                     : method_ == Method::occlusion && !mean_ ? 2
                     : method_ == Method::relief              ? bisections_
                                                              : 0;
  counts.lookups += march + refine + shadow_samples_ * counts.lights;
}

}  // namespace atelier
