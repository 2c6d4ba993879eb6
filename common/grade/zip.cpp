#include "grade/zip.hpp"

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>

#include <ctime>
#include <memory>

#include "base/error.hpp"
#include "base/printable.hpp"

namespace atelier::grade {
namespace {

/// Noon UTC of 1 January 2000, the date of all files; ZIP can store it in every time zone.
constexpr std::time_t file_date = 946'728'000;

la_ssize_t append(archive*, void* to, const void* bytes, std::size_t count) {
  static_cast<std::string*>(to)->append(static_cast<const char*>(bytes), count);
  return la_ssize_t(count);
}

class ZipWriter {
 public:
  ZipWriter() : writer_(archive_write_new(), archive_write_free) {
    if (!writer_ || archive_write_set_format_zip(writer_.get()) != ARCHIVE_OK)
      throw Error("the archive library does not support ZIP");
    archive_write_set_bytes_in_last_block(writer_.get(), 1);  // no padding
    check(archive_write_open(writer_.get(), &archive_, nullptr, append, nullptr), "the archive");
  }

  void add(const std::string& path, const PackedFile& file) {
    const std::unique_ptr<archive_entry, void (*)(archive_entry*)> entry(archive_entry_new(), archive_entry_free);
    archive_entry_set_pathname(entry.get(), path.c_str());
    archive_entry_set_filetype(entry.get(), AE_IFREG);
    archive_entry_set_perm(entry.get(), file.executable ? 0755 : 0644);
    archive_entry_set_size(entry.get(), la_int64_t(file.bytes.size()));
    archive_entry_set_mtime(entry.get(), file_date, 0);
    check(archive_write_header(writer_.get(), entry.get()), path);
    if (archive_write_data(writer_.get(), file.bytes.data(), file.bytes.size()) != la_ssize_t(file.bytes.size()))
      check(ARCHIVE_FATAL, path);
  }

  std::string finish() {
    check(archive_write_close(writer_.get()), "the archive");
    return std::move(archive_);
  }

 private:
  void check(int status, const std::string& what) {
    if (status == ARCHIVE_OK) return;
    const char* words = archive_error_string(writer_.get());
    throw Error(fmt::format("{}: cannot be packed: {}", printable(what), words ? words : "no reason given"));
  }

  std::string archive_;
  std::unique_ptr<archive, int (*)(archive*)> writer_;
};

}  // namespace

std::string make_zip(const PackedFiles& files) {
  ZipWriter writer;
  for (const auto& [path, file] : files) writer.add(path, file);
  return writer.finish();
}

}  // namespace atelier::grade
