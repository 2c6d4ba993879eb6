#include "cli/progress.hpp"

#include <memory>

#include "catch.hpp"

using namespace atelier;

namespace {

/// What two steps of two cases write.
std::string written(bool terminal, int width = 80) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::tmpfile(), std::fclose);
  REQUIRE(file);
  {
    Progress progress(file.get(), terminal, width, 2);
    for (const char* step : {"00-hello", "01-move"}) {
      progress.building(step);
      for (std::size_t k = 1; k <= 2; ++k) progress.judged(step, k, 2);
      judge::CaseResult passed, failed;
      passed.status = judge::Status::passed, failed.status = judge::Status::failed;
      progress.finished({.step = step, .score = 1, .max_score = 3, .cases = {passed, failed}});
    }
  }
  std::rewind(file.get());
  std::string text(4096, '\0');
  text.resize(std::fread(text.data(), 1, text.size(), file.get()));
  return text;
}

}  // namespace

TEST_CASE("progress is one plain line per step if the output is not a terminal") {
  CHECK(written(false) ==
        "00-hello: 1 / 3 points, 1 of 2 cases passed (step 1 of 2)\n"
        "01-move: 1 / 3 points, 1 of 2 cases passed (step 2 of 2)\n");
}

TEST_CASE("progress is one line on a terminal, and none in the end") {
  CHECK(written(true) ==
        "\r00-hello: building (step 1 of 2)\x1b[K"
        "\r00-hello: case 1 of 2 (step 1 of 2)\x1b[K"
        "\r00-hello: case 2 of 2 (step 1 of 2)\x1b[K"
        "\r01-move: building (step 2 of 2)\x1b[K"
        "\r01-move: case 1 of 2 (step 2 of 2)\x1b[K"
        "\r01-move: case 2 of 2 (step 2 of 2)\x1b[K"
        "\r\x1b[K");
  CHECK(written(true, 10).starts_with("\r00-hel...\x1b[K"));
}
