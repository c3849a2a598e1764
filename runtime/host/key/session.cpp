#include <algorithm>
#include <cstring>
#include <runtime/host/key/session.hpp>

namespace eagerx::key {
namespace {

/// So that no key of one direction, or of another use, is a key of the other.
constexpr std::string_view kFromListener = "eagerx link 1: from who listens.";
constexpr std::string_view kFromConnector = "eagerx link 1: from who connects";
static_assert(kFromListener.size() == kFromConnector.size());

template <class Array>
void wipe(Array& bytes) {
  explicit_bzero(bytes.data(), bytes.size());
}

}  // namespace

void Records::forget() {
  explicit_bzero(&out_, sizeof out_);
  explicit_bzero(&in_, sizeof in_);
  sodium_ = nullptr;
  taken_size_ = 0;
  is_over_ = false;
}

std::size_t Records::seal(const std::uint8_t* bytes, std::size_t size, std::uint8_t* sealed) {
  constexpr unsigned kByte = 8;
  // The length is bound, too: with another one the seal is not where it is looked for.
  sealed[0] = static_cast<std::uint8_t>(size);
  sealed[1] = static_cast<std::uint8_t>(size >> kByte);
  Size sealed_size = 0;
  sodium_->push(&out_, sealed + kLengthBytes, &sealed_size, bytes, size, sealed, kLengthBytes,
                size == 0 ? kTagFinal : kTagMessage);
  return kLengthBytes + static_cast<std::size_t>(sealed_size);
}

Records::Found Records::open(std::uint8_t* bytes, std::size_t& size) {
  constexpr unsigned kByte = 8;
  if (is_over_) return Found::forged;
  if (taken_size_ < kLengthBytes) return Found::nothing;
  const std::size_t length = static_cast<std::size_t>(taken_[0]) | std::size_t{taken_[1]} << kByte;
  const std::size_t whole = kLengthBytes + length + kSealBytes;
  is_over_ = length > kMostBytes;
  if (is_over_) return Found::forged;
  if (taken_size_ < whole) return Found::nothing;
  Size opened = 0;
  std::uint8_t tag = 0;
  const bool is_right = sodium_->pull(&in_, bytes, &opened, &tag, taken_.data() + kLengthBytes,
                                      length + kSealBytes, taken_.data(), kLengthBytes) == 0;
  taken_size_ -= whole;
  std::memmove(taken_.data(), taken_.data() + whole, taken_size_);
  size = is_right ? static_cast<std::size_t>(opened) : 0;
  const bool is_end = tag == kTagFinal && length == 0;
  is_over_ = !is_right || is_end || tag != kTagMessage || length == 0;
  return !is_over_ ? Found::record : is_right && is_end ? Found::end : Found::forged;
}

void Greeting::forget() {
  wipe(key_);
  wipe(secret_);
  wipe(out_key_);
  wipe(in_key_);
  explicit_bzero(&out_, sizeof out_);
  explicit_bzero(&in_, sizeof in_);
}

void Greeting::go_on(Records& records) {
  records.forget();
  records.sodium_ = sodium_;
  records.out_ = out_;
  records.in_ = in_;
  forget();
}

void Greeting::begin(const Functions& sodium, const Key& key, Role role) {
  sodium_ = &sodium;
  key_ = key;
  role_ = role;
  taken_size_ = send_size_ = 0;
  has_keys_ = is_done_ = false;
  sodium.kx_keypair(open_.data(), secret_.data());
  std::memcpy(said_.data(), kTitle.data(), kTitle.size());
  await_size_ = role == Role::listens ? kHelloBytes : kAnswerBytes;
  if (role == Role::listens) return;
  std::copy(open_.begin(), open_.end(), said_.begin() + kTitle.size());
  std::copy_n(said_.begin(), kHelloBytes, send_.begin());
  send_size_ = kHelloBytes;
}

bool Greeting::take(Bytes bytes) {
  const std::size_t count = std::min(bytes.size(), wanted());
  if (count > 0) std::memcpy(taken_.data() + taken_size_, bytes.data(), count);
  taken_size_ += count;
  // Who says something else from the start is not waited for.
  const std::size_t title = std::min(taken_size_, kTitle.size());
  if (role_ == Role::listens && !has_keys_ && std::memcmp(taken_.data(), kTitle.data(), title) != 0)
    return false;
  if (taken_size_ < await_size_) return true;
  taken_size_ = 0;
  if (role_ == Role::connects) return take_answer();
  return has_keys_ ? take_proof(taken_.data()) : take_hello();
}

bool Greeting::take_hello() {
  const std::uint8_t* const other = taken_.data() + kTitle.size();
  auto* const to = std::copy_n(other, kPublicBytes, said_.begin() + kTitle.size());
  std::copy(open_.begin(), open_.end(), to);
  if (!make_keys(other)) return false;
  std::copy(open_.begin(), open_.end(), send_.begin());
  send_proof(kPublicBytes);
  await_size_ = kProofBytes;
  return true;
}

bool Greeting::take_answer() {
  std::copy_n(taken_.begin(), kPublicBytes, said_.begin() + kHelloBytes);
  if (!make_keys(taken_.data()) || !take_proof(taken_.data() + kPublicBytes)) return false;
  send_proof(0);
  return true;
}

bool Greeting::take_proof(const std::uint8_t* proof) {
  std::uint8_t nothing = 0, tag = 0;
  Size size = 0;
  is_done_ = sodium_->init_pull(&in_, proof, in_key_.data()) == 0 &&
             sodium_->pull(&in_, &nothing, &size, &tag, proof + kHeadBytes, kSealBytes,
                           said_.data(), said_.size()) == 0 &&
             tag == kTagMessage;
  return is_done_;
}

/// The beginning of what is sent: a record of nothing that is bound to all that was said.
void Greeting::send_proof(std::size_t at) {
  const std::uint8_t nothing = 0;
  sodium_->init_push(&out_, send_.data() + at, out_key_.data());
  sodium_->push(&out_, send_.data() + at + kHeadBytes, nullptr, &nothing, 0, said_.data(),
                said_.size(), kTagMessage);
  send_size_ = at + kProofBytes;
}

/// False: no peer generates such a number.
bool Greeting::make_keys(const std::uint8_t* other) {
  // Our own greeting, reflected.
  if (std::equal(open_.begin(), open_.end(), other)) return false;
  std::array<std::uint8_t, kSharedBytes> in{}, out{};
  const bool connects = role_ == Role::connects;
  const auto exchange =
      connects ? sodium_->kx_client_session_keys : sodium_->kx_server_session_keys;
  const bool is_good = exchange(in.data(), out.data(), open_.data(), secret_.data(), other) == 0;
  if (is_good) {
    mix(in.data(), connects, in_key_.data());
    mix(out.data(), !connects, out_key_.data());
  }
  wipe(in);
  wipe(out);
  has_keys_ = is_good;
  return is_good;
}

/// The key of one direction: BLAKE2b, keyed with the key of the file, of the direction, of what the
/// exchange of this session gave and of all that was said.
void Greeting::mix(const std::uint8_t* shared, bool from_listener, std::uint8_t* stream_key) const {
  std::array<std::uint8_t, kFromListener.size() + kSharedBytes + sizeof said_> text{};
  const std::string_view direction = from_listener ? kFromListener : kFromConnector;
  auto* to = std::copy(direction.begin(), direction.end(), text.begin());
  to = std::copy_n(shared, kSharedBytes, to);
  std::copy(said_.begin(), said_.end(), to);
  sodium_->generichash(stream_key, kStreamKeyBytes, text.data(), text.size(), key_.data(),
                       key_.size());
  wipe(text);
}

}  // namespace eagerx::key
