// How much of a result a student may see.
#pragma once

#include "grade/course/course_file.hpp"
#include "judge/compare/result.hpp"

namespace atelier::grade {

/// Takes out of a result what the level does not show, before the student's report is written from it:
///   full   everything stays
///   where  names, titles, status and points of the cases; which functions are wrong or missing; the compiler's
///          messages. No pictures, numbers, inputs, expected results, mistakes, hints or printed output: a program
///          could print the inputs of hidden cases
///   score  points and status of the cases, numbered instead of named; points of the steps
void limit_feedback(judge::SubmissionResult& result, Feedback level);

}  // namespace atelier::grade
