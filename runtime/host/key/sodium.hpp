// libsodium, where it is installed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace eagerx::key {

// Of libsodium's headers, version 1.0.18: Debian 12 and 13. They are not needed where a program is
// built, and the library not where no key is used. The unit test compares them with the headers.

inline constexpr std::size_t kPublicBytes = 32;  // crypto_kx_PUBLICKEYBYTES
inline constexpr std::size_t kSecretBytes = 32;  // crypto_kx_SECRETKEYBYTES
inline constexpr std::size_t kSharedBytes = 32;  // crypto_kx_SESSIONKEYBYTES
inline constexpr std::size_t kStreamKeyBytes =
    32;                                        // crypto_secretstream_xchacha20poly1305_KEYBYTES
inline constexpr std::size_t kHeadBytes = 24;  // crypto_secretstream_xchacha20poly1305_HEADERBYTES
inline constexpr std::size_t kSealBytes = 17;  // crypto_secretstream_xchacha20poly1305_ABYTES
inline constexpr std::uint8_t kTagMessage = 0;
inline constexpr std::uint8_t kTagFinal = 3;  // nothing comes after it

/// crypto_secretstream_xchacha20poly1305_state
struct StreamState {
  std::uint8_t key[kStreamKeyBytes];
  std::uint8_t nonce[12];
  std::uint8_t pad[8];
};

using Size = unsigned long long;  // NOLINT(google-runtime-int): as libsodium has it

/// 0: done, -1: refused.
struct Functions {
  int (*init)();
  int (*kx_keypair)(std::uint8_t* open, std::uint8_t* secret);
  int (*kx_client_session_keys)(std::uint8_t* in, std::uint8_t* out, const std::uint8_t* own_open,
                                const std::uint8_t* own_secret, const std::uint8_t* other);
  int (*kx_server_session_keys)(std::uint8_t* in, std::uint8_t* out, const std::uint8_t* own_open,
                                const std::uint8_t* own_secret, const std::uint8_t* other);
  int (*generichash)(std::uint8_t* out, std::size_t out_size, const std::uint8_t* bytes, Size size,
                     const std::uint8_t* key, std::size_t key_size);
  int (*init_push)(StreamState* state, std::uint8_t* head, const std::uint8_t* key);
  int (*push)(StreamState* state, std::uint8_t* sealed, Size* sealed_size,
              const std::uint8_t* bytes, Size size, const std::uint8_t* also, Size also_size,
              std::uint8_t tag);
  int (*init_pull)(StreamState* state, const std::uint8_t* head, const std::uint8_t* key);
  int (*pull)(StreamState* state, std::uint8_t* bytes, Size* size, std::uint8_t* tag,
              const std::uint8_t* sealed, Size sealed_size, const std::uint8_t* also,
              Size also_size);
  std::size_t (*state_bytes)();
  std::size_t (*head_bytes)();
  std::size_t (*seal_bytes)();
};

/// Null and a `problem` if the library is missing.
const Functions* sodium(std::string& problem);

}  // namespace eagerx::key
