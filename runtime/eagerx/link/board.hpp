// The board's end of the link. It only answers requests: it answers each request of the host once
// it needs more messages than it has, and a duplicate with its last answer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/link/frame.hpp>
#include <eagerx/link/stream.hpp>

namespace eagerx::link {

/// `Port` has put(byte), flush(), and get(), which returns a byte, kNothing or kClosed.
inline constexpr int kNothing = -1;
inline constexpr int kClosed = -2;

/// `ToBoard`, `ToHost`: maximum payload of a frame in bytes; longer messages take several frames.
/// All zero at the start. `Depth`: number of stored answers, for a host that sends that many
/// requests before it waits; the `Port` must buffer requests that arrive in the meantime.
template <class Port, std::size_t ToBoard, std::size_t ToHost, std::size_t Depth = 1>
class BoardLink : public Stream<BoardLink<Port, ToBoard, ToHost, Depth>> {
  static_assert(ToBoard >= Greeting::kBytes && ToHost >= Greeting::kBytes && Depth >= 1);

 public:
  Port port;

  /// Sends `status` to the host. If it is not 0, no session begins.
  void identify(Identity identity, std::uint8_t status) {
    identity_ = identity;
    status_ = status;
  }
  /// Waits until a session has begun, or returns immediately if one has just begun; false if the
  /// line is closed.
  bool wait_for_host() {
    while (!greeted_) {
      if (!wait_for_request()) {
        if (closed_) return false;
      }
    }
    greeted_ = false;
    open_ = true;
    return true;
  }
  /// Whether the session continues. A host that restarts ends it.
  bool ok() const { return open_; }
  std::uint32_t damaged() const { return damaged_ + in_.damaged(); }

  [[gnu::noinline]] void put_bytes(const std::uint8_t* bytes, std::size_t size) {
    while (size > 0 && open_) {
      const std::size_t taken = out().append(bytes, size);
      bytes += taken;
      size -= taken;
      if (size > 0) next_request();
    }
  }
  [[gnu::noinline]] bool get_bytes(std::uint8_t* bytes, std::size_t size) {
    while (size > 0 && open_) {
      if (read_ == received_) {
        next_request();
        continue;
      }
      *bytes++ = in_.payload()[read_++];
      --size;
    }
    return open_;
  }

 private:
  /// Answers the current request, and waits for the next one.
  [[gnu::noinline]] void next_request() {
    // Programs of the same graph never answer before they have read everything.
    if (read_ != received_) open_ = false;
    if (open_ && number_ > 0) send(Kind::answer, number_);
    if (!open_ || !wait_for_request()) open_ = false;
    out().clear();
  }

  OutFrame<ToHost>& out() { return out_[number_ % Depth]; }
  /// Whether the answer to the request `number` is still stored.
  bool is_kept(std::uint32_t number) const {
    if (number == 0 || number_ == 0) return false;
    if constexpr (Depth == 1) return number == number_;
    return number <= number_ && number_ - number < Depth;
  }

  /// True for a new request of this session; false for a new session or a closed line.
  [[gnu::noinline]] bool wait_for_request() {
    for (;;) {
      const int byte = port.get();
      if (byte == kClosed) return closed_ = true, false;
      if (byte == kNothing || !in_.take(static_cast<std::uint8_t>(byte))) continue;
      if (in_.kind() == Kind::hello) {
        if (greet()) return false;
      } else if (in_.kind() == Kind::request && in_.intact(crc_start_) && (open_ || greeted_)) {
        if (in_.number() == next_number(number_)) break;
        if (is_kept(in_.number())) put_frame(out_[in_.number() % Depth]);
      } else {
        ++damaged_;
      }
    }
    number_ = next_number(number_);
    read_ = 0;
    received_ = in_.size();
    return true;
  }

  /// True if a new session begins.
  [[gnu::noinline]] bool greet() {
    if (!in_.intact(0) || in_.size() != Greeting::kBytes) return ++damaged_, false;
    const Greeting hello = Greeting::read(in_.payload());
    const bool same = (open_ || greeted_) && hello.session == session_;
    if (same && number_ > 0) return false;  // a late duplicate
    const Greeting welcome{kProtocol, status_, identity_.runtime, identity_.graph, hello.session};
    std::uint8_t bytes[Greeting::kBytes];
    welcome.write(bytes);
    out().clear();
    out().append(bytes, sizeof bytes);
    send(Kind::welcome, 0);
    out().clear();
    if (same) return false;
    session_ = hello.session;
    crc_start_ = welcome.crc_start();
    number_ = 0;
    read_ = received_ = 0;
    open_ = false;
    greeted_ = hello.crc_start() == welcome.crc_start() && status_ == 0;
    return greeted_;
  }

  [[gnu::noinline]] void send(Kind kind, std::uint32_t number) {
    out().seal(kind, number, kind == Kind::welcome ? 0 : crc_start_);
    put_frame(out());
  }
  [[gnu::noinline]] void put_frame(const OutFrame<ToHost>& frame) {
    frame.send([this](std::uint8_t byte) { port.put(byte); });
    port.flush();
  }

  InFrame<ToBoard> in_;
  OutFrame<ToHost> out_[Depth];  // the answer to request N is in N % Depth
  Identity identity_;
  std::size_t read_, received_;  // of the request's payload
  std::uint32_t number_;         // of the request
  std::uint32_t session_;
  std::uint32_t crc_start_;
  std::uint32_t damaged_;
  std::uint8_t status_;
  bool open_, greeted_, closed_;
};

}  // namespace eagerx::link
