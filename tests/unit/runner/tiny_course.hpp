// A step of two C++ files and a shader, to be built without the project around it.
#pragma once

#include <filesystem>
#include <string>

#include "base/file.hpp"
#include "judge/run/build.hpp"

namespace atelier::test {

/// A contract with two files to write, as CMake describes it, and a student's honest start on them.
struct Course {
  TemporaryFolder folder;
  std::filesystem::path student = folder.path() / "student files", out = folder.path() / "out",
                        given = folder.path() / "given";
  std::filesystem::path library = out / "90-sums" / "libstep.so";
  judge::StepFlags flags{.compiler = "g++",
                         .compiler_version = "GNU",
                         .compile = {"-std=c++20", "-O0", "-fPIC", "-Wall", "-I" + (folder.path() / "given").string()},
                         .link = {"-shared"},
                         .files = {{"90-sums", {"sum.cpp", "product.cpp", "sums.glsl"}}, {"91-shader", {"only.glsl"}}},
                         .headers = {{"90-sums", {"90-sums/sums.hpp"}}},
                         .uses = {},
                         .titles = {}};

  Course() {
    write_file(given / "90-sums/sums.hpp", "#pragma once\nextern \"C\" int sum(int a, int b);\n#define ONE 1\n");
    write("sum.cpp", "#include \"90-sums/sums.hpp\"\nint sum(int a, int b) { return a + b; }\n");
    write("product.cpp", "extern \"C\" int product(int a, int b) { return a * b; }\n");
    write("sums.glsl", "float sum(float a, float b) { return a + b; }\n");
  }
  void write(const std::string& name, const std::string& text) { write_file(student / name, text); }
  judge::Built build() { return judge::build_step(flags, "90-sums", student, out); }
};

}  // namespace atelier::test
