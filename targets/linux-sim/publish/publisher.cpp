#include <time.h>

#include <algorithm>
#include <string_view>
#include <targets/linux-sim/background.hpp>
#include <targets/linux-sim/elements.hpp>
#include <targets/linux-sim/nearest.hpp>
#include <targets/linux-sim/options.hpp>
#include <targets/linux-sim/publish/datagrams.hpp>
#include <targets/linux-sim/publish/destination.hpp>
#include <targets/linux-sim/publish/publisher.hpp>
#include <targets/linux-sim/summary.hpp>

namespace eagerx::linux_sim {

/// Who gets what is published behind each step.
class Sink {
 public:
  Sink() = default;
  Sink(const Sink&) = delete;
  Sink& operator=(const Sink&) = delete;
  virtual ~Sink() = default;
  virtual void step(const Snapshot& snapshot) = 0;
  virtual std::string name() const = 0;
  /// What it did, in words for the summary.
  virtual std::string account() const = 0;
};

namespace {

template <class Format>
class DatagramSink final : public Sink {
 public:
  std::string open(const Destination& destination) {
    name_ = destination.text;
    return datagrams_.open(destination);
  }
  void step(const Snapshot& snapshot) override {
    format_.write(snapshot, [&](const std::string& datagram) { datagrams_.send(datagram); });
  }
  std::string name() const override { return name_; }
  std::string account() const override {
    std::string text = std::to_string(datagrams_.sent()) + " datagrams";
    if (datagrams_.lost() > 0) text += ", " + std::to_string(datagrams_.lost()) + " not taken";
    return text;
  }

 private:
  std::string name_;
  Datagrams datagrams_;
  Format format_;
};

template <class Made>
std::string add_sink(std::vector<std::unique_ptr<Sink>>& sinks, const Destination& destination) {
  auto sink = std::make_unique<Made>();
  std::string problem = sink->open(destination);
  sinks.push_back(std::move(sink));
  return problem;
}

/// By its name in traces, or as graphs call it: "pendulum/theta/observation", "pendulum.theta".
bool is_called(const Channel& channel, const std::string& name) {
  return name == channel.name || name == channel.port;
}

std::string problem_of_channel(const std::string& name, const GraphFacts& facts) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < facts.channel_count; ++i) {
    if (is_called(facts.channels[i], name)) return {};
    names.emplace_back(facts.channels[i].name);
  }
  const std::string near = nearest_name(name, names);
  std::string list;
  for (const std::string& each : names) list += (list.empty() ? "" : ", ") + each;
  return "error: `--publish-only " + name + "`: there is no such channel\nhelp: " +
         (near.empty() ? "there is " + list : "did you mean `" + near + "`?");
}

}  // namespace

LivePublisher::LivePublisher() = default;
LivePublisher::~LivePublisher() {
  is_over_ = true;
  if (sender_.joinable()) sender_.join();
}

std::string LivePublisher::problem_of(const Options& options, const GraphFacts& facts) {
  for (const std::string& text : options.publish) {
    const auto read = read_destination(text);
    if (const auto* const problem = std::get_if<std::string>(&read)) return *problem;
  }
  for (const std::string& name : options.publish_only) {
    if (std::string problem = problem_of_channel(name, facts); !problem.empty()) return problem;
  }
  return {};
}

void LivePublisher::choose(const std::vector<std::string>& only) {
  bytes_.assign(facts_->channel_count, 0);
  place_.assign(facts_->channel_count, 0);
  for (std::size_t i = 0; i < facts_->channel_count; ++i) {
    const Channel& channel = facts_->channels[i];
    if (!only.empty() && std::none_of(only.begin(), only.end(), [&](const std::string& name) {
          return is_called(channel, name);
        }))
      continue;
    LatestMessage message;
    message.channel = &channel;
    const std::string_view name = channel.name;
    const std::size_t slash = std::min(name.find('/'), name.size());
    message.node = name.substr(0, slash);
    message.port = name.substr(std::min(slash + 1, name.size()));
    message.scalar = scalar_of_dtype(channel.dtype);
    message.size = channel.size;
    bytes_[i] = channel.size * with_scalar(message.scalar, [](auto zero) { return sizeof zero; });
    message.bytes.resize(bytes_[i]);
    snapshot_.messages.push_back(std::move(message));
  }
  std::stable_sort(snapshot_.messages.begin(), snapshot_.messages.end(),
                   [](const auto& a, const auto& b) { return a.node < b.node; });
  for (std::size_t i = 0; i < snapshot_.messages.size(); ++i)
    place_[static_cast<std::size_t>(snapshot_.messages[i].channel - facts_->channels)] = i;
}

std::string LivePublisher::open(const Options& options, const GraphFacts& facts) {
  if (options.publish.empty()) return {};
  for (const std::string& text : options.publish) {
    const auto destination = std::get<Destination>(read_destination(text));
    const std::string problem = destination.kind == Destination::Kind::udp
                                    ? add_sink<DatagramSink<JsonDatagrams>>(sinks_, destination)
                                    : add_sink<DatagramSink<TeleplotLines>>(sinks_, destination);
    if (!problem.empty()) return problem;
  }
  facts_ = &facts;
  interval_s_ = options.publish_rate_hz > 0.0 ? 1.0 / options.publish_rate_hz : 0.0;
  choose(options.publish_only);
  // Of the graph's messages, what comes in half a second, and not less than this.
  constexpr double kHeld_s = 0.5;
  constexpr double kLeast = 1 << 18, kMost = 1 << 28;
  double bytes_a_second = 0.0;
  std::size_t longest = 0;
  for (std::size_t i = 0; i < facts.channel_count; ++i) {
    const Channel& channel = facts.channels[i];
    longest = std::max(longest, bytes_[i]);
    if (bytes_[i] > 0)
      bytes_a_second += static_cast<double>(MessageRing::record_bytes(bytes_[i])) *
                        static_cast<double>(channel.rate_num) /
                        static_cast<double>(channel.rate_den);
  }
  const double wanted = std::clamp(kHeld_s * bytes_a_second, kLeast, kMost);
  ring_ = std::make_unique<MessageRing>(static_cast<std::size_t>(wanted), longest);
  sender_ = thread_without_signals([this] { send_all(); });
  return {};
}

void LivePublisher::send_all() {
  constexpr timespec kIdle{0, 1'000'000};
  for (;;) {
    const bool is_last = is_over_.load(std::memory_order_acquire);
    const bool some = ring_->drain(
        [this](const MessageRing::Head& head, const std::byte* message) { take(head, message); });
    if (is_last) return;
    if (!some) nanosleep(&kIdle, nullptr);
  }
}

void LivePublisher::take(const MessageRing::Head& head, const std::byte* message) {
  if (head.channel == kStep) return end_step(head.seq);
  if (head.channel == kEpisode) {
    if (snapshot_.step > 0 || head.seq > 0)
      episode_begins_s_ = snapshot_.time_s + facts_->period_s();
    snapshot_.episode = static_cast<std::uint32_t>(head.seq);
    for (LatestMessage& each : snapshot_.messages) each.is_there = false;
    return;
  }
  LatestMessage& latest = snapshot_.messages[place_[head.channel]];
  std::copy_n(message, latest.bytes.size(), latest.bytes.begin());
  latest.is_there = true;
}

void LivePublisher::end_step(std::uint64_t step) {
  snapshot_.step = step;
  snapshot_.time_s = episode_begins_s_ + facts_->seconds(step);
  if (snapshot_.time_s < next_s_) return;
  // From the last instant that was due, so that the mean rate is the one that was asked for.
  if (interval_s_ > 0.0) next_s_ = std::max(next_s_ + interval_s_, snapshot_.time_s - interval_s_);
  for (const auto& sink : sinks_) sink->step(snapshot_);
}

void LivePublisher::close(Summary& summary) {
  if (!is_open()) return;
  is_over_.store(true, std::memory_order_release);
  sender_.join();
  for (const auto& sink : sinks_) {
    std::string account = sink->account();
    if (ring_->dropped() > 0)
      account += ", " + std::to_string(ring_->dropped()) + " messages dropped before";
    summary.more.emplace_back("published to " + sink->name(), account);
  }
}

}  // namespace eagerx::linux_sim
