// The states that a loop's header can have.
#include <algorithm>
#include <tuple>

#include "generator/analysis/bound/walk.hpp"

namespace eagerx::gen::bound {

/// Forgets the limits of numbers that the loop makes anew, and by such.
void Walk::forget_limits(LoopIndex l, State& state) const {
  state.limits.erase_if([&](const auto& limit) {
    return is_made_in(l, limit.first) || is_made_in(l, limit.second.base);
  });
}

/// The header's state where all that may change is a number of its own.
State Walk::open_header(LoopIndex l, const State& in, const Locations& fixed) {
  State header = in;
  forget_limits(l, header);
  const Address at = address(flow_.loops[l].header);
  for (const Location& where : in.locations()) {
    if (!fixed.contains(where)) header.set(where, {base_of(Origin::header, at, where), 0, 0});
  }
  header.comparison.reset();
  header.choice.reset();
  if (const auto found = escapes_.find(l); found != escapes_.end()) {
    header.escaped = std::min(header.escaped, found->second.first);
    header.arguments_escaped |= found->second.second;
  }
  return header;
}

/// Numbers, or pointers into the same object, which may grow by the same in each turn.
Walk::Ties Walk::likely_ties(const State& in, const Locations& fixed) const {
  std::vector<std::pair<Base, Location>> all;
  for (const Location& where : in.locations()) {
    const Value& value = *in.find(where);
    if (!fixed.contains(where) && value.is_exact()) all.emplace_back(value.base, where);
  }
  std::ranges::sort(all);
  Ties ties;
  for (std::size_t i = 1, first = 0; i < all.size(); ++i) {
    if (all[i].first == all[first].first)
      ties[all[i].second] = all[first].second;
    else
      first = i;
  }
  return ties;
}

/// Those of the locations that are as far from each other after a turn as they are at first.
Walk::Ties Walk::kept_ties(const Ties& ties, const State& in, const State& latch) {
  std::set<Location> all;
  for (const auto& [where, first] : ties) all.insert({where, first});
  Ties kept;
  std::map<std::tuple<Base, Base, std::int64_t>, Location> firsts;
  for (const Location& where : all) {
    const Value &before = *in.find(where), *after = latch.find(where);
    if (after == nullptr || !after->is_exact()) continue;
    const auto [first, is_new] =
        firsts.emplace(std::tuple(before.base, after->base, after->low - before.low), where);
    if (!is_new) kept[where] = first->second;
  }
  return kept;
}

/// Whether all are as far from each other after a turn as they are at first.
bool Walk::hold(const Ties& ties, const State& in, const State& latch) {
  return std::ranges::all_of(ties, [&](const auto& tie) {
    const Value *a = latch.find(tie.first), *b = latch.find(tie.second);
    if (a == nullptr || b == nullptr || a->base != b->base || !a->is_exact() || !b->is_exact())
      return false;
    return a->low - b->low == in.find(tie.first)->low - in.find(tie.second)->low;
  });
}

/// All become the number of another location, plus the distance from it.
void Walk::tie(LoopIndex l, const State& in, const Ties& ties, State& header) const {
  const Address at = address(flow_.loops[l].header);
  for (const auto& [where, first] : ties) {
    const std::int64_t distance = in.find(where)->low - in.find(first)->low;
    header.set(where, {base_of(Origin::header, at, first), distance, distance});
  }
}

Walk::Changes Walk::changes(LoopIndex l, const State& in, const State& header, const State& latch,
                            const Locations& fixed) const {
  Changes result;
  const Address at = address(flow_.loops[l].header);
  for (const Location& where : in.locations()) {
    const Value *after = latch.find(where), *before = header.find(where);
    if (after == nullptr || before == nullptr) continue;
    if (*after == *before) {
      result.fixed.insert(where);
      continue;
    }
    // A number of the header's own, perhaps that of another location.
    const bool is_own = place_of(before->base) == at;
    if (fixed.contains(where) || !is_own || after->base != before->base) continue;
    result.steps[where] = Value{0, after->low - before->low, after->high - before->high};
  }
  return result;
}

bool Walk::is_made_in(LoopIndex l, Base base) const {
  const std::span<const Base> parts = analysis_.sums_.parts(base);
  if (!parts.empty())
    return std::ranges::any_of(parts, [&](Base part) { return is_made_in(l, part); });
  const auto place = place_of(base);
  if (!place) return false;
  const std::vector<Address>& addresses = flow_.loops[l].addresses;
  if (addresses.empty() || *place < addresses.front() || *place > addresses.back()) return false;
  return std::ranges::binary_search(addresses, *place);
}

/// The header's state in all turns, or in the last one.
State Walk::running_header(LoopIndex l, const State& in, const Changes& changes, const Ties& ties,
                           const Enumerated& turns, bool last) {
  State header = open_header(l, in, changes.fixed);
  tie(l, in, ties, header);
  if (!turns.count) return header;
  const Address at = address(flow_.loops[l].header);
  const auto count =
      static_cast<std::int64_t>(std::min<std::uint64_t>(turns.count->most - 1, INT32_MAX));
  for (const auto& [where, step] : changes.steps) {
    const std::int64_t down = step.low * count, up = step.high * count;
    if (last) {
      if (const auto value = sum(*in.find(where), {0, down, up}, 1)) header.set(where, *value);
      continue;
    }
    const Base own = base_of(Origin::header, at, where);
    const Value way{0, std::min<std::int64_t>(down, 0), std::max<std::int64_t>(up, 0)};
    const auto value = sum(*in.find(where), way, 1);
    if (value && header.find(where)->base == own) header.limits[own] = *value;
  }
  if (last) return header;
  for (const auto& [where, range] : turns.ranges) {
    const Base own = base_of(Origin::header, at, where);
    if (!changes.steps.contains(where) && header.find(where)->base == own)
      header.limits[own] = range;
  }
  return header;
}

/// What is known of each location in one more turn: numbers.
void Walk::widen(FlatMap<Location, Value>& ranges, const State& header, bool is_first) {
  for (const Location& where : header.locations()) {
    const Value value = header.resolve(*header.find(where));
    if (is_first && value.base == 0) ranges[where] = value;
    if (!ranges.contains(where)) continue;
    Value& range = ranges[where];
    range = {0, std::min(range.low, value.low), std::max(range.high, value.high)};
    if (value.base != 0) ranges.erase(where);
  }
  ranges.erase_if([&](const auto& one) { return header.find(one.first) == nullptr; });
}

}  // namespace eagerx::gen::bound
