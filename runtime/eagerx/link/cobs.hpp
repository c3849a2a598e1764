// Consistent overhead byte stuffing: frames without a zero in them, so that a zero ends a frame.
// Source: Cheshire, Baker, "Consistent Overhead Byte Stuffing", IEEE/ACM ToN 7(2), 1999.
#pragma once

#include <cstddef>
#include <cstdint>

namespace eagerx::link {

inline constexpr std::size_t kCobsRun = 254;  // most bytes after one length byte

/// Maximum encoded size of `size` bytes, without the final zero.
constexpr std::size_t cobs_bound(std::size_t size) {
  return size + size / kCobsRun + 1;
}

/// Calls put(byte) for each byte of the encoded form, without the zero that ends it.
template <class Put>
constexpr void cobs_encode(const std::uint8_t* bytes, std::size_t size, Put&& put) {
  std::size_t begin = 0;
  for (;;) {
    std::size_t end = begin;
    while (end < size && end - begin < kCobsRun && bytes[end] != 0) ++end;
    put(static_cast<std::uint8_t>(end - begin + 1));
    for (std::size_t i = begin; i < end; ++i) put(bytes[i]);
    if (end == size) return;
    begin = end - begin == kCobsRun ? end : end + 1;  // a full run stands for no zero
  }
}

/// Decodes `size` bytes without zeros in place. Returns the new size, or `size` itself, which is
/// impossible for a valid frame, if the bytes are not an encoded frame.
constexpr std::size_t cobs_decode(std::uint8_t* bytes, std::size_t size) {
  std::size_t in = 0;
  std::size_t out = 0;
  while (in < size) {
    const std::size_t run = bytes[in++];
    if (run == 0 || run - 1 > size - in) return size;
    for (std::size_t i = 1; i < run; ++i) bytes[out++] = bytes[in++];
    if (run <= kCobsRun && in < size) bytes[out++] = 0;
  }
  return out;
}

}  // namespace eagerx::link
