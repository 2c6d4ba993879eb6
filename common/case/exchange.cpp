#include "case/exchange.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstring>

#include "base/descriptor.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/printable.hpp"
#include "base/strict_json.hpp"
#include "base/system_reason.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;

static_assert(std::endian::native == std::endian::little, "pixels are written in memory order");
static_assert(sizeof(Rgba) == 16);

constexpr std::array<char, 8> magic = {'A', 'T', 'E', 'L', 'I', 'E', 'R', '1'};
constexpr std::size_t max_sentence = 500;  // bytes of an error message

struct PixelHeader {
  std::array<char, 8> magic;
  std::uint32_t width, height;
};
static_assert(sizeof(PixelHeader) == 16);

/// A file that an untrusted program may have written. Refuses links (which could lead to the judge's own files) and
/// never blocks on a FIFO.
class UntrustedFile {
 public:
  UntrustedFile(const HeldFolder& folder, const std::string& name)
      : name_(printable(name)), descriptor_(folder.open_file(name)) {
    if (!descriptor_) {
      if (errno == ELOOP) throw Error(name_ + " is a symbolic link, not a regular file");
      throw Error(fmt::format("{}: {}", name_, system_reason()));
    }
    struct stat status {};
    if (::fstat(descriptor_.get(), &status) != 0 || !S_ISREG(status.st_mode))
      throw Error(name_ + " is a folder, pipe or device, not a regular file");
    if (status.st_nlink > 1) throw Error(name_ + " is a hard link to a file that has another name");
    size_ = std::size_t(status.st_size);
  }

  const std::string& name() const { return name_; }
  std::size_t size() const { return size_; }

  /// The next `count` bytes. Throws Error if the file ends before.
  void read(void* to, std::size_t count) {
    for (std::size_t done = 0; done < count;) {
      const ssize_t got = ::read(descriptor_.get(), static_cast<char*>(to) + done, count - done);
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) throw Error(fmt::format("{}: {}", name_, system_reason()));
      if (got == 0) throw Error(fmt::format("{} became shorter while it was read", name_));
      done += std::size_t(got);
    }
  }

 private:
  std::string name_;  ///< without its folder, for messages to the student
  Descriptor descriptor_;
  std::size_t size_ = 0;
};

std::string number_text(double value) {
  if (std::isnan(value)) return "\"nan\"";
  if (std::isinf(value)) return value > 0 ? "\"inf\"" : "\"-inf\"";
  if (value == 0) return std::signbit(value) ? "-0.0" : "0";  // a JSON reader takes -0 for the integer 0
  return fmt::format("{}", value);                            // the shortest text that reads back as the same double
}

}  // namespace

void write_pixels(const fs::path& file, const Image& image) {
  const PixelHeader header{magic, std::uint32_t(image.width()), std::uint32_t(image.height())};
  const std::size_t pixel_bytes = image.pixels().size_bytes();
  std::string bytes(sizeof header + pixel_bytes, '\0');
  std::memcpy(bytes.data(), &header, sizeof header);
  if (pixel_bytes > 0) std::memcpy(bytes.data() + sizeof header, image.pixels().data(), pixel_bytes);
  write_file(file, bytes);
}

void write_values(const fs::path& file, const std::vector<Numbers>& results) {
  std::string text = "{\"results\": [";
  for (std::size_t i = 0; i < results.size(); ++i) {
    text += i == 0 ? "\n[" : ",\n[";
    for (std::size_t j = 0; j < results[i].size(); ++j) {
      if (j > 0) text += ", ";
      text += number_text(results[i][j]);
    }
    text += "]";
  }
  write_file(file, text + "\n]}\n");
}

void write_case_error(const fs::path& file, const std::string& sentence) {
  const std::string_view first_line = std::string_view(sentence).substr(0, sentence.find('\n'));
  write_file(file, shorten(printable(first_line), max_sentence) + "\n");
}

Image read_pixels(const HeldFolder& folder, const std::string& name, glm::ivec2 expected) {
  Image image(expected.x, expected.y);
  UntrustedFile file(folder, name);
  const std::size_t needed = sizeof(PixelHeader) + image.pixels().size_bytes();
  if (file.size() != needed) {
    throw Error(fmt::format("{} has {} bytes; a picture of {} x {} pixels needs {}", file.name(), file.size(),
                            expected.x, expected.y, needed));
  }
  PixelHeader header;
  file.read(&header, sizeof header);
  if (header.magic != magic) throw Error(file.name() + " is not a picture file: it does not begin with ATELIER1");
  if (header.width != std::uint32_t(expected.x) || header.height != std::uint32_t(expected.y)) {
    throw Error(fmt::format("{} has {} x {} pixels; {} x {} are required", file.name(), header.width, header.height,
                            expected.x, expected.y));
  }
  file.read(image.pixels().data(), image.pixels().size_bytes());
  return image;
}

std::vector<Numbers> read_values(const HeldFolder& folder, const std::string& name, std::size_t limit) {
  UntrustedFile file(folder, name);
  if (file.size() > limit)
    throw Error(fmt::format("{} has {} bytes; at most {} are allowed", file.name(), file.size(), limit));
  std::string text(file.size(), '\0');
  file.read(text.data(), text.size());
  const strict_json::Json document = strict_json::parse(text, file.name());
  strict_json::refuse_unknown(document, {"results"}, file.name());
  const strict_json::Json& lists = strict_json::required(document, "results", file.name());
  if (!lists.is_array()) strict_json::refuse(lists, file.name() + ": results", "a list of lists of numbers");
  std::vector<Numbers> results;
  for (const strict_json::Json& list : lists) {
    const std::string where = fmt::format("{}: result {}", file.name(), results.size());
    if (!list.is_array()) strict_json::refuse(list, where, "a list of numbers");
    Numbers& numbers = results.emplace_back();
    for (const strict_json::Json& value : list) numbers.push_back(strict_json::any_number(value, where));
  }
  return results;
}

std::map<std::string, std::int64_t> read_counts(const HeldFolder& folder, const std::string& file_name) {
  constexpr std::size_t max_bytes = 1 << 16, max_counts = 64;
  UntrustedFile file(folder, file_name);
  if (file.size() > max_bytes)
    throw Error(fmt::format("{} has {} bytes; at most {} are allowed", file.name(), file.size(), max_bytes));
  std::string text(file.size(), '\0');
  file.read(text.data(), text.size());
  const strict_json::Json document = strict_json::parse(text, file.name());
  const strict_json::Json& members = strict_json::required(document, "counts", file.name());
  if (!members.is_object() || members.size() > max_counts)
    strict_json::refuse(members, file.name() + ": counts", fmt::format("at most {} whole numbers", max_counts));
  std::map<std::string, std::int64_t> counts;
  for (const auto& [name, value] : members.items()) {
    if (!value.is_number_integer() || value.get<std::int64_t>() < 0)
      strict_json::refuse(value, file.name() + ": " + name, "a whole number, 0 or more");
    counts[name] = value.get<std::int64_t>();
  }
  return counts;
}

std::string read_case_error(const HeldFolder& folder, const std::string& name) {
  if (!folder.has(name)) return {};
  try {
    UntrustedFile file(folder, name);
    std::string text(std::min(file.size(), max_sentence), '\0');
    const bool cut = file.size() > text.size();
    file.read(text.data(), text.size());
    const std::size_t line_end = text.find('\n');
    if (cut && line_end == text.npos) text += "...";
    return shorten(printable(std::string_view(text).substr(0, line_end)), max_sentence);
  } catch (const Error& unreadable) {
    return unreadable.what();
  }
}

}  // namespace atelier
