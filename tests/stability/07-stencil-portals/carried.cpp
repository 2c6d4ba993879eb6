// carried: cameras through a portal once, and there and back 10000 times.
#include "stability/07-stencil-portals/rows.hpp"

namespace atelier::stability {

using namespace stencil_portals;

namespace {

/// Carried `times` through a portal and back through its exit.
Camera there_and_back(Camera camera, const glm::dmat4& entry, const glm::dmat4& exit, int times) {
  const glm::dmat4 there = portal_passage(entry, exit), back = portal_passage(exit, entry);
  for (int i = 0; i < times; ++i) camera = carried(carried(camera, there), back);
  return camera;
}

/// Beside a frame.
Camera camera_by(Trial& t, const glm::dmat4& frame) {
  Camera camera;
  camera.eye = glm::dvec3(frame[3]) + 2.0 * t.direction();
  camera.target = camera.eye + 5.0 * t.direction();
  camera.up = glm::vec3(t.direction());
  return camera;
}

}  // namespace

void add_carried_rows(Table& table) {
  Group group = table.of("carried");
  for (const double distance : {1.0, million})
    group.close(fmt::format("1000 odd portals {:g} m away: eye and target", distance),
                metres(2 * (distance + 10), sums_of_products), [=] {
                  return worst_of(1000, 750, [=](Trial& t) {
                    const glm::dmat4 entry = odd_frame(t, distance), exit = odd_frame(t, distance);
                    const Camera camera = camera_by(t, entry), after = carried(camera, portal_passage(entry, exit));
                    return std::max(largest_of(Exact(after.eye) - through(entry, exit, Exact(camera.eye))),
                                    largest_of(Exact(after.target) - through(entry, exit, Exact(camera.target))));
                  });
                });
  group.close("a million metres away: up", {2 * rounding_unit, "absolute", "a turn in double precision, rounded"}, [] {
    return worst_of(1000, 751, [](Trial& t) {
      const glm::dmat4 entry = odd_frame(t, million), exit = odd_frame(t, million);
      const Camera camera = camera_by(t, entry), after = carried(camera, portal_passage(entry, exit));
      return largest_of(Exact(after.up) - turned_through(entry, exit, Exact(camera.up)));
    });
  });
  for (const double distance : {10.0, million})
    group.close(
        fmt::format("10000 times there and back through odd frames {:g} m away", distance),
        {1e-3, "m", "a visitor may not notice; 20000 passages of some ten roundings of that distance each make 2e-5 m"},
        [=] {
          return worst_of(20, 752, [=](Trial& t) {
            const glm::dmat4 entry = odd_frame(t, distance), exit = odd_frame(t, distance);
            const Camera camera = camera_by(t, entry), after = there_and_back(camera, entry, exit, 10'000);
            return std::max(largest_of(Exact(after.eye) - Exact(camera.eye)),
                            largest_of(Exact(after.target) - Exact(camera.target)));
          });
        });
  group.close(
      "10000 times there and back: where up is", {0.1, "degrees", "20000 roundings of a float, all one way"}, [] {
        return worst_of(20, 753, [](Trial& t) {
          const glm::dmat4 entry = odd_frame(t, 10), exit = odd_frame(t, 10);
          const Camera camera = camera_by(t, entry);
          return degrees_between(glm::dvec3(there_and_back(camera, entry, exit, 10'000).up), glm::dvec3(camera.up));
        });
      });
  group.equals("10000 times there and back at quarter turns and dyadic places: the error",
               [] {
                 return Values{worst_of(20, 754, [](Trial& t) {
                   const glm::dmat4 entry = quarter_frame(t, 2048), exit = quarter_frame(t, 2048);
                   Camera camera;
                   camera.eye = dyadic_place(t, 2048), camera.target = dyadic_place(t, 2048);
                   camera.up = {0, 0.6f, 0.8f};
                   const Camera after = there_and_back(camera, entry, exit, 10'000);
                   return std::max({difference(values(after.eye), values(camera.eye)),
                                    difference(values(after.target), values(camera.target)),
                                    difference(values(after.up), values(camera.up))});
                 })};
               },
               {0});
  group.equals("all else stays",
               [] {
                 Camera camera;
                 camera.projection = Projection::orthographic;
                 camera.fov_y = 3, camera.height = 1e-9f, camera.near = -1e9f, camera.far = infinite;
                 const Camera after = carried(camera, mirror_passage(glm::dmat4(1)));
                 return Values{double(after.projection == Projection::orthographic), double(after.fov_y),
                               double(after.height), double(after.near), double(after.far)};
               },
               {1, 3, double(1e-9f), -1e9, double(infinite)});
}

}  // namespace atelier::stability
