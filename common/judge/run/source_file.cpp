#include "judge/run/source_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <system_error>

#include "base/sealed.hpp"
#include "base/system_reason.hpp"

namespace atelier::judge {
namespace {

namespace fs = std::filesystem;

const char* kind_name(fs::file_type type) {
  switch (type) {
    case fs::file_type::directory:
      return "folder";
    case fs::file_type::fifo:
      return "FIFO";
    case fs::file_type::socket:
      return "socket";
    default:
      return "device";
  }
}

}  // namespace

std::string is_too_large(std::size_t limit) {
  return fmt::format("is larger than the limit of {} bytes", limit);
}

std::string why_unusable(const fs::path& path) {
  std::error_code error;
  const fs::file_type type = fs::symlink_status(path, error).type();
  if (type == fs::file_type::not_found) return is_missing;
  if (type == fs::file_type::symlink) return is_link;
  if (type == fs::file_type::none) return "cannot be read: " + error.message();
  if (type != fs::file_type::regular) return fmt::format("is a {}, not a regular file", kind_name(type));
  const auto size = fs::file_size(path, error);
  if (!error && size > source_limit) return is_too_large();
  if (!error && size == 0 && path.extension() != ".txt") return is_empty;
  if (error || ::access(path.c_str(), R_OK) != 0)
    return "cannot be read: " + (error ? error.message() : system_reason());
  std::string begin(seal_length, ' ');
  std::ifstream(path, std::ios::binary).read(begin.data(), std::streamsize(begin.size()));
  return is_sealed(begin) ? is_of_a_solution : std::string();
}

std::string in_words(const UnusableFiles& files) {
  std::string words;
  for (const auto& [file, why] : files) words += (words.empty() ? "" : "; ") + file + " " + why;
  return words;
}

}  // namespace atelier::judge
