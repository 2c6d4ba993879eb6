// Renamed identifiers in a student's files: whole tokens, only in their step.
#include "cli/student/renames.hpp"

#include "base/file.hpp"
#include "catch.hpp"

using namespace atelier;
using atelier::test::error_of;
using atelier::test::mentions;

TEST_CASE("whole tokens are renamed, in the files of their step") {
  const std::vector<Rename> renames = {{"03-far", "lit", "compare_depth"},
                                       {"03-far", "\"03-far/far.glsl\"", "\"03-far/given/far.glsl\""},
                                       {"03-far", "near", "far"},
                                       {"03-far", "far", "near"},
                                       {"04-near", "lit", "other"}};
  struct Row {
    const char *text, *expected;
  };
  for (const Row& row : {Row{"float lit(vec3 c) { return lit_by(c) + split(c) + lit (c); }",
                             "float compare_depth(vec3 c) { return lit_by(c) + split(c) + compare_depth (c); }"},
                         Row{"#include \"03-far/far.glsl\"\n", "#include \"03-far/given/far.glsl\"\n"},
                         Row{"a.near = b.far;", "a.far = b.near;"},  // each once: no chain of renames
                         Row{"\"lit\" // it's lit\n", "\"lit\" // it's compare_depth\n"},
                         Row{"\"open lit\n", "\"open compare_depth\n"}, Row{"", ""}})
    CHECK(renamed(row.text, "03-far", renames) == row.expected);
  CHECK(renamed("lit", "02-light", renames) == "lit");
}

TEST_CASE("a file of renames is read line by line, and an invalid line is named") {
  const TemporaryFolder folder;
  const auto file = folder.path() / "renames.txt";
  CHECK(read_renames(file).empty());
  write_file(file, std::string_view("# why\n\n03-far lit compare_depth\n  03-far  a  b  \n"));
  const std::vector<Rename> all = {{"03-far", "lit", "compare_depth"}, {"03-far", "a", "b"}};
  CHECK(read_renames(file) == all);
  CHECK(renames_to_do(all, {all[0]}) == std::vector{all[1]});
  for (const char* line : {"03-far lit\n", "03-far a b c\n"}) {
    write_file(file, "# one\n" + std::string(line));
    CHECK(mentions(error_of([&] { read_renames(file); }), {"renames.txt:2", "old and a new name"}));
  }
}
