#include "oracle/picture.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <map>
#include <mutex>
#include <optional>
#include <thread>

#include "base/error.hpp"
#include "oracle/normal_map.hpp"
#include "oracle/portal.hpp"
#include "oracle/sky.hpp"

namespace atelier::oracle {

namespace {

const std::map<std::string, Output>& outputs() {
  static const std::map<std::string, Output> named = {{"colour", Output::colour},     {"diffuse", Output::diffuse},
                                                      {"specular", Output::specular}, {"normal", Output::normal},
                                                      {"depth", Output::depth},       {"position", Output::position},
                                                      {"texcoord", Output::texcoord}, {"thing", Output::thing}};
  return named;
}

/// What a ray sees, and from where.
struct Sight {
  std::optional<SurfacePoint> point;
  glm::dvec3 eye{0};                         ///< of the camera, carried through the openings before the point
  glm::dvec3 direction{0, 0, -1};            ///< of the ray behind the last of them
  const Portals::Opening* closed = nullptr;  ///< the point's: no ray goes through it
};

Sight look(const World& world, const Portals& portals, const PictureRequest& request, const Ray& ray,
           const glm::dvec3& eye) {
  Segment segment{.ray = ray, .start = std::min(0.0, ray.least)};
  Sight sight{.point = first_seen(world, portals, segment), .eye = eye};
  for (int passed = 0; sight.point; ++passed) {
    const Portals::Opening* opening = portals.at(*sight.point);
    if (!opening) break;
    if (passed >= request.shading.portal_depth) {
      sight.closed = opening;
      break;
    }
    segment = beyond(*opening, segment, sight.point->t);
    sight.eye = glm::dvec3(opening->through * glm::dvec4(sight.eye, 1));
    sight.point = first_seen(world, portals, segment);
  }
  sight.direction = segment.ray.direction;
  return sight;
}

/// What is behind everything in a direction of world space.
glm::dvec3 background(const Scene& scene, const glm::dvec3& direction) {
  return scene.sky ? sky_colour(*scene.sky, direction) : glm::dvec3(scene.background);
}

/// The value of one ray.
glm::dvec3 sample(const World& world, const Portals& portals, const CameraRays& camera, const PictureRequest& request,
                  const Ray& ray) {
  const Sight sight = look(world, portals, request, ray, camera.eye());
  std::optional<SurfacePoint> point = sight.point;
  if (sight.closed) return request.output == Output::colour ? sight.closed->colour : glm::dvec3(0);
  if (point && request.shading.normal_maps) point = under_normal_map(world.scene(), *point);
  if (!point) return request.output == Output::colour ? background(world.scene(), sight.direction) : glm::dvec3(0);
  const auto shaded = [&](Part part) { return shade(world, *point, sight.eye, request.shading, part); };
  switch (request.output) {
    case Output::colour:
      return shaded(Part::all);
    case Output::diffuse:
      return shaded(Part::diffuse);
    case Output::specular:
      return shaded(Part::specular);
    case Output::normal:
      return point->normal * 0.5 + 0.5;
    case Output::depth:
      return glm::dvec3(camera.depth(point->t, request.reversed_depth));
    case Output::position:
      return point->position - request.position_origin;
    case Output::texcoord:
      return {point->texcoord, 0};
    case Output::thing:
      return glm::dvec3(point->thing + 1);
  }
  return glm::dvec3(0);
}

void trace_row(const World& world, const Portals& portals, const CameraRays& camera, const PictureRequest& request,
               int y, Image& image) {
  const int n = request.samples;
  for (int x = 0; x < image.width(); ++x) {
    glm::dvec3 sum(0);
    for (int row = 0; row < n; ++row)
      for (int column = 0; column < n; ++column) {
        const glm::dvec2 place(x + (column + 0.5) / n, y + (row + 0.5) / n);
        if (!request.lens)
          sum += sample(world, portals, camera, request, camera.through(place));
        else if (const auto direction = request.lens(place / glm::dvec2(request.size)))
          sum += sample(world, portals, camera, request, camera.along(*direction));
      }
    const glm::vec3 mean(sum / double(n * n));
    image.at(x, y) = {mean.r, mean.g, mean.b, 1};
  }
}

/// Distributes the rows of a picture to threads, and stores the first exception.
class Rows {
 public:
  explicit Rows(int count) : count_(count) {}

  /// Processes rows until none is left. `after_each` gets the fraction of rows that have been handed out.
  void work(const std::function<void(int)>& row, const std::function<void(double)>& after_each) {
    try {
      for (int y = next_++; y < count_; y = next_++) {
        row(y);
        if (after_each) after_each(double(std::min(next_.load(), count_)) / count_);
      }
    } catch (...) {
      next_ = count_;  // stops the other threads
      const std::lock_guard lock(guard_);
      if (!thrown_) thrown_ = std::current_exception();
    }
  }
  void rethrow() const {
    if (thrown_) std::rethrow_exception(thrown_);
  }

 private:
  int count_;
  std::atomic<int> next_ = 0;
  std::mutex guard_;
  std::exception_ptr thrown_;
};

}  // namespace

std::vector<std::string> output_names() {
  std::vector<std::string> names;
  for (const auto& [name, output] : outputs()) names.push_back(name);
  return names;
}

Output output_named(const std::string& name) {
  const auto found = outputs().find(name);
  if (found == outputs().end())
    throw Error(fmt::format("output '{}' has no ground truth; {} have one", name, fmt::join(output_names(), ", ")));
  return found->second;
}

Image trace(const World& world, const PictureRequest& request) {
  if (request.samples < 1 || request.samples > 64)
    throw Error(fmt::format("{} x {} samples a pixel (allowed: 1 x 1 to 64 x 64)", request.samples, request.samples));
  validate(request.shading);
  if (request.lens && request.output == Output::depth) throw Error("depths under a lens have no ground truth");
  Image image(request.size.x, request.size.y);
  const CameraRays camera(request.camera, request.size);
  const Portals portals(world.scene());
  Rows rows(request.size.y);
  const auto row = [&](int y) { trace_row(world, portals, camera, request, y, image); };
  {
    const int threads = request.threads > 0 ? request.threads : std::max(1, int(std::thread::hardware_concurrency()));
    std::vector<std::jthread> helpers;
    for (int i = 1; i < threads; ++i) helpers.emplace_back([&] { rows.work(row, {}); });
    rows.work(row, request.progress);
  }
  rows.rethrow();
  return image;
}

}  // namespace atelier::oracle
