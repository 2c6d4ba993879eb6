#include "sample.hpp"

#include <algorithm>
#include <cmath>

namespace atelier::test {

using namespace judge;

Image sphere_picture(int side, bool highlight) {
  Image image(side, side);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const float u = (x + 0.5f) / side * 2 - 1, v = 1 - (y + 0.5f) / side * 2;
      const float square = (u * u + v * v) / 0.64f;
      const float checker = (int(x * 8 / side) + int(y * 8 / side)) % 2 ? 0.10f : 0.06f;
      Rgba c{checker, checker, checker * 1.1f, 1};
      if (square < 1) {
        const float nx = u / 0.8f, ny = v / 0.8f, nz = std::sqrt(1 - square);
        const float lit = std::max(0.0f, -0.5f * nx + 0.6f * ny + 0.62f * nz);
        const float half = std::max(0.0f, -0.28f * nx + 0.33f * ny + 0.9f * nz);
        const float shine = highlight ? std::pow(half, 60.0f) : 0;
        c = {0.03f + 0.55f * lit + shine, 0.02f + 0.22f * lit + shine, 0.02f + 0.12f * lit + shine, 1};
      }
      image.at(x, y) = {std::sqrt(std::min(1.0f, c.r)), std::sqrt(std::min(1.0f, c.g)), std::sqrt(std::min(1.0f, c.b)),
                        1};
    }
  }
  return image;
}

CaseResult failed_picture(int side) {
  CaseResult c;
  c.name = "highlight", c.title = "The highlight of a polished sphere", c.status = Status::failed;
  c.score = 0.45, c.max_score = 2;
  c.asked = "A sphere with a small white highlight where the half vector meets the normal.";
  c.reason = "4 % of the pixels are too dark, by up to 138/255, most in the upper left.";
  c.mistake = "no-specular";
  c.mistake_sentence = "The specular term is missing: what is drawn is the diffuse light alone.";
  c.hint = "Draw pow(max(dot(N, H), 0), exponent) as a grey and look whether it is black.";
  c.credit = "0.45 of 2: the failing share lies between the budget and that of an empty answer, and forms a blob.";
  c.command = "./atelier check 02 --case highlight";
  Evidence e;
  e.reference = sphere_picture(side, true), e.yours = sphere_picture(side, false);
  e.over = Image(side, side), e.flip = Image(side, side), e.mistake = sphere_picture(std::max(1, side / 2), false);
  Worst worst;
  float largest = 0, over = 0;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const Rgba a = e.yours.at(x, y), b = e.reference.at(x, y);
      const float error = std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
      const float on = error > 3.0f / 255 ? 1.0f : 0.0f;
      over += on;
      e.over.at(x, y) = {on, on, on, 1}, e.flip.at(x, y) = {error, error, error, 1};
      if (error <= largest) continue;
      largest = error;
      worst = {x, y, {a.r * 255, a.g * 255, a.b * 255, 255}, {b.r * 255, b.g * 255, b.b * 255, 255}};
    }
  }
  c.figures = {{"over", over}, {"share", over / (float(side) * side)}, {"blob", over * 0.6}, {"shift", 0.01}};
  c.worst = worst, c.evidence = std::move(e);
  return c;
}

CaseResult passed_picture(int side) {
  CaseResult c;
  c.name = "diffuse", c.title = "Diffuse light on a sphere", c.status = Status::passed, c.score = c.max_score = 2;
  c.asked = "A sphere that is brightest where it faces the lamp.";
  c.reason = "Equal to the reference: no pixel differs by more than 1/255 (3/255 are allowed).";
  c.hint = "Read on: why the light falls with the cosine.";
  c.command = "./atelier check 02 --case diffuse";
  c.evidence = Evidence{.yours = sphere_picture(side, true),
                        .reference = sphere_picture(side, true),
                        .over = {},
                        .flip = {},
                        .mistake = {}};
  return c;
}

CaseResult failed_probe() {
  CaseResult c;
  c.name = "attenuation-extremes", c.title = "attenuation where it is hard", c.status = Status::failed, c.max_score = 1;
  c.asked = "A finite factor at every distance, the light's own place included.";
  c.reason = "1 of 3 results is wrong: a NaN where 0 was expected.";
  c.hint = "What does the formula divide by when the distance is 0?";
  c.command = "./atelier check 02 --case attenuation-extremes";
  c.table =
      "distance   yours      expected\n"
      "0          nan        1          <-- wrong\n"
      "1          0.5        0.5\n"
      "1e6        1e-12      1e-12\n";
  return c;
}

namespace {

/// One cause for each failing case, but one for all without an answer for the same reason.
void add_causes(StepResult& step) {
  for (std::size_t i = 0; i < step.cases.size(); ++i) {
    const CaseResult& result = step.cases[i];
    if (result.status == Status::passed) continue;
    const bool no_answer = result.status == Status::missing || result.status == Status::build_failed;
    const auto same = std::find_if(step.causes.begin(), step.causes.end(), [&](const Cause& cause) {
      return no_answer && step.cases[cause.shown.front()].reason == result.reason;
    });
    if (same != step.causes.end())
      same->shown.push_back(i);
    else
      step.causes.push_back({.kind = no_answer ? Cause::Kind::no_answer : Cause::Kind::picture, .shown = {i}});
  }
}

}  // namespace

SubmissionResult sample(int side) {
  StepResult step{.step = "02-blinn-phong",
                  .title = "Blinn-Phong shading",
                  .implementations = {{"01-transforms", "yours"}, {"02-blinn-phong", "yours"}}};
  step.cases = {passed_picture(side), failed_picture(side), failed_probe()};
  const auto add = [&](const char* name, const char* title, Status status, const char* reason, const char* output) {
    CaseResult c;
    c.name = name, c.title = title, c.status = status, c.reason = reason, c.output = output, c.max_score = 1;
    c.asked = "Four lamps of different colours, added.", c.command = std::string("./atelier check 02 --case ") + name;
    step.cases.push_back(std::move(c));
  };
  add("spot", "A spot light's cone", Status::missing, "the program wrote no picture", "");
  add("lights", "Several lights at once", Status::crashed, "segmentation fault (SIGSEGV)",
      "lights: 64\nabout to draw\n");
  add("copper", "Copper", Status::timeout, "10 seconds are allowed for a case", "");
  add("gamma", "sRGB encoding", Status::build_failed, "blinn_phong.glsl did not compile", "");
  step.score = 2.45, step.max_score = 9;
  add_causes(step);
  StepResult other{
      .step = "01-transforms", .title = "Transforms", .score = 2, .max_score = 2, .cases = {passed_picture(side)}};
  return {.submission = "ada-lovelace",
          .score = 4.45,
          .max_score = 11,
          .steps = {other, step},
          .environment = {
              {"driver", "llvmpipe (LLVM 15.0.6, 256 bits)"}, {"context", "osmesa"}, {"compiler", "g++ 12.2.0"}}};
}

SubmissionResult unbuilt_sample(int cases) {
  StepResult step{.step = "02-blinn-phong", .title = "Blinn-Phong shading", .max_score = 2.0 * cases};
  step.build_log = "blinn_phong.cpp:1:1: error: 'this' does not name a type\n";
  for (int i = 0; i < cases; ++i) {
    CaseResult c;
    c.name = "case-" + std::to_string(i), c.title = "Title " + std::to_string(i);
    c.asked = "Something else in case " + std::to_string(i) + ".";
    c.status = Status::build_failed, c.max_score = 2;
    c.reason = "blinn_phong.cpp:1:1: error: 'this' does not name a type";
    c.hint = "Fix the first compiler error.";
    c.command = "./atelier check 02 --case " + c.name;
    step.cases.push_back(std::move(c));
  }
  add_causes(step);
  return {.submission = "ada-lovelace",
          .max_score = step.max_score,
          .steps = {step},
          .environment = {},
          .notes = {"../x leads out of the archive's folder"}};
}

std::string hostile_text() {
  using namespace std::string_literals;
  return "<script>alert(1)</script>\"'&]]>--><img src=x onerror=alert(1)>"
         "\x1b]0;title\x07\x1b]8;;http://evil.example\x1b\\link\x1b]8;;\x1b\\\x1b[2J\xC2\x9B"
         "31m\x9B"
         "31m\x08"
         "\xE2\x80\xAE"
         "rtl\xE2\x81\xA6\xff\xC0\xAF\xED\xA0\x80\xEF\xBF\xBF\x0b\x00\r\nsecond line\x7f"s;
}

SubmissionResult hostile_sample() {
  SubmissionResult result = sample(16);
  const std::string bad = hostile_text();
  result.submission = bad, result.notes = {bad};
  result.environment = {{bad, bad}};
  for (StepResult& step : result.steps) {
    step.step += bad, step.title = bad, step.build_log = bad, step.implementations = {{bad, bad}};
    step.caveat = bad;
    for (CaseResult& c : step.cases) {
      c.name += bad, c.title = bad, c.asked = bad, c.reason = bad, c.mistake = bad, c.mistake_sentence = bad;
      c.hint = bad, c.credit = bad, c.command = bad, c.table = bad, c.output = bad, c.figures = {{bad, std::nan("")}};
    }
  }
  return result;
}

}  // namespace atelier::test
