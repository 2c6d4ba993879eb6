// The bounding volume hierarchy finds the same hits as testing every triangle.
#include "catch.hpp"
#include "pieces.hpp"

namespace atelier::test {
namespace {

/// Triangles of all sizes, some flat along an axis, some alike.
Scene confetti(int count) {
  Scene scene = dark_scene();
  scene.materials[0].two_sided = true;
  Dice dice;
  Mesh mesh{.name = "confetti"};
  for (int i = 0; i < count; ++i) {
    const glm::dvec3 middle = 5.0 * dice.in_cube();
    const double size = std::pow(10, -2 * dice.next());
    for (int corner = 0; corner < 3; ++corner) {
      glm::dvec3 p = middle + size * dice.in_cube();
      if (i % 4 == 0) p[i / 4 % 3] = std::round(middle[i / 4 % 3]);
      mesh.indices.push_back(std::uint32_t(mesh.vertices.size()));
      mesh.vertices.push_back({glm::vec3(p), {0, 1, 0}, {0, 0}});
    }
  }
  add_object(scene, mesh, 0);
  return scene;
}

}  // namespace

TEST_CASE("a ray finds the same hit in the tree as one by one", "[bvh]") {
  const Scene scene = confetti(2000);
  const oracle::World world(scene);
  const auto& vertices = scene.meshes[0].vertices;
  Dice dice;
  int met = 0;
  for (int i = 0; i < 2000; ++i) {
    oracle::Ray ray{6.0 * dice.in_cube(), dice.in_cube()};
    if (i % 5 == 0) ray.direction[i / 5 % 3] = 0;                                // along a wall of many boxes
    if (i % 10 == 0) ray.origin[i / 5 % 3] = std::round(ray.origin[i / 5 % 3]);  // and within it
    if (i % 3 == 0) ray.most = 2;
    const oracle::ShearedRay sheared(ray);
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t v = 0; v < vertices.size(); v += 3)
      if (const auto hit = intersect(sheared, glm::dvec3(vertices[v].position), glm::dvec3(vertices[v + 1].position),
                                     glm::dvec3(vertices[v + 2].position)))
        nearest = std::min(nearest, hit->t);
    const auto seen = world.seen(ray);
    INFO("ray " << i);
    CHECK(seen.has_value() == std::isfinite(nearest));
    CHECK(world.blocked(ray) == std::isfinite(nearest));
    if (seen && std::isfinite(nearest)) CHECK(seen->t == nearest);  // the same arithmetic: the same bits
    met += seen.has_value();
  }
  CHECK((met > 100 && met < 1900));
}

TEST_CASE("the tree is shallow for every arrangement", "[bvh]") {
  std::vector<Box3> row, points, heap(5000), spread;
  for (int i = 0; i < 4096; ++i) {
    row.push_back({{i, -1, -1}, {i + 0.5, 1, 1}});
    points.emplace_back().add({i, 0, 0});
    const double x = std::pow(1.15, i % 1000);  // each as far from the next as seven before it together
    spread.push_back({{x, -1, -1}, {x, 1, 1}});
  }
  for (Box3& box : heap) box.add(glm::dvec3(0));
  const struct {
    const char* name;
    const std::vector<Box3>& boxes;
    int deepest;
  } rows[] = {{"in a row", row, 20},
              {"points in a row", points, 20},
              {"all at one place", heap, 20},
              {"ever further apart", spread, 90}};
  for (const auto& [name, boxes, deepest] : rows) {
    INFO(name);
    const oracle::Bvh tree(boxes);
    CHECK(tree.depth() <= deepest);
    int met = 0;
    const double most = 1e300;
    tree.traverse({{-1, 0, 0}, {1, 0, 0}}, most, [&](std::uint32_t) { return ++met, false; });
    CHECK(met == int(boxes.size()));
  }
}

TEST_CASE("an empty tree is allowed", "[bvh]") {
  const oracle::Bvh tree(std::vector<Box3>{});
  CHECK(tree.empty());
  const double most = 1;
  tree.traverse({}, most, [](std::uint32_t) -> bool { throw std::logic_error("met nothing"); });
}

}  // namespace atelier::test
