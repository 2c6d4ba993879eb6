#include "07-stencil-portals/given/portal_lights.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "03-shadow-mapping/given/shadowed_surface.hpp"
#include "07-stencil-portals/given/openings.hpp"
#include "07-stencil-portals/stencil_portals.hpp"
#include "scene/light_reach.hpp"

namespace atelier {

using namespace stencil_portals;

std::vector<SettingSpec> portal_light_settings() {
  return {{.name = "portals.lights",
           .fallback = false,
           .help = "light goes through portals, and mirrors reflect it; once"}};
}

void PortalLights::configure(const Settings& settings) {
  wanted_ = settings.flag("portals.lights");
  cull_ = settings.flag("light.cull");
  normalised_ = settings.choice("specular.normalisation") != "none";
}

namespace {

constexpr std::size_t most_images = 32;  ///< each has a map, and uniforms in every surface's shader

/// Whether a light shines on the side that a frame's +z faces.
bool shines_on(const glm::dmat4& frame, const Light& light) {
  if (light.type == LightType::directional) return glm::dot(glm::dvec3(frame[2]), glm::dvec3(light.direction)) < 0;
  return glm::dot(glm::dvec3(frame[2]), light.position - glm::dvec3(frame[3])) > 0;
}

/// The most light, on any surface, that an image may give: what comes out of the exit is at least as far from the light
/// as the entry. `given_back`: the most that a surface reflects.
double most_light(const Opening& opening, const Light& light, const glm::dvec3& given_back) {
  Box3 box;
  for (const glm::dvec4& corner : opening.corners()) box.add(glm::dvec3(corner));
  const glm::dvec3 most = most_arriving(light, box) * given_back;
  return std::max({most.r, most.g, most.b});
}

/// The image of a light behind the exit; none if the light does not enter.
std::optional<Light> image_through(const Opening& opening, const Light& light) {
  const bool front = shines_on(opening.frame, light);
  if (!front && !(opening.two_sided && shines_on(from_behind(opening.frame), light))) return {};
  Light image = light_image(light, opening.passage);
  image.passage = {.entry = opening.node,
                   .exit = opening.exit_node,
                   .through = opening.passage,
                   .entry_to_world = front ? opening.frame : from_behind(opening.frame),
                   .exit_to_world = front ? opening.exit : from_behind(opening.exit),
                   .half_size = opening.half_size};
  return image;
}

}  // namespace

void PortalLights::add_lights(const Scene& scene, std::vector<Light>& lights) const {
  if (!wanted_) return;
  const auto lobe = [&](double exponent) { return normalised_ ? (exponent + 8) / 8 : 1; };  // at most (light_reach.hpp)
  const glm::dvec3 given_back = most_given_back(scene.materials, lobe);
  const std::vector<Opening> openings = openings_of(scene);
  // All that are left out together change no pixel by 1/255.
  const double enough = cull_ ? least_visible_light / double(openings.size() * scene.lights.size() + 1) : 0;
  std::size_t images = 0;
  for (const Opening& opening : openings)
    for (int i = 0; i < int(scene.lights.size()); ++i) {
      const Light& light = scene.lights[std::size_t(i)];
      std::optional<Light> image = image_through(opening, light);
      if (!image || most_light(opening, light, given_back) < enough) continue;
      if (++images > most_images)
        throw Error(
            fmt::format("portals.lights=on needs more than {} images of lights: this scene has {} lights and {} "
                        "openings",
                        most_images, scene.lights.size(), openings.size()));
      image->image_of = i;
      lights.push_back(std::move(*image));
    }
}

/// Of the drawn lights, those that are images, in the order of the shader's list.
std::vector<int> PortalLights::images() const {
  std::vector<int> images;
  for (const auto* list : {&lights_.points, &lights_.spots, &lights_.directional})
    std::ranges::copy_if(*list, std::back_inserter(images),
                         [&](int i) { return lights_.light(i).passage.has_value(); });
  return images;
}

Need PortalLights::need(const Scene&, const View&, const Node&) const {
  const std::vector<int> all = images();
  if (all.empty()) return {};
  const auto index = [&](int light) {
    const auto found = std::ranges::find(all, light);
    return found == all.end() ? -1 : int(found - all.begin());
  };
  return {.wanted = true,
          .structure = {{"LIGHT_IMAGES", std::to_string(all.size())},
                        {"POINT_IMAGES", glsl_list(lights_.points, index)},
                        {"SPOT_IMAGES", glsl_list(lights_.spots, index)},
                        {"DIRECTIONAL_IMAGES", glsl_list(lights_.directional, index)}}};
}

std::map<Slot, SlotCode> PortalLights::slots() const {
  const std::string file = "07-stencil-portals/given/portal_lights.glsl";
  return {{Slot::visible_from_point, {file, "point_light_through_opening"}},
          {Slot::visible_from_spot, {file, "spot_light_through_opening"}},
          {Slot::visible_from_directional, {file, "directional_light_through_opening"}}};
}

void PortalLights::bind_view(Binder& binder, const Scene&, const Viewpoint& viewpoint) {
  const std::vector<int> all = images();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Passage& passage = *lights_.light(all[i]).passage;
    const glm::dmat4 to_absolute = glm::translate(glm::dmat4(1), viewpoint.origin);
    const std::string name = fmt::format("u_light_images[{}].", i);
    binder.set(name + "world_to_exit", glm::mat4(glm::inverse(passage.exit_to_world) * to_absolute));
    binder.set(name + "half_size", glm::vec2(passage.half_size));
  }
}

}  // namespace atelier
