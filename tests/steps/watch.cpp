// ./atelier watch in a pseudo-terminal, with its own work folder.
#include <poll.h>
#include <pty.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <sstream>
#include <thread>

#include "base/file.hpp"
#include "catch.hpp"
#include "command.hpp"
#include "editor_tasks.hpp"

using namespace atelier;
using namespace atelier::test;
namespace fs = std::filesystem;
using namespace std::chrono_literals;

namespace {

/// The child at the other end of a terminal. What it prints is read as it is waited for.
class Terminal {
 public:
  Terminal(const std::vector<std::string>& arguments, const fs::path& work) {
    const std::string program = (folders().build / "bin" / "atelier").string(), where = work.string();
    std::vector<char*> list = {const_cast<char*>(program.c_str())};
    for (const std::string& argument : arguments) list.push_back(const_cast<char*>(argument.c_str()));
    list.push_back(nullptr);
    child_ = ::forkpty(&terminal_, nullptr, nullptr, nullptr);
    REQUIRE(child_ >= 0);
    if (child_ == 0) {
      ::setenv("ATELIER_WORK", where.c_str(), 1);
      ::setenv("TERM", "dumb", 1);
      ::execv(program.c_str(), list.data());
      ::_exit(127);
    }
  }
  ~Terminal() {
    ::kill(child_, SIGKILL);
    ::close(terminal_);
    if (!ended_) ::waitpid(child_, nullptr, 0);
  }

  void press(const std::string& keys) { REQUIRE(::write(terminal_, keys.data(), keys.size()) == ssize_t(keys.size())); }

  /// What was printed up to these words; fails where they do not come within a minute.
  std::string read_to(const std::string& words) {
    const auto until = std::chrono::steady_clock::now() + 60s;
    std::size_t found;
    while ((found = text_.find(words)) == std::string::npos && std::chrono::steady_clock::now() < until)
      if (!read_some()) break;
    INFO("waited for: " << words << "\nread: " << text_);
    REQUIRE(found != std::string::npos);
    const std::string before = text_.substr(0, found + words.size());
    text_.erase(0, found + words.size());
    return before;
  }

  /// The status that it exits with once it has ended.
  int wait_for_end() {
    while (read_some()) {
    }
    int status = 0;
    REQUIRE(::waitpid(child_, &status, 0) == child_);
    ended_ = true;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

 private:
  /// False once the other end is closed.
  bool read_some() {
    pollfd entry{terminal_, POLLIN, 0};
    if (::poll(&entry, 1, 1000) == 0) return true;
    char chunk[4096];
    const ssize_t got = ::read(terminal_, chunk, sizeof chunk);
    if (got > 0) text_.append(chunk, std::size_t(got));
    return got > 0;
  }

  int terminal_ = -1;
  pid_t child_ = -1;
  bool ended_ = false;
  std::string text_;
};

/// A folder of work with step 00 as it is handed out, and the other steps beside it.
struct Work {
  TemporaryFolder folder{"atelier-watch"};
  fs::path file = folder.path() / "steps/00-hello/hello.glsl";
  std::string skeleton = read_file(folders().root / "steps/00-hello/hello.glsl");
  std::string solution = read_file(folders().solutions() / "00-hello/hello.glsl");

  Work() {
    fs::create_directory(folder.path() / "steps");
    for (const CourseStep& step : course())
      for (const std::string& name : step.files)
        write_file(folder.path() / "steps" / step.name / name, read_file(folders().root / "steps" / step.name / name));
    write_file(folder.path() / "steps/skeletons.sha256", read_file(folders().root / "steps/skeletons.sha256"));
    // Whoever runs the tests may have solved step 00; these tests begin before that.
    skeleton = solution;
    const std::size_t body = skeleton.find("return ");
    REQUIRE(body != std::string::npos);
    skeleton.replace(body, skeleton.find(';', body) - body, "return vec3(0.5)");
    write_file(file, skeleton);
  }
  /// As editors do that write in place: emptied first.
  void save(const std::string& text) const {
    std::FILE* out = std::fopen(file.c_str(), "w");
    REQUIRE(out != nullptr);
    std::this_thread::sleep_for(5ms);
    std::fputs(text.c_str(), out);
    std::fclose(out);
  }
};

constexpr const char* keys_line = "[q]uit";

/// The number of lines in which an editor sees a round of the task `watch` begin or end.
int count_lines(const std::string& printed, const char* pattern) {
  const std::regex regex(editor_task("watch").at("problemMatcher")[0]["background"][pattern].get<std::string>());
  int count = 0;
  std::istringstream lines(printed);
  for (std::string line; std::getline(lines, line);) {
    if (line.ends_with('\r')) line.pop_back();
    if (std::regex_search(line, regex)) ++count;
  }
  return count;
}

}  // namespace

TEST_CASE("edit, verdict, edit, verdict, break, fix, reset, quit, resume", "[watch]") {
  const Work work;
  {
    Terminal terminal({"watch", "00"}, work.folder.path());
    CHECK(mentions(terminal.read_to(keys_line), {"0 of 2 cases passed", "triangle", "too bright"}));

    work.save(work.solution);
    CHECK(mentions(terminal.read_to(keys_line), {"2 of 2 cases passed", "has passed in full"}));

    std::string broken = work.solution;
    broken.erase(broken.find(';', broken.find("return ")), 1);
    work.save(broken);
    const std::string verdict = terminal.read_to(keys_line);
    CHECK(count_lines(verdict, "beginsPattern") == 1);
    CHECK(count_lines(verdict, "endsPattern") == 1);
    CHECK(mentions(verdict, {"build failed", "hello.glsl:", "syntax error", "0 of 2 cases passed"}));
    std::size_t said = 0;
    for (std::size_t at = verdict.find("syntax error"); at != std::string::npos;
         at = verdict.find("syntax error", at + 1))
      ++said;
    CHECK(said <= 2);  // the line of the cases, and the explanation

    write_file(work.file, work.solution);  // beside and renamed, as other editors do
    CHECK(mentions(terminal.read_to(keys_line), {"2 of 2 cases passed"}));

    terminal.press("r");
    CHECK(mentions(terminal.read_to(keys_line), {"2 of 2 cases passed"}));

    terminal.press("Rn");
    terminal.read_to("Nothing was reset.");
    CHECK(read_file(work.file) == work.solution);
    terminal.press("Ry");
    CHECK(mentions(terminal.read_to("cases passed"), {"hello.glsl.before-reset", "0 of 2"}));
    CHECK(read_file(work.file) != work.solution);
    CHECK(read_file(work.file.string() + ".before-reset") == work.solution);
    terminal.read_to(keys_line);

    terminal.press("h");
    terminal.read_to("hint 1 of 3");
    terminal.press("l");
    terminal.read_to("small");
    terminal.press("q");
    CHECK(terminal.wait_for_end() == 0);
  }
  // Resume: without a step it begins where there is something to do, and the hints go on.
  Terminal terminal({"watch"}, work.folder.path());
  CHECK(mentions(terminal.read_to(keys_line), {"00-hello", "0 of 2 cases passed"}));
  terminal.press("h");
  terminal.read_to("hint 2 of 3");
  terminal.press("n");
  CHECK(mentions(terminal.read_to(keys_line), {"01-transforms"}));
  terminal.press("\x03");
  CHECK(terminal.wait_for_end() == -SIGINT);
}

TEST_CASE("a newer save cancels a running check", "[watch]") {
  const Work work;
  Terminal terminal({"watch", "01"}, work.folder.path());
  terminal.read_to(keys_line);
  // A loop without end in the first function; saved again as it was while it hangs.
  const fs::path file = work.folder.path() / "steps/01-transforms/transforms.cpp";
  const std::string before = read_file(file);
  std::string hanging = before;
  const std::size_t body = hanging.find("{\n", hanging.find("mat4 translation("));
  REQUIRE(body != std::string::npos);
  hanging.insert(body + 2, "  for (volatile int i = 0;; i = i + 1) {}\n");
  write_file(file, hanging);
  CHECK(count_lines(terminal.read_to("building and drawing ..."), "beginsPattern") == 1);
  std::this_thread::sleep_for(3s);  // the compiler is not interrupted, the program is
  const auto begin = std::chrono::steady_clock::now();
  write_file(file, before);
  const std::string rest = terminal.read_to(keys_line);
  CHECK(!mentions(rest, {"took longer"}));
  CHECK(count_lines(rest, "beginsPattern") == 1);
  CHECK(count_lines(rest, "endsPattern") == 2);  // of the cancelled round and of the next
  INFO(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() << " s");
  terminal.press("q");
  CHECK(terminal.wait_for_end() == 0);
}
