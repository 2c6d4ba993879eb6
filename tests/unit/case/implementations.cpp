#include "case/implementations.hpp"

#include <fstream>

#include "base/file.hpp"
#include "catch.hpp"

using namespace atelier;
using test::error_of;
namespace fs = std::filesystem;

TEST_CASE("for each file, the first root that has it is used") {
  const TemporaryFolder folder;
  const fs::path mine = folder.path() / "mine", solution = folder.path() / "solution";
  write_file(mine / "02-x" / "a.glsl", "mine");
  write_file(solution / "02-x" / "a.glsl", "solution");
  write_file(solution / "02-x" / "b.glsl", "solution");
  write_file(mine / "03-y" / "a.glsl", "mine");
  write_file(solution / "03-y" / "a.glsl", "solution");
  write_file(folder.path() / "outside.glsl", "");

  const fs::path given = folder.path() / "given";
  write_file(given / "02-x" / "c.glsl", "given");
  write_file(given / "02-x" / "d.glsl", "given");

  const std::string text = "02-x=" + mine.string() + ":" + solution.string() + ":02-x/d.glsl=" + given.string();
  const Implementations found = Implementations::parse(text);
  CHECK(found.to_string() == text);
  CHECK(found.find("02-x/a.glsl") == mine / "02-x/a.glsl");
  CHECK(found.find("02-x/b.glsl") == solution / "02-x/b.glsl");
  CHECK(found.find("03-y/a.glsl") == solution / "03-y/a.glsl");  // `mine` stands for 02-x only
  CHECK(found.find("02-x/d.glsl") == given / "02-x/d.glsl");
  for (const char* name : {"02-x/c.glsl", "02-x", "", "../outside.glsl", "02-x/../../outside.glsl", "/etc/passwd"}) {
    INFO(name);
    CHECK(found.find(name).empty());
  }
}

TEST_CASE("search paths are checked") {
  CHECK(Implementations::parse("").roots().empty());
  CHECK(Implementations::parse("::/tmp:").roots().size() == 1);
  CHECK(error_of([] { Implementations::parse("/nowhere"); }) == "implementations: there is no folder '/nowhere'");
  CHECK(error_of([] { Implementations::parse("02-x=/nowhere"); }) == "implementations: there is no folder '/nowhere'");
  CHECK(error_of([] { Implementations::parse("=/tmp"); }) == "implementations: '=/tmp' names no step before '='");
  CHECK(error_of([] { Implementations::parse("a/b/c=/tmp"); }).find("'a/b/c' is neither a step") != std::string::npos);
}
