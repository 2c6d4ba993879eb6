// world_matrices: deep, wide, in any order, and hierarchies that cannot be.
#include <climits>
#include <numeric>

#include "stability/01-transforms/exact.hpp"
#include "stability/01-transforms/rows.hpp"

namespace atelier::stability {

using transforms::world_matrices;

namespace {

/// A chain in which every joint hangs on the next one, so that the whole of it is above the first.
std::vector<Joint> chain(int depth, const glm::mat4& local) {
  std::vector<Joint> joints;
  for (int i = 0; i < depth; ++i) joints.push_back({i + 1 < depth ? i + 1 : -1, local});
  return joints;
}

glm::mat4 step_of(const glm::vec3& offset) {
  glm::mat4 m(1.0f);
  m[3] = glm::vec4(offset, 1);
  return m;
}

/// A hundredth of a turn about an oblique axis, and a step: rounded floats, whose product the exact truth takes as is.
glm::mat4 screw() {
  glm::mat4 m(glm::mat3(exact::rotation({1, 2, 2}, 0.0628)));
  m[3] = glm::vec4(0.1f, 0.02f, 0, 1);
  return m;
}

/// The first joint's matrix against its exact one, as a share of that one's largest entry.
double chain_error(int depth) {
  const std::vector<Joint> joints = chain(depth, screw());
  glm::dmat4 expected(1);
  for (const Joint& joint : joints) expected = glm::dmat4(joint.local) * expected;
  return relative_difference(values(world_matrices(joints).front()), values(expected));
}

void add_depth_rows(Group& group) {
  for (const int depth : {1'000, 100'000})
    group.equals(
        fmt::format("a chain {} deep, listed child first", depth),
        [=] {
          return values(world_matrices(chain(depth, step_of({1, 0, 0}))).front());
        },
        values(step_of({float(depth), 0, 0})));
  group.close("a chain of 1000 that turns and steps",
              {1000 * 4 * rounding_unit, "relative",
               "each of the 1000 products adds at most four roundings of the largest entry"},
              [] { return chain_error(1000); });
  group.equals(
      "100 000 children of one root",
      [] {
        std::vector<Joint> joints(100'001, Joint{0, step_of({0, 1, 0})});
        joints.front() = {-1, step_of({5, 0, 0})};
        return values(world_matrices(joints).back());
      },
      values(step_of({5, 1, 0})));
  group.equals("no joints at all", [] { return Values{double(world_matrices({}).size())}; }, {0});
  group.finite("200 joints that each halve: below the smallest float", [] {
    glm::mat4 half(1.0f);
    half[0][0] = half[1][1] = half[2][2] = 0.5f;
    return all_values(world_matrices(chain(200, half)));
  });
}

void add_refusals(Group& group) {
  const std::pair<const char*, int> parents[] = {
      {"-2", -2}, {"the number of joints", 3}, {"the smallest int", INT_MIN}, {"the largest int", INT_MAX}};
  for (const auto& [words, parent] : parents)
    group.refuses(fmt::format("a parent of {}", words), [parent = parent] {
      world_matrices(std::vector<Joint>{{-1, {}}, {parent, {}}, {-1, {}}});
    });
  for (const int length : {1, 2, 3, 10'000})
    group.refuses(fmt::format("a cycle of {}, below a good root", length), [=] {
      std::vector<Joint> joints = {{-1, glm::mat4(1)}};
      for (int i = 0; i < length; ++i) joints.push_back({1 + (i + 1) % length, glm::mat4(1)});
      world_matrices(joints);
    });
  group.refuses("a chain that ends in a cycle", [] {
    std::vector<Joint> joints = chain(1000, glm::mat4(1));
    joints.back().parent = 990;
    world_matrices(joints);
  });
}

/// A random tree in a random order: parents may stand before or behind their children.
std::vector<Joint> random_tree(Trial& t, int size) {
  std::vector<int> place(std::size_t(size), 0);
  std::iota(place.begin(), place.end(), 0);
  for (int i = size - 1; i > 0; --i) std::swap(place[std::size_t(i)], place[std::size_t(t.between(0, i + 1))]);
  std::vector<Joint> joints(std::size_t(size), Joint{});
  for (int i = 0; i < size; ++i) {
    Joint& joint = joints[std::size_t(place[std::size_t(i)])];
    joint.parent = i == 0 ? -1 : place[std::size_t(t.between(0, i))];
    joint.local = glm::mat4(glm::mat3(exact::rotation(t.direction(), t.between(-3, 3))));
    joint.local[3] = glm::vec4(t.in_cube(2), 1);
  }
  return joints;
}

}  // namespace

void add_hierarchy_rows(Table& table) {
  Group group = table.of("world_matrices");
  add_depth_rows(group);
  add_refusals(group);
  group.close(
      "300 random trees of 40 joints in random order",
      {20 * 4 * rounding_unit, "relative", "no path is longer than 20 joints in these; four roundings each"}, [] {
        return worst_of(300, 10, [](Trial& t) {
          const std::vector<Joint> joints = random_tree(t, 40);
          return relative_difference(all_values(world_matrices(joints)), all_values(exact::world_matrices(joints)));
        });
      });
}

}  // namespace atelier::stability
