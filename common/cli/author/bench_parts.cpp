// Times the parts of a verdict in this process.
#include <fmt/format.h>

#include <cmath>

#include "cli/author/bench.hpp"
#include "gl/context.hpp"
#include "image/compare.hpp"
#include "image/flip.hpp"
#include "oracle/picture.hpp"
#include "scene/builtin.hpp"

namespace atelier {
namespace {

/// A picture with structure at every scale, like a rendering; `offset` shifts its values by a fraction of a level.
Image test_picture(int width, int height, float offset) {
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const float wave = 0.5f + 0.3f * std::sin(0.05f * float(x)) * std::cos(0.031f * float(y));
      const float tile = ((x / 16 + y / 16) % 2) != 0 ? 0.15f : 0.0f;
      image.at(x, y) = {wave + offset, 0.7f * wave + tile, tile + offset, 1};
    }
  return image;
}

/// The oracle on all CPU cores: only camera rays, and a picture with shadow rays.
void bench_oracle(int repeats, std::vector<Figure>& figures) {
  const Scene scene = make_builtin_scene("teapot");
  const oracle::World world(scene);
  const int side = 512;
  const auto traced = [&](const char* name, oracle::Output output, oracle::Shadows shadows, const char* unit) {
    Figure figure = time_runs(name, "", repeats, [&] {
      oracle::trace(world,
                    {.camera = scene.camera, .size = {side, side}, .output = output, .shading = {.shadows = shadows}});
    });
    figure.detail = fmt::format("teapot scene of {} triangles, {}x{}: {:.1f} million {} a second",
                                world.triangle_count(), side, side, 1e-6 * side * side / figure.seconds, unit);
    figures.push_back(figure);
  };
  traced("oracle, what is seen", oracle::Output::thing, oracle::Shadows::none, "rays");
  traced("oracle, with hard shadows", oracle::Output::colour, oracle::Shadows::hard, "pixels");
}

}  // namespace

std::vector<Figure> bench_parts(int repeats) {
  std::vector<Figure> figures;
  figures.push_back(time_runs("context, OSMesa", "created and destroyed", repeats,
                              [] { make_headless_context(ContextKind::osmesa); }));

  const Image yours = test_picture(512, 512, 0.5f / 255), reference = test_picture(512, 512, 0);
  figures.push_back(
      time_runs("strict comparison", "512x512, encoding of both and the fitted shift included", repeats, [&] {
        const Image a = encode_for_comparison(yours), b = encode_for_comparison(reference);
        compare_strict(a, b, Measure::level, 3);
        fit_shift(a, b);
      }));
  figures.back().limit = 0.010;

  const Image large = test_picture(1920, 1080, 4.0f / 255), other = test_picture(1920, 1080, 0);
  for (const int threads : {1, 2}) {
    figures.push_back(time_runs(threads == 1 ? "FLIP, one thread" : "FLIP, two threads", "1920x1080", repeats,
                                [&] { flip(other, large, {.threads = threads}); }));
    // Half the time of NVIDIA's own tool on the same cores.
    figures.back().limit = threads == 1 ? 0.28 : 0.16;
  }
  bench_oracle(repeats, figures);
  return figures;
}

}  // namespace atelier
