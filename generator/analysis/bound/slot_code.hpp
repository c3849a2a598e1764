// Whether the code of each kind of slot can be distinguished from that of the others.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "generator/analysis/bound/regions.hpp"

namespace eagerx::gen::bound {

/// One half of a kind of slot: before the environment's action, or after it.
struct SlotCode {
  std::optional<std::uint64_t> due;  // the kind; nullopt: any
  bool is_after = false;
  std::vector<Region> regions;
};

/// Whether the compiler gave several kinds of slots the same code: it joined the same ends of two,
/// moved what they begin with to before their `switch`, or made one function of two. Its lines then
/// name one of the kinds, whose bound has what the others run too.
bool is_shared(Analysis& analysis, const std::vector<SlotCode>& slots);

}  // namespace eagerx::gen::bound
