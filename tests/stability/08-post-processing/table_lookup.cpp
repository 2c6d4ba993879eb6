// table_trilinear, table_tetrahedral: tables of 2 to 256 grid points a side, at grid points, at edges, on greys.
#include "stability/08-post-processing/rows.hpp"

namespace atelier::stability {

namespace {

enum class Lookup { trilinear, tetrahedral };

/// A table of colours in a texture, as the contract has it.
class ColourGrid {
 public:
  /// `colour_at(place)` for each grid point, red fastest; place is 0..1.
  template <class ColourAt>
  ColourGrid(Gl& gl, int size, ColourAt colour_at) : gl_(&gl), size_(size), texture_(gl) {
    for (int b = 0; b < size; ++b)
      for (int g = 0; g < size; ++g)
        for (int r = 0; r < size; ++r) texels_.emplace_back(colour_at(Colour(r, g, b) / double(size - 1)));
    upload(GL_RGB32F, GL_RGB, texels_.data());
  }
  /// (r + 2 g + 4 b) / 7, in red alone: for the largest tables.
  ColourGrid(Gl& gl, int size) : gl_(&gl), size_(size), texture_(gl) {
    std::vector<float> texels;
    texels.reserve(std::size_t(size) * std::size_t(size) * std::size_t(size));
    for (int b = 0; b < size; ++b)
      for (int g = 0; g < size; ++g)
        for (int r = 0; r < size; ++r) texels.push_back(float(r + 2 * g + 4 * b) / float(7 * (size - 1)));
    upload(GL_R32F, GL_RED, texels.data());
  }

  int size() const { return size_; }
  glm::vec3 texel(const glm::ivec3& at) const { return texels_[std::size_t(at.r + size_ * (at.g + size_ * at.b))]; }

  Values look_up(ShaderFunctions& shaders, Lookup way, const std::vector<glm::vec3>& colours) const {
    ShaderFunction function =
        post_function({"c"},
                      fmt::format("vec4({}(u_colours, c.rgb), 0.0)",
                                  way == Lookup::trilinear ? "table_trilinear" : "table_tetrahedral"),
                      "uniform sampler3D u_colours;\n");
    function.uniforms = {{"u_table_size", {double(size_)}}};
    // The first of `textures` gets unit 1. There the table is bound as a 3D texture, beside no 2D texture.
    function.textures = {{"u_colours", 0}};
    gl_->ActiveTexture(GL_TEXTURE1);
    gl_->BindTexture(GL_TEXTURE_3D, texture_.id());
    std::vector<ShaderInput> calls;
    for (const glm::vec3& c : colours) calls.push_back(input_of(c));
    Values found = colours_of(shaders, function, calls);
    gl_->ActiveTexture(GL_TEXTURE1);
    gl_->BindTexture(GL_TEXTURE_3D, 0);
    gl_->ActiveTexture(GL_TEXTURE0);
    return found;
  }

 private:
  void upload(GLint internal, GLenum format, const void* texels) {
    gl_->BindTexture(GL_TEXTURE_3D, texture_.id());
    gl_->TexImage3D(GL_TEXTURE_3D, 0, internal, size_, size_, size_, 0, format, GL_FLOAT, texels);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
      gl_->TexParameteri(GL_TEXTURE_3D, filter, GL_LINEAR);
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
      gl_->TexParameteri(GL_TEXTURE_3D, wrap, GL_CLAMP_TO_EDGE);
    gl_->BindTexture(GL_TEXTURE_3D, 0);
  }

  Gl* gl_;
  int size_;
  GlTexture texture_;
  std::vector<glm::vec3> texels_;
};

/// Each component of it changes by at most 2.3 over a path from black to white that never turns back.
Colour curved_colour(const Colour& c) {
  return {c.r * c.r, c.g * c.b, c.b - 0.3 * c.r * c.g + 0.1 * std::sin(7 * c.r)};
}

/// The sum of all eight corners' weights times their colours, or of four: of each corner of the tetrahedron the weight
/// is the part of the fraction that no other has.
Colour exactly_looked_up(const ColourGrid& grid, Lookup way, const Colour& colour) {
  const Colour place = colour * double(grid.size() - 1);
  const glm::ivec3 cell = glm::min(glm::ivec3(place), glm::ivec3(grid.size() - 2));
  const Colour part = place - Colour(cell);
  Colour sum(0);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::ivec3 bits(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
    double trilinear = 1, least_in = 1, most_out = 0;
    for (int i = 0; i < 3; ++i) {
      trilinear *= bits[i] ? part[i] : 1 - part[i];
      (bits[i] ? least_in : most_out) = bits[i] ? std::min(least_in, part[i]) : std::max(most_out, part[i]);
    }
    const double weight = way == Lookup::trilinear ? trilinear : std::max(least_in - most_out, 0.0);
    sum += weight * Colour(grid.texel(cell + bits));
  }
  return sum;
}

/// 3000 colours; those of some kinds lie on borders of tetrahedra.
enum class Kind { random, two_alike, greys };
std::vector<glm::vec3> colours_to_look_up(Kind kind) {
  std::vector<glm::vec3> colours;
  for (int i = 0; i < 3000; ++i) {
    Trial t(910, i);
    glm::vec3 c = some_colour(t);
    if (kind == Kind::greys) c = glm::vec3(c.r);
    if (kind == Kind::two_alike) c[i % 3] = c[(i + 1) % 3];
    colours.push_back(c);
  }
  return colours;
}

std::vector<glm::vec3> grid_points(int size) {
  std::vector<glm::vec3> points;
  for (int b = 0; b < size; ++b)
    for (int g = 0; g < size; ++g)
      for (int r = 0; r < size; ++r) points.push_back(glm::vec3(r, g, b) / float(size - 1));
  return points;
}

double lookup_error(ShaderFunctions& shaders, const ColourGrid& grid, Lookup way,
                    const std::vector<glm::vec3>& colours) {
  std::vector<Colour> expected;
  for (const glm::vec3& c : colours) expected.push_back(exactly_looked_up(grid, way, Colour(c)));
  return difference(grid.look_up(shaders, way, colours), all_values(expected));
}

/// Of the centres of all cells of 17 grid points a side, one of which is NaN: how many are lost that do not touch it.
double lost_beyond(ShaderFunctions& shaders, Lookup way) {
  constexpr int size = 17, middle = 8;
  const ColourGrid grid(shaders.gl(), size, [](const Colour& c) {
    return c == Colour(middle / 16.0) ? glm::vec3(not_a_number) : glm::vec3(c);
  });
  std::vector<glm::vec3> colours;
  for (const glm::vec3& c : grid_points(size - 1)) {
    const glm::vec3 cell = glm::round(c * float(size - 2));
    const glm::vec3 off = glm::abs(cell + 0.5f - float(middle));
    if (std::max({off.r, off.g, off.b}) > 1) colours.push_back((cell + 0.5f) / float(size - 1));
  }
  return double(count_non_finite(grid.look_up(shaders, way, colours)));
}

}  // namespace

void add_lookup_rows(Table& table, ShaderFunctions& shaders) {
  Gl& gl = shaders.gl();
  const auto curved = [&gl](int size) {
    return ColourGrid(gl, size, [](const Colour& c) { return glm::vec3(curved_colour(c)); });
  };
  for (const Lookup way : {Lookup::trilinear, Lookup::tetrahedral}) {
    const bool filtered = way == Lookup::trilinear;
    Group group = table.of(filtered ? "table_trilinear (GLSL)" : "table_tetrahedral (GLSL)");
    // A step of the weights is 1/256 of what a component differs by between opposite corners of a cell.
    const auto bound = [=](int size) {
      return filtered
                 ? Bound{2.3 / 256 / (size - 1) + 16 * rounding_unit, "absolute",
                         "drivers mix texels by weights of at least 8 bits; over a cell colours change by up to 2.3 "
                         "divided by the number of cells"}
                 : Bound{16 * rounding_unit, "absolute",
                         "the place is rounded, which counts up to 2.3 times, and four products and their sums"};
    };
    for (const int size : {2, 3, 17, 64}) {
      for (const Kind kind : {Kind::random, Kind::two_alike, Kind::greys})
        group.close(fmt::format("{} grid points, 3000 {}", size,
                                kind == Kind::random      ? "random colours"
                                : kind == Kind::two_alike ? "colours with two components alike"
                                                          : "greys"),
                    bound(size),
                    [=, &shaders] { return lookup_error(shaders, curved(size), way, colours_to_look_up(kind)); });
      group.close(fmt::format("{} grid points: the eight corners", size),
                  {16 * rounding_unit, "absolute", "a texel; the coordinate of its centre is rounded"},
                  [=, &shaders] { return lookup_error(shaders, curved(size), way, grid_points(2)); });
    }
    for (const int size : {2, 9, 17})
      group.close(fmt::format("{} grid points: at each of them", size),
                  {16 * rounding_unit, "absolute", "a texel; the coordinate of its centre is rounded"},
                  [=, &shaders] { return lookup_error(shaders, curved(size), way, grid_points(size)); });
    group.close("256 grid points, a table that is linear: 3000 random colours",
                {(filtered ? 1.0 / 256 / 255 : 0) + 16 * rounding_unit, "absolute",
                 "as above, of a number that changes by 1/255 over a cell"},
                [=, &shaders, &gl] {
                  const std::vector<glm::vec3> colours = colours_to_look_up(Kind::random);
                  const Values found = ColourGrid(gl, 256).look_up(shaders, way, colours);
                  Values expected;
                  for (const glm::vec3& c : colours)
                    expected.insert(expected.end(), {glm::dot(Colour(c), Colour(1, 2, 4)) / 7, 0, 0});
                  return difference(found, expected);
                });
    for (const float level : {1e-30f, largest_half, 1e30f})
      group.close(fmt::format("a table that is {:g} everywhere", level),
                  {6 * rounding_unit, "relative", "the weights sum to 1 up to their roundings"}, [=, &shaders, &gl] {
                    const ColourGrid even(gl, 5, [=](const Colour&) { return glm::vec3(level); });
                    const std::vector<glm::vec3> colours = colours_to_look_up(Kind::random);
                    return relative_difference(even.look_up(shaders, way, colours),
                                               Values(3 * colours.size(), double(level)));
                  });
    group.equals("a NaN at a grid point: cells that do not touch it and are lost",
                 [=, &shaders] { return Values{lost_beyond(shaders, way)}; }, {0});
    group.same(
        "a NaN in one of three pixels: the others",
        [=, &shaders] {
          Values found =
              curved(9).look_up(shaders, way, {{0.3f, 0.4f, 0.5f}, glm::vec3(not_a_number), {0.9f, 0.1f, 0.7f}});
          found.erase(found.begin() + 3, found.begin() + 6);
          return found;
        },
        [=, &shaders] {
          return curved(9).look_up(shaders, way, {{0.3f, 0.4f, 0.5f}, {0.9f, 0.1f, 0.7f}});
        });
  }
  table.of("table_tetrahedral (GLSL)")
      .close("17 grid points, 65504 beside the diagonal: 3000 greys see nothing of it",
             {4 * rounding_unit, "absolute", "two weights, two products and a sum"}, [=, &shaders, &gl] {
               const ColourGrid grid(gl, 17, [](const Colour& c) {
                 return glm::vec3(c.r == c.g && c.g == c.b ? float(c.r) : largest_half);
               });
               const std::vector<glm::vec3> greys = colours_to_look_up(Kind::greys);
               return difference(grid.look_up(shaders, Lookup::tetrahedral, greys), all_values(greys));
             });
}

}  // namespace atelier::stability
