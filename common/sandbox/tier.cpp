#include "sandbox/tier.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/process.hpp"
#include "sandbox/sandbox.hpp"

namespace atelier::sandbox {
namespace {

/// Why nothing can be run in this tier; empty if it can.
std::string try_tier(Tier tier) {
  try {
    const Sandbox sandbox(tier);
    Confined confined = sandbox.confine({.arguments = {"/usr/bin/true"}, .environment = {{}}}, {});
    const Finished done = run_process(
        {.arguments = confined.launch.arguments, .environment = {{}}, .descriptors = confined.launch.descriptors});
    if (!confined.was_started()) return failure_of_sandbox(done.output);
    return done.ok() ? "" : fmt::format("a program that does nothing ends with status {} in it", done.exit_status);
  } catch (const Error& error) {
    return error.what();
  }
}

}  // namespace

std::string to_string(Tier tier) {
  switch (tier) {
    case Tier::full:
      return "full";
    case Tier::account:
      return "account";
    default:
      return "none";
  }
}

std::optional<Tier> tier_named(std::string_view name) {
  for (const Tier tier : {Tier::none, Tier::account, Tier::full})
    if (name == to_string(tier)) return tier;
  return std::nullopt;
}

Possible find_possible_tiers() {
  Possible possible{.why_not_full = try_tier(Tier::full), .why_not_account = try_tier(Tier::account)};
  if (possible.why_not_full.empty())
    possible.best = Tier::full;
  else if (possible.why_not_account.empty())
    possible.best = Tier::account;
  return possible;
}

Tier choose_tier(const Possible& possible, const std::string& asked) {
  const auto refuse = [&](const std::string& why) {
    throw Error(
        fmt::format("--sandbox {}: does not work here: {}. Install bubblewrap where user namespaces are "
                    "permitted, or grade as root; --sandbox none runs strangers' code with your own rights",
                    asked, why));
  };
  if (asked == "best") {
    if (possible.best == Tier::none)
      refuse(fmt::format("full: {}; account: {}", possible.why_not_full, possible.why_not_account));
    return possible.best;
  }
  const std::optional<Tier> tier = tier_named(asked);
  if (!tier) throw Error(fmt::format("--sandbox {}: it takes best, full, account or none", asked));
  if (*tier == Tier::full && !possible.why_not_full.empty()) refuse(possible.why_not_full);
  if (*tier == Tier::account && !possible.why_not_account.empty()) refuse(possible.why_not_account);
  return *tier;
}

}  // namespace atelier::sandbox
