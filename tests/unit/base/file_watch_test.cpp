// FileWatch against every way in which editors write files.
#include "base/file_watch.hpp"

#include <poll.h>

#include "base/file.hpp"
#include "catch.hpp"

using namespace atelier;
namespace fs = std::filesystem;

namespace {

bool notified(const FileWatch& watch) {
  pollfd entry{.fd = watch.descriptor(), .events = POLLIN, .revents = 0};
  return ::poll(&entry, 1, 2'000) == 1;
}

void write_in_place(const fs::path& file, const std::string& text) {
  std::FILE* out = std::fopen(file.c_str(), "w");
  REQUIRE(out != nullptr);
  std::fputs(text.c_str(), out);
  std::fclose(out);
}

}  // namespace

TEST_CASE("a watched file is reported once for each change, whichever way it is written") {
  const TemporaryFolder folder;
  const fs::path a = folder.path() / "a.glsl", b = folder.path() / "b.cpp", other = folder.path() / "other.txt";
  write_file(a, "one");
  write_file(b, "one");
  FileWatch watch({a, b});
  CHECK(watch.take_changes().empty());

  struct Row {
    const char* name;
    std::function<void()> change;
    std::vector<fs::path> changed;
  };
  const Row rows[] = {
      {"in place", [&] { write_in_place(a, "three"); }, {a}},
      {"beside and renamed", [&] { write_file(b, "three"); }, {b}},
      {"the same length", [&] { write_file(a, "eerht"); }, {a}},
      {"both, in the order given", [&] { write_file(b, "four"), write_file(a, "four"); }, {a, b}},
      {"away", [&] { fs::remove(a); }, {a}},
      {"back", [&] { write_file(a, "five"); }, {a}},
      {"a neighbour's", [&] { write_file(other, "six"); }, {}},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    row.change();
    if (watch.descriptor() >= 0) CHECK(notified(watch));
    CHECK(watch.take_changes() == row.changed);
    CHECK(watch.take_changes().empty());
  }
}

TEST_CASE("a watched file may be missing, and its folder too") {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "deep" / "a.glsl";
  FileWatch watch({file});
  CHECK(watch.take_changes().empty());
  write_file(file, "here");
  CHECK(watch.take_changes() == std::vector<fs::path>{file});
}
