#include "base/replace_together.hpp"

#include <iterator>

#include "base/error.hpp"
#include "base/file.hpp"
#include "catch.hpp"

using atelier::Error;
using atelier::read_file;
using atelier::replace_together;
using atelier::TemporaryFolder;
using atelier::write_file;
namespace fs = std::filesystem;

TEST_CASE("files that belong together are replaced atomically") {
  const TemporaryFolder folder;
  const fs::path a = folder.path() / "a", b = folder.path() / "b";
  write_file(a, std::string_view("old a"));
  write_file(b, std::string_view("old b"));
  const auto writes = [](const char* text) {
    return [text](const fs::path& file) { write_file(file, std::string_view(text)); };
  };

  CHECK_THROWS_AS(replace_together({{a, writes("new a")}, {b, [](const fs::path&) { throw Error("no room"); }}}),
                  Error);
  CHECK(read_file(a) == "old a");
  CHECK(read_file(b) == "old b");
  CHECK(std::distance(fs::directory_iterator(folder.path()), {}) == 2);  // nothing is left lying about

  replace_together({{a, writes("new a")}, {b, writes("new b")}});
  CHECK(read_file(a) == "new a");
  CHECK(read_file(b) == "new b");
  CHECK(std::distance(fs::directory_iterator(folder.path()), {}) == 2);
}
