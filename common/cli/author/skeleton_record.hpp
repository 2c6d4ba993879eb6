// What the committed skeletons are: so that a file that a student has worked on is told from an untouched one.
//
// steps/skeletons.sha256 has a line "DIGEST  NN-name/FILE" for every file that ./atelier skeleton has made, as
// sha256sum writes them (and `cd steps && sha256sum -c skeletons.sha256` reads).
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace atelier {

using SkeletonRecord = std::map<std::string, std::string>;  ///< "02-blinn-phong/blinn_phong.cpp" -> digest

/// Empty where the file is not there yet. Throws Error naming file and line for anything else than digests and names.
SkeletonRecord read_skeleton_record(const std::filesystem::path& steps);
void write_skeleton_record(const std::filesystem::path& steps, const SkeletonRecord& record);

enum class SkeletonState {
  missing,    ///< no such file
  untouched,  ///< the skeleton, as it was made
  edited,     ///< something else: somebody's work
};

/// The state of steps/NAME, NAME as in the record.
SkeletonState skeleton_state(const std::filesystem::path& steps, const SkeletonRecord& record, const std::string& name);
std::string to_string(SkeletonState state);

}  // namespace atelier
