#include "peers/peers.hpp"

#include <fmt/format.h>

#include <chrono>
#include <nlohmann/json.hpp>

#include "base/parse_number.hpp"

namespace atelier::peers {

namespace {

double seconds_of(const std::function<void()>& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

struct Times {
  std::vector<double> ours, theirs;
};

Times times_of(const Row& row, int rounds) {
  Times times;
  for (int round = -1; round < rounds; ++round) {  // the first warms up
    double theirs = 0;
    if (row.peer.run) {
      if (row.peer.prepare) row.peer.prepare();
      theirs = seconds_of(row.peer.run);
    }
    const double ours = seconds_of(row.ours);
    if (round < 0) continue;
    times.ours.push_back(ours);
    if (row.peer.run) times.theirs.push_back(theirs);
  }
  return times;
}

}  // namespace

int compare(const std::vector<Row>& rows, int argc, char** argv) {
  int rounds = 5;
  if (argc > 2 || (argc == 2 && !parse_number(argv[1], rounds)) || rounds < 1) {
    fmt::print(stderr, "error: {} takes one argument, the number of rounds: at least 1\n", argv[0]);
    return 2;
  }
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
  fmt::print("{}\n", nlohmann::ordered_json{{"rows", list}}.dump(2));
  return 0;
}

}  // namespace atelier::peers
