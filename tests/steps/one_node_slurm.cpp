#include "one_node_slurm.hpp"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <random>

#include "base/error.hpp"
#include "base/launch.hpp"
#include "catch.hpp"

namespace atelier::test {

namespace fs = std::filesystem;

namespace {

/// Daemons are in folders that not every PATH has.
std::map<std::string, std::string> environment_of_daemons() {
  std::map<std::string, std::string> environment = own_environment();
  environment["PATH"] += ":/usr/sbin:/sbin";
  return environment;
}

std::string daemon_program(const std::string& name) {
  for (const fs::path folder : {"/usr/sbin", "/sbin", "/usr/bin"})
    if (fs::exists(folder / name)) return (folder / name).string();
  return find_program(name).string();
}

/// A port of this machine that nobody uses now.
int unused_port() {
  const Descriptor held(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  REQUIRE(::bind(held.get(), reinterpret_cast<sockaddr*>(&address), size) == 0);
  REQUIRE(::getsockname(held.get(), reinterpret_cast<sockaddr*>(&address), &size) == 0);
  return ntohs(address.sin_port);
}

std::string end_of(const std::string& log) {
  return log.substr(log.size() - std::min<std::size_t>(log.size(), 2000));
}

std::string name_of_machine() {
  char name[256] = {};
  ::gethostname(name, sizeof name - 1);
  const std::string whole = name;
  return whole.substr(0, whole.find('.'));
}

}  // namespace

std::string OneNodeSlurm::why_not() {
  if (::geteuid() != 0) return "only root can start a Slurm that runs jobs";
  for (const char* program : {"munged", "slurmctld", "slurmd", "sbatch"}) try {
      daemon_program(program);
    } catch (const Error&) {
      return fmt::format("{} is missing: install slurmctld, slurmd, slurm-client and munge", program);
    }
  return "";
}

OneNodeSlurm::OneNodeSlurm() {
  fs::permissions(folder_.path(), fs::perms(0755));  // munged serves everybody
  write_configuration();
  start_watcher();
  start({daemon_program("munged"), "--foreground", "--force", "--socket=" + file("munge.socket").string(),
         "--key-file=" + file("munge.key").string(), "--log-file=" + file("munged.log").string(),
         "--pid-file=" + file("munged.pid").string(), "--seed-file=" + file("munge.seed").string()});
  REQUIRE(comes_true([&] { return fs::exists(file("munge.socket")); }, 20));
  start({daemon_program("slurmctld"), "-D", "-c"});
  start({daemon_program("slurmd"), "-D"});
  const bool ready = comes_true(
      [&] {
        return command({"sinfo", "--noheader", "--partition=open", "--format=%t"}).output == "idle\n";
      },
      60);
  INFO(logs());
  REQUIRE(ready);
}

OneNodeSlurm::~OneNodeSlurm() {
  for (Running& program : programs_) {  // in order, so that each ends its own processes
    program.signal(SIGTERM);
    comes_true([&] { return !program.runs(); }, 10);
  }
  programs_.clear();
  // What slurmd has started has left its process group, but has its configuration in the environment. A process may
  // start another one while it is killed.
  const std::string where = folder_.path().string();
  CHECK(comes_true(
      [&] {
        const std::vector<FoundProcess> left = processes_with(where);
        for (const FoundProcess& process : left) ::kill(process.number, SIGKILL);
        return left.empty();
      },
      20));
}

void OneNodeSlurm::add_to(std::map<std::string, std::string>& environment) const {
  environment["SLURM_CONF"] = file("slurm.conf").string();
}

Finished OneNodeSlurm::command(std::vector<std::string> arguments) const {
  std::map<std::string, std::string> environment = own_environment();
  add_to(environment);
  return run_process({.arguments = std::move(arguments), .environment = std::move(environment)});
}

void OneNodeSlurm::write_configuration() const {
  std::random_device random;
  std::string key;
  for (int i = 0; i < 128; ++i) key += char(random() & 0xff);
  write_file(file("munge.key"), key);
  fs::permissions(file("munge.key"), fs::perms(0400));
  for (const char* folder : {"state", "spool"}) fs::create_directory(file(folder));
  const std::string here = folder_.path().string(), name = name_of_machine();
  const int port_of_controller = unused_port();
  int port = unused_port();
  while (port == port_of_controller) port = unused_port();
  // A requeued task waits for cred_expire, in seconds; the processors are made up, so that tasks run side by side.
  write_file(file("slurm.conf"), fmt::format(R"(ClusterName=atelier
SlurmctldHost={name}(127.0.0.1)
AuthType=auth/munge
AuthInfo=socket={here}/munge.socket,cred_expire=5
SlurmUser=root
SlurmctldPort={port_of_controller}
SlurmdPort={port}
StateSaveLocation={here}/state
SlurmdSpoolDir={here}/spool
SlurmctldPidFile={here}/slurmctld.pid
SlurmdPidFile={here}/slurmd.pid
SlurmctldLogFile={here}/slurmctld.log
SlurmdLogFile={here}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerType=sched/builtin
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SwitchType=switch/none
MpiDefault=none
ReturnToService=2
SlurmdParameters=config_overrides
KillWait=5
NodeName={name} NodeAddr=127.0.0.1 CPUs=4 State=UNKNOWN
PartitionName=open Nodes=ALL Default=YES MaxTime=INFINITE State=UP
PartitionName=closed Nodes=ALL State=DOWN
)",
                                             fmt::arg("name", name), fmt::arg("here", here), fmt::arg("port", port),
                                             fmt::arg("port_of_controller", port_of_controller)));
}

void OneNodeSlurm::start(const std::vector<std::string>& arguments) {
  std::map<std::string, std::string> environment = environment_of_daemons();
  add_to(environment);
  programs_.emplace_front(arguments, environment);  // they end in the opposite order
}

void OneNodeSlurm::start_watcher() {
  const std::string script =
      "while kill -0 \"$1\"; do sleep 1; done; for p in /proc/[0-9]*; do "
      "if [ ${p#/proc/} != $$ ] && grep -qs \"$0\" $p/environ; then kill -9 ${p#/proc/}; fi; done; rm -rf \"$0\"";
  Running starter({"sh", "-c", "setsid sh -c \"$0\" \"$1\" \"$2\" >/dev/null 2>&1 &", script, folder_.path().string(),
                   std::to_string(::getpid())},
                  environment_of_daemons());
  REQUIRE(starter.wait() == 0);
}

std::string OneNodeSlurm::logs() const {
  std::string text;
  for (const char* log : {"munged.log", "slurmctld.log", "slurmd.log"})
    if (fs::exists(file(log))) text += fmt::format("{}:\n{}\n", log, end_of(read_file(file(log))));
  return text;
}

}  // namespace atelier::test
