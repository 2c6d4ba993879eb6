#include "peers/peers.hpp"

#include <fmt/format.h>

#include <chrono>
#include <exception>
#include <nlohmann/json.hpp>

#include "base/parse_number.hpp"

namespace atelier::peers {

namespace {

double seconds_of(const std::function<void()>& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

double seconds_of(const Peer& peer) {
  if (peer.prepare) peer.prepare();
  const double seconds = seconds_of(peer.run);
  if (peer.check) peer.check();
  return seconds;
}

struct Times {
  std::vector<double> ours, theirs;
};

Times times_of(const Row& row, int rounds) {
  Times times;
  for (int round = -1; round < rounds; ++round) {  // the first warms up
    // Whoever runs second finds the caches, the heap and the processor's clock as the other has left them.
    const bool ours_first = round % 2 == 0;
    double ours = 0, theirs = 0;
    if (ours_first) ours = seconds_of(row.ours);
    if (row.peer.run) theirs = seconds_of(row.peer);
    if (!ours_first) ours = seconds_of(row.ours);
    if (round < 0) continue;
    times.ours.push_back(ours);
    if (row.peer.run) times.theirs.push_back(theirs);
  }
  return times;
}

nlohmann::ordered_json compared(const std::vector<Row>& rows, int rounds) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Row& row : rows) {
    const Times times = times_of(row, rounds);
    nlohmann::ordered_json json = {{"work", row.work}, {"peer", row.peer.name}, {"ours", times.ours}};
    if (row.aim > 0) json["aim"] = row.aim;
    if (row.peer.run)
      json["theirs"] = times.theirs;
    else
      json["missing"] = row.peer.missing;
    list.push_back(std::move(json));
  }
  return nlohmann::ordered_json{{"rows", list}};
}

}  // namespace

int compare(const std::function<std::vector<Row>()>& make_rows, int argc, char** argv) {
  int rounds = 5;
  if (argc > 2 || (argc == 2 && !parse_number(argv[1], rounds)) || rounds < 1) {
    fmt::print(stderr, "error: {} takes one argument, the number of rounds: at least 1\n", argv[0]);
    return 2;
  }
  try {
    fmt::print("{}\n", compared(make_rows(), rounds).dump(2));
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return 1;
  }
}

}  // namespace atelier::peers
