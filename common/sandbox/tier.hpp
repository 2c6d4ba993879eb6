// How well a program can be confined on this machine.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace atelier::sandbox {

enum class Tier {
  none,     ///< with the rights of the account that grades
  account,  ///< an account of its own, Landlock, a filter of system calls, limits; needs root
  full,     ///< also its own file system, processes and network (bubblewrap)
};

std::string to_string(Tier tier);
std::optional<Tier> tier_named(std::string_view name);

/// What is possible here.
struct Possible {
  Tier best = Tier::none;
  std::string why_not_full, why_not_account;  ///< empty if it is possible
};

/// Tries each tier on a program that does nothing: about 30 ms.
Possible find_possible_tiers();

/// The tier named `asked`, or with "best" the best one, which must not be none. Throws Error for another name, and if
/// the tier does not work here, saying why and what to do.
Tier choose_tier(const Possible& possible, const std::string& asked);

}  // namespace atelier::sandbox
