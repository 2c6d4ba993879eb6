// Which code stands behind each step: the student's, the solution's, a mistake's. Decided by the order of a search
// path.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace atelier {

/// Folders that hold NN-name/ folders with shader files and compiled step libraries (NN-name/libstep.so), first match
/// wins, file by file. A root may be limited to one step, "03-shadow-mapping=DIR", or to one file or folder of it,
/// "03-shadow-mapping/given=DIR".
class Implementations {
 public:
  struct Root {
    std::filesystem::path folder;
    std::string only;  ///< the step, or the file or folder of a step, that it answers for; empty: all
    bool answers_for(const std::string& name) const;  ///< "NN-name/file"
  };

  Implementations() = default;
  explicit Implementations(std::vector<Root> roots) : roots_(std::move(roots)) {}

  /// From "DIR:STEP=DIR:DIR"; empty parts are skipped. Throws Error naming a folder that does not exist.
  static Implementations parse(const std::string& text);
  std::string to_string() const;  ///< the text that parse reads

  /// The path behind "NN-name/file", or an empty path; absolute names and names with ".." are never found.
  std::filesystem::path find(const std::string& name) const;
  /// The folder that find answers from.
  const std::vector<Root>& roots() const { return roots_; }

 private:
  std::vector<Root> roots_;
};

}  // namespace atelier
