// TCP lines between the programs of a split graph: accepted peers, and timeouts.
#pragma once

#include <sys/socket.h>

#include <cstdint>
#include <runtime/host/key/session.hpp>
#include <string>

namespace eagerx::linux_sim {

/// The requirements of a program that uses a key.
struct KeyInUse {
  const key::Functions* sodium = nullptr;  // null: there is no key
  key::Key key{};
};

/// Whether only this machine can be at the other end.
bool is_of_this_machine(const sockaddr* address);
/// "127.0.0.1:5000", of this end.
std::string address_of_end(int file);
/// Whether `address` has the form of HOST:PORT.
bool is_tcp_address(const std::string& address);

inline constexpr const char* kNeedsKey =
    "beyond this machine TCP needs a key\n"
    "help: `eagerx-gen key new FILE` writes one; both sides take it with `--key FILE`";

/// Connects the non-blocking socket `file` until `until_ns` of CLOCK_MONOTONIC. Returns errno.
int connect_until(int file, const sockaddr* address, socklen_t size, std::uint64_t until_ns);

/// The greeting of the connecting side. Empty, and `records` is open; or the problem.
std::string greet(int file, const KeyInUse& key, std::uint64_t until_ns, key::Records& records);

/// Waits until `until_ns` for a peer that has the key; others are dropped, and have no longer than
/// `greeting_s`. Returns its socket, or -1: errno says why. `say` receives notes about strangers.
int accept_known(int listener, const KeyInUse& key, int greeting_s, std::uint64_t until_ns,
                 void (*say)(const std::string& text), key::Records& records);

}  // namespace eagerx::linux_sim
