// Permissions to read a run and to change it.
#pragma once

#include <runtime/host/web_socket/web_socket.hpp>
#include <string>
#include <string_view>

namespace eagerx::foxglove {

using web_socket::Handshake;

/// Reads `--publish-key`: a file that only its owner can read, with a key of 16 to 512 printable
/// characters in its first line. Empty, or the problem.
std::string read_key(const std::string& path, std::string& key);

/// Takes as long for a wrong text as for the right one of its length.
bool is_key(std::string_view presented, std::string_view key);

/// Whether a page is Foxglove's, or of this machine.
bool is_known_origin(std::string_view origin);

struct Access {
  std::string key;  // empty: there is none
  bool is_loopback = true;
  bool is_real = false;
  std::string only_host = {};  // only a page of this `HOST:PORT`, and only with the key; empty: no

  /// The page of `only_host`, for a client that has called it by that name.
  bool may_see(const Handshake& who) const {
    return !only_host.empty() && who.host == only_host && is_right(who);
  }

  /// A wrong key is rejected; without a key, everyone may read.
  bool may_read(const Handshake& who) const {
    if (!only_host.empty())
      return is_right(who) && (who.origin.empty() || who.origin == "http://" + only_host);
    return who.key.empty() || is_right(who);
  }
  /// With a key, its holders. Without one, programs and known pages of this machine, unless
  /// hardware moves.
  bool may_change(const Handshake& who) const {
    if (!key.empty()) return is_right(who);
    return is_loopback && !is_real && (who.origin.empty() || is_known_origin(who.origin));
  }

 private:
  bool is_right(const Handshake& who) const { return !key.empty() && is_key(who.key, key); }
};

}  // namespace eagerx::foxglove
