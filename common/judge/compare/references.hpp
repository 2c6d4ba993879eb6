// The references of a step: right answers to compare with, and wrong ones to recognise. Read when first asked for.
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

/// What a right answer to one case is.
struct CaseReferences {
  std::vector<Image>
      pictures;  ///< as a program writes them (linear colour, or data); one or more, any of them is right
  std::vector<Numbers> values;  ///< of a probe: one list an input
  double skeleton_share = 1;    ///< f1 of credit.hpp
};

/// What known mistakes answer to one case.
struct CaseAtlas {
  std::vector<AtlasPicture> pictures;
  WrongValues values;
};

/// The atlas for an answer that was drawn with other numbers (camera, light, settings) than the atlas was.
CaseAtlas seen_from_elsewhere(CaseAtlas atlas);

/// Throws Error, naming the file and what to do, wherever a reference is missing, unreadable, of another size than the
/// case asks for, changed since its sidecar was written, or made for another tolerance. It never makes one.
/// May be used from several threads at once.
class StepReferences {
 public:
  /// Only what is added by hand.
  explicit StepReferences(std::string step, std::vector<Mistake> mistakes = {});

  /// From tests/cases/NN-name/. Decoded pictures are kept below `cache` (see picture_cache.hpp); empty: not kept.
  StepReferences(std::string step, std::vector<Mistake> mistakes, std::filesystem::path folder,
                 std::filesystem::path cache);

  /// Puts references in the place of those in the folder.
  void add(const std::string& case_name, CaseReferences references, CaseAtlas atlas = {});

  /// Puts other pictures in the place of the stored ones and keeps all else that is known of the case. Not while
  /// anything is being judged.
  void set_pictures(const JudgedCase& c, std::vector<Image> pictures);

  const CaseReferences& of(const JudgedCase& c) const;
  const CaseAtlas& atlas(const JudgedCase& c) const;

  /// Reads the references of all these cases now, so that a broken one is found before anything is drawn.
  void require(const std::vector<JudgedCase>& cases) const;

  const std::string& step() const { return step_; }
  const Mistake* mistake(const std::string& name) const;  ///< nullptr where the step has none of this name

 private:
  CaseReferences load(const JudgedCase& c) const;
  CaseAtlas load_atlas(const JudgedCase& c) const;

  std::string step_;
  std::vector<Mistake> mistakes_;
  std::filesystem::path folder_, cache_;
  // Recursive: an atlas asks for its reference while it is being read. Held apart, so that the whole can be moved.
  std::unique_ptr<std::recursive_mutex> mutex_ = std::make_unique<std::recursive_mutex>();
  mutable std::map<std::string, CaseReferences> references_;
  mutable std::map<std::string, CaseAtlas> atlases_;
};

}  // namespace atelier::judge
