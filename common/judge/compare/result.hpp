// What judging says: plain data, from one case up to one submission. Reports are written from these structs alone.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "image/image.hpp"

namespace atelier::judge {

enum class Status {
  passed,
  failed,        ///< an answer came, and it is wrong
  missing,       ///< no answer, or none that could be read, or no files to build it from
  crashed,       ///< a signal ended the program during this case, or something was thrown
  timeout,       ///< the time limit ended it
  build_failed,  ///< the student's files did not compile
};

std::string to_string(Status status);  ///< "passed", "failed", ... as in results.json

/// One pixel where the answer is furthest from the reference.
struct Worst {
  int x = 0, y = 0;       ///< pixels from the upper left corner
  Rgba yours, reference;  ///< in the unit that was compared: 0..255 encoded colour, or the data itself
};

/// The pictures behind a verdict, as they were compared (encoded 0..1 for colours): what a report draws.
struct Evidence {
  bool colours = true;  ///< false for directions and data; data in other ranges are mapped to 0..1 to be seen
  Image yours, reference;
  Image over;                    ///< 1 where a pixel is over the tolerance
  Image flip;                    ///< LDR-FLIP error 0..1 in red, green and blue; empty for data, and until draw_flip()
  std::optional<Image> mistake;  ///< the picture of the mistake that was recognised (may be smaller)
};

struct CaseResult {
  std::string name, title;
  Status status = Status::missing;
  double score = 0, max_score = 0;

  std::string asked;   ///< what the case asks for, in one sentence
  std::string reason;  ///< what was seen, in one sentence; for a pass, the margin
  std::optional<std::string>
      hypothesis;                      ///< one operation on all of it that explains it: "flipped-y", "transposed" ...
  std::optional<std::string> mistake;  ///< the name of the known mistake that the answer looks like
  std::optional<std::string> mistake_sentence;  ///< what a student reads about it
  std::string hint;                             ///< what to try next
  std::string credit;                           ///< how partial credit came about; empty when all or nothing
  std::string command;                          ///< draws just this case

  /// Measured numbers by name. Of a picture: "over" (pixels), "share" (0..1), "blob" (pixels), "shift" (pixels),
  /// "largest" (in the unit), "flip_mean" (0..1, once drawn), "non_finite" (pixels). Of a probe: "inputs", "wrong",
  /// "largest" (in tolerances). Where a mistake was recognised: "nearness" (its distance over the reference's, 0..1).
  std::map<std::string, double> figures;
  std::optional<Worst> worst;
  std::optional<Evidence> evidence;  ///< absent for probes, and where there was no picture
  std::string table;                 ///< of a probe: inputs, yours, expected, the worst first; preformatted text
  std::string output;                ///< what the program printed or threw, bounded; untrusted text
};

struct StepResult {
  std::string step, title;
  double score = 0, max_score = 0;
  std::vector<CaseResult> cases;
  std::string build_log;              ///< compiler's words; empty after a clean build; untrusted text
  std::string references = "stored";  ///< or "live": drawn by the solution, on the driver that drew the answers
  std::map<std::string, std::string> implementations;  ///< step -> "yours", "solution": who stands behind which step
};

/// Where and with what a result was made.
using Environment = std::map<std::string, std::string>;  ///< "driver", "context", "compiler", "cpu", "atelier" ...

struct SubmissionResult {
  std::string submission;
  double score = 0, max_score = 0;
  std::vector<StepResult> steps;
  Environment environment;
  std::vector<std::string> notes;  ///< what was passed over when the submission was taken, a sentence each
};

}  // namespace atelier::judge
