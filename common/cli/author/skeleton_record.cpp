#include "cli/author/skeleton_record.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/sha256.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t digest_length = 64;

fs::path record_path(const fs::path& steps) {
  return steps / "skeletons.sha256";
}

}  // namespace

SkeletonRecord read_skeleton_record(const fs::path& steps) {
  SkeletonRecord record;
  const fs::path path = record_path(steps);
  if (!fs::exists(path)) return record;
  const std::string text = read_file(path, 1 << 20);
  int number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = text.substr(begin, end - begin);
    begin = end + 1;
    ++number;
    const bool digest = line.find_first_not_of("0123456789abcdef") == digest_length;
    if (!digest || line.compare(digest_length, 2, "  ") != 0 || line.size() == digest_length + 2)
      throw Error(fmt::format("{}:{}: write a SHA-256 digest, two spaces and a file below steps/, as sha256sum does",
                              path.string(), number));
    record[line.substr(digest_length + 2)] = line.substr(0, digest_length);
  }
  return record;
}

void write_skeleton_record(const fs::path& steps, const SkeletonRecord& record) {
  std::string text;
  for (const auto& [name, digest] : record) text += digest + "  " + name + "\n";
  write_file(record_path(steps), text);
}

SkeletonState skeleton_state(const fs::path& steps, const SkeletonRecord& record, const std::string& name) {
  if (!fs::exists(steps / name)) return SkeletonState::missing;
  const auto found = record.find(name);
  const bool same = found != record.end() && sha256(read_file(steps / name)) == found->second;
  return same ? SkeletonState::untouched : SkeletonState::edited;
}

std::string to_string(SkeletonState state) {
  switch (state) {
    case SkeletonState::missing:
      return "missing";
    case SkeletonState::untouched:
      return "untouched";
    case SkeletonState::edited:
      return "edited";
  }
  return {};
}

}  // namespace atelier
