// Budget cases: the allowed choices, the student's choice, and its points.
#include "judge/compare/choice.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "catch.hpp"
#include "judge/compare/verdict.hpp"
#include "judge/run/choices_file.hpp"

using namespace atelier;
using namespace atelier::judge;
using nlohmann::json;

namespace {

const json usual = {{"settings", {"hall.segments"}},
                    {"at_most", {{"triangles", 200}}},
                    {"error", "rmse"},
                    {"full", 0.01},
                    {"none", 1.0}};

std::string refusal(const json& object) {
  try {
    read_choice(object, "case 'hall': choice");
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

template <class Function>
std::string words_of(Function function) {
  try {
    function();
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

Image flat(float value) {
  Image image(4, 4);
  for (Rgba& p : image.pixels()) p = {value, value, value, 1};
  return image;
}

JudgedCase budget_case() {
  JudgedCase c;
  c.ask.name = "hall-choice";
  c.ask.scene = "hall";
  c.ask.size = {4, 4};
  c.unit = Unit::number;
  c.points = 2;
  c.choice = read_choice(usual, "");
  c.choice->cases = {"hall-choice", "other-choice"};
  return c;
}

}  // namespace

TEST_CASE("a choice's scoring is read, or refused with the member's name") {
  const Choice choice = read_choice(usual, "");
  CHECK(choice.settings == std::vector<std::string>{"hall.segments"});
  CHECK(choice.at_most == Counts{{"triangles", 200}});
  CHECK(choice.metric == ErrorMetric::rmse);
  CHECK(choice.full == 0.01);
  CHECK(choice.none == 1.0);

  struct Row {
    const char* name;
    const char* member;
    json value;
    const char* says;
  };
  const Row rows[] = {
      {"nothing to choose", "settings", json::array(), "at least one setting to choose"},
      {"no bound", "at_most", json::object(), "at_most"},
      {"a bound of nothing", "at_most", {{"triangles", 0}}, "at_most: triangles"},
      {"an unknown error", "error", "ssim", "error"},
      {"a metric without a truth", "error", "mean", "error"},
      {"no error at all", "full", 0, "full"},
      {"none below full", "none", 0.001, "none 0.001 must be above full 0.01"},
      {"an unknown member", "cost", 3, "cost"},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    json object = usual;
    object[row.member] = row.value;
    CHECK(refusal(object).find(row.says) != std::string::npos);
  }
  for (const char* member : {"settings", "at_most", "error", "full", "none"}) {
    INFO(member);
    json object = usual;
    object.erase(member);
    CHECK(refusal(object).find(member) != std::string::npos);
  }
}

TEST_CASE("choices.txt is read line by line") {
  const Choices choices = read_choices(
      "// words\n\n  hall-choice :  hall.segments = 96 \r\nhall-choice: draw.wireframe=off\nshine: power = stable\n"
      "far: world.offset = 1.5e3\nsky: above = 0.2,.5,1\nsky: below = #3380fF\n",
      "choices.txt");
  REQUIRE(choices.size() == 4);
  CHECK(choices.at("hall-choice").at("hall.segments") == SettingValue(96));
  CHECK(choices.at("hall-choice").at("draw.wireframe") == SettingValue(false));
  CHECK(choices.at("shine").at("power") == SettingValue(std::string("stable")));
  CHECK(choices.at("far").at("world.offset") == SettingValue(1500.0));
  CHECK(choices.at("sky").at("above") == SettingValue(Colour(0.2, 0.5, 1)));
  CHECK(choices.at("sky").at("below") == SettingValue(parse_colour("#3380ff").value()));
  CHECK(read_choices("", "choices.txt").empty());
  CHECK(read_choices("# words\na: b = 1\n  # more", "choices.txt").size() == 1);
  CHECK(read_choices("\xef\xbb\xbf// made elsewhere\na: b = 1", "choices.txt").size() == 1);
  // No number and no colour: the program's setting says so by its name.
  for (const char* text : {"nan", "inf", "-inf", "1e999", "0x20", "1,1", "1,nan,1", "#fff", "#12345g"})
    CHECK(read_choices(std::string("a: b = ") + text, "choices.txt").at("a").at("b") ==
          SettingValue(std::string(text)));

  struct Row {
    const char* text;
    const char* says;
  };
  const Row rows[] = {
      {"// fine\nhall.segments = 96", "choices.txt:2: 'hall.segments = 96' is not a choice"},
      {"hall-choice: hall.segments", "choices.txt:1"},
      {"hall-choice: = 96", "choices.txt:1"},
      {"hall-choice: hall.segments =", "choices.txt:1"},
      {"hall=choice: hall.segments = 3", "choices.txt:1"},
      {"Hall: hall.segments = 3", "choices.txt:1"},
      {"\x1b[31m: a = 3", "choices.txt:1"},
      {"a: b = 1\na: b = 2", "choices.txt:2: b is chosen twice for a"},
      {"a: b = \xff", "choices.txt:1"},
      {"a: b = \x80\x80", "choices.txt:1"},
      {"a: b = 3 metres", "choices.txt:1"},
      {"a: b = 0.2, 0.5, 1",
       "choices.txt:1: 'a: b = 0.2, 0.5, 1' is not a choice; write CASE: SETTING = VALUE, the "
       "value without spaces"},
      {"a: b = 1,1,1\na: b = #ffffff", "choices.txt:2: b is chosen twice for a"},
  };
  for (const Row& row : rows) {
    INFO(row.text);
    const std::string words = words_of([&] { read_choices(row.text, "choices.txt"); });
    CHECK(words.find(row.says) != std::string::npos);
    CHECK(words.find('\x1b') == std::string::npos);
  }
}

TEST_CASE("only the settings that a case allows can be chosen") {
  const JudgedCase c = budget_case();
  CHECK(with_choices(c, {{"hall-choice", {{"hall.segments", 96}}}}).settings.at("hall.segments") == SettingValue(96));
  CHECK(with_choices(c, {{"other-choice", {{"draw.wireframe", true}}}}).settings.empty());
  CHECK(words_of([&] {
          with_choices(c, {{"hall-choice", {{"draw.wireframe", true}}}});
        }).find("draw.wireframe cannot be chosen here, only hall.segments") != std::string::npos);
  CHECK(words_of([&] {
          with_choices(c, {{"hall-choise", {{"hall.segments", 96}}}});
        }).find("'hall-choise' is not a case with a choice; did you mean 'hall-choice'?") != std::string::npos);
}

TEST_CASE("a choice earns points by its error, and none above the cost limit") {
  const Choice choice = read_choice(usual, "");
  struct Row {
    const char* name;
    float error;
    std::int64_t triangles;
    double credit, margin;
  };
  const Row rows[] = {
      {"exact and cheap", 0, 10, 1, 0.05},
      {"at the border", 0.00999f, 200, 1, 1},
      {"half way, by the logarithm", 0.1f, 200, 0.5, 10},
      {"no better than nothing", 1.0f, 200, 0, 100},
      {"worse than nothing", 2.0f, 200, 0, 200},
      {"exact and too dear", 0, 201, 0, 1.005},
      {"exact and far too dear", 0, 600, 0, 3},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    const ChoiceMeasurement measured =
        measure_choice(flat(row.error), flat(0), Encoding::data, {{"triangles", row.triangles}, {"draws", 3}}, choice);
    // Errors are floats: their relative rounding is 6e-8, and the logarithm's scale here is 4.6.
    CHECK(measured.credit == Approx(row.credit).margin(1e-6));
    CHECK(margin(measured, choice) == Approx(row.margin).epsilon(1e-2));
    CHECK(measured.critical_count == "triangles");
  }
  CHECK(words_of([&] {
          measure_choice(flat(0), flat(0), Encoding::data, {{"draws", 3}}, choice);
        }).find("the program does not count triangles") != std::string::npos);
}

TEST_CASE("a verdict on a choice has the error, the cost and the points") {
  const JudgedCase c = budget_case();
  StepReferences references("01-transforms");
  Image truth = flat(0);
  truth.at(0, 0) = {0.001f, 0, 0, 1};  // or it would be a single colour, which gate 0 asks about
  CaseReferences right;
  right.pictures = {truth};
  references.add(c.ask.name, right);
  const auto judged = [&](float error, std::int64_t triangles) {
    Answer answer;
    answer.ended = Answer::Ended::normally;
    Image picture = flat(error);
    picture.at(0, 0).r += 0.001f;
    answer.pixels = picture;
    answer.counts = {{"triangles", triangles}};
    return judge_case(c, answer, references);
  };
  const CaseResult good = judged(0, 150), middling = judged(0.1f, 150), dear = judged(0, 1'234);
  CHECK(good.status == Status::passed);
  CHECK(good.score == 2);
  CHECK(middling.status == Status::failed);
  CHECK(middling.score == Approx(1).margin(0.01));
  CHECK(middling.reason.find("triangles: 150 of at most 200") != std::string::npos);
  CHECK(dear.status == Status::failed);
  CHECK(dear.score == 0);
  CHECK(dear.reason.find("1 234") + dear.reason.find("1,234") != 2 * std::string::npos);
  CHECK(dear.reason.find("at most 200 are allowed") != std::string::npos);

  Answer silent;
  silent.ended = Answer::Ended::normally;
  silent.pixels = truth;
  CHECK(judge_case(c, silent, references).status == Status::missing);
  CHECK(judge_case(c, silent, references).reason.find("'triangles' is missing") != std::string::npos);

  Answer refused;
  refused.error = "choices.txt:1: 'x' is not a choice";
  CHECK(judge_case(c, refused, references).reason == refused.error);
}
