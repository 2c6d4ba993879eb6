#include "grade/intake/source_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/printable.hpp"
#include "grade/intake/archive.hpp"
#include "grade/intake/listed_names.hpp"
#include "grade/intake/step_places.hpp"

namespace atelier::grade {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_others = 1000;

/// Why an entry is not a folder; empty if it is. Links are refused, because they can point outside the submission.
std::string why_no_folder(fs::file_type type) {
  if (type == fs::file_type::symlink) return judge::is_link;
  return type == fs::file_type::directory ? "" : "is not a folder";
}

/// Calls read_archive for an archive on the disk or in memory.
using ReadArchive = std::function<ArchiveContents(const WantedBytes&, const TakeMember&, const ArchiveLimits&)>;

class SourceReader {
 public:
  SourceReader(const judge::StepFlags& flags, const SourceLimits& limits)
      : flags_(flags), names_(flags), limits_(limits) {}

  SourceFiles read_folder(const fs::path& folder) {
    std::vector<std::string> level = {""};
    for (int depth = 0; depth < limits_.folder_levels && !level.empty(); ++depth) {
      std::vector<std::string> next;
      for (const std::string& inner : level) look_into(folder, inner, next);
      level = std::move(next);
    }
    if (!level.empty())
      found_.unread.push_back(fmt::format("only the first {} levels are read", limits_.folder_levels));
    if (entries_ > limits_.entries)
      found_.unread.push_back(fmt::format("only the first {} entries are read", limits_.entries));
    for (const auto& [path, file] : archives_)
      if (broken_ < limits_.broken_archives)
        try_archive(path, file.string(), [&, &path = path, &file = file] { read_members(file, path, 1); });
    return std::move(found_);
  }

  SourceFiles read_one_archive(const fs::path& file) {
    read_members(file, "", 1);
    return std::move(found_);
  }

  SourceFiles read_files(const std::vector<std::pair<std::string, fs::path>>& files) {
    for (const auto& [name, file] : files) take_entry(name, file);
    return std::move(found_);
  }

 private:
  /// Looks at the entries of one folder, and adds the folders in it to `next`.
  void look_into(const fs::path& top, const std::string& inner, std::vector<std::string>& next) {
    std::error_code error;
    std::vector<fs::directory_entry> entries;  // in the order of their names: the system's order is unspecified
    for (auto at = fs::directory_iterator(top / inner, error); !error && at != fs::end(at); at.increment(error)) {
      if (++entries_ > limits_.entries) break;
      entries.push_back(*at);
    }
    std::ranges::sort(entries, {}, &fs::directory_entry::path);
    for (const fs::directory_entry& entry : entries) {
      const std::string name = entry.path().filename().string(), path = inner.empty() ? name : inner + "/" + name;
      const fs::file_type type = entry.symlink_status(error).type();
      if (flags_.files.contains(name)) found_.step_folders[path] = why_no_folder(type);
      if (type != fs::file_type::directory)
        take_entry(path, entry.path());
      else if (!is_folder_of_tools(name))
        next.push_back(path);
      found_.has_folders_of_steps |= flags_.files.contains(name);
    }
  }

  void take_entry(const std::string& path, const fs::path& file) {
    const std::string name = fs::path(path).filename().string();
    if (!names_.find(name).empty())
      found_.files[path] = {.at = file, .bytes = {}, .why_unusable = {}};
    else if (has_archive_name(name) && may_read_archive(path, 1))
      archives_.emplace_back(path, file);
    else
      add_other(path);
  }

  void add_other(const std::string& path) {
    if (!is_litter(path) && found_.others.size() < most_others) found_.others.push_back(path);
  }

  bool may_read_archive(const std::string& path, int level) {
    if (level > limits_.archive_levels) {
      found_.unread.push_back(
          fmt::format("{} is not read: archives are read to {} levels", shown(path), limits_.archive_levels));
      return false;
    }
    if (++archive_count_ == limits_.archives + 1)
      found_.unread.push_back(fmt::format("only the first {} archives are read", limits_.archives));
    return archive_count_ <= limits_.archives && broken_ < limits_.broken_archives;
  }

  static std::string shown(const std::string& path) { return shorten(printable(path), 100); }

  /// Reads an archive in the source, which may be broken; messages about it begin with `name`.
  template <class Read>
  void try_archive(const std::string& path, const std::string& name, Read&& read) {
    try {
      read();
    } catch (const Error& error) {
      std::string what = error.what();
      if (what.starts_with(name + ": ")) what.erase(0, name.size() + 2);
      found_.unread.push_back(fmt::format("{} {}", shown(path), shorten(printable(what), 300)));
      ++broken_;
    }
  }

  void read_members(const fs::path& file, const std::string& in, int level) {
    read_with(in, level, [&](const auto&... arguments) { return read_archive(file, arguments...); });
  }

  /// Takes the files of an archive that is at the path `in`, then those of the archives in it.
  void read_with(const std::string& in, int level, const ReadArchive& read) {
    const auto full = [&](const std::string& name) { return in.empty() ? name : in + "/" + name; };
    const ArchiveLimits all;
    std::map<std::string, std::string> files;  // of this archive: none of one that turns out to be broken
    std::vector<std::pair<std::string, std::string>> inner;
    const WantedBytes wanted = [&](const std::string& name) -> std::size_t {
      const std::string last = fs::path(name).filename().string();
      if (!names_.find(last).empty()) return judge::source_limit;
      return has_archive_name(last) && may_read_archive(full(name), level + 1) ? all.archive_bytes : 0;
    };
    const TakeMember take = [&](const std::string& name, std::string bytes) {
      if (!names_.find(fs::path(name).filename().string()).empty())
        files[name] = std::move(bytes);
      else
        inner.emplace_back(full(name), std::move(bytes));
    };
    ArchiveLimits limits = all;
    limits.total_bytes = limits.skipped_bytes = limits_.inflated_bytes - std::min(inflated_, limits_.inflated_bytes);
    const ArchiveContents contents = read(wanted, take, limits);
    inflated_ += contents.inflated;
    for (auto& [name, bytes] : files)
      found_.files[full(name)] = {.at = {}, .bytes = std::move(bytes), .why_unusable = {}};
    for (const auto& [name, why] : contents.unusable) {
      if (has_archive_name(name))
        found_.unread.push_back(fmt::format("{} {}", shown(full(name)), why));
      else
        found_.files[full(name)] = {.at = {}, .bytes = {}, .why_unusable = why};
    }
    for (const std::string& sentence : contents.skipped) found_.notes.push_back(sentence);
    for (const std::string& name : contents.names) {
      if (!name.ends_with('/') && !has_archive_name(name) && !found_.files.contains(full(name))) add_other(full(name));
      for (const fs::path& part : fs::path(name)) found_.has_folders_of_steps |= flags_.files.contains(part.string());
    }
    for (const auto& [path, bytes] : inner) {
      if (broken_ >= limits_.broken_archives) break;
      try_archive(path, path, [&, &path = path, &bytes = bytes] {
        read_with(path, level + 1, [&](const auto&... arguments) { return read_archive(path, bytes, arguments...); });
      });
    }
  }

  const judge::StepFlags& flags_;
  ListedNames names_;
  SourceLimits limits_;
  SourceFiles found_;
  std::vector<std::pair<std::string, fs::path>> archives_;  ///< on the disk
  std::size_t entries_ = 0, inflated_ = 0;
  int archive_count_ = 0, broken_ = 0;
};

}  // namespace

SourceFiles read_source(const judge::StepFlags& flags, const fs::path& source, const SourceLimits& limits) {
  SourceReader reader(flags, limits);
  return fs::is_directory(source) ? reader.read_folder(source) : reader.read_one_archive(source);
}

SourceFiles read_loose_files(const judge::StepFlags& flags,
                             const std::vector<std::pair<std::string, fs::path>>& files) {
  return SourceReader(flags, {}).read_files(files);
}

}  // namespace atelier::grade
