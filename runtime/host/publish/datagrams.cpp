#include <netdb.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <runtime/host/base/hash.hpp>
#include <runtime/host/base/json.hpp>
#include <runtime/host/publish/datagrams.hpp>
#include <runtime/host/trace/json_text.hpp>

namespace eagerx::publish {
namespace {

constexpr double kSecondInNs = 1e9, kMsInNs = 1e6;

/// Shortest decimal, in any locale.
template <class T>
void append_number(std::string& to, T value) {
  std::array<char, 32> text{};
  const auto result = std::to_chars(text.data(), text.data() + text.size(), value);
  to.append(text.data(), result.ptr);
}

/// Sends what is ready at the end of each step; a socket that takes no more loses it.
class DatagramSink : public PublishSink {
 public:
  DatagramSink(Address to, const PublishedChannels& channels)
      : to_(std::move(to)), channels_(channels), last_(channels.size()), has_(channels.size()) {
    for (std::size_t c = 0; c < channels.size(); ++c) last_[c].resize(channels[c].size);
  }
  ~DatagramSink() override {
    if (socket_ >= 0) ::close(socket_);
  }
  DatagramSink(const DatagramSink&) = delete;
  DatagramSink& operator=(const DatagramSink&) = delete;

  std::string open() override {
    addrinfo hints{}, *found = nullptr;
    hints.ai_socktype = SOCK_DGRAM;
    hints.ai_flags = AI_NUMERICSERV;
    const int error = getaddrinfo(to_.host.c_str(), to_.port.c_str(), &hints, &found);
    if (error != 0)
      return "error: `" + to_.said + "`: there is no host `" + to_.host +
             "`: " + gai_strerror(error);
    const std::unique_ptr<addrinfo, void (*)(addrinfo*)> owned(found, freeaddrinfo);
    std::memcpy(&address_, found->ai_addr, found->ai_addrlen);
    address_size_ = found->ai_addrlen;
    socket_ = ::socket(found->ai_family, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (socket_ >= 0) return {};
    return "error: `" + to_.said + "`: " + std::strerror(errno);
  }

  void message(const PublishedMessage& message) override {
    std::memcpy(last_[message.channel].data(), message.values,
                last_[message.channel].size() * sizeof(std::uint64_t));
    has_[message.channel] = true;
  }

  const char* unit() const override { return "datagrams"; }

 protected:
  void send(const std::string& datagram) {
    const ssize_t size = ::sendto(socket_, datagram.data(), datagram.size(), 0,
                                  reinterpret_cast<const sockaddr*>(&address_), address_size_);
    ++(size < 0 ? dropped_ : sent_);
  }
  /// f(channel) for each that has had a message since the last time.
  template <class F>
  void for_each_new(F&& f) {
    for (std::size_t c = 0; c < channels_.size(); ++c) {
      if (has_[c]) f(c);
      has_[c] = false;
    }
  }
  const PublishedChannels& channels() const { return channels_; }
  const std::uint64_t* values(std::size_t channel) const { return last_[channel].data(); }

 private:
  Address to_;
  const PublishedChannels& channels_;
  std::vector<std::vector<std::uint64_t>> last_;  // values, by channel
  std::vector<bool> has_;
  sockaddr_storage address_{};
  socklen_t address_size_ = 0;
  int socket_ = -1;
};

class UdpSink final : public DatagramSink {
 public:
  UdpSink(Address to, const PublishedChannels& channels, std::uint64_t graph_hash)
      : DatagramSink(std::move(to), channels),
        graph_(",\"graph\":\"" + host::hex_text(graph_hash) + "\"") {}

  void step(const PublishedStep& step) override {
    begin(step);
    for_each_new([&](std::size_t c) { add(step, c); });
    send(text_ + "}");
  }

 private:
  static constexpr std::size_t kMostBytes = 60'000;  // less than kMostDatagramBytes

  void begin(const PublishedStep& step) {
    text_ = "{\"timestamp\":";
    append_number(text_, static_cast<double>(step.time_ns) / kSecondInNs);
    text_ += ",\"episode\":";
    append_number(text_, step.episode);
    text_ += ",\"step\":";
    append_number(text_, step.step);
    text_ += graph_;
    begun_ = text_.size();
  }
  /// A record that does not fit goes into a datagram of its own, or is dropped.
  void add(const PublishedStep& step, std::size_t c) {
    field_ = ",";
    host::append_json_string(field_, channels()[c].name);
    field_ += ':';
    trace_log::append_json_values(field_, channels()[c], values(c));
    if (begun_ + field_.size() > kMostBytes) {
      ++dropped_;
      return;
    }
    if (text_.size() + field_.size() > kMostBytes) {
      send(text_ + "}");
      begin(step);
    }
    text_ += field_;
  }

  const std::string graph_;  // the member that says it
  std::string text_, field_;
  std::size_t begun_ = 0;  // bytes of the text before the first channel
};

class TeleplotSink final : public DatagramSink {
 public:
  using DatagramSink::DatagramSink;

  void step(const PublishedStep& step) override {
    text_.clear();
    time_.clear();
    append_number(time_, static_cast<double>(step.time_ns) / kMsInNs);
    for_each_new([&](std::size_t c) {
      for (std::size_t i = 0; i < channels()[c].size; ++i) add(c, i);
    });
    if (!text_.empty()) send(text_);
  }

 private:
  static constexpr std::size_t kMostBytes = 1'400;  // of a frame of Ethernet

  void add(std::size_t c, std::size_t i) {
    const trace_log::RecordedChannel& channel = channels()[c];
    const std::uint64_t bits = values(c)[i];
    if (!std::isfinite(trace_log::number_of(channel.dtype, bits))) return;  // has no text
    line_ = channel.name;
    // These mean something in a line.
    for (char& each : line_)
      if (each == ':' || each == '|' || each == ';' || each == '\n') each = '_';
    if (channel.size > 1) line_ += "[" + std::to_string(i) + "]";
    line_ += ":" + time_ + ":" + trace_log::text_of(channel.dtype, bits) + "\n";
    if (!text_.empty() && text_.size() + line_.size() > kMostBytes) {
      send(text_);
      text_.clear();
    }
    text_ += line_;
  }

  std::string text_, line_, time_;
};

}  // namespace

std::unique_ptr<PublishSink> udp_sink(const Address& to, const PublishedChannels& channels,
                                      std::uint64_t graph_hash) {
  return std::make_unique<UdpSink>(to, channels, graph_hash);
}
std::unique_ptr<PublishSink> teleplot_sink(const Address& to, const PublishedChannels& channels) {
  return std::make_unique<TeleplotSink>(to, channels);
}

}  // namespace eagerx::publish
