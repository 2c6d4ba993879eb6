#include "grade/zip.hpp"

#include "base/file.hpp"
#include "base/process.hpp"
#include "catch.hpp"
#include "made_archive.hpp"

using namespace atelier;
using namespace atelier::grade;

namespace {

namespace fs = std::filesystem;

const PackedFiles files = {{"01-move/move.cpp", {.bytes = "int a;\n"}},
                           {"02-light/light.glsl", {.bytes = std::string(100'000, 'x')}},
                           {"empty", {}},
                           {"run", {.bytes = "#!/bin/sh\n", .executable = true}}};

}  // namespace

TEST_CASE("a packed archive is read back") {
  const TemporaryFolder folder;
  write_file(folder.path() / "a.zip", make_zip(files));
  const auto found = test::read_members(folder.path() / "a.zip",
                                        {"01-move/move.cpp", "02-light/light.glsl", "empty", "run"}, {.ratio = 1e6})
                         .files;
  REQUIRE(found.size() == files.size());
  for (const auto& [path, file] : files) {
    INFO(path);
    CHECK(found.at(path) == file.bytes);
  }
}

TEST_CASE("the same files make the same archive, and another program unpacks it with its permissions") {
  const TemporaryFolder folder;
  const std::string archive = make_zip(files);
  CHECK(archive == make_zip(files));
  CHECK(archive.size() < 2'000);  // it is deflated
  write_file(folder.path() / "a.zip", archive);
  REQUIRE(run_process({.arguments = {"cmake", "-E", "tar", "xf", "a.zip"}, .folder = folder.path()}).ok());
  CHECK(read_file(folder.path() / "02-light/light.glsl") == files.at("02-light/light.glsl").bytes);
  const auto executable = [&](const char* name) {
    return (fs::status(folder.path() / name).permissions() & fs::perms::owner_exec) != fs::perms::none;
  };
  CHECK(executable("run"));
  CHECK_FALSE(executable("empty"));
}
