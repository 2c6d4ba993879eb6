#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "base/file.hpp"
#include "base/printable.hpp"
#include "base/process.hpp"
#include "base/strict_json.hpp"
#include "catch.hpp"
#include "judge/report/report_json.hpp"
#include "judge/report/report_junit.hpp"
#include "sample.hpp"

using namespace atelier;
using namespace atelier::judge;

TEST_CASE("results.json has the members that other programs rely on") {
  const auto document = strict_json::parse(results_json(test::sample()), "results.json");
  for (const char* member : {"submission", "score", "max_score", "steps", "environment"})
    CHECK(document.contains(member));
  CHECK(document["submission"] == "ada-lovelace");
  CHECK(document["score"] == 4.45);
  CHECK(document["environment"]["context"] == "osmesa");
  CHECK(document["notes"].empty());
  CHECK(strict_json::parse(results_json(test::unbuilt_sample(3)), "results.json")["notes"].size() == 1);
  CHECK(strict_json::parse(results_json(test::unbuilt_sample(3)), "results.json")["steps"][0]["cases"].size() == 3);
  CHECK(test::mentions(junit_xml(test::unbuilt_sample(3)), {"tests=\"3\"", "errors=\"3\"", "\"note\""}));
  const auto& step = document["steps"][1];
  CHECK(step["step"] == "02-blinn-phong");
  CHECK(step["implementations"]["01-transforms"] == "yours");
  CHECK(step["caveat"] == "");
  const char* const statuses[] = {"passed", "failed", "failed", "missing", "crashed", "timeout", "build_failed"};
  REQUIRE(step["cases"].size() == std::size(statuses));
  for (std::size_t i = 0; i < std::size(statuses); ++i) {
    const auto& c = step["cases"][i];
    CHECK(c["status"] == statuses[i]);
    for (const char* member : {"name", "title", "status", "score", "max_score", "reason", "mistake", "hint"}) {
      INFO(member);
      CHECK(c.contains(member));
    }
  }
  CHECK(step["cases"][0]["mistake"].is_null());
  CHECK(step["cases"][0]["worst"].is_null());
  CHECK(step["cases"][1]["mistake"] == "no-specular");
  CHECK(step["cases"][1]["worst"]["reference"].size() == 4);
}

TEST_CASE("results.json represents NaN and infinity, and rounds sums") {
  SubmissionResult result = test::sample();
  result.score = 0.1 + 0.2;
  result.steps[1].cases[1].figures = {{"a", std::nan("")}, {"b", -INFINITY}, {"c", 0.1}};
  const auto document = strict_json::parse(results_json(result), "results.json");
  CHECK(document["score"] == 0.3);
  const auto& figures = document["steps"][1]["cases"][1]["figures"];
  CHECK(figures["a"] == "nan");
  CHECK(figures["b"] == "-inf");
  CHECK(figures["c"] == 0.1);
}

TEST_CASE("results.json is valid and plain whatever the texts hold") {
  const std::string text = results_json(test::hostile_sample());
  CHECK(strict_json::parse(text, "results.json")["steps"].size() == 2);
  for (char c : text) REQUIRE((c == '\n' || static_cast<unsigned char>(c) >= 0x20));
}

TEST_CASE("a file is written atomically") {
  const TemporaryFolder folder;
  write_results_json(folder.path() / "a/results.json", test::sample());
  CHECK(read_file(folder.path() / "a/results.json") == results_json(test::sample()));
  CHECK(test::error_of([&] { write_results_json("/proc/nowhere/results.json", test::sample()); }) != "");
}

namespace {

/// A well-formedness check in few words: every tag that opens closes in order, and text holds no bare sign of markup.
/// Enough for what the writer can produce (elements, attributes in double quotes, the five references).
std::string malformed(const std::string& xml) {
  std::vector<std::string> open;
  for (std::size_t at = 0; at < xml.size();) {
    if (xml[at] == '&') {
      const std::string reference = xml.substr(at, xml.find(';', at) - at + 1);
      const std::set<std::string> known = {"&amp;", "&lt;", "&gt;", "&quot;", "&#39;"};
      if (!known.contains(reference)) return "reference " + reference;
      at += reference.size();
    } else if (xml[at] == '>') {
      return "bare >";
    } else if (xml[at] == '<') {
      std::size_t end = at;
      for (bool quoted = false; end < xml.size() && (quoted || xml[end] != '>'); ++end) {
        if (xml[end] == '"') quoted = !quoted;
        if (quoted && xml[end] == '<') return "< in an attribute";
      }
      const std::string tag = xml.substr(at + 1, end - at - 1);
      const std::string name = tag.substr(0, tag.find(' '));
      if (tag.starts_with('/')) {
        if (open.empty() || "/" + open.back() != tag) return "</" + tag;
        open.pop_back();
      } else if (!tag.ends_with('/') && !tag.starts_with('?')) {
        open.push_back(name);
      }
      at = end + 1;
    } else {
      ++at;
    }
  }
  return open.empty() ? "" : "open " + open.back();
}

}  // namespace

TEST_CASE("JUnit XML counts cases, failures and errors") {
  const std::string xml = junit_xml(test::sample());
  CHECK(malformed(xml) == "");
  CHECK(
      test::mentions(xml, {"<testsuites name=\"ada-lovelace\" tests=\"8\" failures=\"3\" errors=\"3\">",
                           "<testsuite name=\"02-blinn-phong\" tests=\"7\" failures=\"3\" errors=\"3\" skipped=\"0\">",
                           "<testcase classname=\"02-blinn-phong\" name=\"highlight\">",
                           "<error type=\"crashed\" message=\"segmentation fault (SIGSEGV)\">",
                           "<failure type=\"missing\" message=\"the program wrote no picture\">",
                           "looks like: The specular term is missing", "<property name=\"score\" value=\"2.45\"/>"}));
}

TEST_CASE("JUnit XML is well-formed XML 1.0 whatever the texts hold") {
  const std::string xml = junit_xml(test::hostile_sample());
  CHECK(malformed(xml) == "");
  CHECK(printable(xml, Layout::keep_lines) == xml);  // only characters that XML 1.0 allows, and no broken UTF-8
  const TemporaryFolder folder;
  write_junit_xml(folder.path() / "junit.xml", test::hostile_sample());
  try {
    const Finished finished =
        run_process({.arguments = {"xmllint", "--noout", (folder.path() / "junit.xml").string()}});
    INFO(finished.output);
    CHECK(finished.ok());
  } catch (const Error& missing) {
    WARN("xmllint (libxml2-utils) is not installed: only our own check ran. " << missing.what());
  }
}

TEST_CASE("the well-formedness check itself finds faults") {
  for (const char* bad : {"<a>", "<a></b>", "<a b=\"<\"/>", "<a>&x</a>", "<a>></a>", "</a>"}) {
    INFO(bad);
    CHECK(malformed(bad) != "");
  }
}
