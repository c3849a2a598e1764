#include <sha2.h>  // of libmd, which every Debian has, for dpkg needs it

#include <array>

#include "generator/support/json/base64.hpp"
#include "generator/tools/page/page.hpp"

namespace eagerx::gen {

std::string sha256_base64(std::string_view text) {
  SHA2_CTX state;
  std::array<std::uint8_t, SHA256_DIGEST_LENGTH> digest{};
  SHA256Init(&state);
  SHA256Update(&state, reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
  SHA256Final(digest.data(), &state);
  return base64({reinterpret_cast<const char*>(digest.data()), digest.size()});
}

}  // namespace eagerx::gen
