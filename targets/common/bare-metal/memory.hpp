// Registers of peripherals. Drivers of peripherals take the memory as a template parameter, so that
// tests can replace it with one that records accesses.
#pragma once

#include <cstdint>

namespace eagerx::board {

/// 32-bit registers at the addresses in the manual.
// NOLINTBEGIN(performance-no-int-to-ptr)
struct MappedMemory {
  static std::uint32_t read(std::uintptr_t address) {
    return *reinterpret_cast<const volatile std::uint32_t*>(address);
  }
  static void write(std::uintptr_t address, std::uint32_t value) {
    *reinterpret_cast<volatile std::uint32_t*>(address) = value;
  }
};
// NOLINTEND(performance-no-int-to-ptr)

template <class Memory>
void set_bits(std::uintptr_t address, std::uint32_t bits) {
  Memory::write(address, Memory::read(address) | bits);
}
template <class Memory>
void clear_bits(std::uintptr_t address, std::uint32_t bits) {
  Memory::write(address, Memory::read(address) & ~bits);
}
/// The bits of `mask` become those of `value`.
template <class Memory>
void change_bits(std::uintptr_t address, std::uint32_t mask, std::uint32_t value) {
  Memory::write(address, (Memory::read(address) & ~mask) | value);
}
template <class Memory>
bool has_bits(std::uintptr_t address, std::uint32_t bits) {
  return (Memory::read(address) & bits) == bits;
}

}  // namespace eagerx::board
