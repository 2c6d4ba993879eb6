// Gate 0, results without an answer, and the contents of a result.
#include "judge/compare/verdict.hpp"

#include <cmath>
#include <limits>

#include "catch.hpp"
#include "synthetic.hpp"

namespace atelier::judge::test {
namespace {

using atelier::test::error_of;
using atelier::test::mentions;

StepReferences references_of(const Image& picture) {
  StepReferences references("02-blinn-phong");
  CaseReferences right;
  right.pictures.push_back(picture);
  references.add("sphere", right);
  return references;
}

TEST_CASE("no answer: the status has the kind of failure, the reason is the program's message") {
  const StepReferences references = references_of(draw({}));
  struct Row {
    Answer::Ended ended;
    Status status;
    const char* word;
  };
  for (const Row& row : {Row{Answer::Ended::missing, Status::missing, "missing"},
                         Row{Answer::Ended::crashed, Status::crashed, "crashed"},
                         Row{Answer::Ended::timeout, Status::timeout, "timeout"},
                         Row{Answer::Ended::build_failed, Status::build_failed, "build_failed"}}) {
    INFO(row.word);
    Answer answer;
    answer.ended = row.ended;
    const CaseResult silent = judge_case(picture_case(), answer, references);
    CHECK(silent.status == row.status);
    CHECK(to_string(silent.status) == row.word);
    CHECK(silent.score == 0);
    CHECK(silent.max_score == 10);
    CHECK_FALSE(silent.reason.empty());
    answer.error = "segmentation fault (SIGSEGV)";
    CHECK(judge_case(picture_case(), answer, references).reason == answer.error);
  }
  Answer numbers = answer_of(std::vector<Numbers>{{1}});  // numbers where a picture is asked for
  CHECK(judge_case(picture_case(), numbers, references).status == Status::missing);
}

TEST_CASE("gate 0: pictures that need no comparison score 0, with the reason") {
  const Image right = draw({});
  const StepReferences references = references_of(right);
  const auto spoiled = [&](int count, float value) {
    Image picture = right;
    for (int i = 0; i < count; ++i) picture.at(3 + i, 50).g = value;
    return picture;
  };
  Image transparent = right;
  transparent.at(7, 8).a = nan;
  struct Row {
    const char* name;
    Image picture;
    std::vector<std::string_view> words;
  };
  const std::vector<Row> rows{
      {"one NaN", spoiled(1, nan), {"1 pixel is NaN", "(3, 50)"}},
      {"minus infinity", spoiled(1, -infinity), {"infinity", "(3, 50)"}},
      {"many", spoiled(25, nan), {"25 pixels", "(12, 50)"}},
      {"NaN opacity", transparent, {"(7, 8)"}},
      {"smaller", Image(64, 32), {"64x32", "192x192"}},
      {"black", Image(192, 192), {"black all over"}},
      {"one colour", Image(192, 192, {0.5f, 0, 0, 1}), {"red all over"}},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    const CaseResult result = judge_case(picture_case(), answer_of(row.picture), references);
    CHECK(result.status == Status::failed);
    CHECK(result.score == 0);
    INFO(result.reason);
    for (std::string_view word : row.words) CHECK(mentions(result.reason, {word}));
    CHECK_FALSE(result.hint.empty());
  }
  const CaseResult many = judge_case(picture_case(), answer_of(spoiled(25, nan)), references);
  CHECK_FALSE(mentions(many.reason, {"(13, 50)"}));  // the first ten alone
  CHECK(many.figures.at("non_finite") == 25);
  REQUIRE(many.evidence.has_value());
  CHECK(many.evidence->over.at(3, 50).r == 1);
  CHECK(many.evidence->over.at(2, 50).r == 0);
  CHECK(std::isfinite(many.evidence->yours.at(3, 50).g));
}

TEST_CASE("gate 0: a single colour may be the right answer") {
  const StepReferences references = references_of(Image(192, 192, {0.3f, 0.3f, 0.3f, 1}));
  CHECK(judge_case(picture_case(), answer_of(Image(192, 192, {0.3f, 0.3f, 0.3f, 1})), references).status ==
        Status::passed);
  CHECK(judge_case(picture_case(), answer_of(Image(192, 192, {0.6f, 0.3f, 0.3f, 1})), references).status ==
        Status::failed);
}

TEST_CASE("a result has all that a report needs") {
  Drawing wrong;
  wrong.no_highlight = true;
  const StepReferences references = references_of(draw({}));
  Answer answer = answer_of(draw(wrong));
  answer.output = "debug";
  CaseResult result = judge_case(picture_case(), answer, references);
  CHECK(result.name == "sphere");
  CHECK(result.title == "A sphere over a floor");
  CHECK(result.asked == "A bumpy sphere over a textured floor.");
  CHECK(result.hint == "Look at the light.");
  CHECK(result.command == "./atelier check 02-blinn-phong --case sphere");
  CHECK(result.output == "debug");
  CHECK(mentions(result.reason, {"too dark", "in the middle"}));
  CHECK(result.figures.at("share") == Approx(result.figures.at("over") / (192.0 * 192)));
  CHECK(result.figures.at("blob") > 0);
  CHECK(result.worst->reference.g > result.worst->yours.g);
  CHECK(result.worst->reference.g <= 255);
  CHECK(result.worst->reference.g > 1);  // 0..255, not 0..1

  CHECK(result.figures.count("flip_mean") == 0);
  draw_flip(result);
  CHECK(result.evidence->flip.width() == 192);
  CHECK(result.figures.at("flip_mean") > 0);

  CHECK_FALSE(judge_case(picture_case(), answer, references, KeepEvidence::never).evidence.has_value());
  CHECK(judge_case(picture_case(), answer_of(draw({})), references, KeepEvidence::always).evidence.has_value());
}

TEST_CASE("data outside 0..1 are mapped to be visible, without a FLIP map") {
  const Image depth = draw_depth({});
  const StepReferences references = references_of(depth);
  const JudgedCase c = picture_case(Profile::strict, Unit::number, 0.01, 4);
  CaseResult result = judge_case(c,
                                 answer_of(changed(depth,
                                                   [](const Rgba& p) {
                                                     return Rgba{p.r + 1, p.g + 1, p.b + 1, 1};
                                                   })),
                                 references);
  REQUIRE(result.evidence.has_value());
  CHECK_FALSE(result.evidence->colours);
  for (const Rgba& p : result.evidence->reference.pixels()) REQUIRE((p.r >= 0 && p.r <= 1));
  CHECK(result.worst->yours.r == Approx(result.worst->reference.r + 1));  // the data itself
  draw_flip(result);
  CHECK(result.evidence->flip.empty());
}

TEST_CASE("without a reference nothing is judged") {
  const StepReferences none("02-blinn-phong");
  CHECK(mentions(error_of([&] { judge_case(picture_case(), Answer{}, none); }), {"sphere", "no reference"}));
}

}  // namespace
}  // namespace atelier::judge::test
