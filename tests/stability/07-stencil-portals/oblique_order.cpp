// Which of two surfaces is in front, under an oblique near plane: pairs of points a millimetre apart, 2 m to 20 m
// before the eye. A pair is misordered where its depths, as OpenGL computes them from the matrix and stores them in 24
// bits, do not put the nearer point strictly nearer. Handout, section 7: the distance of the eye from the plane takes
// the place of the near plane's.
#include "01-transforms/transforms.hpp"
#include "stability/07-stencil-portals/rows.hpp"

namespace atelier::stability {

namespace {

using namespace stencil_portals;

constexpr int pairs = 2048;
constexpr double apart = 1e-3;                         ///< metres
constexpr double nearest = 2, farthest = 20;           ///< metres, of the nearer points
constexpr float camera_near = 0.1f, camera_far = 100;  ///< metres, of the frame's projection

glm::mat4 ordinary(float near) {
  return transforms::perspective(std::numbers::pi_v<float> / 2, 1, near, camera_far);
}

/// Straight ahead, so many metres before the eye.
glm::mat4 oblique(double distance) {
  return oblique_projection(ordinary(camera_near), glm::vec4(0, 0, -1, -float(distance)));
}

/// Distances of the nearer points, evenly spread in the logarithm.
std::vector<double> near_points() {
  std::vector<double> distances;
  for (int i = 0; i < pairs; ++i) distances.push_back(Trial(791, i).size_between(nearest, farthest));
  return distances;
}

/// Of a point straight ahead, in steps of a buffer of 24 bits.
double stored_depth(const glm::mat4& projection, double distance) {
  const glm::vec4 clip = projection * glm::vec4(0, 0, -float(distance), 1);
  return std::round(double(clip.z / clip.w * 0.5f + 0.5f) * 0xffffff);
}

/// The share of pairs that come out wrong, 0..1.
double misordered_pairs(const glm::mat4& projection) {
  double wrong = 0;
  for (const double z : near_points()) wrong += !(stored_depth(projection, z) < stored_depth(projection, z + apart));
  return wrong / pairs;
}

/// The share of pairs that steps of 2^-24 can be expected to make equal: two depths that are d steps apart fall on the
/// same step with the probability 1 - d. With the plane straight ahead the depth is F / (F - c) (1 - c / w).
double expected_ties(double c) {
  double sum = 0;
  for (const double z : near_points()) {
    const double steps = camera_far * c / (camera_far - c) * (1 / z - 1 / (z + apart)) * 0x1p24;
    sum += std::max(0.0, 1 - steps);
  }
  return sum / pairs;
}

Sweep oblique_order_sweep() {
  Sweep sweep{.name = "oblique-order",
              .title = "Pairs of surfaces a millimetre apart, 2 m to 20 m away, in the wrong order: depths of 24 bits",
              .x_label = "distance of the eye from the plane, m",
              .y_label = "share of misordered pairs",
              .log_y = false,
              .curves = {{"oblique near plane", {}},
                         {"a near plane at that distance", {}},
                         {fmt::format("clip distances, near plane {:g} m", camera_near), {}}}};
  for (int step = -20; step <= 0; ++step) {
    const double distance = std::pow(10.0, step / 4.0);
    sweep.curves[0].points.push_back({distance, misordered_pairs(oblique(distance))});
    sweep.curves[1].points.push_back({distance, misordered_pairs(ordinary(float(distance)))});
    sweep.curves[2].points.push_back({distance, misordered_pairs(ordinary(camera_near))});
  }
  return sweep;
}

}  // namespace

void add_oblique_order_rows(Table& table) {
  Group group = table.of("oblique_projection, order of depths");
  for (const double distance : {1e-4, 1e-3, 1e-2})
    group.close(fmt::format("the eye {:g} m from the plane: as many pairs as steps of 2^-24 make equal", distance),
                {0.1, "of all pairs",
                 "four standard deviations of a share of 2048 pairs are 0.044; the rounding of z and z / w moves a "
                 "depth by half a step, which makes ties of some pairs and parts others"},
                [=] { return std::abs(misordered_pairs(oblique(distance)) - expected_ties(distance)); });
  group.equals("the eye 0.1 m from the plane, where clip distances take over: misordered pairs",
               [] { return Values{misordered_pairs(oblique(camera_near))}; }, {0});
  table.sweeps.push_back(oblique_order_sweep);
}

}  // namespace atelier::stability
