#include "09-dithering/given/probes.hpp"

#include <algorithm>
#include <cmath>

#include "09-dithering/dithering.hpp"
#include "09-dithering/given/exact_diffusion.hpp"
#include "09-dithering/given/noise_check.hpp"
#include "09-dithering/given/patterns.hpp"
#include "09-dithering/given/read_bitmap.hpp"

namespace atelier {

namespace {

using namespace dithering;

// ---- Bayer's matrix

/// The rank in a row and column.
Numbers probe_bayer(ProbeContext&, const Arguments& in) {
  const int size = in.integer("size");
  const std::vector<int> matrix = bayer_matrix(size);
  if (matrix.size() != std::size_t(size) * std::size_t(size)) return {double(matrix.size()), -1};
  return {double(matrix.size()), double(matrix[std::size_t(in.integer("row") * size + in.integer("column"))])};
}

// ---- Diffused errors

Kernel kernel_of(const Arguments& in) {
  return in.integer("atkinson") ? Kernel::atkinson : Kernel::floyd_steinberg;
}

/// What one neighbour gets, in sixteenths; how many neighbours get something, and how much all together.
Numbers probe_shares(ProbeContext&, const Arguments& in) {
  double part = 0, all = 0, count = 0;
  for (const Share& share : shares_of(kernel_of(in))) {
    if (share.right == in.integer("right") && share.down == in.integer("down")) part += double(share.part);
    all += double(share.part);
    count += share.part != 0;
  }
  return {16 * part, count, 16 * all};
}

Diffusion diffusion_of(const Arguments& in) {
  return {.levels = in.integer("levels"), .kernel = kernel_of(in), .serpentine = in.integer("serpentine") != 0};
}

std::vector<float> values_of(const Arguments& in) {
  const std::vector<double>& numbers = in.numbers("values");
  return {numbers.begin(), numbers.end()};
}

/// The levels of up to 12 pixels; -1 for those that there are not.
Numbers probe_diffused(ProbeContext&, const Arguments& in) {
  const std::vector<std::uint8_t> levels = diffused(values_of(in), in.integer("width"), diffusion_of(in));
  Numbers out;
  for (std::size_t i = 0; i < 12; ++i) out.push_back(i < levels.size() ? double(levels[i]) : -1);
  return out;
}

/// Slopes with noise: codes without flat parts, where a last digit could decide between two levels.
std::vector<std::uint8_t> slope_codes(int width, int height, int channels, int seed) {
  std::vector<std::uint8_t> codes;
  std::uint32_t state = std::uint32_t(seed) * 2654435761u + 1;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int channel = 0; channel < channels; ++channel) {
        state = state * 1664525u + 1013904223u;  // Numerical Recipes, 2nd edition, 7.1
        const int slope = channel % 2 == 0 ? 230 * x / std::max(width - 1, 1) : 230 * y / std::max(height - 1, 1);
        codes.push_back(std::uint8_t(slope + int(state >> 24) % 24));
      }
  return codes;
}

/// How many pixels of a larger picture have another level than in double precision.
Numbers probe_diffused_picture(ProbeContext&, const Arguments& in) {
  const int width = in.integer("width"), height = in.integer("height");
  const std::vector<std::uint8_t> codes = slope_codes(width, height, 1, in.integer("picture"));
  std::vector<float> values;
  std::vector<double> exact;
  for (const std::uint8_t code : codes) {
    values.push_back(float(code) * (1.0f / 255));
    exact.push_back(code / 255.0);
  }
  const Diffusion how = diffusion_of(in);
  const std::vector<std::uint8_t> levels = diffused(values, width, how);
  const std::vector<int> right =
      exactly_diffused(exact, width, how.levels, how.kernel == Kernel::atkinson, how.serpentine);
  double wrong = 0;
  for (std::size_t i = 0; i < right.size(); ++i) wrong += i >= levels.size() || levels[i] != right[i];
  return {double(levels.size()), wrong};
}

/// The same of diffused_fast, over four channels.
Numbers probe_fast(ProbeContext&, const Arguments& in) {
  const int width = in.integer("width"), height = in.integer("height"), levels = in.integer("levels");
  const std::vector<std::uint8_t> codes = slope_codes(width, height, 4, in.integer("picture"));
  const std::vector<std::uint8_t> fast = diffused_fast(codes, width, levels);
  double wrong = 0;
  for (std::size_t channel = 0; channel < 4; ++channel) {
    std::vector<double> exact;
    for (std::size_t i = channel; i < codes.size(); i += 4) exact.push_back(codes[i] / 255.0);
    const std::vector<int> right = exactly_diffused(exact, width, levels, false, false);
    for (std::size_t i = 0; i < right.size(); ++i)
      wrong += 4 * i + channel >= fast.size() || fast[4 * i + channel] != right[i];
  }
  return {double(fast.size()), wrong};
}

// ---- Blue noise

/// "points": that many cells by chance; 0: every second cell in both directions, which leaves nothing to improve.
std::vector<int> cells_of(const Arguments& in) {
  const int size = in.integer("size"), points = in.integer("points");
  std::vector<int> cells = first_points(size);
  if (points > 0) cells.resize(std::min(cells.size(), std::size_t(points)));
  if (points == 0) {
    cells.clear();
    for (int y = 0; y < size; y += 2)
      for (int x = 0; x < size; x += 2) cells.push_back(y * size + x);
  }
  return cells;
}

Numbers probe_blue_noise(ProbeContext&, const Arguments& in) {
  const int size = in.integer("size");
  const std::vector<int> first = cells_of(in);
  const NoiseCheck check = check_noise(blue_noise(size, first), size, first);
  return {double(check.not_once), check.relaxed, check.taken, check.added,
          in.integer("points") == 0 ? double(check.points_moved) : 0};
}

Numbers probe_noise_refuses(ProbeContext&, const Arguments& in) {
  std::vector<int> first;
  for (const double cell : in.numbers("first"))
    if (cell > -1000) first.push_back(int(cell));  // no list is empty: -1000 stands for no cell
  return refuses([&] { blue_noise(in.integer("size"), first); });
}

// ---- Bitmaps

/// A picture of bits: a disc and a diagonal, with 2 and 255 among the values that are white.
std::vector<std::uint8_t> bits_of(int width, int height) {
  std::vector<std::uint8_t> bits;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const bool disc = (2 * x - width) * (2 * x - width) + 4 * (y - 2) * (y - 2) < width * width / 2;
      bits.push_back(x == y ? 255 : disc ? std::uint8_t(1 + (x + y) % 2) : 0);
    }
  return bits;
}

Numbers probe_bitmap(ProbeContext&, const Arguments& in) {
  const int width = in.integer("width"), height = in.integer("height");
  const std::vector<std::uint8_t> bits = bits_of(width, height), file = bitmap_file(bits, width);
  const Bitmap bitmap = read_bitmap(file);
  double wrong = 0;
  for (std::size_t i = 0; i < bits.size(); ++i)
    wrong += i >= bitmap.pixels.size() || bitmap.pixels[i] != (bits[i] != 0);
  const bool headers = bitmap.is_bitmap && bitmap.header_size == 40 && bitmap.planes == 1 && bitmap.compression == 0 &&
                       bitmap.pixels_at == 62 && (bitmap.colours == 2 || bitmap.colours == 0);
  return {double(headers),
          double(bitmap.file_size == int(file.size())),
          double(file.size()),
          double(bitmap.bits),
          double(bitmap.width),
          double(bitmap.height),
          double(bitmap.palette[0]),
          double(bitmap.palette[1]),
          wrong,
          double(bitmap.padded_with_zeros)};
}

std::vector<std::uint8_t> black_pixels(const Arguments& in) {
  return std::vector<std::uint8_t>(std::size_t(in.integer("pixels")), 0);
}

}  // namespace

std::map<std::string, Probe> dither_probes() {
  const std::string glsl = text_including("09-dithering/dithering.glsl");
  return {
      {"bayer_matrix", probe_bayer},
      {"bayer_refuses",
       [](ProbeContext&, const Arguments& in) { return refuses([&] { bayer_matrix(in.integer("size")); }); }},
      {"threshold_of", shader_probe(glsl, "vec4(threshold_of(rank, count))", 1)},
      {"level_of", shader_probe(glsl, "vec4(level_of(value, threshold, levels))", 1)},
      {"shares_of", probe_shares},
      {"diffused", probe_diffused},
      {"diffused_picture", probe_diffused_picture},
      {"diffused_refuses",
       [](ProbeContext&, const Arguments& in) {
         return refuses([&] { diffused(values_of(in), in.integer("width"), diffusion_of(in)); });
       }},
      {"cube_place", shader_probe(glsl, "vec4(cube_place(direction), 0.0)", 3)},
      {"edge_between", shader_probe(glsl, "vec4(edge_between(a, normal_a, b, normal_b, nearest) ? 1.0 : 0.0)", 1)},
      {"blue_noise", probe_blue_noise},
      {"blue_noise_refuses", probe_noise_refuses},
      {"bitmap_file", probe_bitmap},
      {"bitmap_refuses",
       [](ProbeContext&, const Arguments& in) {
         return refuses([&] { bitmap_file(black_pixels(in), in.integer("width")); });
       }},
      {"octave_of", shader_probe(glsl, "vec4(octave_of(size), 0.0, 0.0)", 2)},
      {"surface_place", shader_probe(glsl, "vec4(surface_place(position, normal), 0.0, 0.0)", 2)},
      {"mixed_threshold", shader_probe(glsl, "vec4(mixed_threshold(a, b, part))", 1)},
      {"diffused_fast", probe_fast},
      {"fast_refuses",
       [](ProbeContext&, const Arguments& in) {
         return refuses([&] { diffused_fast(black_pixels(in), in.integer("width"), in.integer("levels")); });
       }},
  };
}

}  // namespace atelier
