#include "@STEP@/given/probes.hpp"

#include "@STEP@/@NAME@.hpp"

namespace atelier {

std::map<std::string, Probe> @NAME@_probes() {
  return {
      {"density",
       [](ProbeContext&, const Arguments& in) { return Numbers{@NAME@::density(float(in.number("half_distance")))}; }},
      {"density_refuses",
       [](ProbeContext&, const Arguments& in) {
         return refuses([&] { @NAME@::density(float(in.number("half_distance"))); });
       }},
      {"@NAME@_light", shader_probe(text_including("@STEP@/@NAME@.glsl"),
                                 "vec4(@NAME@_light(light, air, density, way, int(pieces)), 0.0)", 3)},
  };
}

}  // namespace atelier
