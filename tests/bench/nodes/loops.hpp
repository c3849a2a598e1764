// Two programs that call the callbacks of a thousand nodes.
#pragma once

#include <cstdint>

namespace eagerx::bench {

/// `steps` steps of the environment, an even number; any message of the end, so that nothing is
/// left out.
std::uint32_t run_generated(std::uint64_t steps);
std::uint32_t run_by_hand(std::uint64_t steps);

}  // namespace eagerx::bench
