// A held folder, with a program's tricks played by the test itself.
#include "base/held_folder.hpp"

#include <fcntl.h>
#include <sys/stat.h>

#include <cerrno>

#include "base/file.hpp"
#include "catch.hpp"

using namespace atelier;
using test::error_of;
using test::mentions;
namespace fs = std::filesystem;

TEST_CASE("A held folder stays the same one when a link takes its place") {
  const TemporaryFolder temporary;
  const fs::path precious = temporary.path() / "precious", moved = temporary.path() / "moved";
  write_file(precious / "file", std::string_view("precious"));
  const HeldFolder held = temporary.held().create_folder("held");
  write_file(held.path() / "file", std::string_view("own"));
  CHECK(held.in_place());

  fs::rename(held.path(), moved);
  CHECK_FALSE(held.in_place());
  fs::create_directory_symlink(precious, held.path());
  CHECK_FALSE(held.in_place());
  char letter = 0;
  const Descriptor own = held.open_file("file");
  REQUIRE(::read(own.get(), &letter, 1) == 1);
  CHECK(letter == 'o');
  held.remove_file("file");
  CHECK(read_file(precious / "file") == "precious");
  CHECK(fs::is_empty(moved));

  write_file(moved / "more" / "file", std::string_view("own"));
  held.remove_contents();
  CHECK(read_file(precious / "file") == "precious");
  CHECK(fs::is_empty(moved));
}

TEST_CASE("What links in a held folder lead to is neither opened nor removed") {
  const TemporaryFolder temporary;
  const fs::path precious = temporary.path() / "precious";
  write_file(precious / "file", std::string_view("precious"));
  const HeldFolder held = temporary.held().create_folder("held");
  fs::create_directories(held.path() / "inner" / "innermost");
  fs::create_directory_symlink(precious, held.path() / "folder link");
  fs::create_directory_symlink(precious, held.path() / "inner" / "folder link");
  fs::create_directory_symlink(precious, held.path() / "inner" / "innermost" / "folder link");
  fs::create_symlink(precious / "file", held.path() / "file link");
  fs::create_symlink("nowhere", held.path() / "broken link");
  REQUIRE(::mkfifo((held.path() / "fifo").c_str(), 0600) == 0);

  const Descriptor linked = held.open_file("file link");
  CHECK(errno == ELOOP);
  CHECK_FALSE(linked);
  CHECK(held.open_file("fifo"));  // at once, though nobody writes
  CHECK(held.has("broken link"));
  CHECK_FALSE(held.has("nothing"));
  held.remove_file("file link");
  CHECK_FALSE(held.has("file link"));
  held.remove_contents();
  CHECK(fs::is_empty(held.path()));
  CHECK(read_file(precious / "file") == "precious");
}

TEST_CASE("A temporary folder that is exchanged for a link removes its own contents alone") {
  const TemporaryFolder around;
  const fs::path precious = around.path() / "precious", moved = around.path() / "moved";
  write_file(precious / "file", std::string_view("precious"));
  fs::path path;
  {
    const TemporaryFolder temporary;
    path = temporary.path();
    write_file(path / "file", std::string_view("own"));
    fs::rename(path, moved);
    fs::create_directory_symlink(precious, path);
  }
  CHECK(read_file(precious / "file") == "precious");
  CHECK(fs::is_empty(moved));
  CHECK_FALSE(fs::exists(fs::symlink_status(path)));
}

TEST_CASE("Folders are removed however deep they are nested") {
  const TemporaryFolder temporary;
  const HeldFolder held = temporary.held().create_folder("held");
  // Longer than any path may be, and deeper than this process may hold descriptors.
  int folder = ::open(held.path().c_str(), O_RDONLY | O_DIRECTORY);
  for (int depth = 0; depth < 3000; ++depth) {
    REQUIRE(::mkdirat(folder, "nested", 0700) == 0);
    const int inner = ::openat(folder, "nested", O_RDONLY | O_DIRECTORY);
    ::close(folder);
    folder = inner;
  }
  ::close(folder);
  held.remove_contents();
  CHECK(fs::is_empty(held.path()));
}

TEST_CASE("Only a folder itself can be held, and only a new one created") {
  const TemporaryFolder temporary;
  write_file(temporary.path() / "file", std::string_view("x"));
  fs::create_directory_symlink(temporary.path(), temporary.path() / "link");
  for (const char* const name : {"file", "link", "nothing"}) {
    INFO(name);
    const fs::path path = temporary.path() / name;
    CHECK(mentions(error_of([&] { HeldFolder{path}; }), {path.string(), "cannot be opened as a folder"}));
  }
  CHECK(mentions(error_of([&] { temporary.held().create_folder("link"); }), {"link: cannot be created: File exists"}));
}
