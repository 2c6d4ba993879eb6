#include "grade/results/mistake_pictures.hpp"

#include <set>

#include "judge/report/preview.hpp"

namespace atelier::grade {

void write_mistake_pictures(const std::filesystem::path& student, const judge::SubmissionResult& result) {
  for (const judge::StepResult& step : result.steps) {
    std::set<std::string> written;
    for (const judge::CaseResult& c : step.cases) {
      if (!c.mistake || !c.evidence || !c.evidence->yours.same_size(c.evidence->reference)) continue;
      if (written.insert(*c.mistake).second)
        judge::write_preview(mistake_picture(student, step.step, *c.mistake), *c.evidence, mistake_picture_side);
    }
  }
}

std::filesystem::path mistake_picture(const std::filesystem::path& student, const std::string& step,
                                      const std::string& mistake) {
  return student / "mistakes" / (step + "." + mistake + ".png");
}

}  // namespace atelier::grade
