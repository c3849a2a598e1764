#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <map>
#include <optional>
#include <runtime/host/foxglove/server_message.hpp>
#include <runtime/host/trace/channel_name.hpp>
#include <runtime/host/trace/mcap_reader.hpp>
#include <utility>

#include "generator/tools/monitor/source.hpp"

namespace eagerx::gen {
namespace {

constexpr std::size_t kPartBytes = 1 << 18;  // bytes

/// "30/1" of a channel's metadata.
bool read_rate(std::string_view text, trace_log::RecordedChannel& to) {
  const char* const end = text.data() + text.size();
  const auto num = std::from_chars(text.data(), end, to.rate_num);
  if (num.ec != std::errc() || num.ptr == end || *num.ptr != '/') return false;
  const auto den = std::from_chars(num.ptr + 1, end, to.rate_den);
  return den.ec == std::errc() && den.ptr == end && to.rate_num > 0 && to.rate_den > 0;
}

/// A recording of a program, of the monitor or of `trace convert`; it may grow.
class McapSource final : public Source, private trace_log::McapListener {
 public:
  McapSource(std::string path, int file) : path_(std::move(path)), file_(file), reader_(*this) {}
  ~McapSource() override { ::close(file_); }
  McapSource(const McapSource&) = delete;
  McapSource& operator=(const McapSource&) = delete;

  [[nodiscard]] int descriptor() const override { return -1; }
  [[nodiscard]] std::string problem() const override { return problem_; }

  State read(std::int64_t now_ns, StreamListener& listener) override {
    const std::size_t before = bytes_.size();
    bytes_.resize(before + kPartBytes);
    const ssize_t size = ::read(file_, bytes_.data() + before, kPartBytes);
    bytes_.resize(before + static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
    if (size < 0 && errno != EAGAIN && errno != EINTR) return fail(std::strerror(errno));
    if (size <= 0) return State::open;
    listener_ = &listener;
    // Only what comes while one looks has a time.
    if (size < static_cast<ssize_t>(kPartBytes) && std::exchange(was_short_, true))
      real_ns_ = now_ns;
    std::string_view rest = bytes_;
    const bool is_right = reader_.read(rest);
    bytes_.erase(0, bytes_.size() - rest.size());
    if (is_refused_) return State::failed;
    if (!is_right) return fail(reader_.problem());
    return reader_.is_complete() ? State::ended : State::more;
  }

 private:
  void channel(const trace_log::McapChannel& channel) override;
  void message(const trace_log::McapMessage& message) override;
  State fail(const std::string& why) {
    problem_ = fmt::format("error: cannot read `{}`: {}", path_, why);
    return State::failed;
  }

  const std::string path_;
  const int file_;
  trace_log::McapReader reader_;
  std::string bytes_, problem_;
  StreamListener* listener_ = nullptr;
  StreamFacts facts_;
  std::map<std::uint16_t, std::string> channels_;
  std::optional<std::uint16_t> steps_;  // the channel that counts them
  std::optional<std::int64_t> real_ns_;
  foxglove::ChannelValue value_;
  bool has_begun_ = false, is_refused_ = false, was_short_ = false;
};

/// A channel of eagerx-gen says what its messages are; others are not shown.
void McapSource::channel(const trace_log::McapChannel& channel) {
  if (has_begun_ || channel.encoding != "json" || !channel.topic.starts_with('/')) return;
  trace_log::RecordedChannel recorded;
  recorded.name = channel.topic.substr(1);
  std::optional<trace_log::Dtype> dtype;
  bool has_rate = false, has_size = false;
  for (const auto& [name, value] : channel.metadata) {
    if (name == "dtype") dtype = trace_log::dtype_of(value);
    if (name == "rate_hz") has_rate = read_rate(value, recorded);
    if (name != "size") continue;
    const char* const end = value.data() + value.size();
    const auto [at, error] = std::from_chars(value.data(), end, recorded.size);
    has_size = error == std::errc() && at == end && recorded.size > 0;
  }
  if (!dtype || !has_rate || !has_size || channels_.contains(channel.id)) return;
  if (!trace_log::problem_with_channel_name(recorded.name).empty()) return;
  if (channels_.size() >= kMostStreamChannels) return listener_->fault(StreamFault::crowded_out, 1);
  recorded.dtype = *dtype;
  channels_[channel.id] = recorded.name;
  facts_.channels.push_back(std::move(recorded));
}

void McapSource::message(const trace_log::McapMessage& message) {
  constexpr std::size_t kMostValue = 1 << 18;  // bytes
  if (is_refused_) return;
  if (!std::exchange(has_begun_, true)) is_refused_ = !listener_->begin(facts_);
  const auto found = channels_.find(message.channel);
  if (is_refused_ || found == channels_.end()) return;
  if (message.data.size() > kMostValue) return listener_->fault(StreamFault::crowded_out, 1);
  constexpr auto kMostNs = static_cast<std::uint64_t>(INT64_MAX / 2);
  if (message.time_ns > kMostNs ||
      !foxglove::read_channel_value(message.data, kMostStreamElements, value_))
    return listener_->fault(StreamFault::damaged, 1);
  const auto time_ns = static_cast<std::int64_t>(message.time_ns);
  listener_->message({.channel = found->second,
                      .values = value_.values,
                      .elements = value_.elements,
                      .episode = value_.episode,
                      .seq = value_.tick,
                      .time_ns = time_ns,
                      .real_ns = real_ns_});
  // Every step has one action.
  if (!steps_ && found->second.starts_with("environment/")) steps_ = message.channel;
  if (steps_ == message.channel)
    listener_->step({value_.episode, value_.tick + 1, time_ns, real_ns_});
}

}  // namespace

std::unique_ptr<Source> open_mcap_source(const std::string& path, std::string& problem) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
  if (file >= 0) return std::make_unique<McapSource>(path, file);
  problem = fmt::format("error: cannot read `{}`: {}", path, std::strerror(errno));
  return nullptr;
}

}  // namespace eagerx::gen
