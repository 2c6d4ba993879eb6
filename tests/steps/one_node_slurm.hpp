// A Slurm of one machine, this one, for as long as a test lasts. It needs no configuration of the system, no systemd
// and no database, and does not meet another Slurm: it has its own key, socket and ports.
#pragma once

#include <deque>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/file.hpp"
#include "base/process.hpp"
#include "running.hpp"

namespace atelier::test {

class OneNodeSlurm {
 public:
  /// Why it cannot be started here; empty if it can.
  static std::string why_not();

  /// Starts it, and fails the test if it does not get ready: four processors, the partition `open`, and `closed`, which
  /// starts nothing.
  OneNodeSlurm();
  ~OneNodeSlurm();  ///< ends it with all jobs

  /// SLURM_CONF, for the commands of Slurm.
  void add_to(std::map<std::string, std::string>& environment) const;
  /// Runs a command of Slurm.
  Finished command(std::vector<std::string> arguments) const;
  /// The jobs that wait or run, as squeue prints them.
  std::string queue() const { return command({"squeue", "--noheader"}).output; }

 private:
  std::filesystem::path file(const char* name) const { return folder_.path() / name; }
  void write_configuration() const;
  /// What ends all if the test itself is killed: daemons then end too, but not what they have started.
  void start_watcher();
  void start(const std::vector<std::string>& arguments);
  std::string logs() const;

  TemporaryFolder folder_{"atelier-steps-test"};
  std::deque<Running> programs_;
};

}  // namespace atelier::test
