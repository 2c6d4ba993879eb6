// The references of a step: correct answers to compare with, and mistakes to recognise. Read on first use.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "image/image.hpp"
#include "judge/compare/judged_case.hpp"
#include "judge/compare/mistakes.hpp"
#include "judge/compare/sidecar.hpp"
#include "judge/explain/naming.hpp"

namespace atelier::judge {

/// The correct answers to one case.
struct CaseReferences {
  std::vector<Image> pictures;     ///< at least one, as a program writes them (linear colour, or data); each is correct
  std::vector<Numbers> values;     ///< of a probe: one list per input
  double skeleton_fraction = 1;    ///< f1 of credit.hpp
  std::vector<std::string> needs;  ///< the students' functions without any one of which the case fails
  std::vector<std::string> shows;  ///< of a picture: the known mistakes that it would show
};

/// The answers of known mistakes to one case.
struct CaseAtlas {
  std::vector<AtlasPicture> pictures;
  WrongValues values;
};

/// The atlas for an answer drawn with a different camera, light or settings than the atlas.
CaseAtlas with_other_view(CaseAtlas atlas);

/// Throws Error, naming the file and what to do, if a reference is missing, unreadable, of the wrong size, changed
/// since its sidecar was written, or made for another tolerance. Never makes a reference. Thread-safe.
class StepReferences {
 public:
  /// Without a folder: only references from add().
  explicit StepReferences(std::string step, std::vector<Mistake> mistakes = {});

  /// References from `folder`. Decoded pictures are cached in `cache` (see picture_cache.hpp); empty: no cache.
  StepReferences(std::string step, std::vector<Mistake> mistakes, std::filesystem::path folder,
                 std::filesystem::path cache);

  /// Uses these instead of the references in the folder.
  void add(const std::string& case_name, CaseReferences references, CaseAtlas atlas = {});

  /// Replaces the stored pictures of a case and keeps its other data. Must not be called while cases are judged.
  void set_pictures(const JudgedCase& c, std::vector<Image> pictures);

  const CaseReferences& of(const JudgedCase& c) const;
  const CaseAtlas& atlas(const JudgedCase& c) const;

  /// Reads the references of all these cases now, to detect problems before anything is drawn.
  void require(const std::vector<JudgedCase>& cases) const;

  const std::string& step() const { return step_; }
  const Mistake* mistake(const std::string& name) const;  ///< nullptr if the step has no mistake of this name

 private:
  CaseReferences load(const JudgedCase& c) const;
  CaseAtlas load_atlas(const JudgedCase& c) const;

  std::string step_;
  std::vector<Mistake> mistakes_;
  std::filesystem::path folder_, cache_;
  // Recursive, because reading an atlas reads its reference. By pointer, so that the object can be moved.
  std::unique_ptr<std::recursive_mutex> mutex_ = std::make_unique<std::recursive_mutex>();
  mutable std::map<std::string, CaseReferences> references_;
  mutable std::map<std::string, CaseAtlas> atlases_;
};

}  // namespace atelier::judge
