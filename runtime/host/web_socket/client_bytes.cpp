#include <algorithm>
#include <limits>
#include <runtime/host/web_socket/client_bytes.hpp>
#include <utility>

namespace eagerx::web_socket {
namespace {

constexpr std::size_t kPlainHead = 2;  // bytes
constexpr unsigned kMaskBit = 0x80, kLengthBits = 0x7f;

/// Bytes of a frame's head, from its second one.
std::size_t size_of_head(unsigned second) {
  constexpr unsigned kLength16 = 126, kLength64 = 127;
  const unsigned length = second & kLengthBits;
  return kPlainHead + (length == kLength16 ? 2U : length == kLength64 ? 8U : 0U);
}

/// Bytes of its mask and payload. A length above 2^63, which is none, closes the connection.
std::uint64_t size_of_rest(std::string_view head) {
  constexpr std::uint64_t kMask = 4, kMost = std::numeric_limits<std::uint64_t>::max() - kMask;
  constexpr unsigned kByte = 8;
  std::uint64_t length = static_cast<unsigned char>(head[1]) & kLengthBits;
  if (head.size() > kPlainHead) length = 0;
  for (const char byte : head.substr(kPlainHead))
    length = length << kByte | static_cast<unsigned char>(byte);
  return std::min(length, kMost) + kMask;
}

}  // namespace

void ClientBytes::add(std::string_view bytes) {
  if (state_ == State::waits)
    held_ += bytes;
  else
    take(bytes);
}

void ClientBytes::answered(Answer with) {
  if (state_ != State::waits) return;
  state_ = with == Answer::web_socket ? State::frames : State::page;
  take(std::exchange(held_, {}));
}

void ClientBytes::take(std::string_view bytes) {
  while (!bytes.empty()) {
    std::size_t size = 1;
    if (state_ == State::request) {
      take_request(bytes.front());
    } else if (state_ == State::waits) {
      held_ += bytes;
      return;
    } else if (state_ == State::frames && rest_ == 0) {
      take_head(bytes.front());
    } else if (state_ == State::frames || state_ == State::page) {
      size = bytes.size();
      if (state_ == State::frames)
        size = static_cast<std::size_t>(std::min<std::uint64_t>(size, rest_));
      if (state_ == State::frames) rest_ -= size;
      passed += bytes.substr(0, size);
    } else {
      return;
    }
    bytes.remove_prefix(size);
  }
}

/// The library ends a line at any LF: it and this must agree on where the frames begin.
void ClientBytes::take_request(char byte) {
  constexpr std::uint32_t kEnd = 0x0d0a0d0a;  // CR LF CR LF
  constexpr unsigned kByte = 8;
  const bool is_after_cr = static_cast<char>(last_) == '\r';
  last_ = last_ << kByte | static_cast<unsigned char>(byte);
  passed += byte;
  if (last_ == kEnd) state_ = State::waits;
  if (byte == '\n' && !is_after_cr) state_ = State::no_request;
}

void ClientBytes::take_head(char byte) {
  constexpr char kReserved = '\x83';
  head_ += byte;
  if (head_.size() < kPlainHead) return;
  const unsigned second = static_cast<unsigned char>(head_[1]);
  if ((second & kMaskBit) == 0) {
    // A frame with a reserved opcode: the library closes with 1002, a protocol error.
    passed += kReserved;
    state_ = State::unmasked;
  } else if (head_.size() == size_of_head(second)) {
    rest_ = size_of_rest(head_);
    passed += std::exchange(head_, {});
  }
}

}  // namespace eagerx::web_socket
