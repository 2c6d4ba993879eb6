#include "case/exchange.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>

#include "base/file.hpp"
#include "base/printable.hpp"
#include "catch.hpp"

using namespace atelier;
using test::error_of;
namespace fs = std::filesystem;

namespace {

constexpr float inf = std::numeric_limits<float>::infinity();

Image small_picture() {
  Image image(3, 2);
  for (int i = 0; i < 6; ++i) image.pixels()[i] = {i * 0.1f, -1e30f, 1e-40f, 1};
  return image;
}

std::string bytes_of(const Image& image) {
  const TemporaryFolder folder;
  write_pixels(folder.path() / "a", image);
  return read_file(folder.path() / "a");
}

std::string values_refusal(const std::string& text) {
  const TemporaryFolder folder;
  write_file(folder.path() / "a.values", text);
  return error_of([&] { read_values(folder.held(), "a.values"); });
}

}  // namespace

TEST_CASE("all pixels are read back bit by bit") {
  const TemporaryFolder folder;
  Image image = small_picture();
  image.at(2, 1) = {std::nanf("0x1234"), inf, -inf, -0.0f};
  write_pixels(folder.path() / "a.pixels", image);
  const Image back = read_pixels(folder.held(), "a.pixels", {3, 2});
  CHECK(std::memcmp(back.pixels().data(), image.pixels().data(), image.pixels().size_bytes()) == 0);
}

TEST_CASE("pixels are laid out as documented") {
  const std::string bytes = bytes_of(small_picture());
  CHECK(bytes.size() == 16 + 6 * 16);
  CHECK(bytes.substr(0, 8) == "ATELIER1");
  CHECK(bytes.substr(8, 8) == std::string("\x03\0\0\0\x02\0\0\0", 8));
}

TEST_CASE("pixels of the wrong kind or size are refused") {
  const std::string good = bytes_of(small_picture());
  std::string bad_magic = good, swapped = good;
  bad_magic[7] = '2';
  std::swap(swapped[8], swapped[12]);
  struct Row {
    std::string bytes, words;
  };
  const Row rows[] = {
      {"", "a.pixels has 0 bytes; a picture of 3 x 2 pixels needs 112"},
      {good.substr(0, 15), "has 15 bytes"},
      {good.substr(0, good.size() - 1), "has 111 bytes"},
      {good + "x", "has 113 bytes"},
      {bad_magic, "a.pixels is not a picture file: it does not begin with ATELIER1"},
      {swapped, "a.pixels has 2 x 3 pixels; 3 x 2 are required"},
  };
  for (const Row& row : rows) {
    const TemporaryFolder folder;
    write_file(folder.path() / "a.pixels", row.bytes);
    const std::string message = error_of([&] { read_pixels(folder.held(), "a.pixels", {3, 2}); });
    INFO(message);
    CHECK(message.find(row.words) != std::string::npos);
  }
}

TEST_CASE("anything but a regular file is refused at once") {
  const TemporaryFolder folder;
  const fs::path target = folder.path() / "target";
  write_pixels(target, small_picture());
  fs::create_symlink(target, folder.path() / "link");
  fs::create_directory(folder.path() / "directory");
  REQUIRE(mkfifo((folder.path() / "fifo").c_str(), 0600) == 0);
  write_pixels(folder.path() / "first", small_picture());
  fs::create_hard_link(folder.path() / "first", folder.path() / "second");
  const HeldFolder devices("/dev");
  struct Row {
    const HeldFolder& folder;
    std::string name, words;
  };
  const Row rows[] = {
      {folder.held(), "link", "link is a symbolic link, not a regular file"},
      {folder.held(), "second", "second is a hard link to a file that has another name"},
      {folder.held(), "directory", "directory is a folder, pipe or device"},
      {folder.held(), "fifo", "fifo is a folder, pipe or device"},  // open would wait here for a writer
      {devices, "zero", "zero is a folder, pipe or device"},
      {folder.held(), "nothing", "nothing: No such file"},
  };
  for (const Row& row : rows) {
    const std::string pixels = error_of([&] { read_pixels(row.folder, row.name, {3, 2}); });
    const std::string values = error_of([&] { read_values(row.folder, row.name); });
    INFO(pixels << "\n" << values);
    CHECK(pixels.find(row.words) != std::string::npos);
    CHECK(values.find(row.words) != std::string::npos);
    CHECK(read_case_error(row.folder, row.name).empty() == (row.name == "nothing"));
  }
}

TEST_CASE("a sparse file of the wrong size is refused") {
  const TemporaryFolder folder;
  write_file(folder.path() / "a", "ATELIER1");
  fs::resize_file(folder.path() / "a", std::uintmax_t(1) << 40);
  CHECK(error_of([&] {
          read_pixels(folder.held(), "a", {3, 2});
        }).find("has 1099511627776 bytes") != std::string::npos);
  CHECK(error_of([&] { read_values(folder.held(), "a"); }).find("1048576 are allowed") != std::string::npos);
  CHECK(read_case_error(folder.held(), "a").size() <= 500);
}

TEST_CASE("values are read back as the same doubles") {
  const TemporaryFolder folder;
  const std::vector<Numbers> written = {
      {0.1, 1.0 / 3, 1e300, 5e-324, -17, 0, -0.0, 9007199254740993.0}, {}, {std::nan(""), inf, -inf}};
  write_values(folder.path() / "a", written);
  const std::vector<Numbers> read = read_values(folder.held(), "a");
  REQUIRE(read.size() == 3);
  CHECK(read[0] == written[0]);
  CHECK(std::signbit(read[0][6]));
  CHECK(read[1].empty());
  CHECK(std::isnan(read[2][0]));
  CHECK(read[2][1] == inf);
  CHECK(read[2][2] == -inf);
}

TEST_CASE("values of the wrong shape are refused") {
  struct Row {
    std::string text, words;
  };
  const Row rows[] = {
      {"", "a.values: parse error"},
      {"{\"results\": [[1, 2", "a.values: parse error"},
      {"[]", "a.values: [] is not allowed; it takes an object"},
      {"{}", "a.values: member 'results' is missing"},
      {R"({"result": []})", "unknown member 'result'; did you mean 'results'?"},
      {R"({"results": 3})", "a.values: results: 3 is not allowed"},
      {R"({"results": [3]})", "a.values: result 0: 3 is not allowed; it takes a list of numbers"},
      {R"({"results": [[1], [null]]})", "a.values: result 1: null is not allowed"},
      {R"({"results": [["1"]]})", "result 0: \"1\" is not allowed"},
      {R"({"results": [[[1]]]})", "result 0: [1] is not allowed"},
      {R"({"results": [[1e999]]})", "a.values: "},
      {R"({"results": [[NaN]]})", "a.values: parse error"},
      {R"({"results": [], "results": [[1]]})", "appears twice"},
      {std::string(500000, '['), "nested deeper than 32 levels"},
      {std::string((1 << 20) + 1, ' '), "has 1048577 bytes; at most 1048576 are allowed"},
      {"{\"results\": \"" + std::string(1000000, 'x') + "\"}", "a.values: results: \"xxx"},
  };
  for (const Row& row : rows) {
    const std::string message = values_refusal(row.text);
    INFO(row.text.substr(0, 80) << "\n-> " << message.substr(0, 400));
    CHECK(message.find(row.words) != std::string::npos);
    CHECK(message.size() < 400);  // however long the value was
  }
  CHECK(values_refusal(R"({"results": [[1, true, "nan"]]})") == "");
}

TEST_CASE("a case's error is one printable line") {
  struct Row {
    const char* name;
    std::string bytes, shown;
  };
  const Row rows[] = {
      {"plain", "look_at: eye and target are equal\n", "look_at: eye and target are equal"},
      {"second line", "one\ntwo\n", "one"},
      {"escape", "\x1b[2Jgone", "\xEF\xBF\xBD[2Jgone"},
      {"zero byte", std::string("a\0b", 3),
       "a\xEF\xBF\xBD"
       "b"},
      {"no UTF-8", "a\xff", "a\xEF\xBF\xBD"},
      {"empty", "", ""},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    const TemporaryFolder folder;
    write_file(folder.path() / "e", row.bytes);
    CHECK(read_case_error(folder.held(), "e") == row.shown);
  }
  const TemporaryFolder folder;
  const std::string long_line(10000, 'x');
  write_case_error(folder.path() / "e", fmt::format("{}\nmore", long_line));
  CHECK(read_case_error(folder.held(), "e").size() <= 500);
  write_file(folder.path() / "e", long_line);
  CHECK(read_case_error(folder.held(), "e").size() <= 500);
  CHECK(read_case_error(folder.held(), "nothing").empty());
}
