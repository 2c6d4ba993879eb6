// Lists of mistakes and variants, and the patches that make them.
#include "judge/compare/mistakes.hpp"

#include "base/file.hpp"
#include "catch.hpp"
#include "words.hpp"

using namespace atelier;
using namespace atelier::judge;
using test::error_of;
namespace fs = std::filesystem;

namespace {

const std::string solution_text =
    "#include <cmath>\n"
    "\n"
    "float highlight(float n_dot_h, float exponent) {\n"
    "  return std::pow(n_dot_h, exponent);\n"
    "}\n";

const std::string good_patch =
    "--- a/blinn_phong.cpp\n"
    "+++ b/blinn_phong.cpp\n"
    "@@ -3,3 +3,3 @@\n"
    " float highlight(float n_dot_h, float exponent) {\n"
    "-  return std::pow(n_dot_h, exponent);\n"
    "+  return std::pow(n_dot_h, exponent / 4);\n"
    " }\n";

/// A folder with a list, and patches for it to name.
struct Lists {
  TemporaryFolder folder;
  fs::path file = folder.path() / "list.json";

  explicit Lists(const std::string& text) {
    write_file(file, text);
    for (const char* name : {"a.patch", "b.patch", "notes.txt"}) write_file(folder.path() / name, good_patch);
    fs::create_directory(folder.path() / "folder.patch");
  }
};

std::string mistake(const std::string& change_from = "", const std::string& change_to = "") {
  std::string text =
      R"({"name": "a", "title": "A", "sentence": "You forgot it.", "hint": "Look.", "patch": "a.patch"})";
  if (!change_from.empty()) {
    const std::size_t at = text.find(change_from);
    REQUIRE(at != std::string::npos);
    text.replace(at, change_from.size(), change_to);
  }
  return text;
}

}  // namespace

TEST_CASE("mistakes and variants are read") {
  const Lists lists("[" + mistake() + ", " +
                    mistake("\"name\": \"a\"", R"("spellings": ["b.patch", "a.patch"], "name": "b-2")") + "]");
  const auto mistakes = read_mistakes(lists.file);
  REQUIRE(mistakes.size() == 2);
  CHECK(mistakes[0].name == "a");
  CHECK(mistakes[0].title == "A");
  CHECK(mistakes[0].sentence == "You forgot it.");
  CHECK(mistakes[0].hint == "Look.");
  CHECK(mistakes[0].patch == lists.folder.path() / "a.patch");
  CHECK(mistakes[0].spellings.empty());
  REQUIRE(mistakes[1].spellings.size() == 2);
  CHECK(mistakes[1].spellings[0] == lists.folder.path() / "b.patch");

  const Lists others(R"([{"name": "other-order", "title": "The sum is taken from behind", "patch": "b.patch"}])");
  const auto variants = read_variants(others.file);
  REQUIRE(variants.size() == 1);
  CHECK(variants[0].name == "other-order");
  CHECK(variants[0].patch == others.folder.path() / "b.patch");
}

TEST_CASE("names of mistakes can be read without patches") {
  const Lists lists("[" + mistake(", \"patch\": \"a.patch\"", "") + "]");
  const auto mistakes = read_mistakes(lists.file, Patches::optional);
  REQUIRE(mistakes.size() == 1);
  CHECK(mistakes[0].sentence == "You forgot it.");
  CHECK(mistakes[0].patch.empty());
}

TEST_CASE("broken lists are refused with the place and the reason") {
  struct Row {
    std::string name, text;
    Words words;
  };
  const std::vector<Row> rows = {
      {"not JSON", "[{", {"list.json"}},
      {"an object", "{}", {"list"}},
      {"nothing in it", "[]", {"at least one"}},
      {"a number", "[1]", {"entry 1"}},
      {"unknown member", "[" + mistake("\"hint\"", "\"hnit\"") + "]", {"entry 1", "hnit", "hint"}},
      {"no name", "[" + mistake("\"name\": \"a\", ", "") + "]", {"entry 1", "name"}},
      {"bad name", "[" + mistake("\"a\"", "\"A b\"") + "]", {"entry 1: name", "A b"}},
      {"long name", "[" + mistake("\"a\"", "\"" + std::string(65, 'a') + "\"") + "]", {"name"}},
      {"twice", "[" + mistake() + "," + mistake() + "]", {"entry 2", "'a'", "twice"}},
      {"no title", "[" + mistake("\"title\": \"A\", ", "") + "]", {"'a'", "title"}},
      {"no sentence", "[" + mistake("\"sentence\": \"You forgot it.\", ", "") + "]", {"'a'", "sentence"}},
      {"empty sentence", "[" + mistake("You forgot it.", "") + "]", {"'a': sentence"}},
      {"hint of a wrong type", "[" + mistake("\"Look.\"", "[]") + "]", {"'a': hint", "[]"}},
      {"no patch", "[" + mistake(", \"patch\": \"a.patch\"", "") + "]", {"'a'", "patch"}},
      {"missing patch", "[" + mistake("a.patch", "c.patch") + "]", {"'a': patch", "c.patch", "no file"}},
      {"a folder", "[" + mistake("a.patch", "folder.patch") + "]", {"'a': patch", "folder.patch"}},
      {"another ending", "[" + mistake("a.patch", "notes.txt") + "]", {"'a': patch", ".patch file"}},
      {"elsewhere", "[" + mistake("a.patch", "../a.patch") + "]", {"'a': patch", "beside the list"}},
      {"absolute", "[" + mistake("a.patch", "/a.patch") + "]", {"'a': patch", "beside the list"}},
      {"missing spelling",
       "[" + mistake("\"a\"", R"("a", "spellings": ["c.patch"])") + "]",
       {"'a': spellings", "c.patch"}},
      {"spelling without a list",
       "[" + mistake("\"a\"", R"("a", "spellings": "b.patch")") + "]",
       {"'a': spellings", "b.patch", "list"}},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    const Lists lists(row.text);
    const std::string error = error_of([&] { read_mistakes(lists.file); });
    INFO(error);
    CHECK(has_all(error, {"list.json"}));
    CHECK(has_all(error, row.words));
  }
  const Lists lists("[" + mistake() + "]");
  CHECK(has_all(error_of([&] { read_variants(lists.file); }), {"list.json", "unknown member"}));
  CHECK(has_all(error_of([&] { read_mistakes(lists.folder.path() / "none.json"); }), {"none.json"}));
}

TEST_CASE("a patch makes the mistake out of the solution and leaves the solution alone") {
  const TemporaryFolder folder;
  const fs::path solution = folder.path() / "solution", made = folder.path() / "made",
                 patch = folder.path() / "a.patch";
  write_file(solution / "blinn_phong.cpp", solution_text);
  write_file(solution / "blinn_phong.glsl", "// shader\n");
  write_file(solution / "below" / "other.cpp", "");
  write_file(patch, good_patch);
  make_patched(solution, patch, made);

  CHECK(has_all(read_file(made / "blinn_phong.cpp"), {"exponent / 4"}));
  CHECK(read_file(made / "blinn_phong.glsl") == "// shader\n");
  CHECK(read_file(solution / "blinn_phong.cpp") == solution_text);
  std::vector<std::string> names;
  for (const auto& file : fs::directory_iterator(made)) names.push_back(file.path().filename());
  CHECK(names.size() == 2);
}

TEST_CASE("useless patches are refused with the message of patch") {
  const auto replaced = [](std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
  };
  struct Row {
    std::string name, patch;
    Words words;
  };
  const std::vector<Row> rows = {
      {"another solution", replaced(good_patch, "-  return std::pow", "-  return powf"), {"does not apply", "FAILED"}},
      {"another file",
       replaced(replaced(good_patch, "a/blinn_phong.cpp", "a/none.cpp"), "b/blinn_phong.cpp", "b/none.cpp"),
       {"does not apply"}},
      {"no patch", "hello\n", {"does not apply", "garbage"}},
      {"empty", "", {"changes nothing"}},
      {"a new file", "--- /dev/null\n+++ b/new.cpp\n@@ -0,0 +1 @@\n+int x;\n", {"not add or remove"}},
      {"a file taken away", "--- a/other.glsl\n+++ /dev/null\n@@ -1 +0,0 @@\n-x\n", {"not add or remove"}},
      {"outside", "--- a/../../x.cpp\n+++ b/../../x.cpp\n@@ -0,0 +1 @@\n+int x;\n", {"does not apply"}},
      {"applied already",
       replaced(replaced(good_patch, "-  return std::pow(n_dot_h, exponent);", "-  return 0;"), "exponent / 4",
                "exponent"),
       {"does not apply"}},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    const TemporaryFolder folder;
    const fs::path solution = folder.path() / "solution", patch = folder.path() / "bad.patch";
    write_file(solution / "blinn_phong.cpp", solution_text);
    write_file(solution / "other.glsl", "x\n");
    write_file(patch, row.patch);
    const std::string error = error_of([&] { make_patched(solution, patch, folder.path() / "made"); });
    INFO(error);
    CHECK(has_all(error, {"bad.patch"}));
    CHECK(has_all(error, row.words));
  }
  const TemporaryFolder folder;
  write_file(folder.path() / "a.patch", good_patch);
  CHECK(has_all(
      error_of([&] { make_patched(folder.path() / "none", folder.path() / "a.patch", folder.path() / "made"); }),
      {"none", "no such folder"}));
}
