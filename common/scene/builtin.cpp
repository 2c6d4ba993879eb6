#include "scene/builtin.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.hpp"
#include "scene/builtin_scenes.hpp"

namespace atelier {
namespace {

struct Entry {
  const char* name;
  Scene (*make)();
};

constexpr Entry entries[] = {
    {"teapot", builtin::teapot},       {"sphere", builtin::sphere}, {"primitives", builtin::primitives},
    {"materials", builtin::materials}, {"lights", builtin::lights}, {"robot", builtin::robot},
    {"room", builtin::room},           {"hall", builtin::hall},
};

}  // namespace

std::vector<std::string> builtin_scene_names() {
  std::vector<std::string> names;
  for (const Entry& entry : entries) names.push_back(entry.name);
  return names;
}

Scene make_builtin_scene(std::string_view name) {
  for (const Entry& entry : entries)
    if (name == entry.name) {
      Scene scene = entry.make();
      scene.name = entry.name;
      return scene;
    }
  throw Error(fmt::format("there is no scene '{}' (allowed: {})", name, fmt::join(builtin_scene_names(), ", ")));
}

}  // namespace atelier
