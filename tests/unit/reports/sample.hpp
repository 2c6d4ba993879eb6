// Results made up for the tests of the reports, with the pictures that go with them.
#pragma once

#include <string>

#include "judge/compare/result.hpp"

namespace atelier::test {

/// A sphere with a highlight over a dim floor, encoded; `highlight` false: without it.
Image sphere_picture(int side, bool highlight);

/// A failed case with a mistake, a worst pixel, and evidence of `side` x `side` pixels.
judge::CaseResult failed_picture(int side = 64);

judge::CaseResult passed_picture(int side = 64);
judge::CaseResult failed_probe();

/// One step with a case of every status, and a step that passes.
judge::SubmissionResult sample(int side = 64);

/// A step whose files do not build: `cases` cases with the same reason and different words otherwise.
judge::SubmissionResult unbuilt_sample(int cases);

/// Markup, quotes, an end of CDATA and of a script, terminal escapes (title, hyperlink, clear screen, C1), a bell, a
/// backspace, direction marks, bytes that are no UTF-8, a NUL.
std::string hostile_text();

/// `sample()` with that text in every field that a text can be in.
judge::SubmissionResult hostile_sample();

}  // namespace atelier::test
