#include "judge/compare/references.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/sha256.hpp"
#include "image_io/image_io.hpp"
#include "judge/compare/measure.hpp"
#include "judge/compare/picture_cache.hpp"

namespace atelier::judge {
namespace {

/// How a picture file is read: as linear colours, or as unchanged numbers.
Encoding encoding_in_file(Unit unit) {
  return unit == Unit::colour ? Encoding::linear : Encoding::data;
}

void check_size(const Image& picture, glm::ivec2 expected, const std::filesystem::path& file) {
  if (picture.width() == expected.x && picture.height() == expected.y) return;
  throw Error(fmt::format("{}: is {}x{} pixels; its case requires {}x{}", file.string(), picture.width(),
                          picture.height(), expected.x, expected.y));
}

void require_file(const std::filesystem::path& file, const JudgedCase& c, const std::string& step) {
  std::error_code ignored;
  if (std::filesystem::is_regular_file(file, ignored)) return;
  throw Error(fmt::format("{}: this reference of case '{}' is missing; make it with './atelier reference {}'",
                          file.string(), c.ask.name, step));
}

/// One of several pictures of equal height that are stored one below the other.
Image picture_in_atlas(const Image& atlas, int index, int height) {
  Image picture(atlas.width(), height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < atlas.width(); ++x) picture.at(x, y) = atlas.at(x, index * height + y);
  return picture;
}

}  // namespace

CaseAtlas with_other_view(CaseAtlas atlas) {
  for (AtlasPicture& entry : atlas.pictures) entry.same_view = false;
  return atlas;
}

StepReferences::StepReferences(std::string step, std::vector<Mistake> mistakes)
    : step_(std::move(step)), mistakes_(std::move(mistakes)) {}

StepReferences::StepReferences(std::string step, std::vector<Mistake> mistakes, std::filesystem::path folder,
                               std::filesystem::path cache)
    : step_(std::move(step)), mistakes_(std::move(mistakes)), folder_(std::move(folder)), cache_(std::move(cache)) {}

void StepReferences::add(const std::string& case_name, CaseReferences references, CaseAtlas atlas) {
  const std::lock_guard lock(*mutex_);
  references_[case_name] = std::move(references);
  atlases_[case_name] = std::move(atlas);
}

void StepReferences::set_pictures(const JudgedCase& c, std::vector<Image> pictures) {
  const std::lock_guard lock(*mutex_);
  CaseReferences references = of(c);
  references.pictures = std::move(pictures);
  references_[c.ask.name] = std::move(references);
}

const Mistake* StepReferences::mistake(const std::string& name) const {
  const auto found = std::find_if(mistakes_.begin(), mistakes_.end(), [&](const Mistake& m) { return m.name == name; });
  return found == mistakes_.end() ? nullptr : &*found;
}

const CaseReferences& StepReferences::of(const JudgedCase& c) const {
  const std::lock_guard lock(*mutex_);
  const auto found = references_.find(c.ask.name);
  if (found != references_.end()) return found->second;
  return references_.emplace(c.ask.name, load(c)).first->second;
}

const CaseAtlas& StepReferences::atlas(const JudgedCase& c) const {
  const std::lock_guard lock(*mutex_);
  const auto found = atlases_.find(c.ask.name);
  if (found != atlases_.end()) return found->second;
  return atlases_.emplace(c.ask.name, load_atlas(c)).first->second;
}

void StepReferences::require(const std::vector<JudgedCase>& cases) const {
  for (const JudgedCase& c : cases) of(c);
}

CaseReferences StepReferences::load(const JudgedCase& c) const {
  if (folder_.empty()) throw Error(fmt::format("{}: case '{}' has no reference", step_, c.ask.name));
  CaseReferences references;
  if (c.profile == Profile::values) {
    references.values = c.expected;
    const std::filesystem::path file = values_path(folder_, c.ask.name);
    std::error_code ignored;
    if (c.expected.empty())
      require_file(file, c, step_);
    else if (!std::filesystem::exists(file, ignored))
      return references;  // a sidecar is optional if the case file has the numbers
    Sidecar sidecar = read_sidecar(file);
    check_sidecar(sidecar, c, file);
    references.skeleton_fraction = sidecar.skeleton_fraction;
    references.needs = std::move(sidecar.needs);
    if (c.expected.empty()) references.values = std::move(sidecar.values);
    for (const Numbers& result : references.values)  // those of the case file were checked when it was read
      if (!c.numbers.empty() && result.size() != c.numbers.size())
        throw Error(fmt::format("{}: a result has {} numbers, but 'numbers' of case '{}' names {}", file.string(),
                                result.size(), c.ask.name, c.numbers.size()));
    if (references.values.size() != c.ask.inputs.size())
      throw Error(fmt::format("{}: has results for {} inputs, but case '{}' has {}", file.string(),
                              references.values.size(), c.ask.name, c.ask.inputs.size()));
    return references;
  }

  for (const std::filesystem::path& name : c.references) {
    const std::filesystem::path file = folder_ / name.filename();
    require_file(file, c, step_);
    require_file(sidecar_path(file), c, step_);
    const Sidecar sidecar = read_sidecar(sidecar_path(file));
    check_sidecar(sidecar, c, sidecar_path(file));
    // The file is hashed and decoded only if the cache does not have its current state.
    Image picture = cached_picture(cache_, file, sidecar.sha256, [&] {
      if (sha256(read_file(file)) != sidecar.sha256)
        throw Error(
            fmt::format("{}: is not the file that its sidecar was written for (SHA-256 differs); copy both from "
                        "the same source, or make them again with './atelier reference {}'",
                        file.string(), step_));
      return read_image(file, encoding_in_file(c.unit));
    });
    check_size(picture, c.ask.size, file);
    if (references.pictures.empty()) {
      references.skeleton_fraction = sidecar.skeleton_fraction;
      references.needs = sidecar.needs;
      references.shows = sidecar.atlas;
    }
    references.pictures.push_back(std::move(picture));
  }
  if (references.pictures.empty()) throw Error(fmt::format("{}: case '{}' names no reference", step_, c.ask.name));
  return references;
}

CaseAtlas StepReferences::load_atlas(const JudgedCase& c) const {
  CaseAtlas atlas;
  if (folder_.empty()) return atlas;
  if (c.profile == Profile::values || c.choice) {
    const std::filesystem::path file = wrong_values_path(folder_, c.ask.name);
    std::error_code ignored;
    if (std::filesystem::exists(file, ignored)) atlas.values = read_wrong_values(file);
    return atlas;
  }
  const Image right = compared_form(of(c).pictures.at(0), c);
  const Image reference = make_atlas_picture(right, right, c.unit);
  const std::vector<std::string> mistakes = read_sidecar(sidecar_path(folder_ / c.references.front().filename())).atlas;
  if (mistakes.empty()) return atlas;
  const std::filesystem::path file = atlas_path(folder_, c.ask.name);
  require_file(file, c, step_);
  const Image pictures = cached_picture(cache_, file, "atlas", [&] { return read_image(file, Encoding::data); });
  check_size(pictures, {reference.width(), reference.height() * int(mistakes.size())}, file);
  for (std::size_t i = 0; i < mistakes.size(); ++i)
    atlas.pictures.push_back({mistakes[i], picture_in_atlas(pictures, int(i), reference.height()), reference});
  return atlas;
}

}  // namespace atelier::judge
