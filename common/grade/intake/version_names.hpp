// Names of folders and archives that say which version something is, or which part of one student's work.
#pragma once

#include <string>

namespace atelier::grade {

/// A name split into what is versioned and its version: "ada (2)" is "ada" and 2.
struct VersionedName {
  std::string base;        ///< empty if the whole name is a version ("v1", "final")
  bool versioned = false;  ///< the name has a version
  /// Orders versions: old < none < copy, (1), v2, 2024-03-05 by their numbers < new, final, latest.
  long long order = 0;
};

/// Recognises at the end of a name, after a space, '-', '_' or '.': v2, (2), a date as 2024-03-05 or 20240305, and the
/// words old, backup, copy, new, final, latest and the like; several of them too ("final-v2"). The name may be a path
/// and end as an archive's does; only its last part counts.
VersionedName split_version(const std::string& name);

/// Whether the first of two names is of the older version. Of equal versions the one that sorts first, with numbers
/// by their value: "hw9" is older than "hw10".
bool is_older(const std::string& a, const std::string& b);

/// Without what is added to a second copy of a file: " (1)", "-1", "_1", " - Copy".
std::string without_copy_number(const std::string& stem);

/// Whether a name is that of a version or of a part of one student's work ("v1", "hw2", "src", "report"), and so of no
/// student.
bool is_name_of_work(const std::string& name);

/// Whether a name is that of what compilers make or the course gives ("build", "x64", "skeletons").
bool is_name_of_given(const std::string& name);

/// Whether a name is that of what the course gives ("skeletons"), and not of what a compiler makes ("build").
bool is_name_of_course(const std::string& name);

}  // namespace atelier::grade
