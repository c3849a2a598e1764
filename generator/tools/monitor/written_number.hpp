// Numbers of messages, formatted as in traces. Inside monitor/ only.
#pragma once

#include <cstdint>
#include <runtime/host/trace/log_file.hpp>

namespace eagerx::gen {

/// The number that is written: of a float32 the double with the same digits, as JSON has.
double written_number(trace_log::Dtype dtype, std::uint64_t bits);

}  // namespace eagerx::gen
