// Plan of a board's telemetry: the messages in each record, how many, and the load of the line.
// runtime/eagerx/link/telemetry.hpp implements it.
#pragma once

#include "generator/graph/plan/plan.hpp"

namespace eagerx::gen {

/// Bytes on the line of a frame with such a payload: two zeros, kind, number, CRC-32C and COBS.
std::uint64_t telemetry_frame_bytes(std::uint64_t payload);

/// Needs channels and rates of the plan. Problems: E0426 it is too much for the line however slow,
/// or a message is longer than a frame.
std::optional<TelemetryPlan> make_telemetry(const Plan& plan, Diagnostics& diagnostics);

}  // namespace eagerx::gen
