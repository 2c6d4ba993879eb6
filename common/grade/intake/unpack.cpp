#include "grade/intake/unpack.hpp"

#include "base/error.hpp"
#include "base/file.hpp"

namespace atelier::grade {

namespace fs = std::filesystem;

ArchiveContents unpack_archive(const fs::path& file, const fs::path& folder, const ArchiveLimits& limits) {
  fs::create_directories(folder);
  require_space(folder, working_space);
  judge::UnusableFiles refused;
  const auto wanted = [](const std::string& name) { return name.ends_with('/') ? 0 : class_member_bytes; };
  const auto take = [&](const std::string& name, std::string bytes) {
    try {
      // The reader has refused ".." and absolute paths, and no link is ever made here that a path could lead through.
      if (fs::exists(folder / name)) throw Error("another file has its place");
      write_file(folder / name, std::string_view(bytes));
    } catch (const std::exception&) {  // a name that is too long, or a file where another member needs a folder
      require_space(folder, min_free_space);
      refused[name] = "has a name that this system cannot store";
    }
  };
  ArchiveContents contents = read_archive(file, wanted, take, limits);
  contents.unusable.merge(refused);
  return contents;
}

}  // namespace atelier::grade
