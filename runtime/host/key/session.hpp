// A session of two programs that share a key, over a line that others can read and write. README.md
// describes the handshake and its guarantees. This file has no sockets: bytes go in and out.
// Nothing allocates.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <runtime/host/key/key_file.hpp>
#include <runtime/host/key/sodium.hpp>
#include <span>
#include <string_view>

namespace eagerx::key {

enum class Role : std::uint8_t { connects, listens };

using Bytes = std::span<const std::uint8_t>;

/// The data after a greeting: records of at most kMostBytes each way, each sealed on its own.
class Records {
 public:
  static constexpr std::size_t kMostBytes = 4096;
  static constexpr std::size_t kLengthBytes = 2;
  static constexpr std::size_t kMostSealed = kLengthBytes + kMostBytes + kSealBytes;

  Records() = default;
  Records(const Records&) = delete;
  Records& operator=(const Records&) = delete;
  ~Records() { forget(); }

  bool is_open() const { return sodium_ != nullptr; }
  void forget();

  /// One record of `size` bytes, at most kMostBytes; none is the last one, after which nothing
  /// comes. Returns how many bytes it is of `sealed`, which has room for kMostSealed.
  std::size_t seal(const std::uint8_t* bytes, std::size_t size, std::uint8_t* sealed);

  /// Where the next bytes of the line belong; read into it, then take() says how many they are.
  std::span<std::uint8_t> room() { return std::span(taken_).subspan(taken_size_); }
  void take(std::size_t size) { taken_size_ += size; }
  enum class Found : std::uint8_t {
    nothing,  // more bytes are needed
    record,
    end,     // the other one says that nothing comes any more
    forged,  // it is not what the other one sent next; nothing after it is read
  };
  /// Opens the next record into `bytes`, which has room for kMostBytes.
  Found open(std::uint8_t* bytes, std::size_t& size);

 private:
  friend class Greeting;
  const Functions* sodium_ = nullptr;
  StreamState out_{}, in_{};
  std::array<std::uint8_t, kMostSealed> taken_{};
  std::size_t taken_size_ = 0;
  bool is_over_ = false;
};

/// The first bytes in each direction. The connecting side sends first. Before is_done(), each side
/// has verified that the other has the key, and is live.
class Greeting {
 public:
  static constexpr std::string_view kTitle = "eagerx-key-link1";  // 16 bytes
  static constexpr std::size_t kHelloBytes = 16 + kPublicBytes;
  static constexpr std::size_t kProofBytes = kHeadBytes + kSealBytes;
  static constexpr std::size_t kAnswerBytes = kPublicBytes + kProofBytes;
  static constexpr std::size_t kMostBytes = kAnswerBytes;

  Greeting() = default;
  Greeting(const Greeting&) = delete;
  Greeting& operator=(const Greeting&) = delete;
  ~Greeting() { forget(); }

  void begin(const Functions& sodium, const Key& key, Role role);
  /// Where the session continues, once it is_done().
  void go_on(Records& records);
  void forget();

  /// The bytes to send now; empty: nothing until the next take().
  Bytes to_send() const { return {send_.data(), send_size_}; }
  void sent() { send_size_ = 0; }
  /// Number of bytes needed for the next step; 0 if it reads no more.
  std::size_t wanted() const { return is_done_ ? 0 : await_size_ - taken_size_; }
  /// At most wanted() bytes. False: the sender does not have the key, or repeats data of another
  /// peer.
  bool take(Bytes bytes);
  bool is_done() const { return is_done_; }

 private:
  bool take_hello();
  bool take_answer();
  bool take_proof(const std::uint8_t* proof);
  void send_proof(std::size_t at);
  bool make_keys(const std::uint8_t* other);
  void mix(const std::uint8_t* shared, bool from_listener, std::uint8_t* stream_key) const;

  const Functions* sodium_ = nullptr;
  StreamState out_{}, in_{};
  Key key_{};
  std::array<std::uint8_t, kPublicBytes> open_{};
  std::array<std::uint8_t, kSecretBytes> secret_{};
  std::array<std::uint8_t, kStreamKeyBytes> out_key_{}, in_key_{};
  /// All unencrypted data, of the connecting and the listening side.
  std::array<std::uint8_t, 16 + 2 * kPublicBytes> said_{};
  std::array<std::uint8_t, kMostBytes> taken_{}, send_{};
  std::size_t taken_size_ = 0, send_size_ = 0, await_size_ = 0;
  Role role_ = Role::connects;
  bool has_keys_ = false, is_done_ = false;
};

}  // namespace eagerx::key
