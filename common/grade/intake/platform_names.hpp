// What the names say that course platforms give to downloaded submissions.
//
//   Moodle      Ada Lovelace_12345_assignsubmission_file_/hw.zip, or in one folder
//               Ada Lovelace_12345_assignsubmission_file_hw.zip
//   Canvas      lovelaceada_LATE_123_456_hw-1.zip: the student's number, the file's number, "-1" of a second attempt
//   Gradescope  submission_123456/, with submission_metadata.yml beside the folders
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace atelier::grade {

struct PlatformName {
  std::string name;         ///< the student's, as the platform writes it; empty: unknown
  std::string identifier;   ///< the student's number, or the submission's
  std::string file;         ///< the name of the uploaded file; empty: a folder of them
  std::uint64_t order = 0;  ///< Canvas: the file's number; later files have larger ones
  bool late = false;
  bool is_text = false;  ///< Moodle: what was typed into its page ("onlinetext"), not files
};

/// Nothing if the name is not of the platform. Names may be any bytes.
std::optional<PlatformName> moodle_name(const std::string& entry);
std::optional<PlatformName> canvas_name(const std::string& entry);
std::optional<PlatformName> gradescope_name(const std::string& entry);

/// The name that an uploaded file had: "light.cpp" for "lovelaceada_123_456_light.cpp". Other names are unchanged.
std::string uploaded_name(const std::string& entry);

/// The names for sentences about several entries of a student: as uploaded, where that tells them apart, and otherwise
/// whole. That of Moodle's folder for a student is the student's.
std::vector<std::string> names_for_sentences(const std::vector<std::string>& entries);

inline constexpr const char* gradescope_metadata = "submission_metadata.yml";

struct GradescopeSubmitter {
  std::string name;        ///< empty: not in the file
  std::string identifier;  ///< the student number, or else the e-mail address; empty: not in the file
};

struct GradescopeSubmission {
  std::vector<GradescopeSubmitter> submitters;  ///< several of a group
  std::optional<std::int64_t> created;          ///< seconds since 1970, UTC
};

/// Reads who submitted what from submission_metadata.yml, by "submission_123456". What is not as Gradescope writes it
/// is passed over. Throws Error naming the file if it cannot be read or has more than 64 MiB.
std::map<std::string, GradescopeSubmission> read_gradescope_metadata(const std::filesystem::path& file);

}  // namespace atelier::grade
