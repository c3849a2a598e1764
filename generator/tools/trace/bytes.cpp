#include "generator/tools/trace/bytes.hpp"

#include <zlib.h>

namespace eagerx::gen {

std::uint32_t crc32_of(std::string_view bytes) {
  return static_cast<std::uint32_t>(
      crc32_z(0, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()));
}

}  // namespace eagerx::gen
