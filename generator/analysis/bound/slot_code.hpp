// The code of each kind of slot, with what it shares with others.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <vector>

#include "generator/analysis/bound/regions.hpp"

namespace eagerx::gen::bound {

/// One half of a kind of slot: before the environment's action, or after it.
struct SlotCode {
  std::optional<std::uint64_t> due;  // the kind; nullopt: any
  bool is_after = false;
  std::vector<Region> regions;
};

/// Compilers give several kinds of slots the same code: they join the same ends of two, move what
/// they begin with to before their `switch`, or make one function of two. The lines of such code
/// name one of the kinds. This adds it to all that may run it, so that each has a bound. Returns
/// the code that also runs where no slot of its kind is due, and so belongs to the schedule, too.
std::set<Address> share(Analysis& analysis, std::vector<SlotCode>& slots);

}  // namespace eagerx::gen::bound
