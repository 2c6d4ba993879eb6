// A search path that decides which code implements each step: the student's, the solution's or a mistake's.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace atelier {

/// Roots: folders that hold NN-name/ folders with shader files and compiled step libraries (NN-name/libstep.so). For
/// each file the first root that has it wins. A root may be limited to one step, "03-shadow-mapping=DIR", or to one
/// file or folder of a step, "03-shadow-mapping/given=DIR".
class Implementations {
 public:
  struct Root {
    std::filesystem::path folder;
    std::string only;  ///< the step, or the file or folder of a step, that it is limited to; empty: no limit
    bool applies_to(const std::string& name) const;  ///< "NN-name/file"
  };

  Implementations() = default;
  explicit Implementations(std::vector<Root> roots) : roots_(std::move(roots)) {}

  /// From "DIR:STEP=DIR:DIR"; empty parts are skipped. Throws Error naming a folder that does not exist.
  static Implementations parse(const std::string& text);
  std::string to_string() const;  ///< the text that parse reads

  /// The path of "NN-name/file", or an empty path. Never finds absolute names or names with "..".
  std::filesystem::path find(const std::string& name) const;
  /// The folders that find searches, in order.
  const std::vector<Root>& roots() const { return roots_; }

 private:
  std::vector<Root> roots_;
};

}  // namespace atelier
