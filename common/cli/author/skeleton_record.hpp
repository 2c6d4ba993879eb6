// Hashes of the committed skeletons, to distinguish edited files from untouched ones.
//
// steps/skeletons.sha256 has a line "DIGEST  NN-name/FILE" for every file that ./atelier skeleton has made, as
// sha256sum writes them (and `cd steps && sha256sum -c skeletons.sha256` reads).
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace atelier {

using SkeletonRecord = std::map<std::string, std::string>;  ///< "02-blinn-phong/blinn_phong.cpp" -> digest

/// Empty if the file does not exist. Throws Error naming file and line for an invalid line.
SkeletonRecord read_skeleton_record(const std::filesystem::path& steps);
void write_skeleton_record(const std::filesystem::path& steps, const SkeletonRecord& record);

enum class SkeletonState {
  missing,    ///< no such file
  untouched,  ///< the generated skeleton
  edited,     ///< anything else
};

/// The state of steps/NAME, NAME as in the record.
SkeletonState skeleton_state(const std::filesystem::path& steps, const SkeletonRecord& record, const std::string& name);
std::string to_string(SkeletonState state);

}  // namespace atelier
