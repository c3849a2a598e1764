// Bytes of a client that the library may receive. The library accepts unmasked frames, which RFC
// 6455 (section 5.1) forbids.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace eagerx::web_socket {

class ClientBytes {
 public:
  enum class Answer : std::uint8_t { page, web_socket };

  void add(std::string_view bytes);
  /// Sets the answer to the request; the bytes after it wait until then.
  void answered(Answer with);
  /// Whether it accepts no more bytes before answered().
  bool is_waiting() const { return state_ == State::waits && !held_.empty(); }
  /// A line of the request does not end in CR LF.
  bool is_no_request() const { return state_ == State::no_request; }
  /// A frame was not masked.
  bool is_unmasked() const { return state_ == State::unmasked; }

  std::string passed;  // for the library; empty it after passing it on

 private:
  enum class State : std::uint8_t { request, waits, page, frames, no_request, unmasked };

  void take(std::string_view bytes);
  void take_request(char byte);
  void take_head(char byte);

  State state_ = State::request;
  std::string held_;
  std::uint32_t last_ = 0;  // four bytes of the request
  std::string head_;        // of a frame: two bytes, and a longer length
  std::uint64_t rest_ = 0;  // bytes of the frame's mask and payload that are missing
};

}  // namespace eagerx::web_socket
