// Dithering of a picture of 1920 x 1080 pixels: diffused errors beside Pillow's, Bayer's matrix beside ImageMagick's
// and beside a copy, and blue noise. Pictures are in memory; reading and writing files is not timed.
#ifdef HAVE_PYTHON
#include <Python.h>
#endif
#ifdef HAVE_MAGICK
#include <wand/MagickWand.h>
#endif
#include <fmt/format.h>

#include <cstring>
#include <memory>
#include <string>

#include "09-dithering/dithering.hpp"
#include "09-dithering/given/ordered_bytes.hpp"
#include "09-dithering/given/patterns.hpp"
#include "base/error.hpp"
#include "peers/peers.hpp"

namespace atelier::peers {

namespace {

constexpr int width = 1920, height = 1080;

/// Slopes with noise, four bytes a pixel.
std::vector<std::uint8_t> make_codes() {
  std::vector<std::uint8_t> codes;
  std::uint32_t state = 1;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int channel = 0; channel < 4; ++channel) {
        state = state * 1664525u + 1013904223u;
        codes.push_back(std::uint8_t((channel % 2 ? 230 * y / height : 230 * x / width) + int(state >> 24) % 24));
      }
  return codes;
}

#ifdef HAVE_PYTHON

/// Pillow in this process. Statements run in one namespace, in which `picture` is the RGB image.
class Pillow {
 public:
  explicit Pillow(const std::vector<std::uint8_t>& codes) {
    Py_Initialize();
    names_ = PyDict_New();
    PyDict_SetItemString(names_, "__builtins__", PyEval_GetBuiltins());
    PyObject* const bytes =
        PyBytes_FromStringAndSize(reinterpret_cast<const char*>(codes.data()), Py_ssize_t(codes.size()));
    PyDict_SetItemString(names_, "codes", bytes);
    Py_DECREF(bytes);
    found_ = try_run("from PIL import Image, __version__ as version") &&
             try_run(fmt::format("picture = Image.frombytes('RGBA', ({}, {}), codes).convert('RGB')", width, height));
  }

  bool found() const { return found_; }

  void run(const std::string& statement) {
    if (!try_run(statement)) throw Error("Pillow fails: " + statement);
  }

  std::string text(const char* name) { return PyUnicode_AsUTF8(PyDict_GetItemString(names_, name)); }

 private:
  bool try_run(const std::string& statement) {
    PyObject* const result = PyRun_String(statement.c_str(), Py_file_input, names_, names_);
    if (!result) PyErr_Clear();
    Py_XDECREF(result);
    return result != nullptr;
  }

  PyObject* names_ = nullptr;
  bool found_ = false;
};

Peer pillow(const std::shared_ptr<Pillow>& python, const char* name, const std::string& prepare,
            const std::string& statement, const std::string& check) {
  if (!python->found()) return {.name = fmt::format("Pillow, {}", name), .missing = "python3-pil"};
  python->run(prepare);
  return {.name = fmt::format("Pillow {}, {}", python->text("version"), name),
          .run = [=] { python->run(statement); },
          .check = [=] { python->run(check); }};
}

#else

struct Pillow {
  explicit Pillow(const std::vector<std::uint8_t>&) {}
};

Peer pillow(const std::shared_ptr<Pillow>&, const char* name, const std::string&, const std::string&,
            const std::string&) {
  return {.name = fmt::format("Pillow, {}", name), .missing = "python3-dev and python3-pil"};
}

#endif

#ifdef HAVE_MAGICK

Peer magick(const std::vector<std::uint8_t>& codes) {
  MagickWandGenesis();
  const auto picture = std::shared_ptr<MagickWand>(NewMagickWand(), DestroyMagickWand);
  const auto changed = std::make_shared<std::shared_ptr<MagickWand>>();
  if (MagickConstituteImage(picture.get(), width, height, "RGBA", CharPixel, codes.data()) == MagickFalse)
    throw Error("ImageMagick takes no picture");
  std::size_t version = 0;
  return {.name = fmt::format("{:.18}, o8x8,3", GetMagickVersion(&version)),
          .run = [changed] { MagickOrderedPosterizeImage(changed->get(), "o8x8,3"); },
          .prepare =
              [picture, changed] {
                *changed = std::shared_ptr<MagickWand>(CloneMagickWand(picture.get()), DestroyMagickWand);
                // A clone shares its pixels until one of them is written.
                MagickConstituteImage(changed->get(), 1, 1, "RGB", CharPixel, "abc");
                MagickSetFirstIterator(changed->get());
              }};
}

#else

Peer magick(const std::vector<std::uint8_t>&) {
  return {.name = "ImageMagick, o8x8,3", .missing = "libmagickwand-dev"};
}

#endif

std::vector<Row> rows_of_dithering() {
  using namespace dithering;
  const auto codes = std::make_shared<std::vector<std::uint8_t>>(make_codes());
  const auto python = std::make_shared<Pillow>(*codes);
  std::vector<Row> rows;
  rows.push_back(
      {.work = "diffused_fast, 27 colours",
       .ours = [=] { diffused_fast(*codes, width, 3); },
       .peer = pillow(python, "quantize",
                      "palette = Image.new('P', (1, 1))\n"
                      "steps = (0, 128, 255)\n"
                      "colours = [c for r in steps for g in steps for b in steps for c in (r, g, b)]\n"
                      "palette.putpalette(colours + [0] * (768 - len(colours)))",
                      "result = picture.quantize(palette=palette, dither=1)", "assert len(result.getcolors()) > 20"),
       .aim = 4});
  rows.push_back({.work = "diffused_fast, 2 levels",
                  .ours = [=] { diffused_fast(*codes, width, 2); },
                  .peer = pillow(python, "convert('1')", "", "result = picture.convert('1')",
                                 "assert len(result.getcolors()) == 2"),
                  .aim = 2});
  const auto matrix = std::make_shared<std::vector<int>>(bayer_matrix(8));
  const auto changed = std::make_shared<std::vector<std::uint8_t>>(*codes);
  const auto bayer = [=] {
    std::memcpy(changed->data(), codes->data(), codes->size());
    dither_bytes(*changed, width, *matrix, 8, 3);
  };
  rows.push_back({.work = "Bayer 8 x 8, 27 colours", .ours = bayer, .peer = magick(*codes), .aim = 10});
  rows.push_back({.work = "Bayer 8 x 8, 27 colours",
                  .ours = bayer,
                  .peer = {.name = "a copy of the picture",
                           .run = [=] { std::memcpy(changed->data(), codes->data(), codes->size()); }},
                  .aim = 0.25});
  for (const int size : {64, 128})
    rows.push_back({.work = fmt::format("blue_noise, {0} x {0}", size),
                    .ours = [=, first = first_points(size)] { blue_noise(size, first); },
                    .peer = {.name = "void and cluster", .missing = "no package has it"}});
  return rows;
}

}  // namespace

}  // namespace atelier::peers

int main(int argc, char** argv) {
  return atelier::peers::compare(atelier::peers::rows_of_dithering, argc, argv);
}
