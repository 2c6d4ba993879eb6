#include "base/csv.hpp"
#include "catch.hpp"

using namespace atelier;

TEST_CASE("a CSV field is quoted only if necessary", "[base]") {
  CHECK(csv_field("") == "");
  CHECK(csv_field("shadow.fit: casters") == "shadow.fit: casters");
  CHECK(csv_field("a, b") == "\"a, b\"");
  CHECK(csv_field("the \"knee\"") == "\"the \"\"knee\"\"\"");
  CHECK(csv_field("two\nlines") == "\"two\nlines\"");
  CHECK(csv_field("two\r") == "\"two\r\"");
}

TEST_CASE("a CSV table is parsed as it was written", "[base]") {
  using Fields = std::vector<std::string>;
  struct Row {
    const char* text;
    std::vector<Fields> rows;
  };
  const Row rows[] = {
      {"", {}},
      {"\n\r\n\r", {}},
      {"a", {{"a"}}},
      {"a,b\nc,d", {{"a", "b"}, {"c", "d"}}},
      {"a,b\r\nc,\r\n", {{"a", "b"}, {"c", ""}}},
      {"a\rb\r", {{"a"}, {"b"}}},
      {",\n", {{"", ""}}},
      {"a;b\n1,5;2\n", {{"a", "b"}, {"1,5", "2"}}},
      {"a;b,c\n", {{"a;b", "c"}}},
      {"\"a,\"\"b\"\"\nc\",d\n", {{"a,\"b\"\nc", "d"}}},
      {"\"\"", {}},
      {"\"\",\"\"", {{"", ""}}},
      {"\xEF\xBB\xBF\"a\",b", {{"a", "b"}}},
      {"a\"b,c", {{"a\"b", "c"}}},
  };
  for (const Row& row : rows) {
    INFO(row.text);
    std::vector<Fields> found;
    for (const CsvRow& parsed : parse_csv(row.text, "t.csv")) found.push_back(parsed.fields);
    CHECK(found == row.rows);
  }
  const std::vector<CsvRow> lines = parse_csv("a\n\n\"b\nc\"\nd\n", "t.csv");
  REQUIRE(lines.size() == 3);
  CHECK(lines[1].line == 3);
  CHECK(lines[2].line == 5);
  CHECK(test::error_of([] { parse_csv("a\n\"b", "t.csv"); }) == "t.csv:2: a quote is not closed");
  CHECK(test::mentions(test::error_of([] { parse_csv("\"a\nb\"c", "t.csv"); }), {"t.csv:2: text follows"}));
  CHECK(parse_csv(std::string(100'000, '\r'), "t.csv").empty());
  for (const char* text : {"", "a,b", "\"q\"", "two\nlines\r"})
    CHECK(parse_csv("x," + csv_field(text), "").at(0).fields.at(1) == text);
}
