// What the compiler really opens for a student's file.
//
// refused_includes reads the text, as well as it can, for the sake of its messages. But what counts is what the
// compiler does, which may read a text differently: with control characters, lone carriage returns or spliced lines. So
// each file is preprocessed first, and what that has opened must be among what it opens for a file with all allowed
// headers.
#pragma once

#include <filesystem>
#include <string>

#include "judge/run/build.hpp"

namespace atelier::judge {

/// The result for one file.
struct Opened {
  bool allowed = false;
  std::string log;  ///< why not, a line each; else empty. Never contains a line of a file that was opened.
};

/// Preprocesses `source`, a file name in `sources`, with the options that it is compiled with; intermediate files go to
/// `objects`. Refused are: a file outside of what text_with_all_headers opens; a #line directive that
/// names another file, of which compilers show lines in messages; an error of preprocessing.
///
/// Files of the standard library's own subfolders (bits/, debug/) are allowed, since macros may choose among them.
Opened check_opened_files(const StepFlags& flags, const std::string& step, const std::vector<std::string>& options,
                          const std::filesystem::path& sources, const std::string& source,
                          const std::filesystem::path& objects, const ToolSettings& tools);

}  // namespace atelier::judge
