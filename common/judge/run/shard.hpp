// A shard: the cases of a run that one worker process answers in order. If a case ends the worker, it is restarted.
#pragma once

#include <chrono>
#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/file.hpp"
#include "judge/run/runner.hpp"
#include "judge/run/worker.hpp"

namespace atelier::judge {

/// The constructor starts the first process. advance() never waits, so several shards can run in parallel.
class Shard {
 public:
  using Clock = std::chrono::steady_clock;
  using Deliver = std::function<void(std::size_t index, Answer)>;

  /// `time_outs` is a counter that all shards of a run share.
  Shard(const RunSettings& settings, const std::vector<Case>& cases, std::deque<std::size_t> waiting, int& time_outs,
        Deliver deliver);

  bool done() const { return worker_ == nullptr; }
  const Worker& worker() const { return *worker_; }         ///< only while not done()
  Clock::time_point deadline() const { return deadline_; }  ///< call advance() by this time at the latest

  /// Handles all that has happened since the last call. Never waits.
  void advance();

 private:
  void start();
  sandbox::Room room(const std::filesystem::path& job, const std::filesystem::path& out) const;
  void read_pipes();
  void begin(const std::string& name);
  void end(const std::string& name);
  void handle_end(Answer::Ended how, const std::string& in_case, const std::string& before_any);
  void handle_not_started();
  std::string in_words(const Exit& exit) const;
  bool time_out_limit_reached() const { return settings_.max_time_outs > 0 && time_outs_ >= settings_.max_time_outs; }
  void skip_waiting();

  const RunSettings& settings_;
  const std::vector<Case>& cases_;
  std::deque<std::size_t> waiting_;        ///< not begun yet, in order
  std::optional<std::size_t> running_;     ///< begun and not ended
  std::optional<TemporaryFolder> folder_;  ///< of this process: its job file, and the folder for its answers
  std::optional<HeldFolder> out_;          ///< the folder for its answers, opened before the process started
  int& time_outs_;
  Deliver deliver_;
  std::unique_ptr<Worker> worker_;
  bool case_begun_ = false;  ///< whether this process has begun a case
  bool alone_ = true;        ///< whether it was started while none of the submission's ran
  int memory_kills_ = 0;     ///< in the sandbox, before it was started
  std::string output_;       ///< printed since the last "end" line
  std::string tail_;         ///< the last bytes that this process has printed
  Clock::time_point since_, deadline_;
};

}  // namespace atelier::judge
