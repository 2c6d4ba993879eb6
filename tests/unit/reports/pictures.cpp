#include "judge/report/report_pictures.hpp"

#include <algorithm>
#include <cmath>

#include "base/file.hpp"
#include "catch.hpp"
#include "image_io/image_io.hpp"
#include "judge/report/preview.hpp"
#include "sample.hpp"

using namespace atelier;
using namespace atelier::judge;

namespace {

std::string roles(const CaseResult& result) {
  std::string all;
  for (const ReportPicture& picture : report_pictures(result)) all += picture.role + " ";
  return all;
}

bool fit_for_the_screen(const Image& image) {
  return std::all_of(image.pixels().begin(), image.pixels().end(), [](const Rgba& c) {
    const auto good = [](float v) { return v >= 0 && v <= 1; };
    return good(c.r) && good(c.g) && good(c.b) && c.a == 1;
  });
}

}  // namespace

TEST_CASE("the pictures of a verdict follow from its evidence") {
  CaseResult failed = test::failed_picture();
  CHECK(roles(failed) == "yours reference difference flip mask signed mistake detail detail ");
  CHECK(roles(test::passed_picture()) == "yours reference ");
  CHECK(roles(test::failed_probe()) == "");
  failed.evidence->flip = {}, failed.evidence->mistake.reset(), failed.worst.reset();
  CHECK(roles(failed) == "yours reference difference mask signed ");
  failed.evidence->yours = Image(3, 5);
  CHECK(roles(failed) == "yours reference ");
  failed.evidence->yours = Image();
  CHECK(roles(failed) == "");
}

TEST_CASE("every picture can be shown, with any pixels") {
  CaseResult failed = test::failed_picture(40);
  Evidence& evidence = *failed.evidence;
  evidence.yours.at(0, 0) = {NAN, INFINITY, -INFINITY, NAN};
  evidence.yours.at(1, 0) = {-5, 1e30f, 0.5f, 0};
  evidence.reference.at(2, 0) = {0.5f, 0.5f, 0.5f, 0.25f};
  for (const ReportPicture& picture : report_pictures(failed)) {
    INFO(picture.title);
    CHECK(fit_for_the_screen(picture.pixels));
    CHECK(picture.alt != "");
  }
  CHECK(report_pictures(failed)[0].pixels.at(0, 0) == Rgba{1, 0, 1, 1});
}

TEST_CASE("data outside 0..1 is shown over the reference's range") {
  Image reference(2, 1), yours(2, 1);
  reference.at(0, 0) = {-10, -10, -10, 1}, reference.at(1, 0) = {30, 30, 30, 1};
  yours.at(0, 0) = {0, 0, 0, 1}, yours.at(1, 0) = {100, 100, 100, 1};
  const Displayed shown = displayed(yours, reference);
  CHECK(shown.low == -10);
  CHECK(shown.high == 30);
  CHECK(shown.reference.at(0, 0) == Rgba{0, 0, 0, 1});
  CHECK(shown.yours.at(0, 0) == Rgba{0.25f, 0.25f, 0.25f, 1});
  CHECK(shown.yours.at(1, 0) == Rgba{1, 1, 1, 1});
}

TEST_CASE("the worst pixel is framed in its enlarged surroundings, at corners too") {
  for (const auto& [x, y] : {std::pair(0, 0), std::pair(63, 63), std::pair(30, 7)}) {
    CaseResult failed = test::failed_picture(64);
    failed.worst->x = x, failed.worst->y = y;
    failed.evidence->reference.at(x, y) = {0, 1, 0, 1};
    const auto pictures = report_pictures(failed);
    const auto detail = std::find_if(pictures.begin(), pictures.end(), [](const auto& p) {
      return p.role == "detail" && p.title.starts_with("Reference");
    });
    REQUIRE(detail != pictures.end());
    CHECK(detail->pixels.width() == detail_side * detail_zoom);
    const auto green = std::count(detail->pixels.pixels().begin(), detail->pixels.pixels().end(), Rgba{0, 1, 0, 1});
    CHECK(green == detail_zoom * detail_zoom);  // the frame stands around the pixel and covers none of it
  }
}

TEST_CASE("large pictures are shrunk, small mistakes enlarged") {
  CaseResult failed = test::failed_picture(16);
  const auto pictures = report_pictures(failed);
  const auto mistake =
      std::find_if(pictures.begin(), pictures.end(), [](const auto& p) { return p.role == "mistake"; });
  REQUIRE(mistake != pictures.end());
  CHECK(mistake->pixels.width() == 16);
  failed.evidence->yours = failed.evidence->reference = Image(2000, 100, {0.5f, 0.5f, 0.5f, 1});
  failed.evidence->over = failed.evidence->flip = Image(2000, 100);
  for (const ReportPicture& picture : report_pictures(failed)) CHECK(picture.pixels.width() <= report_side);
}

TEST_CASE("the difference is black for equal pixels, and its scale is given") {
  Image a(2, 1, {0.5f, 0.5f, 0.5f, 1}), b = a;
  float largest = 0;
  CHECK(difference_picture(a, b, largest).at(0, 0).r < 0.05f);  // the heat colours begin at nearly black
  CHECK(largest == 1.0f / 255);
  b.at(1, 0).g = 0.25f;
  const Image difference = difference_picture(a, b, largest);
  CHECK(largest == 0.25f);
  CHECK(difference.at(1, 0).r > 0.9f);
}

TEST_CASE("a preview has your picture, the reference and the difference side by side") {
  const CaseResult failed = test::failed_picture(32);
  const TemporaryFolder folder;
  write_preview(folder.path() / "preview.png", *failed.evidence);
  const Image read = read_image(folder.path() / "preview.png", Encoding::srgb);
  CHECK(read.height() == 32);
  CHECK(read.width() == 3 * 32 + 2 * 4);
  // 8 bits hold a value to half a step.
  CHECK(read.at(10, 10).r == Approx(failed.evidence->yours.at(10, 10).r).margin(0.5 / 255 + 1e-6));
  CHECK(read.at(36 + 10, 10).r == Approx(failed.evidence->reference.at(10, 10).r).margin(0.5 / 255 + 1e-6));
  Evidence unequal = *failed.evidence;
  unequal.yours = Image(3, 3);
  CHECK(test::mentions(test::error_of([&] { preview_image(unequal); }), {"3 x 3", "32 x 32"}));
}
