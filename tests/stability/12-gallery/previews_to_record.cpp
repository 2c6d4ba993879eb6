// previews_to_record: random previews against a search for the next one, versions and ages at the end of their range,
// and any number from 0 on for `most`.
#include <optional>

#include "stability/12-gallery/rows.hpp"

namespace atelier::stability {

using namespace gallery;

namespace {

constexpr std::uint64_t last = std::numeric_limits<std::uint64_t>::max();

/// The contract, one preview after the other: of those that are left, the one before which no other comes.
std::vector<int> exact_order(const std::vector<PreviewState>& previews, int most) {
  std::vector<int> order;
  std::vector<bool> taken(previews.size(), false);
  while (int(order.size()) < most) {
    std::optional<std::size_t> next;
    for (std::size_t i = 0; i < previews.size(); ++i) {
      const PreviewState& p = previews[i];
      if (taken[i] || !p.visible || (p.recorded && p.recorded_of == p.version)) continue;
      const bool sooner =
          !next || (previews[*next].recorded && (!p.recorded || p.frames_since > previews[*next].frames_since));
      if (sooner) next = i;
    }
    if (!next) break;
    taken[*next] = true;
    order.push_back(int(*next));
  }
  return order;
}

/// One of few numbers, so that many are equal, those at both ends of the range among them.
std::uint64_t some_number(Trial& t) {
  const std::uint64_t numbers[] = {0, 1, 2, last / 2, last / 2 + 1, last - 1, last};
  return numbers[int(t.between(0, 7))];
}

std::vector<PreviewState> some_previews(Trial& t, int count) {
  std::vector<PreviewState> previews(std::size_t(count), PreviewState{});
  for (PreviewState& p : previews) {
    p.visible = t.between(0, 1) < 0.8;
    p.recorded = t.between(0, 1) < 0.7;
    p.version = some_number(t), p.recorded_of = some_number(t), p.frames_since = some_number(t);
  }
  return previews;
}

Values order_of(const std::vector<PreviewState>& previews, int most) {
  Values order;
  for (const int i : previews_to_record(previews, most)) order.push_back(i);
  return order;
}

/// In view, and shows another version.
PreviewState old_one(std::uint64_t age) {
  return {.visible = true, .version = 1, .recorded = true, .recorded_of = 0, .frames_since = age};
}

/// In view and never recorded; the rest means nothing then.
PreviewState new_one(std::uint64_t version, std::uint64_t of, std::uint64_t age) {
  return {.visible = true, .version = version, .recorded = false, .recorded_of = of, .frames_since = age};
}

/// In view, recorded.
PreviewState with_versions(std::uint64_t version, std::uint64_t of) {
  return {.visible = true, .version = version, .recorded = true, .recorded_of = of, .frames_since = 3};
}

}  // namespace

void add_schedule_rows(Table& table) {
  Group group = table.of("previews_to_record");
  for (const int count : {1, 6, 30})
    for (const int most : {0, 1, 3, largest_int})
      group.equals(fmt::format("1000 lists of {} previews, at most {}: others", count, most),
                   [=] {
                     return Values{worst_of(1000, 2110, [=](Trial& t) {
                       const std::vector<PreviewState> previews = some_previews(t, count);
                       return double(previews_to_record(previews, most) != exact_order(previews, most));
                     })};
                   },
                   {0});
  for (const int most : {0, 1, largest_int})
    group.equals(fmt::format("no previews, at most {}", most), [=] { return order_of({}, most); }, {});
  group.equals("versions 0 and 2^64 - 1, older and newer: whatever is not equal is recorded",
               [] {
                 return order_of({with_versions(0, last), with_versions(last, 0), with_versions(last, last),
                                  with_versions(last, last - 1), with_versions(0, 0)},
                                 9);
               },
               {0, 1, 3});
  group.equals(
      "ages up to 2^64 - 1: the longest first",
      [] {
        return order_of(
            {old_one(0), old_one(last / 2), old_one(last), old_one(last / 2 + 1), old_one(1), old_one(last - 1)}, 9);
      },
      {2, 5, 3, 1, 4, 0});
  group.equals("never recorded: neither versions nor ages matter, and they come before an age of 2^64 - 1",
               [] {
                 return order_of({old_one(last), new_one(5, 5, 0), new_one(0, 0, last), new_one(last, 0, 7)}, 9);
               },
               {1, 2, 3, 0});
  group.equals("not in view, never recorded, at most 9",
               [] {
                 PreviewState hidden = new_one(1, 0, last);
                 hidden.visible = false;
                 return order_of({hidden, hidden}, 9);
               },
               {});
  group.equals("10000 equal ones, at most 9999: those that are not at their own place",
               [] {
                 const std::vector<int> order =
                     previews_to_record(std::vector<PreviewState>(10'000, old_one(last)), 9999);
                 double wrong = std::abs(double(order.size()) - 9999);
                 for (std::size_t i = 0; i < order.size(); ++i) wrong += order[i] != int(i);
                 return Values{wrong};
               },
               {0});
}

}  // namespace atelier::stability
