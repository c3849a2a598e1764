// PNG files of drawings: the same bytes on every machine, and no library.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace eagerx::linux_sim {

/// A PNG of red, green, blue; `pixels` has 3 bytes each, row by row from the top. Compressed as
/// runs and repetitions of the row above (deflate with fixed codes), which fits drawings: 5 to 20
/// kB for 480x480.
std::string png_of(const std::uint8_t* pixels, int width, int height);

}  // namespace eagerx::linux_sim
