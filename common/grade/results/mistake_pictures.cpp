#include "grade/results/mistake_pictures.hpp"

#include <set>

#include "judge/report/preview.hpp"

namespace atelier::grade {

std::filesystem::path pictures_folder(const std::filesystem::path& results, const SubmissionRecord& record) {
  return results / "pictures" / record.student.id;
}

void write_mistake_pictures(const std::filesystem::path& pictures, const judge::SubmissionResult& result) {
  for (const judge::StepResult& step : result.steps) {
    std::set<std::string> written;
    for (const judge::CaseResult& c : step.cases) {
      if (!c.mistake || !c.evidence || !c.evidence->yours.same_size(c.evidence->reference)) continue;
      if (written.insert(*c.mistake).second)
        judge::write_preview(mistake_picture(pictures, step.step, *c.mistake), *c.evidence, mistake_picture_side);
    }
  }
}

std::filesystem::path mistake_picture(const std::filesystem::path& pictures, const std::string& step,
                                      const std::string& mistake) {
  return pictures / (step + "." + mistake + ".png");
}

}  // namespace atelier::grade
