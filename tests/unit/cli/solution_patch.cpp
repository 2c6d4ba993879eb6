// Patches of a solution: made from two folders, and updated if the solution changes. Entries in their lists.
#include "cli/author/solution_patch.hpp"

#include "base/file.hpp"
#include "base/process.hpp"
#include "catch.hpp"
#include "cli/author/mistake_list.hpp"
#include "judge/compare/mistakes.hpp"

using namespace atelier;
using atelier::test::error_of;
using atelier::test::mentions;

namespace {

namespace fs = std::filesystem;

const Sources solution = {{"a.cpp", "one\ntwo\nthree\nfour\nfive\nsix\nseven\n"}, {"b.glsl", "x\n"}};

Sources with(const std::string& a) {
  Sources changed = solution;
  changed["a.cpp"] = a;
  return changed;
}

/// The patch between the solution and what `mistaken` is, renewed for `now`.
Renewed renewed(const Sources& mistaken, const Sources& now) {
  const TemporaryFolder folder;
  write_file(folder.path() / "m.patch", patch_between(solution, mistaken));
  return renewed_patch(folder.path() / "m.patch", solution, now);
}

/// What a patch makes of sources.
Sources patched(const Sources& sources, const std::string& patch) {
  const TemporaryFolder folder;
  for (const auto& [name, text] : sources) write_file(folder.path() / "in" / name, text);
  write_file(folder.path() / "m.patch", patch);
  judge::make_patched(folder.path() / "in", folder.path() / "m.patch", folder.path() / "out");
  return sources_of(folder.path() / "out");
}

}  // namespace

TEST_CASE("a patch has the paths a/FILE and b/FILE, and reproduces the edited files") {
  const Sources mistaken = with("one\ntwo\n3\nfour\nfive\nsix\nseven\n");
  const std::string patch = patch_between(solution, mistaken);
  CHECK(patch.starts_with("--- a/a.cpp\n+++ b/a.cpp\n@@ -1,6 +1,6 @@\n"));
  CHECK(patched(solution, patch) == mistaken);
  CHECK(patch_between(solution, solution) == "");
  CHECK(mentions(error_of([] { patch_between(solution, {{"a.cpp", ""}}); }), {"adds or removes none", "b.glsl"}));
}

TEST_CASE("patches are merged with a changed solution, and conflicts are reported") {
  using State = Renewed::State;
  const Sources mistaken = with("one\ntwo\nthree\nfour\nfive\n6\nseven\n");
  CHECK(renewed(mistaken, solution).state == State::as_it_was);
  const Sources elsewhere = with("eins\nzwei\nthree\nfour\nfive\nsix\nseven\n");
  CHECK(renewed(mistaken, elsewhere).state == State::as_it_was);  // its own lines are the same

  const Sources beside = with("one\ntwo\n3a\n3b\nVIER\nfive\nsix\nseven\n");
  const Renewed made = renewed(mistaken, beside);
  REQUIRE(made.state == State::renewed);
  CHECK(patched(beside, made.text)["a.cpp"] == "one\ntwo\n3a\n3b\nVIER\nfive\n6\nseven\n");

  CHECK(renewed(mistaken, with("one\ntwo\nthree\nfour\nfive\nsechs\nseven\n")).state == State::conflict);
  CHECK(renewed(mistaken, mistaken).state == State::lost);
  const TemporaryFolder folder;
  write_file(folder.path() / "m.patch", std::string_view("--- a/a.cpp\n+++ b/a.cpp\n@@ -1 +1 @@\n-zero\n+0\n"));
  CHECK(renewed_patch(folder.path() / "m.patch", solution, beside).state == State::not_on_before);
}

TEST_CASE("entries are added to a list, and nothing else is changed") {
  const std::string one = with_entry("", mistake_entry("first-one"), "mistakes.json");
  const std::string two = with_entry(one, mistake_entry("second-one"), "mistakes.json");
  CHECK(two.starts_with(one.substr(0, one.size() - 3)));
  const std::string once = with_spelling(two, "first-one", "first-one.other.patch", "mistakes.json");
  const std::string spelt = with_spelling(once, "first-one", "first-one.other-2.patch", "mistakes.json");
  const TemporaryFolder folder;
  for (const char* patch : {"first-one.patch", "first-one.other.patch", "first-one.other-2.patch", "second-one.patch"})
    write_file(folder.path() / patch, std::string_view("-"));
  write_file(folder.path() / "mistakes.json", spelt);
  const auto mistakes = judge::read_mistakes(folder.path() / "mistakes.json");
  REQUIRE(mistakes.size() == 2);
  CHECK(mistakes[0].spellings.size() == 2);
  CHECK(mistakes[1].spellings.empty());
  CHECK(mistakes[1].hint.starts_with(to_be_written));

  write_file(folder.path() / "variants.json", with_entry("", variant_entry("first-one"), "variants.json"));
  CHECK(judge::read_variants(folder.path() / "variants.json").size() == 1);
  CHECK(mentions(error_of([&] { with_spelling(two, "third-one", "x.patch", "mistakes.json"); }),
                 {"mistakes.json", "third-one"}));
  CHECK(mentions(error_of([] { with_entry("{", "x", "mistakes.json"); }), {"mistakes.json", "list"}));
}
