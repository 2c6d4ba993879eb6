// A shard: the cases of a run that one worker process answers in turn. The worker is restarted after a case that ended
// it.
#pragma once

#include <chrono>
#include <cstddef>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "judge/run/runner.hpp"
#include "judge/run/worker.hpp"

namespace atelier::judge {

/// Starts its first process at once; advance() polls it, so that several shards run side by side.
class Shard {
 public:
  using Clock = std::chrono::steady_clock;
  using Deliver = std::function<void(std::size_t index, Answer)>;

  /// `time_outs` is counted by all shards of a run together.
  Shard(const RunSettings& settings, const std::vector<Case>& cases, std::deque<std::size_t> waiting,
        std::filesystem::path folder, int& time_outs, Deliver deliver);

  bool done() const { return worker_ == nullptr; }
  const Worker& worker() const { return *worker_; }         ///< only while not done()
  Clock::time_point deadline() const { return deadline_; }  ///< when advance() must be called at the latest

  /// Takes in what has happened since the last call; never waits.
  void advance();

 private:
  void start();
  void listen();
  void begin(const std::string& name);
  void end(const std::string& name);
  void settle(Answer::Ended how, const std::string& in_case, const std::string& before_any);
  bool out_of_patience() const { return settings_.most_time_outs > 0 && time_outs_ >= settings_.most_time_outs; }
  void leave_rest();

  const RunSettings& settings_;
  const std::vector<Case>& cases_;
  std::deque<std::size_t> waiting_;     ///< not begun yet, in order
  std::optional<std::size_t> running_;  ///< begun and not ended
  std::filesystem::path folder_;        ///< of the process: its job file and its answers
  int& time_outs_;
  Deliver deliver_;
  std::unique_ptr<Worker> worker_;
  int processes_ = 0;
  bool begun_ = false;  ///< this process has begun a case
  std::string output_;  ///< printed since the last end
  std::string tail_;    ///< the last that this process has printed, in whatever case
  Clock::time_point since_, deadline_;
};

}  // namespace atelier::judge
