// hue_chroma_luma: greys and all that is nearly grey, the borders of the six sectors, the place where 1 meets 0.
#include "stability/08-post-processing/rows.hpp"

namespace atelier::stability {

namespace {

const Bound hue_bound{
    4 * rounding_unit, "turns",
    "of a sixth: a quotient of up to 1, which drivers round to 2.5 of its last places, and a sum of up "
    "to 6"};

/// A colour at a border between two sectors, or a float on one side of it: the middle component is one float more than
/// the smallest, or less than the largest.
glm::vec3 at_border(int sixths, int side) {
  glm::vec3 c(0.25f);
  c[(sixths + 1) / 2 % 3] = 0.75f;
  const bool between_two = sixths % 2 != 0;  // yellow, cyan, magenta
  if (between_two) c[(sixths - 1) / 2 % 3] = 0.75f;
  if (side == 0) return c;
  if (between_two) {
    const int less = side > 0 ? (sixths - 1) / 2 % 3 : (sixths + 1) / 2 % 3;
    c[less] = std::nextafter(0.75f, 0.0f);
  } else {
    const int more = (sixths / 2 + (side > 0 ? 1 : 2)) % 3;
    c[more] = std::nextafter(0.25f, 1.0f);
  }
  return c;
}

/// A grey, with up to three floats more in each component.
glm::vec3 nearly_grey(Trial& t) {
  const float grey = float(t.between(1e-3, 1));
  glm::vec3 c;
  for (int i = 0; i < 3; ++i) {
    c[i] = grey;
    for (int more = int(t.between(0, 4)); more > 0; --more) c[i] = std::nextafter(c[i], 2.0f);
  }
  return c;
}

}  // namespace

void add_parts_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("hue_chroma_luma (GLSL)");
  const ShaderFunction function = post_function({"c"}, "vec4(hue_chroma_luma(c.rgb), 0.0)");
  const auto of = [=, &shaders](const glm::vec3& c) { return colours_of(shaders, function, {input_of(c)}); };
  for (const float grey : {0.0f, 1e-30f, 1e-7f, 0.5f, 1.0f, largest_half, 1e30f})
    group.equals(fmt::format("a grey of {:g}: hue and chroma", grey),
                 [=] {
                   const Values parts = of(glm::vec3(grey));
                   return Values{parts[0], parts[1]};
                 },
                 {0, 0});
  for (const int side : {-1, 0, 1})
    for (int sixths = 0; sixths < 6; ++sixths) {
      const glm::vec3 c = at_border(sixths, side);
      const char* where = side == 0 ? "exactly" : side > 0 ? "one float after" : "one float before";
      group.close(fmt::format("a hue of {} sixths, {}", sixths, where), hue_bound,
                  [=] { return turns_between(of(c)[0], hue_of(Colour(c))); });
    }
  for (const float blue : {1e-7f, 1e-30f})
    group.close(fmt::format("red with {:g} of blue: 1, or 0 where that is rounded", blue), hue_bound, [=] {
      return turns_between(of({1, 0, blue})[0], hue_of({1, 0, double(blue)}));
    });

  // Random colours: the errors of the hue in turns, of chroma and luma as a share of themselves.
  const auto worst = [=, &shaders](int part, auto colour) {
    return worst_of_calls<Colour>(
        shaders, function, 10'000, 810, [=](Trial& t) { return input_of(colour(t)); },
        [=](const ShaderInput& in, const Colour& out) {
          const Colour c(in[0]);
          if (part == 0) return turns_between(out.x, hue_of(c));
          const double expected = part == 1 ? chroma_of(c) : luma_of(c);
          return out[part] == expected ? 0 : std::abs(out[part] - expected) / expected;
        });
  };
  for (const float size : {1e-30f, 1e-6f, 1.0f, largest_half, 1e30f}) {
    const auto colour = [=](Trial& t) { return size * some_colour(t); };
    group.close(fmt::format("10000 random colours up to {:g}: hue", size), hue_bound, [=] { return worst(0, colour); });
    group.close(fmt::format("10000 random colours up to {:g}: chroma", size),
                {rounding_unit, "relative", "one difference"}, [=] { return worst(1, colour); });
    group.close(fmt::format("10000 random colours up to {:g}: luma", size),
                {4 * rounding_unit, "relative", "a weight, a product and two sums"}, [=] { return worst(2, colour); });
  }
  group.close("10000 greys with up to 3 floats more in a component: hue", hue_bound,
              [=] { return worst(0, nearly_grey); });
  group.equals("10000 greys with up to 3 floats more in a component: the error of the chroma",
               [=] { return Values{worst(1, nearly_grey)}; }, {0});
  group.equals("10000 colours of each kind: hues outside 0..1",
               [=, &shaders] {
                 double outside = 0;
                 for (const bool nearly : {false, true})
                   outside += worst_of_calls<Colour>(
                       shaders, function, 10'000, 811,
                       [=](Trial& t) { return input_of(nearly ? nearly_grey(t) : some_colour(t)); },
                       [](const ShaderInput&, const Colour& out) { return count_outside({out.x}, 0, 1); });
                 return Values{outside};
               },
               {0});
  group.finite("denormal components", [=] { return of({denormal, 2 * denormal, 0}); });
  add_nan_row(group, shaders, function, input_of(glm::vec3(0.5f, 0.25f, 0.125f)));
}

}  // namespace atelier::stability
