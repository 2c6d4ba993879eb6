#include "12-gallery/given/probes.hpp"

#include <algorithm>
#include <vector>

#include "12-gallery/gallery.hpp"
#include "12-gallery/given/preview_probes.hpp"
#include "12-gallery/given/walk.hpp"
#include "12-gallery/given/wall_probe.hpp"

namespace atelier::gallery {

namespace {

std::array<glm::dvec3, 8> eight_corners(const Arguments& in) {
  const auto& flat = in.numbers("corners");
  std::array<glm::dvec3, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i)
    corners[i] = {flat.at(3 * i), flat.at(3 * i + 1), flat.at(3 * i + 2)};
  return corners;
}

Visitor visitor_of(const Arguments& in) {
  return {.position = in.vec3("position"), .velocity = in.vec3("velocity"), .room = in.integer("room")};
}

Numbers numbers_of(const Visitor& visitor) {
  Numbers out = atelier::numbers_of(visitor.position);
  append(out, atelier::numbers_of(visitor.velocity));
  out.push_back(visitor.room);
  return out;
}

/// For each of `points`: its signed distance from either plane, the larger one first. Then the lengths of both normals.
Numbers probe_side_planes(ProbeContext&, const Arguments& in) {
  const std::array<glm::dvec4, 2> planes = side_planes(in.mat4("frame"), in.vec2("half_size"));
  const auto& flat = in.numbers("points");
  Numbers out;
  for (std::size_t i = 0; i + 3 <= flat.size(); i += 3) {
    const glm::dvec4 point(flat[i], flat[i + 1], flat[i + 2], 1);
    const double first = glm::dot(planes[0], point), second = glm::dot(planes[1], point);
    append(out, Numbers{std::max(first, second), std::min(first, second)});
  }
  for (const glm::dvec4& plane : planes) out.push_back(glm::length(glm::dvec3(plane)));
  return out;
}

/// One number for each of `positions`.
Numbers probe_touches(ProbeContext&, const Arguments& in) {
  const auto& flat = in.numbers("positions");
  Numbers out;
  for (std::size_t i = 0; i + 3 <= flat.size(); i += 3)
    out.push_back(touches(in.mat4("frame"), in.vec2("half_size"), {flat[i], flat[i + 1], flat[i + 2]}));
  return out;
}

/// "steps": in how many equal steps the time passes.
Numbers probe_moved(ProbeContext&, const Arguments& in) {
  Visitor visitor = visitor_of(in);
  const int steps = in.integer("steps");
  for (int i = 0; i < steps; ++i) visitor = moved(visitor, in.vec2("walking"), in.number("seconds") / steps);
  return numbers_of(visitor);
}

/// "walls": four numbers each. How far the farthest corner is behind a wall, how much longer than `most` the way is,
/// and the position if `exact` is 1.
Numbers probe_held(ProbeContext&, const Arguments& in) {
  const auto& flat = in.numbers("walls");
  std::vector<glm::dvec4> walls;
  for (std::size_t i = 0; i + 4 <= flat.size(); i += 4)
    walls.emplace_back(flat[i], flat[i + 1], flat[i + 2], flat[i + 3]);
  const glm::dvec3 position = in.vec3("position"), at = held(walls, position);
  double behind = 0;
  for (const glm::dvec4& wall : walls)
    for (const glm::dvec3& corner : corners_of(at)) behind = std::max(behind, -glm::dot(wall, glm::dvec4(corner, 1)));
  Numbers out{behind, std::max(0.0, glm::distance(position, at) - in.number("most"))};
  if (in.number("exact") > 0.5) append(out, atelier::numbers_of(at));
  return out;
}

/// The walk through all rooms: position and room at each of `count` times, `step` seconds apart.
Numbers probe_walk(ProbeContext&, const Arguments& in) {
  Numbers out;
  for (const Ground::Entry& entry : Ground(in.integer("segments")).diary(in.integer("count"), in.number("step"))) {
    append(out, atelier::numbers_of(entry.position));
    out.push_back(entry.room);
  }
  return out;
}

}  // namespace

}  // namespace atelier::gallery

namespace atelier {

std::map<std::string, Probe> gallery_probes() {
  using namespace gallery;
  std::map<std::string, Probe> probes = preview_probes();
  probes.merge(std::map<std::string, Probe>{
      {"hall_wall",
       [](ProbeContext&, const Arguments& in) {
         return seen_from_axis(hall_wall(in.integer("segments"), float(in.number("radius")), float(in.number("height")),
                                         float(in.number("repeat"))),
                               in.numbers("angles"), in.numbers("heights"));
       }},
      {"painting_frame",
       [](ProbeContext&, const Arguments& in) {
         return atelier::numbers_of(
             painting_frame(in.integer("index"), in.integer("count"), in.number("distance"), in.number("height")));
       }},
      {"meets",
       [](ProbeContext&, const Arguments& in) -> Numbers {
         return {double(meets(in.vec4("plane"), eight_corners(in)))};
       }},
      {"side_planes", probe_side_planes},
      {"touches", probe_touches},
      {"gone_through",
       [](ProbeContext&, const Arguments& in) {
         return numbers_of(gone_through(visitor_of(in), in.mat4("entry"), in.mat4("exit"), in.integer("into"),
                                        in.number("clearance"), in.number("speed")));
       }},
      {"moved", probe_moved},
      {"held", probe_held},
      {"walk", probe_walk},
      {"style_of",
       [](ProbeContext&, const Arguments& in) -> Numbers { return {double(style_of(in.integer("room")))}; }},
  });
  return probes;
}

}  // namespace atelier
