// Painting by strokes beside the oil paintings of OpenCV and ImageMagick, 1920x1080, one thread each.
#include <fmt/core.h>

#include <cmath>
#include <cstring>
#include <memory>

#ifdef HAVE_OPENCV
#include <opencv2/core.hpp>
#include <opencv2/core/version.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/xphoto/oilpainting.hpp>
#endif
#ifdef HAVE_MAGICK
#include <wand/MagickWand.h>
#endif

#include "10-artstyles/given/painter.hpp"
#include "base/error.hpp"
#include "image/colour.hpp"
#include "peers/peers.hpp"
#include "scene/card.hpp"

namespace atelier::peers {

namespace {

using namespace artstyles;

constexpr int width = 1920, height = 1080;

/// The card, magnified, with some of its noise left in each pixel.
Picture make_picture() {
  const Image card = make_card();
  Picture picture{width, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const Rgba &p = card.at(x * card.width() / width, y * card.height() / height),
                 &q = card.at(x % card.width(), y % card.height());
      const auto code = [](float light, float other) {
        return std::uint8_t((15 * srgb_code(light) + srgb_code(other)) / 16);
      };
      picture.pixels.emplace_back(code(p.r, q.r), code(p.g, q.g), code(p.b, q.b), 255);
    }
  return picture;
}

#ifdef HAVE_OPENCV

Peer opencv(const Picture& picture) {
  cv::setNumThreads(1);
  const auto source = std::make_shared<cv::Mat>(height, width, CV_8UC3), result = std::make_shared<cv::Mat>();
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const glm::u8vec4& p = picture.pixels[std::size_t(y * width + x)];
      source->at<cv::Vec3b>(y, x) = {p.b, p.g, p.r};
    }
  return {.name = "OpenCV " CV_VERSION ", xphoto::oilPainting, 4, 1",
          .run = [=] { cv::xphoto::oilPainting(*source, *result, 4, 1); },
          .check =
              [=] {
                if (result->size() != source->size() || cv::countNonZero(result->reshape(1) != source->reshape(1)) == 0)
                  throw Error("OpenCV has painted nothing");
              }};
}

#else

Peer opencv(const Picture&) {
  return {.name = "OpenCV, xphoto::oilPainting", .missing = "libopencv-contrib-dev"};
}

#endif

#ifdef HAVE_MAGICK

Peer magick(const Picture& picture) {
  MagickWandGenesis();
  MagickSetResourceLimit(ThreadResource, 1);
  const auto source = std::shared_ptr<MagickWand>(NewMagickWand(), DestroyMagickWand);
  const auto changed = std::make_shared<std::shared_ptr<MagickWand>>();
  if (MagickConstituteImage(source.get(), width, height, "RGBA", CharPixel, picture.pixels.data()) == MagickFalse)
    throw Error("ImageMagick takes no picture");
  std::size_t version = 0;
  return {.name = fmt::format("{:.18}, -paint 4", GetMagickVersion(&version)),
          .run = [changed] { MagickOilPaintImage(changed->get(), 4); },
          .prepare = [=] { *changed = std::shared_ptr<MagickWand>(CloneMagickWand(source.get()), DestroyMagickWand); }};
}

#else

Peer magick(const Picture&) {
  return {.name = "ImageMagick, -paint 4", .missing = "libmagickwand-dev"};
}

#endif

std::vector<Row> rows_of_painting() {
  const auto picture = std::make_shared<Picture>(make_picture());
  std::vector<Row> rows;
  const auto add = [&](const char* work, const Painting& how, Peer peer, double aim) {
    rows.push_back(
        {.work = work, .ours = [=] { painted(*picture, how, fast_strokes()); }, .peer = std::move(peer), .aim = aim});
  };
  Painting confined;
  confined.confined = true;
  add("15 iterations", {}, opencv(*picture), 2);
  add("15 iterations, within the lines", confined, opencv(*picture), 2);
  add("15 iterations", {}, magick(*picture), 0);
  return rows;
}

}  // namespace

}  // namespace atelier::peers

int main(int argc, char** argv) {
  return atelier::peers::compare(atelier::peers::rows_of_painting, argc, argv);
}
