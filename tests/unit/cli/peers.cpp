// What a program of tests/peers writes: reading, and refused output.
#include <functional>
#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "cli/author/bench.hpp"

namespace atelier {
namespace {

using nlohmann::json;
using test::error_of;
using test::mentions;

json three_rounds() {
  return {{"rows",
           {{{"work", "tangents"}, {"peer", "assimp 5.2"}, {"ours", {1, 2, 4}}, {"aim", 5}, {"theirs", {8, 8, 8}}},
            {{"work", "tangents"}, {"peer", "assimp"}, {"ours", {3, 1, 2}}, {"missing", "libassimp-dev"}}}}};
}

}  // namespace

TEST_CASE("the times of peers are read") {
  const std::vector<PeerRow> rows = parse_peers(three_rounds().dump(), 3, "peers");
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].work == "tangents");
  CHECK(rows[0].peer == "assimp 5.2");
  CHECK(rows[0].missing.empty());
  CHECK(rows[0].ours == 2);
  CHECK(rows[0].theirs == 8);
  CHECK(rows[0].ratio == 4);
  CHECK(rows[0].least == 2);
  CHECK(rows[0].most == 8);
  CHECK(rows[0].aim == 5);
  CHECK(rows[1].missing == "libassimp-dev");
  CHECK(rows[1].ours == 2);
  CHECK(rows[1].theirs == 0);
  CHECK(rows[1].aim == 0);
}

TEST_CASE("invalid times of peers are refused with their place") {
  struct Row {
    const char* name;
    std::function<void(json&)> spoil;
    std::initializer_list<std::string_view> words;
  };
  const Row rows[] = {
      {"no rows", [](json& d) { d.erase("rows"); }, {"peers: ", "rows", "missing"}},
      {"an empty list of rows", [](json& d) { d["rows"] = json::array(); }, {"peers: rows", "at least one"}},
      {"a row that is none", [](json& d) { d["rows"][1] = 3; }, {"peers: row 2", "an object"}},
      {"no work", [](json& d) { d["rows"][0].erase("work"); }, {"row 1", "work", "missing"}},
      {"no peer", [](json& d) { d["rows"][0].erase("peer"); }, {"row 1", "peer", "missing"}},
      {"no times of ours", [](json& d) { d["rows"][1].erase("ours"); }, {"row 2", "ours", "missing"}},
      {"no times of theirs", [](json& d) { d["rows"][0].erase("theirs"); }, {"row 1", "theirs", "missing"}},
      {"an empty list", [](json& d) { d["rows"][0]["ours"] = json::array(); }, {"row 1: ours", "3 numbers"}},
      {"a round too few", [](json& d) { d["rows"][0]["theirs"].erase(0); }, {"row 1: theirs", "[8,8]", "3 numbers"}},
      {"a round too many", [](json& d) { d["rows"][0]["ours"].push_back(1); }, {"row 1: ours", "3 numbers"}},
      {"no time at all", [](json& d) { d["rows"][0]["ours"][1] = 0; }, {"row 1: ours", "0 is not allowed"}},
      {"a word for a time", [](json& d) { d["rows"][0]["theirs"][1] = "8"; }, {"row 1: theirs", "\"8\""}},
      {"times of a peer that is missing",
       [](json& d) {
         d["rows"][1]["theirs"] = {1, 1, 1};
       },
       {"row 2", "theirs"}},
      {"a missing package without a name", [](json& d) { d["rows"][1]["missing"] = ""; }, {"row 2: missing"}},
      {"an unknown member", [](json& d) { d["rows"][0]["times"] = 1; }, {"row 1", "times"}},
  };
  for (const Row& row : rows) {
    json spoiled = three_rounds();
    row.spoil(spoiled);
    const std::string words = error_of([&] { parse_peers(spoiled.dump(), 3, "peers"); });
    INFO(row.name << ": " << words);
    CHECK(mentions(words, row.words));
  }
}

}  // namespace atelier
