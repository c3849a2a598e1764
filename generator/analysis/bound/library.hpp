// Loops of the C library and of the compiler's own library, whose sources carry no notes.
#pragma once

#include <cstdint>
#include <map>

#include "generator/analysis/bound/image.hpp"

namespace eagerx::gen::bound {

/// A loop turns at most `most` times, and once more for each `bytes_a_turn` of the third argument.
struct LibraryLoop {
  Address function = 0;
  std::uint32_t most = 0;
  std::uint32_t bytes_a_turn = 0;  // 0: whatever the arguments are
  bool is_of_denormal = false;     // it is entered for a denormal number only
};

/// By the addresses of their headers: the loops of those functions of `image` whose code is the
/// code that was read, byte by byte. In others none.
std::map<Address, LibraryLoop> library_loops(const Image& image);

}  // namespace eagerx::gen::bound
