// mipmaps and upload_texture: sides of 1, odd sides, values that are no colours.
#include "stability/02-blinn-phong/rows.hpp"

namespace atelier::stability {

using blinn_phong::mipmaps;

namespace {

Image noise(int width, int height, std::uint64_t seed) {
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      Trial t(seed, y * std::int64_t(width) + x);
      const auto value = [&] { return float(t.between(0, 1)); };
      image.at(x, y) = {value(), value(), value(), value()};
    }
  return image;
}

Values sizes(const std::vector<Image>& levels) {
  Values out;
  for (const Image& level : levels) out.insert(out.end(), {double(level.width()), double(level.height())});
  return out;
}

glm::dvec4 mean(const Image& image) {
  glm::dvec4 sum(0);
  for (const Rgba& p : image.pixels()) sum += glm::dvec4(p.r, p.g, p.b, p.a);
  return sum / double(image.pixels().size());
}

/// The last level against the mean of exactly those pixels that halving reaches: of each side the largest power of two,
/// which is what rounding down leaves behind.
double last_pixel_error(int width, int height) {
  const Image base = noise(width, height, 90);
  const std::vector<Image> levels = mipmaps(base);
  const int w = 1 << int(std::log2(width)), h = 1 << int(std::log2(height));
  Image reached(w, h);
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x) reached.at(x, y) = base.at(x, y);
  return difference(values(mean(levels.back())), values(mean(reached)));
}

double worst_mean_error(int width, int height) {
  const std::vector<Image> levels = mipmaps(noise(width, height, 91));
  double worst = 0;
  for (const Image& level : levels)
    worst = std::max(worst, difference(values(mean(level)), values(mean(levels.front()))));
  return worst;
}

void add_mipmap_rows(Table& table) {
  Group group = table.of("mipmaps");
  group.equals("1x1: one level", [] { return sizes(mipmaps(Image(1, 1))); }, {1, 1});
  group.equals("1x5", [] { return sizes(mipmaps(Image(1, 5))); }, {1, 5, 1, 2, 1, 1});
  group.equals("7x1", [] { return sizes(mipmaps(Image(7, 1))); }, {7, 1, 3, 1, 1, 1});
  group.equals("5x3", [] { return sizes(mipmaps(Image(5, 3))); }, {5, 3, 2, 1, 1, 1});
  group.equals("16384x1: fifteen levels", [] { return Values{double(mipmaps(Image(16384, 1)).size())}; }, {15});
  const Bound last{16 * rounding_unit, "absolute",
                   "up to 14 levels, three sums each that halve in weight: one rounding a level"};
  for (const auto& [w, h] : {std::pair{1, 1}, {1, 7}, {13, 1}, {3, 3}, {5, 9}, {255, 129}, {1, 16384}})
    group.close(fmt::format("{}x{}: the last pixel is the mean of what halving reaches", w, h), last,
                [w = w, h = h] { return last_pixel_error(w, h); });
  group.close("256x64: every level keeps the mean", {9 * rounding_unit, "absolute", "a rounding a level, nine levels"},
              [] { return worst_mean_error(256, 64); });
  group.equals("one white value of 1e6 among zeros is not clamped",
               [] {
                 Image base(4, 4, {0, 0, 0, 0});
                 base.at(2, 1) = {1e6f, 0, 0, 16};
                 const Rgba last_pixel = mipmaps(base).back().at(0, 0);
                 return Values{double(last_pixel.r), double(last_pixel.a)};
               },
               {62500, 1});
  group.equals("negative data stays negative",
               [] {
                 return Values{double(mipmaps(Image(8, 8, {-3, 0, 0, 1})).back().at(0, 0).r)};
               },
               {-3});
  group.equals("a NaN stays where it is",
               [] {
                 Image base(4, 4);
                 base.at(3, 3).g = not_a_number;
                 const Image below = mipmaps(base).at(1);
                 Values seen;
                 for (const Rgba& p : below.pixels()) seen.push_back(std::isnan(p.g));
                 return seen;
               },
               {0, 0, 0, 1});
  group.finite("values of 8e37: the largest whose sum is a float", [] {
    const Rgba p = mipmaps(Image(2, 2, {8e37f, 8e37f, 8e37f, 1})).back().at(0, 0);
    return Values{double(p.r), double(p.g), double(p.b)};
  });
}

/// Size and number of levels as OpenGL sees them, OpenGL's error, and whether what it keeps are the very pixels,
/// turned.
Values after_upload(Gl& gl, int width, int height, bool chain, float special = 0.5f) {
  Image base = noise(width, height, 92);
  base.at(0, 0).r = special;
  std::vector<Image> levels = {base};
  if (chain) levels = mipmaps(base);
  const GlTexture texture(
      gl, blinn_phong::upload_texture(gl, levels, Wrap::repeat, chain ? Filter::mipmap : Filter::nearest));
  gl.BindTexture(GL_TEXTURE_2D, texture.id());
  GLint w = 0, h = 0, highest = 0;
  gl.GetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &w);
  gl.GetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_HEIGHT, &h);
  gl.GetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, &highest);
  double different = w == width && h == height ? 0 : 1;
  if (different == 0) {
    std::vector<Rgba> texels(base.pixels().size());
    gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, texels.data());
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const Rgba &kept = texels[std::size_t(height - 1 - y) * std::size_t(width) + std::size_t(x)],
                   &given = base.at(x, y);
        different += !(kept == given || (std::isnan(kept.r) && std::isnan(given.r)));
      }
  }
  gl.BindTexture(GL_TEXTURE_2D, 0);
  return {double(w), double(h), double(highest), double(gl.GetError()), different};
}

void add_upload_rows(Table& table, Gl& gl) {
  Group group = table.of("upload_texture");
  group.equals("1x1", [&gl] { return after_upload(gl, 1, 1, false); }, {1, 1, 0, 0, 0});
  group.equals("5x3 with its chain", [&gl] { return after_upload(gl, 5, 3, true); }, {5, 3, 2, 0, 0});
  group.equals("1x7 with its chain", [&gl] { return after_upload(gl, 1, 7, true); }, {1, 7, 2, 0, 0});
  group.equals("4096x1", [&gl] { return after_upload(gl, 4096, 1, false); }, {4096, 1, 0, 0, 0});
  for (const float special : {not_a_number, infinite, -1.0f, 1e30f})
    group.equals(fmt::format("a texel of {:g} stays as it is", special),
                 [&gl, special] { return after_upload(gl, 3, 2, false, special); }, {3, 2, 0, 0, 0});
}

}  // namespace

void add_texture_rows(Table& table, ShaderFunctions& shaders) {
  add_mipmap_rows(table);
  add_upload_rows(table, shaders.gl());
}

}  // namespace atelier::stability
