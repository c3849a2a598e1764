// Windows, delays and rings of one connection.
#pragma once

#include <optional>

#include "generator/plan/plan.hpp"

namespace eagerx::gen {

/// How `input` of a node at `rate_hz` counts messages of a source at `source_rate_hz`; its ring is
/// left to the caller. `needed`: messages that the ring must keep for it; `source_first`: whether
/// the source runs before the node in a slot in which both are due; `asynchronous`: whether it goes
/// by the clock instead. Problems are reported.
std::optional<Reception> plan_reception(const Input& input, const Rational& source_rate_hz,
                                        const Rational& rate_hz, bool source_first,
                                        std::uint64_t& needed, Diagnostics& diagnostics,
                                        bool asynchronous = false);

}  // namespace eagerx::gen
