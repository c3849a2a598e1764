// Evaluates files that take a sequence of any length, with an initial state of zero, one step at a
// time: cells keep the state. The result is the same if no other operator mixes steps. To check
// this, this file tracks the time axis, which has size 1 here and cannot be recognized by shapes.
#pragma once

#include <cstdint>
#include <optional>

#include "generator/policy/network/graph/call.hpp"

namespace eagerx::gen {

using TimeMask = std::uint32_t;  // bit i: axis i may be the time

/// Where the time is in `result`; nothing where steps would be mixed, picked or lost.
using NetTimeRule = std::optional<TimeMask> (*)(const NetCall& call, const NetValue& result);

/// All inputs number by number, with axes that are counted from the back. A value of the last step
/// and one of each do not go together.
std::optional<TimeMask> time_of_each(const NetCall& call, const NetValue& result);
/// The same axes, if the last one or the channels are not the time.
std::optional<TimeMask> time_but_last(const NetCall& call, const NetValue& result);
std::optional<TimeMask> time_but_channels(const NetCall& call, const NetValue& result);
/// Images one by one.
std::optional<TimeMask> time_of_image(const NetCall& call, const NetValue& result);
/// Without the axes of the call, which are not the time.
std::optional<TimeMask> time_of_reduce(const NetCall& call, const NetValue& result);
std::optional<TimeMask> time_of_squeeze(const NetCall& call, const NetValue& result);
std::optional<TimeMask> time_of_unsqueeze(const NetCall& call, const NetValue& result);
/// Cells run along it.
std::optional<TimeMask> time_of_cell(const NetCall& call, const NetValue& result);

TimeMask time_bit(std::int64_t axis);
bool has_time(TimeMask mask, std::int64_t axis);
TimeMask without_axis(TimeMask mask, std::int64_t axis);
std::int64_t rank_of(const NetValue& value);
std::int64_t from_front(std::int64_t axis, std::int64_t rank);
/// The axes of `x`, if `axis` is not the time.
std::optional<TimeMask> time_unless(const NetValue& x, std::int64_t axis);

/// `value`, a result of the call, with its axis of time by `rule`; E0613 where steps of a sequence
/// would be mixed, picked or lost.
NetValue along_time(const NetCall& call, NetTimeRule rule, NetValue value);

}  // namespace eagerx::gen
