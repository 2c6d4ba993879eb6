#include "stability/nan_row.hpp"

#include <vector>

#include "stability/extremes.hpp"

namespace atelier::stability {

void add_nan_row(Group& group, ShaderFunctions& shaders, const ShaderFunction& function, const ShaderInput& call,
                 const std::string& words) {
  const auto others = [=, &shaders](bool broken) {
    std::vector<ShaderInput> calls(64, call);
    if (broken) calls[31][0] = glm::vec4(not_a_number);
    std::vector<glm::vec4> found = shaders.evaluate(function, calls);
    found.erase(found.begin() + 31);
    return all_values(found);
  };
  group.same(
      words + "a NaN in one pixel: all others", [=] { return others(true); }, [=] { return others(false); });
}

}  // namespace atelier::stability
