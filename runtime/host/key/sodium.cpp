#include <dlfcn.h>

#include <runtime/host/base/look_up.hpp>
#include <runtime/host/key/sodium.hpp>

namespace eagerx::key {
namespace {

/// Both Debians have this name; another one has other functions.
constexpr const char* kSodium = "libsodium.so.23";

bool look_up_sodium(void* library, Functions& f) {
  return look_up(library, "sodium_init", f.init) &&
         look_up(library, "crypto_kx_keypair", f.kx_keypair) &&
         look_up(library, "crypto_kx_client_session_keys", f.kx_client_session_keys) &&
         look_up(library, "crypto_kx_server_session_keys", f.kx_server_session_keys) &&
         look_up(library, "crypto_generichash", f.generichash) &&
         look_up(library, "crypto_secretstream_xchacha20poly1305_init_push", f.init_push) &&
         look_up(library, "crypto_secretstream_xchacha20poly1305_push", f.push) &&
         look_up(library, "crypto_secretstream_xchacha20poly1305_init_pull", f.init_pull) &&
         look_up(library, "crypto_secretstream_xchacha20poly1305_pull", f.pull) &&
         look_up(library, "crypto_secretstream_xchacha20poly1305_statebytes", f.state_bytes) &&
         look_up(library, "crypto_secretstream_xchacha20poly1305_headerbytes", f.head_bytes) &&
         look_up(library, "crypto_secretstream_xchacha20poly1305_abytes", f.seal_bytes);
}

}  // namespace

const Functions* sodium(std::string& problem) {
  static Functions functions;
  static const bool found = [] {
    void* const opened = dlopen(kSodium, RTLD_NOW | RTLD_LOCAL);
    return opened != nullptr && look_up_sodium(opened, functions) && functions.init() >= 0 &&
           functions.state_bytes() == sizeof(StreamState) && functions.head_bytes() == kHeadBytes &&
           functions.seal_bytes() == kSealBytes;
  }();
  if (!found)
    problem = "a key needs the library libsodium, `" + std::string(kSodium) +
              "`\nhelp: apt install libsodium23";
  return found ? &functions : nullptr;
}

}  // namespace eagerx::key
