#include "generator/analysis/bound/library.hpp"

#include <array>
#include <runtime/host/base/hash.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace eagerx::gen::bound {
namespace {

struct Row {
  Address offset = 0;  // of the loop's header from the function
  std::uint32_t most = 0, bytes_a_turn = 0;
  bool is_of_denormal = false;
};

struct LibraryFunction {
  std::string_view name;
  std::uint32_t bytes = 0;
  std::uint64_t hash = 0;  // hash_of() it
  std::vector<Row> loops;
};

/// libgcc's ieee754-df.S and ieee754-sf.S, newlib's e_sqrt.c, ef_sqrt.c, memset.c, memcpy-armv7m.S
/// and memmove.c, as Debian 12 and 13 compile them for v7-m (soft) and v7e-m+fp (hard). A number
/// that is denormal is shifted until its highest bit is in place: 52 or 23 times at most, for it is
/// not 0; by sqrt() 21 bits at a time first. A division makes four bits a turn: 5 turns for the
/// high word of the quotient, 8 for the low one; 6 of a float.
const std::vector<LibraryFunction>& library_functions() {
  static const std::vector<Row> kMemset = {{0x16, 3, 0}, {0x44, 0, 16}, {0x70, 3, 0}, {0x82, 3, 0}};
  static const std::vector<Row> kSqrtOfGcc14 = {{0xd0, 2, 0}, {0xe4, 20, 0}};
  static const std::vector<LibraryFunction> kAll = {
      {"__aeabi_dmul", 596, 0x47882f38ec381bb7U, {{0x1a6, 52, 0, true}, {0x1c6, 52, 0, true}}},
      {"__aeabi_ddiv", 464, 0x711fdbf38e1692f9U, {{0x82, 13, 0}}},
      {"__aeabi_fmul", 360, 0xe01f8b84c35552d3U, {{0xce, 23, 0, true}, {0xe6, 23, 0, true}}},
      {"__aeabi_fdiv",
       310,
       0xdf182ce31006f658U,
       {{0x46, 6, 0}, {0xc2, 23, 0, true}, {0xda, 23, 0, true}}},
      {"__ieee754_sqrt", 408, 0x59a157c16dbf9638U, {{0xd4, 2, 0}, {0x17e, 20, 0}}},
      {"__ieee754_sqrt", 388, 0x13efaa13224cea6U, {{0xd4, 2, 0}, {0x140, 20, 0}}},
      {"__ieee754_sqrt", 484, 0xce5c3b29689092d8U, kSqrtOfGcc14},
      {"__ieee754_sqrt", 464, 0x396052b888ff49f7U, kSqrtOfGcc14},
      {"__ieee754_sqrtf", 174, 0xd53374b7f5386ffbU, {{0x28, 23, 0}}},
      {"__ieee754_sqrtf", 212, 0xb5ca6f23b4db8887U, {{0x9c, 23, 0}}},
      {"memset", 162, 0x8caab2a8f0554b75U, kMemset},
      {"memset", 160, 0xde06bc811463fab4U, kMemset},
      {"memset", 162, 0x7c7e15e62c0d7721U, kMemset},
      {"memset", 160, 0xd2fa95beb0d47f68U, kMemset},
      {"memcpy",
       308,
       0x6094587af927bcedU,
       {{0x10, 0, 64}, {0x98, 3, 0}, {0xc0, 3, 0}, {0x118, 0, 1}}},
      {"memcpy",
       236,
       0x3bbd7ec428f9d521U,
       {{0x10, 0, 16}, {0x5c, 0, 4}, {0x78, 0, 4}, {0xd0, 0, 1}}},
      {"memmove",
       254,
       0xac56c2d8102a3520U,
       {{0x14, 0, 1}, {0x38, 0, 1}, {0x68, 0, 1}, {0xb8, 0, 1}, {0xe2, 0, 1}}},
      {"memmove",
       252,
       0xa2fc9b6943d8448aU,
       {{0x14, 0, 1}, {0x38, 0, 1}, {0x68, 0, 1}, {0xb6, 0, 1}, {0xe0, 0, 1}}}};
  return kAll;
}

/// Bytes of the instruction at an address: four, if it begins with one of three patterns of five
/// bits (DDI 0403E A5.1).
Address size_of_instruction(const Image& image, Address at) {
  constexpr std::uint32_t kLeastOfFour = 0b11101;
  return image.constant(at, 2).value_or(0) >> 11U >= kLeastOfFour ? 4 : 2;
}

/// Of a function's code without what the linker writes into it: calls of other functions and the
/// words between code, which may be addresses, count as zeros. nullopt: the image does not have all
/// of it.
std::optional<std::uint64_t> hash_of(const Image& image, Address at, std::uint32_t size) {
  std::string bytes;
  while (bytes.size() < size) {
    const Address here = at + static_cast<Address>(bytes.size());
    const Instruction* i = image.instruction(here);
    const bool is_fixed =
        i != nullptr && (i->turn != Turn::call || (i->target >= at && i->target < at + size));
    const Address end = here + (i == nullptr ? 1 : size_of_instruction(image, here));
    for (Address byte_at = here; byte_at < end; ++byte_at) {
      const auto byte = image.constant(byte_at, 1);
      if (!byte) return std::nullopt;
      bytes += is_fixed ? static_cast<char>(*byte) : '\0';
    }
  }
  return host::fnv1a(bytes);
}

}  // namespace

std::map<Address, LibraryLoop> library_loops(const Image& image) {
  std::map<Address, LibraryLoop> loops;
  for (const auto& [name, at] : image.addresses()) {
    for (const LibraryFunction& function : library_functions()) {
      if (function.name != name || hash_of(image, at, function.bytes) != function.hash) continue;
      // The header runs once more than the loop turns back.
      for (const Row& row : function.loops)
        loops[at + row.offset] = {at, row.most + 1, row.bytes_a_turn, row.is_of_denormal};
    }
  }
  return loops;
}

}  // namespace eagerx::gen::bound
