#include <algorithm>
#include <cstring>
#include <eagerx/trace.hpp>
#include <runtime/host/base/hash.hpp>
#include <runtime/host/telemetry/decoder.hpp>

namespace eagerx::telemetry {
namespace {

template <class T>
std::uint64_t bits_at(const std::uint8_t* bytes) {
  return canonical_bits(link::read_as<T>(bytes));
}

/// As the trace has it; of a bool any byte but 0 is 1.
std::uint64_t bits_of(trace_log::Dtype dtype, const std::uint8_t* bytes) {
  using trace_log::Dtype;
  switch (dtype) {
    case Dtype::float32:
      return bits_at<float>(bytes);
    case Dtype::float64:
      return bits_at<double>(bytes);
    case Dtype::int8:
      return bits_at<std::int8_t>(bytes);
    case Dtype::int16:
      return bits_at<std::int16_t>(bytes);
    case Dtype::int32:
      return bits_at<std::int32_t>(bytes);
    case Dtype::int64:
      return bits_at<std::int64_t>(bytes);
    case Dtype::uint8:
      return bits_at<std::uint8_t>(bytes);
    case Dtype::uint16:
      return bits_at<std::uint16_t>(bytes);
    case Dtype::uint32:
      return bits_at<std::uint32_t>(bytes);
    case Dtype::uint64:
      return bits_at<std::uint64_t>(bytes);
    case Dtype::boolean:
      break;
  }
  return *bytes != 0 ? 1 : 0;
}

bool is_text(std::uint8_t byte) {
  return (byte >= ' ' && byte <= '~') || byte == '\n' || byte == '\r' || byte == '\t';
}

std::string version(std::uint16_t runtime) {
  return std::to_string(runtime / 256) + "." + std::to_string(runtime % 256);
}

}  // namespace

Decoder::Decoder(const Layout& layout) : layout_(layout), seqs_(layout.groups.size()) {
  link::Greeting greeting;
  greeting.graph = layout.hash;
  greeting.runtime = layout.runtime;
  crc_start_ = greeting.crc_start();
  std::uint64_t most = 0;
  for (const Group& group : layout.groups) {
    for (const Channel& channel : group.channels) most = std::max(most, channel.size);
  }
  values_.resize(most);
}

bool Decoder::take(const std::uint8_t* bytes, std::size_t size, Listener& listener) {
  for (std::size_t i = 0; i < size; ++i) {
    if (bytes[i] == 0) {
      end_piece(listener);
      used_ = 0;
      too_long_ = false;
    } else if (used_ < piece_.size()) {
      piece_[used_++] = bytes[i];
    } else {
      too_long_ = true;
    }
  }
  return refusal_.empty();
}

void Decoder::end_piece(Listener& listener) {
  if (used_ == 0) return;
  if (take_text(listener)) {
    counts_.text += used_;
    return;
  }
  const std::size_t size = too_long_ ? used_ : link::cobs_decode(piece_.data(), used_);
  if (size == used_ || !take_frame(size, listener)) ++counts_.damaged;
}

/// Whole lines; in frames there are always bytes that no text has, such as that of the kind.
bool Decoder::take_text(Listener& listener) const {
  if (piece_[used_ - 1] != '\n' || !std::all_of(piece_.begin(), piece_.begin() + used_, is_text))
    return false;
  listener.text({reinterpret_cast<const char*>(piece_.data()), used_});
  return true;
}

bool Decoder::take_frame(std::size_t size, Listener& listener) {
  if (size < link::kHeaderBytes + link::kCrcBytes) return false;
  const std::size_t payload = size - link::kHeaderBytes - link::kCrcBytes;
  const std::uint8_t* const bytes = piece_.data();
  const std::uint8_t kind = bytes[0];
  const std::uint32_t start = kind == link::kTelemetryValues ? crc_start_ : 0;
  const auto crc = link::read_as<std::uint32_t>(bytes + link::kHeaderBytes + payload);
  if (crc != link::crc32c(bytes, link::kHeaderBytes + payload, start)) return false;
  const auto number = link::read_as<std::uint32_t>(bytes + 1);
  if (kind == link::kTelemetryGreeting)
    return take_greeting(bytes + link::kHeaderBytes, payload, number);
  return kind == link::kTelemetryValues &&
         take_record(bytes + link::kHeaderBytes, payload, number, listener);
}

bool Decoder::take_greeting(const std::uint8_t* payload, std::size_t size, std::uint32_t number) {
  if (size != link::kTelemetryGreetingBytes) return false;
  const link::Greeting greeting = link::Greeting::read(payload);
  refusal_.clear();
  if (greeting.protocol != link::kProtocol) {
    refusal_ = "the board speaks protocol " + std::to_string(greeting.protocol) + ", not " +
               std::to_string(link::kProtocol);
  } else if (greeting.graph != layout_.hash) {
    refusal_ = "the board runs another graph, or the same of another time: its hash is " +
               host::hex_text(greeting.graph) + ", that of `" + layout_.graph + "` is " +
               host::hex_text(layout_.hash);
  } else if (greeting.runtime != layout_.runtime) {
    refusal_ = "the board has runtime " + version(greeting.runtime) + ", the layout is of " +
               version(layout_.runtime);
  }
  greeted_ = refusal_.empty();
  if (!greeted_) return true;
  const std::uint8_t* const counts = payload + link::Greeting::kBytes;
  const bool anew = number == 0 && next_number_ > 0;
  ++counts_.greetings;
  episode_ = link::read_as<std::uint32_t>(counts);
  counts_.dropped = link::read_as<std::uint32_t>(counts + 4);
  counts_.late = link::read_as<std::uint32_t>(counts + 8);
  if (anew) {  // the board was reset: nothing is lost
    counting_ = false;
    std::fill(seqs_.begin(), seqs_.end(), 0);
  }
  return true;
}

bool Decoder::take_record(const std::uint8_t* payload, std::size_t size, std::uint32_t number,
                          Listener& listener) {
  if (size < link::kRecordHeaderBytes) return false;
  const std::size_t g = payload[4];
  const auto mask = link::read_as<std::uint16_t>(payload + 6);
  if (g >= layout_.groups.size()) return false;
  const Group& group = layout_.groups[g];
  if (size != group.bytes || (std::uint32_t{mask} >> group.channels.size()) != 0) return false;
  if (!greeted_) return ++counts_.unknown, true;
  follow(number);
  ++counts_.records;
  const std::uint32_t episode = episode_of(payload[5]);
  if (episode != episode_) std::fill(seqs_.begin(), seqs_.end(), 0);
  episode_ = episode;
  // The number that is nearest to the last one.
  const auto low = link::read_as<std::uint32_t>(payload);
  const auto step = static_cast<std::int32_t>(low - static_cast<std::uint32_t>(seqs_[g]));
  const std::uint64_t seq = step < 0 && seqs_[g] < static_cast<std::uint64_t>(-std::int64_t{step})
                                ? low
                                : seqs_[g] + static_cast<std::uint64_t>(std::int64_t{step});
  seqs_[g] = seq;
  Message message{static_cast<std::uint32_t>(g), 0, episode, seq, values_.data()};
  for (std::uint32_t i = 0; i < group.channels.size(); ++i) {
    if ((std::uint32_t{mask} >> i & 1U) == 0) continue;
    message.channel = i;
    show(group, payload, message, listener);
  }
  return true;
}

void Decoder::show(const Group& group, const std::uint8_t* record, Message message,
                   Listener& listener) {
  const Channel& channel = group.channels[message.channel];
  const std::size_t bytes = bytes_of(channel.dtype);
  for (std::size_t i = 0; i < channel.size; ++i)
    values_[i] = bits_of(channel.dtype, record + channel.offset + i * bytes);
  listener.message(message);
}

/// Counts the numbers that are missing; a number behind is a board that began anew.
void Decoder::follow(std::uint32_t number) {
  const std::uint32_t missing = number - next_number_;
  if (counting_ && static_cast<std::int32_t>(missing) > 0) counts_.lost += missing;
  next_number_ = number + 1;
  counting_ = true;
}

/// The number with these low bits that is nearest to the last one.
std::uint32_t Decoder::episode_of(std::uint8_t low) const {
  const auto step = static_cast<std::int8_t>(static_cast<std::uint8_t>(low - episode_));
  if (step < 0 && episode_ < static_cast<std::uint32_t>(-step)) return low;
  return episode_ + static_cast<std::uint32_t>(static_cast<std::int32_t>(step));
}

}  // namespace eagerx::telemetry
