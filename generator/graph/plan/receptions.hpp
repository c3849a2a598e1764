// Windows, delays and rings of one connection.
#pragma once

#include <optional>

#include "generator/graph/plan/plan.hpp"

namespace eagerx::gen {

/// The relation of two nodes.
struct ReceptionEnds {
  Rational source_rate_hz, rate_hz;
  bool source_first = true;   // of a slot in which both are due
  bool asynchronous = false;  // the reader goes by the clock
};

/// How `input` of a node counts the messages of its source; its ring is left to the caller.
/// Problems are reported.
std::optional<Reception> plan_reception(const Input& input, const ReceptionEnds& ends,
                                        Diagnostics& diagnostics);

}  // namespace eagerx::gen
