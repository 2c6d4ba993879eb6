// Picture files: written files are read back, and invalid ones are refused by name.
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>

#include "base/file.hpp"
#include "catch.hpp"
#include "image/compare.hpp"
#include "image_io/image_io.hpp"
#include "pictures.hpp"

using namespace atelier;
using namespace atelier::test;

namespace {

std::span<const std::byte> bytes_of(const std::string& text) {
  return std::as_bytes(std::span(text));
}

/// The largest difference of two pictures in any channel, opacity included.
double difference(const Image& a, const Image& b) {
  REQUIRE(a.same_size(b));
  double largest = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i)
    for (float Rgba::*channel : {&Rgba::r, &Rgba::g, &Rgba::b, &Rgba::a})
      largest = std::max(largest, std::abs(double(a.pixels()[i].*channel) - b.pixels()[i].*channel));
  return largest;
}

/// 2 x 2 Targa: red, green above blue, white; from the bottom upwards unless the descriptor says otherwise.
std::string targa(bool from_top) {
  std::string file(18, '\0');
  file[2] = 2;              // uncompressed colours
  file[12] = file[14] = 2;  // sides
  file[16] = 24;            // bits a pixel
  file[17] = from_top ? 0x20 : 0;
  const std::string above("\0\0\xff\0\xff\0", 6), below("\xff\0\0\xff\xff\xff", 6);  // blue, green, red
  return file + (from_top ? above + below : below + above);
}

/// A Radiance picture of one row, flat: red, green and blue share an exponent, value (m + 0.5) / 256 x 2^(e - 128).
std::string radiance() {
  return std::string("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n") +
         std::string("\x80\x40\x20\x81\x80\x80\x80\x84", 8);
}

struct Kind {
  const char* file;
  WriteOptions options;
  Encoding read_as;
  double margin;
  const char* why;
};

// Half a step of the format, in the encoding in which it is read; linear values of 8 bits spread by the curve's
// steepest slope, which is 2.27 at white.
const Kind kinds[] = {
    {"linear.png", {Encoding::linear}, Encoding::linear, 2.28 * 0.5 / 255, "half a level, decoded"},
    {"encoded.png", {Encoding::srgb}, Encoding::srgb, 0.501 / 255, "half a level"},
    {"data.png", {Encoding::data}, Encoding::data, 0.501 / 255, "half a level"},
    {"fine.png", {Encoding::linear, Depth::bits16}, Encoding::linear, 2.28 * 0.5 / 65535, "half a step, decoded"},
    {"fine-data.png", {Encoding::data, Depth::bits16}, Encoding::data, 0.501 / 65535, "half a step"},
    {"linear.exr", {Encoding::linear}, Encoding::linear, 0, "floats are kept"},
    {"encoded.exr", {Encoding::srgb}, Encoding::srgb, 2e-6, "decoded and encoded again in floats"},
    {"data.exr", {Encoding::data}, Encoding::data, 0, "floats are kept"},
    {"half.exr", {Encoding::linear, Depth::half}, Encoding::linear, 0.5 / 1024, "eleven bits below one"},
    {"encoded.bmp", {Encoding::srgb}, Encoding::srgb, 0.501 / 255, "half a level"},
    {"UPPER.PNG", {Encoding::srgb}, Encoding::srgb, 0.501 / 255, "half a level"},
};

}  // namespace

TEST_CASE("written pictures are read back") {
  const TemporaryFolder folder;
  for (const Kind& kind : kinds) {
    INFO(kind.file << ": " << kind.why);
    const auto path = folder.path() / "made" / kind.file;
    Image image = waves(31, 17);
    write_image(path, image, kind.options);
    CHECK(difference(read_image(path, kind.read_as), image) <= kind.margin);
    if (path.extension() == ".bmp") continue;
    for (Rgba& p : image.pixels()) p.a = p.r;  // opacity is kept apart: colours do not darken with it
    write_image(path, image, kind.options);
    // Opacity is never encoded, so half a level is the most that it is off, whatever the colours do.
    CHECK(difference(read_image(path, kind.read_as), image) <= kind.margin);
  }
}

TEST_CASE("extremes: EXR keeps them, integers clamp them") {
  const TemporaryFolder folder;
  constexpr float inf = std::numeric_limits<float>::infinity(), nan_ = std::numeric_limits<float>::quiet_NaN();
  Image image(3, 1);
  image.at(0, 0) = {1e30f, -5, 1e-30f, 1};
  image.at(1, 0) = {inf, -inf, nan_, 1};
  image.at(2, 0) = {0.5f, 2, 0, 1};
  write_image(folder.path() / "a.exr", image);
  const Image kept = read_image(folder.path() / "a.exr");
  CHECK(kept.at(0, 0) == image.at(0, 0));
  CHECK(kept.at(1, 0).r == inf);
  CHECK(std::isnan(kept.at(1, 0).b));
  write_image(folder.path() / "a.png", image, {Encoding::data});
  const Image clamped = read_image(folder.path() / "a.png", Encoding::data);
  CHECK(clamped.at(0, 0) == Rgba{1, 0, 0, 1});
  CHECK(clamped.at(1, 0) == Rgba{1, 0, 0, 1});
  CHECK(clamped.at(2, 0).r == 128 / 255.0f);
  CHECK(clamped.at(2, 0).g == 1);
}

TEST_CASE("sides, rows and numbers of other formats") {
  for (bool from_top : {false, true}) {
    const Image image = read_image_bytes(bytes_of(targa(from_top)), "a.TGA");
    CHECK(image.at(0, 0) == Rgba{1, 0, 0, 1});
    CHECK(image.at(1, 0) == Rgba{0, 1, 0, 1});
    CHECK(image.at(0, 1) == Rgba{0, 0, 1, 1});
  }
  const Image light = read_image_bytes(bytes_of(radiance()), "light.hdr");
  // The format's readers differ by half of its step of 1/128 in where in a step the value lies.
  CHECK(light.at(0, 0).r == Approx(1).margin(1 / 128.0));
  CHECK(light.at(0, 0).g == Approx(0.5).margin(1 / 128.0));
  CHECK(light.at(1, 0).b == Approx(8).margin(8 / 128.0));
}

TEST_CASE("frames of few colours are exact in animations") {
  const TemporaryFolder folder("atelier-image-test");
  const auto path = folder.path() / "few.gif";
  // 27 colours side by side, in another order in each frame: any palette but the exact one changes them.
  const auto frame = [](int i) {
    Image image(27, 8);
    for (int y = 0; y < 8; ++y)
      for (int x = 0; x < 27; ++x) {
        const int colour = (7 * x + 5 * y + 11 * i) % 27;
        image.at(x, y) = {float(colour % 3) / 2, float(colour / 3 % 3) / 2, float(colour / 9) / 2, 1};
      }
    return image;
  };
  write_animation(path, 3, frame, 0.05, Encoding::data);
  const Image first = read_image(path, Encoding::data);
  REQUIRE(first.same_size(frame(0)));
  for (std::size_t i = 0; i < first.pixels().size(); ++i)
    CHECK(std::abs(first.pixels()[i].r - frame(0).pixels()[i].r) < 0.003);
  // One frame with more colours: none is lost.
  const auto smooth = [&](int i) {
    Image image = frame(i);
    if (i == 1)
      for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 27; ++x) image.at(x, y) = {float(x) / 26, float(y) / 7, float(x + y) / 33, 1};
    Image large(27 * 2, 8 * 2);
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 54; ++x) {
        large.at(x, y) = image.at(x / 2, y / 2);
        if (i == 1) large.at(x, y).g = float(x * 16 + y) / 864;
      }
    return large;
  };
  write_animation(path, 3, smooth, 0.05, Encoding::data);
  CHECK(read_image(path, Encoding::data).same_size(smooth(0)));
}

TEST_CASE("animations: all frames in one file; the first is read") {
  const TemporaryFolder folder;
  const auto path = folder.path() / "turn.gif";
  std::vector<Image> frames;
  for (int i = 0; i < 4; ++i) frames.push_back(Image(24, 16, {i == 0 ? 1.0f : 0.0f, i * 0.3f, 0.5f, 1}));
  write_animation(path, frames, 0.05, Encoding::srgb);
  const std::string file = read_file(path);
  CHECK(file.starts_with("GIF89a"));
  CHECK(file.find("NETSCAPE2.0") != std::string::npos);  // repeats for ever
  int controls = 0;  // a frame's control block: 21 f9 04, flags, the delay in hundredths, transparent colour, 0
  for (std::size_t at = 0; (at = file.find("\x21\xf9\x04", at)) != std::string::npos; ++at) {
    ++controls;
    CHECK(int(file[at + 4]) == 5);
  }
  CHECK(controls == 4);
  // A plain colour is in any palette that is worth its name: to a level of the 5 or 6 bits that GIF encoders sort by.
  CHECK(difference(read_image(path, Encoding::srgb), frames[0]) < 8 / 255.0);

  CHECK(mentions(error_of([&] { write_animation(folder.path() / "a.png", frames, 0.05); }), {"a.png", ".gif"}));
  CHECK(mentions(error_of([&] { write_animation(path, {}, 0.05); }), {"turn.gif", "one frame"}));
  for (double delay : {0.0, -1.0, 61.0, std::numeric_limits<double>::quiet_NaN()})
    CHECK(mentions(error_of([&] { write_animation(path, frames, delay); }), {"0.02..60"}));
  frames[2] = Image(24, 17);
  CHECK(mentions(error_of([&] { write_animation(path, frames, 0.05); }), {"frame 2", "24 x 17"}));
  CHECK(read_file(path) == file);  // what failed has left the old file alone
}

TEST_CASE("pictures embedded in reports") {
  const auto bytes = encode_png(waves(20, 10), {Encoding::srgb});
  CHECK(difference(read_image_bytes(bytes, "embedded", Encoding::srgb), waves(20, 10)) <= 0.501 / 255);
}

TEST_CASE("pictures that cannot be written are refused, without leftovers") {
  const TemporaryFolder folder;
  const Image image(2, 2);
  struct Row {
    const char* file;
    Image image;
    WriteOptions options;
    const char* word;
  };
  for (const Row& row : {Row{"a.jpg", image, {}, ".jpg"},
                         {"a", image, {}, ".png"},
                         {"a.png", Image(), {}, "no pixels"},
                         {"a.png", image, {.depth = Depth::half}, "depth"},
                         {"a.exr", image, {.depth = Depth::bits16}, "depth"},
                         {"a.bmp", image, {.depth = Depth::bits16}, "depth"}}) {
    INFO(row.file);
    CHECK(mentions(error_of([&] { write_image(folder.path() / row.file, row.image, row.options); }),
                   {row.file, row.word}));
  }
  CHECK_FALSE(error_of([&] { write_image("/proc/no-such-place/a.png", image); }).empty());
  CHECK(std::filesystem::is_empty(folder.path()));
}

TEST_CASE("files that are not pictures are refused by name") {
  const TemporaryFolder folder;
  write_file(folder.path() / "text.png", "This is no picture.");
  write_file(folder.path() / "empty.png", "");
  std::filesystem::create_directory(folder.path() / "folder.png");
  for (const char* name : {"text.png", "empty.png", "folder.png", "missing.png"})
    CHECK(mentions(error_of([&] { read_image(folder.path() / name); }), {name}));
  CHECK(mentions(error_of([&] { read_image("/dev/zero"); }), {"/dev/zero"}));

  std::string huge = targa(true);  // says 65535 x 65535
  huge[12] = huge[13] = huge[14] = huge[15] = '\xff';
  CHECK(mentions(error_of([&] { read_image_bytes(bytes_of(huge), "huge.tga"); }), {"huge.tga", "16384"}));
}

TEST_CASE("truncated pictures are refused, damaged ones do no harm") {
  const TemporaryFolder folder;
  const Image image = waves(40, 30);
  std::vector<std::pair<std::string, std::string>> files = {{"a.tga", targa(true)}, {"a.hdr", radiance()}};
  for (const char* name : {"a.png", "a.exr", "a.bmp", "a.gif"}) {
    write_image(folder.path() / name, image);
    files.emplace_back(name, read_file(folder.path() / name));
  }
  for (const auto& [name, whole] : files) {
    INFO(name);
    for (std::size_t tenth = 0; tenth < 10; ++tenth) {
      const std::string part = whole.substr(0, whole.size() * tenth / 10);
      CHECK(mentions(error_of([&, n = name] { read_image_bytes(bytes_of(part), n); }), {name}));
    }
    Noise noise(5);
    for (int i = 0; i < 60; ++i) {  // every second flip within the header, where it hurts most
      std::string damaged = whole;
      const double reach = i % 2 ? 1.0 : std::min(1.0, 128.0 / double(whole.size()));
      damaged[std::size_t(noise.next() * reach * 0.999 * double(whole.size()))] ^= char(1 << (i / 2 % 8));
      const std::string error = error_of([&, n = name] { read_image_bytes(bytes_of(damaged), n); });
      CHECK((error.empty() || mentions(error, {name})));
    }
  }
}

TEST_CASE("a PNG is checked before it is decoded") {
  const auto bytes = encode_png(waves(20, 10));
  const std::string whole(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const auto error = [](const std::string& file) {
    return error_of([&] { read_image_bytes(bytes_of(file), "a.png"); });
  };
  CHECK(error(whole).empty());
  CHECK(error(whole + "what follows is no part of it").empty());
  CHECK(mentions(error(whole.substr(0, whole.size() - 12)), {"a.png", "end is missing"}));  // its IEND
  std::string damaged = whole;
  damaged[whole.size() / 2] ^= 1;
  CHECK(mentions(error(damaged), {"a.png", "checksum"}));
}

TEST_CASE("a truncated JPEG is refused, not filled with grey") {
  // A start of image, a start of scan and some coded pixels: enough for the question, too little for a picture.
  const std::string cut("\xff\xd8\xff\xe0\x00\x04\x00\x00\xff\xda\x00\x02pixels", 18);
  CHECK(mentions(error_of([&] { read_image_bytes(bytes_of(cut), "cut.jpg"); }), {"cut.jpg", "end is missing"}));
  CHECK(mentions(error_of([&] { read_image_bytes(bytes_of(cut + "\xff\xd9"), "odd.jpg"); }), {"odd.jpg"}));
  CHECK_FALSE(mentions(error_of([&] { read_image_bytes(bytes_of(cut + "\xff\xd9"), "odd.jpg"); }), {"end is missing"}));
}
