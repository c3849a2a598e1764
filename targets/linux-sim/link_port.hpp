// A line of bytes to the other program of a split graph: a serial line, or a socket.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <eagerx/link/board.hpp>
#include <runtime/host/key/session.hpp>
#include <string>
#include <targets/linux-sim/link_tcp.hpp>

namespace eagerx::linux_sim {

/// Reads and writes without allocation. A closed line stays closed. TCP beyond this machine needs a
/// key; with a key, TCP traffic is sealed, and a peer without the key is dropped.
class LinkPort {
 public:
  LinkPort() = default;
  LinkPort(const LinkPort&) = delete;
  LinkPort& operator=(const LinkPort&) = delete;
  ~LinkPort() { close(); }

  /// Before open() or listen(). Serial lines and unix sockets do without.
  void use_key(const KeyInUse& key) { key_ = key; }
  /// `unix:PATH`, `HOST:PORT`, or the path of a serial line or a socket. A serial line is opened
  /// exclusively. An open line is closed first. False: see error().
  bool open(const std::string& address, std::uint32_t baud);
  /// The listening side of a socket: waits for one peer, which must send something within
  /// kGreetingS. While it is connected, others are refused. With a key, peers without it are
  /// dropped. `:PORT` listens on this machine only. Leaves a socket of another listening program
  /// alone. Calls `say(text)` with the address, and for silent peers.
  bool listen(const std::string& address, void (*say)(const std::string& text));
  /// For listen(): a peer that is gone without a word, as when its cable is cut, is gone after
  /// kCutS; and no wait is longer than `most_wait_ns`.
  void notice_cuts(std::uint64_t most_wait_ns) {
    notices_cuts_ = true;
    most_wait_ns_ = most_wait_ns;
  }
  void close();
  /// Empty while the line works.
  const std::string& error() const { return error_; }

  /// Whether it was closed because bytes on a sealed line were not those of the other end.
  bool is_forged() const { return is_forged_; }

  void put(std::uint8_t byte);
  void flush();
  /// Bytes that cannot be written by then are dropped; without it after a second.
  void write_until(std::uint64_t ns) { write_until_ns_ = ns; }
  /// The next byte; link::kNothing when it is `until_ns` on the clock, link::kClosed.
  int get(std::uint64_t until_ns);
  /// The next byte, or link::kClosed.
  int get() { return get(UINT64_MAX); }
  /// CLOCK_MONOTONIC.
  static std::uint64_t now_ns();
  /// Whether the run must end. A program that must pause (Ctrl-Z) does so in this function.
  static bool is_interrupted();

  static constexpr int kGreetingS = 5;
  static constexpr int kCutS = 5;

 private:
  using Say = void (*)(const std::string& text);
  bool open_tcp(const std::string& address, Say say);
  bool open_unix(const std::string& path, Say say);
  bool open_serial(const std::string& path, std::uint32_t baud);
  bool accept_on(int listener, Say say);
  bool accept_sealed(int listener, Say say);
  bool begin_session();
  void begin_anew();
  std::uint64_t accept_until() const;
  void set_options() const;
  bool wait(short events, std::uint64_t until_ns);
  static bool wait_on(int file, short events, std::uint64_t until_ns);
  std::size_t write_bytes(const std::uint8_t* bytes, std::size_t size, std::uint64_t until_ns);
  bool send_sealed(std::uint64_t until_ns);
  bool open_record();
  void fill();
  bool fail(const std::string& what);

  static constexpr std::size_t kBufferBytes = key::Records::kMostBytes;
  int file_ = -1;
  bool is_serial_ = false, is_forged_ = false, notices_cuts_ = false;
  std::uint64_t write_until_ns_ = UINT64_MAX, most_wait_ns_ = UINT64_MAX;
  std::string error_;
  std::array<std::uint8_t, kBufferBytes> in_{}, out_{};
  std::size_t in_begin_ = 0, in_end_ = 0, out_size_ = 0;
  KeyInUse key_;
  key::Records records_;  // open: the line is sealed
  std::array<std::uint8_t, key::Records::kMostSealed> sealed_{};
  std::size_t sealed_begin_ = 0, sealed_end_ = 0;  // what has yet to go
};

}  // namespace eagerx::linux_sim
