// On folders that look like those of the kernel.
#include "sandbox/control_group.hpp"

#include <fmt/format.h>

#include "base/file.hpp"
#include "catch.hpp"

using namespace atelier;
using atelier::sandbox::ControlGroup;

namespace fs = std::filesystem;

namespace {

constexpr std::size_t memory = 4096;
constexpr int processes = 7;

std::unique_ptr<ControlGroup> create(const fs::path& root) {
  return ControlGroup::create("1", memory, processes, root, root / "own");
}

/// The files of a group, which here nobody makes and nobody removes with it.
void empty(const fs::path& folder) {
  for (const auto& entry : fs::directory_iterator(folder)) fs::remove(entry.path());
}

}  // namespace

TEST_CASE("Of version 1 a group lies in that of this process, once for each controller") {
  const TemporaryFolder root("atelier-test");
  write_file(root.path() / "own", "11:cpu,memory:/outer/mine\n4:pids:/\n0::/\n");
  fs::create_directories(root.path() / "memory/outer/mine");
  fs::create_directories(root.path() / "pids");
  const fs::path first = root.path() / "memory/outer/mine" / ControlGroup::name_of("1"),
                 second = root.path() / "pids" / ControlGroup::name_of("1");
  {
    const auto group = create(root.path());
    REQUIRE(group);
    CHECK(group->folders() == std::vector<fs::path>{first, second});
    CHECK(read_file(first / "memory.limit_in_bytes") == "4096");
    CHECK(read_file(second / "pids.max") == "7");
    CHECK(group->memory_kills() == 0);
    write_file(first / "memory.oom_control", "oom_kill_disable 0\nunder_oom 0\noom_kill 3\n");
    CHECK(group->memory_kills() == 3);
    empty(first), empty(second);
  }
  CHECK(!fs::exists(first));
  CHECK(!fs::exists(second));
}

TEST_CASE("Of version 1 one controller is enough") {
  const TemporaryFolder root("atelier-test");
  write_file(root.path() / "own", "4:pids:/\n");
  fs::create_directories(root.path() / "pids");
  const auto group = create(root.path());
  REQUIRE(group);
  CHECK(group->folders().size() == 1);
}

TEST_CASE("Of version 2 a group lies in the root, if that gives it both controllers") {
  const TemporaryFolder root("atelier-test");
  write_file(root.path() / "cgroup.controllers", "cpu memory pids\n");
  const fs::path folder = root.path() / ControlGroup::name_of("1");
  for (const char* given : {"", "cpu memory\n", "cpu pids\n"}) {
    INFO(given);
    write_file(root.path() / "cgroup.subtree_control", given);
    CHECK(!create(root.path()));
    CHECK(!fs::exists(folder));
  }
  write_file(root.path() / "cgroup.subtree_control", "cpu memory pids\n");
  {
    const auto group = create(root.path());
    REQUIRE(group);
    CHECK(group->folders() == std::vector<fs::path>{folder});
    CHECK(read_file(folder / "memory.max") == "4096");
    CHECK(read_file(folder / "pids.max") == "7");
    write_file(folder / "memory.events", "low 0\nhigh 0\nmax 12\noom 5\noom_kill 2\noom_group_kill 0\n");
    CHECK(group->memory_kills() == 2);
    empty(folder);
  }
  CHECK(!fs::exists(folder));
}

TEST_CASE("Where no group can be made, there is none") {
  const TemporaryFolder root("atelier-test");
  CHECK(!create(root.path()));
  write_file(root.path() / "own", "4:pids:/\n9:memory:/elsewhere\nno colon\n:\n");
  CHECK(!create(root.path()));
  CHECK(fs::directory_iterator(root.path()) != fs::directory_iterator());
}
