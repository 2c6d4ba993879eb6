// Results of judging as plain data, from one case to a whole submission. Reports are made only from these structs.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "image/image.hpp"

namespace atelier::judge {

enum class Status {
  passed,
  failed,        ///< a wrong answer
  missing,       ///< no readable answer, or no files to build the step from
  crashed,       ///< a signal ended the program, or the student's code threw an exception
  timeout,       ///< the time limit ended it
  build_failed,  ///< the student's files did not compile
};

std::string to_string(Status status);  ///< "passed", "failed", ... as in results.json

/// The pixel where the answer differs most from the reference.
struct Worst {
  int x = 0, y = 0;       ///< pixels from the upper left corner
  Rgba yours, reference;  ///< in the unit that was compared: 0..255 encoded colour, or the data itself
};

/// The pictures for a report, in compared form (colours encoded, 0..1).
struct Evidence {
  bool colours = true;  ///< false for directions and data; data in other ranges are mapped to 0..1
  Image yours, reference;
  Image over;                    ///< 1 where a pixel exceeds the tolerance
  Image flip;                    ///< LDR-FLIP error 0..1 in red, green and blue; empty for data, and before draw_flip()
  std::optional<Image> mistake;  ///< the picture of the recognised mistake (may be smaller)
};

struct CaseResult {
  std::string name, title;
  Status status = Status::missing;
  double score = 0, max_score = 0;
  std::string tier = "core";  ///< or "further", "challenge"

  std::string asked;                            ///< the required result, in one sentence
  std::string reason;                           ///< what is wrong, in one sentence; for a pass, the margin
  std::string waits_for;                        ///< a function that it needs and that is wrong: correct this first
  std::optional<std::string> hypothesis;        ///< one operation that explains it: "flipped-y", "transposed" ...
  std::optional<std::string> mistake;           ///< the name of the known mistake that the step's answers agree with
  std::optional<std::string> mistake_sentence;  ///< what a student reads about it
  std::string hint;                             ///< what to try next
  std::string credit;                           ///< how partial credit was computed; empty if all or no points
  std::string command;                          ///< judges only this case
  std::string other_numbers;                    ///< in words, if it fails only with numbers drawn for the submission

  /// Measured numbers by name. For a picture: "over" (pixels), "share" (0..1), "blob" (pixels), "shift" (pixels),
  /// "largest" (in the unit), "flip_mean" (0..1, once drawn), "non_finite" (pixels). For a probe: "inputs", "wrong",
  /// "largest" (in tolerances). For a budget case: "error" and the limited counts. If a mistake was recognised:
  /// "nearness" (distance to it / distance to the reference, 0..1).
  std::map<std::string, double> figures;
  std::optional<Worst> worst;
  std::optional<Evidence> evidence;  ///< none for probes, and if there was no picture

  // For explain_step (explain/causes.hpp), which sees all cases of a step.
  std::vector<std::string> could_be;  ///< known mistakes that give this answer: of a picture at most one
  bool unwritten = false;             ///< of a probe: the answer is that of the skeleton's function
  std::string measured;               ///< the reason without the hypothesis

  std::string table;   ///< of a probe: inputs, expected, yours, the worst first; preformatted text
  std::string output;  ///< what the program printed, limited in size; untrusted text
};

/// One thing to correct, and the failing cases that it explains.
struct Cause {
  enum class Kind {
    no_answer,  ///< did not compile, or most cases have no answer for one reason: `shown` are all of these
    function,   ///< a function is wrong: `shown` are its failing probes
    unwritten,  ///< functions are as in the skeleton: `shown` are the failing probes of the first one
    picture,    ///< pictures are wrong although the probes of all functions that they need pass
    choice,     ///< a setting in choices.txt
  };
  Kind kind = Kind::picture;
  std::vector<std::string> functions;  ///< of a picture: those that it needs and that no probe asks
  int inputs = 0, wrong = 0;           ///< of a function: over all its probes; 0 inputs: not to be said
  std::vector<std::size_t> shown;      ///< indices of StepResult::cases
  std::vector<std::size_t> waiting;    ///< other cases that fail because of it; pictures that show it best come first
};

std::string to_string(Cause::Kind kind);  ///< "no_answer" ... as in results.json

struct StepResult {
  std::string step, title;
  double score = 0, max_score = 0;
  std::vector<CaseResult> cases;
  std::vector<Cause> causes;          ///< in the order in which to correct them
  std::string build_log;              ///< the compiler's messages; empty after a clean build; untrusted text
  std::string references = "stored";  ///< or "live": drawn by the solution with the driver that drew the answers
  std::map<std::string, std::string> implementations;  ///< step -> "yours", "solution": whose code was used
  std::map<std::string, double> seconds;               ///< of work by kind: "compile", "start", "render", "compare"
  std::string caveat;  ///< what to read before the points, if they do not judge this step alone; otherwise empty
};

/// The environment in which a result was made.
using Environment = std::map<std::string, std::string>;  ///< "driver", "context", "compiler", "cpu", "atelier" ...

struct SubmissionResult {
  std::string submission;
  double score = 0, max_score = 0;
  std::vector<StepResult> steps;
  Environment environment;
  std::optional<std::uint64_t> seed;  ///< of the numbers that were drawn for it; none: nothing was drawn
  std::vector<std::string> notes;     ///< what was skipped in the submission, with the reasons
};

}  // namespace atelier::judge
