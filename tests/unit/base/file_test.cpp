#include "base/file.hpp"

#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <string>
#include <vector>

#include "catch.hpp"

namespace fs = std::filesystem;
using atelier::read_file;
using atelier::require_space;
using atelier::TemporaryFolder;
using atelier::write_file;
using atelier::test::error_of;
using atelier::test::mentions;

namespace {

std::size_t files_in(const fs::path& folder) {
  return std::size_t(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

/// The disk as good as full: no file of this process grows over `bytes` while this lives.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    ::signal(SIGXFSZ, handler_);
  }

 private:
  void (*handler_)(int);
  rlimit before_{};
};

}  // namespace

TEST_CASE("A full disk is reported before anything is written to it") {
  const TemporaryFolder folder;
  CHECK_NOTHROW(require_space(folder.path(), 1));
  CHECK(mentions(error_of([&] { require_space(folder.path(), std::uintmax_t(1) << 62); }),
                 {folder.path().string(), "the disk is full", "MB are needed", "free some space"}));
  CHECK_NOTHROW(require_space("/nowhere", 1));  // what is unknown is no reason to stop
}

TEST_CASE("A written file is read back byte by byte") {
  const TemporaryFolder folder;
  const std::vector<std::pair<std::string, std::string>> rows = {
      {"empty", ""},
      {"one byte", "x"},
      {"text without a last newline", "a\nb"},
      {"null bytes and all others",
       [] {
         std::string all;
         for (int i = 0; i < 256; ++i) all += char(i);
         return all;
       }()},
      {"longer than any buffer", std::string(3'000'001, 'z')},
  };
  for (const auto& [name, bytes] : rows) {
    INFO(name);
    write_file(folder.path() / "new folder" / "deep" / name, bytes);
    CHECK(read_file(folder.path() / "new folder" / "deep" / name) == bytes);
  }
  CHECK(files_in(folder.path() / "new folder" / "deep") == rows.size());  // nothing else is left there
}

TEST_CASE("A file name of the maximum length can be written") {
  const TemporaryFolder folder;
  write_file(folder.path() / std::string(255, 'n'), "long");
  CHECK(read_file(folder.path() / std::string(255, 'n')) == "long");
  CHECK(error_of([&] { write_file(folder.path() / std::string(256, 'n'), "longer"); }) != "");
  CHECK(files_in(folder.path()) == 1);
}

TEST_CASE("Files without a size, as in /proc, are read to their end") {
  if (!fs::exists("/proc/self/status")) SKIP_TEST("this system has no /proc");
  CHECK(mentions(read_file("/proc/self/status"), {"Pid:"}));
}

TEST_CASE("Reading refuses and names non-files and files above the limit") {
  const TemporaryFolder folder;
  write_file(folder.path() / "ten", "0123456789");
  fs::create_symlink(folder.path() / "nowhere", folder.path() / "dangling");
  ::mkfifo((folder.path() / "fifo").c_str(), 0600);

  CHECK(read_file(folder.path() / "ten", 10).size() == 10);
  CHECK(mentions(error_of([&] { read_file(folder.path() / "ten", 9); }), {"ten", "10 bytes", "at most 9"}));
  CHECK(mentions(error_of([&] { read_file("/proc/self/status", 9); }), {"/proc/self/status", "9 bytes"}));
  CHECK(mentions(error_of([&] { read_file(folder.path() / "missing"); }), {"missing", "No such file"}));
  CHECK(mentions(error_of([&] { read_file(folder.path() / "dangling"); }), {"dangling", "No such file"}));
  CHECK(mentions(error_of([&] { read_file(folder.path() / "fifo"); }), {"fifo", "not a regular file"}));
  CHECK(mentions(error_of([&] { read_file(folder.path()); }), {folder.path().string(), "folder"}));
  CHECK(mentions(error_of([&] { read_file("/dev/zero"); }), {"/dev/zero", "not a regular file"}));
  CHECK(mentions(error_of([&] { read_file(""); }), {"cannot be read"}));
}

TEST_CASE("A failed write leaves only the old file") {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "result.json";
  write_file(file, "old");
  std::string message;
  {
    const FileSizeLimit full(4096);
    message = error_of([&] { write_file(file, std::string(5000, 'x')); });
  }
  CHECK(mentions(message, {"result.json", "File too large"}));
  CHECK(read_file(file) == "old");
  CHECK(files_in(folder.path()) == 1);
}

TEST_CASE("Writing refuses and names invalid places") {
  const TemporaryFolder folder;
  write_file(folder.path() / "file", "old");
  CHECK(mentions(error_of([&] { write_file(folder.path(), "x"); }), {folder.path().string(), "folder"}));
  CHECK(mentions(error_of([&] { write_file(folder.path() / "file" / "below", "x"); }), {"below", "folder"}));
  // Not tried on a real device: a write_file that is wrong would replace it for the whole machine.
  ::mkfifo((folder.path() / "fifo").c_str(), 0600);
  CHECK(mentions(error_of([&] { write_file(folder.path() / "fifo", "x"); }), {"fifo", "not a regular file"}));
  CHECK(fs::is_fifo(folder.path() / "fifo"));  // not replaced
  CHECK(mentions(error_of([&] { write_file("/proc/none/x", "x"); }), {"/proc/none/x"}));

  fs::create_directory(folder.path() / "locked");
  fs::permissions(folder.path() / "locked", fs::perms::owner_read | fs::perms::owner_exec);
  if (::geteuid() == 0) SKIP_TEST("root may write into any folder: the unwritable one is not tried");
  CHECK(mentions(error_of([&] { write_file(folder.path() / "locked" / "x", "x"); }), {"locked", "Permission denied"}));
}

TEST_CASE("A link stays a link, and the owner's permissions are kept") {
  const TemporaryFolder folder;
  write_file(folder.path() / "behind", "old");
  fs::permissions(folder.path() / "behind", fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("behind", folder.path() / "link");
  write_file(folder.path() / "link", "new");
  CHECK(fs::is_symlink(folder.path() / "link"));
  CHECK(read_file(folder.path() / "behind") == "new");
  CHECK(fs::status(folder.path() / "behind").permissions() == (fs::perms::owner_read | fs::perms::owner_write));
}

TEST_CASE("A temporary folder is new, empty, and deleted at the end") {
  fs::path first, second;
  {
    TemporaryFolder a("unit"), b("unit");
    first = a.path(), second = b.path();
    CHECK(first != second);
    CHECK(fs::is_empty(first));
    CHECK(mentions(first.filename().string(), {"unit-"}));
    write_file(first / "deep" / "er" / "file", "x");
    const TemporaryFolder moved = std::move(a);
    CHECK(moved.path() == first);
    CHECK(fs::exists(first / "deep" / "er" / "file"));
  }
  CHECK_FALSE(fs::exists(first));
  CHECK_FALSE(fs::exists(second));
}

TEST_CASE("A TMPDIR that is missing is named") {
  const char* before = std::getenv("TMPDIR");
  const std::string kept = before ? before : "";
  ::setenv("TMPDIR", "/no/such/folder", 1);
  const std::string message = error_of([] { TemporaryFolder folder; });
  before ? ::setenv("TMPDIR", kept.c_str(), 1) : ::unsetenv("TMPDIR");
  CHECK(mentions(message, {"TMPDIR"}));
}
