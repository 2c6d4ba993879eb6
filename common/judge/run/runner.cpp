#include "judge/run/runner.hpp"

#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <deque>
#include <memory>
#include <numeric>
#include <set>
#include <system_error>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/shuffle.hpp"
#include "judge/run/shard.hpp"

namespace atelier::judge {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

/// How often to poll for the end of a program. Usually its closing pipes report it; not if its own child holds them
/// open, which is rare. If a pipe is closed, the program is about to end, so poll fast.
constexpr milliseconds slow_poll{20}, fast_poll{1};

void check(const RunSettings& settings, const std::vector<Case>& cases) {
  const auto in_range = [](const char* what, auto value, auto low, auto high) {
    if (value < low || value > high)
      throw Error(fmt::format("{}: {} is not allowed; it takes {}..{}", what, value, low, high));
  };
  in_range("workers", settings.workers, 1, 64);
  in_range("driver threads", settings.driver_threads, 0, 32);
  in_range("time limit of a case in milliseconds", settings.case_limit.count(), 1, 86'400'000);
  in_range("time limit of the start in milliseconds", settings.start_limit.count(), 1, 86'400'000);
  in_range("time-outs", settings.max_time_outs, 0, 1'000'000);
  constexpr const char* kinds[] = {"", "osmesa", "egl", "window"};
  if (std::find(std::begin(kinds), std::end(kinds), settings.context) == std::end(kinds))
    throw Error(
        fmt::format("context: '{}' is not allowed; it takes osmesa, egl, window, or nothing", settings.context));
  std::set<std::string> names;
  for (const Case& c : cases)
    if (!names.insert(c.name).second) throw Error(fmt::format("case '{}' appears twice", c.name));
}

/// Waits until a program has written something, a time limit is reached, or the next poll is due.
void wait_for_any(const std::vector<std::unique_ptr<Shard>>& shards) {
  std::vector<pollfd> pipes;
  const auto now = Clock::now();
  auto until = now + slow_poll;
  for (const auto& shard : shards) {
    if (shard->done()) continue;
    for (const int pipe : {shard->worker().progress(), shard->worker().output()}) {
      pipes.push_back({pipe, POLLIN, 0});  // poll ignores -1
      if (pipe < 0) until = std::min(until, now + fast_poll);
    }
    until = std::min(until, shard->deadline());
  }
  const auto left = std::chrono::ceil<milliseconds>(until - Clock::now());
  ::poll(pipes.data(), pipes.size(), static_cast<int>(std::max(left, milliseconds(0)).count()));
}

/// Distributes the cases to at most `workers` shards, none of them empty. Consecutive cases with the same scene stay
/// together, because the first case of a scene takes about three times as long as a further one: it makes the scene and
/// compiles its shaders. But no shard may get far ahead of the one with the least work, so that all end together.
std::vector<std::deque<std::size_t>> distribute(const std::vector<Case>& cases, const std::vector<std::size_t>& order,
                                                std::size_t workers) {
  constexpr int first_of_scene = 3, one_more = 1, max_ahead = 6;
  struct Load {
    std::deque<std::size_t> cases;
    int work = 0;
  };
  std::vector<Load> loads(std::min(workers, cases.size()));
  const auto ends_with_scene_of = [&](const Load& load, std::size_t index) {
    return !load.cases.empty() && cases[load.cases.back()].scene == cases[index].scene;
  };
  Load* last = nullptr;
  for (const std::size_t index : order) {
    const auto least =
        std::min_element(loads.begin(), loads.end(), [](const Load& a, const Load& b) { return a.work < b.work; });
    const bool stays = last && ends_with_scene_of(*last, index) && last->work < least->work + max_ahead &&
                       last->cases.size() * loads.size() < cases.size();
    if (!stays) last = &*least;
    last->work += ends_with_scene_of(*last, index) ? one_more : first_of_scene;
    last->cases.push_back(index);
  }
  std::vector<std::deque<std::size_t>> shards;
  for (Load& load : loads)
    if (!load.cases.empty()) shards.push_back(std::move(load.cases));
  return shards;
}

}  // namespace

std::vector<std::size_t> case_order(std::size_t count, std::optional<std::uint64_t> seed) {
  if (seed) return shuffled_order(count, *seed);
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t(0));
  return order;
}

std::vector<Answer> run_cases(const RunSettings& settings, const std::vector<Case>& cases, const OnAnswer& on_answer) {
  check(settings, cases);
  if (!settings.shader_cache.empty()) {
    std::error_code error;
    fs::create_directories(settings.shader_cache, error);
    if (error) throw Error(fmt::format("{}: cannot be created: {}", settings.shader_cache.string(), error.message()));
  }
  std::vector<Answer> answers(cases.size());
  const auto deliver = [&](std::size_t index, Answer answer) {
    answers[index] = std::move(answer);
    if (on_answer) on_answer(index, answers[index]);
  };

  const auto indices =
      distribute(cases, case_order(cases.size(), settings.shuffle), static_cast<std::size_t>(settings.workers));
  const fs::path disk = temporary_parent();
  require_space(disk, working_space);
  int time_outs = 0;
  std::vector<std::unique_ptr<Shard>> shards;
  for (const std::deque<std::size_t>& waiting : indices)
    shards.push_back(std::make_unique<Shard>(settings, cases, waiting, time_outs, deliver));
  const auto done = [](const auto& shard) { return shard->done(); };
  while (!std::all_of(shards.begin(), shards.end(), done)) {
    wait_for_any(shards);
    if (settings.interrupted && settings.interrupted()) throw Interrupted();
    for (const auto& shard : shards)
      if (!shard->done()) shard->advance();
  }
  const auto is_normal = [](const Answer& answer) { return answer.ended == Answer::Ended::normally; };
  if (!std::all_of(answers.begin(), answers.end(), is_normal)) require_space(disk, min_free_space);
  return answers;
}

}  // namespace atelier::judge
