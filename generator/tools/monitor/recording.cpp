#include "generator/tools/monitor/recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <eagerx/scene.hpp>
#include <eagerx/trace.hpp>
#include <limits>
#include <map>
#include <optional>
#include <runtime/host/dds/dds_sink.hpp>
#include <runtime/host/publish/address.hpp>
#include <runtime/host/publish/datagrams.hpp>
#include <utility>

#include "generator/support/diagnostics/search.hpp"
#include "generator/tools/monitor/monitor.hpp"
#include "generator/tools/monitor/recorded_file.hpp"

namespace eagerx::gen {
namespace {

constexpr std::string_view kUdpTo = "udp:", kTeleplotTo = "teleplot:", kFoxgloveTo = "foxglove:",
                           kDdsTo = "dds";

bool is_trace(const std::string& path) {
  return path.ends_with(".trace") || path.ends_with(".log");
}

/// A whole number of this type, if it is one.
template <class T>
std::optional<std::uint64_t> whole_bits(double value) {
  constexpr double kLow = static_cast<double>(std::numeric_limits<T>::min());
  // The greatest one is rounded up where it has 64 bits.
  constexpr T kHalf = std::numeric_limits<T>::max() / 2 + 1;
  constexpr double kBehind = static_cast<double>(kHalf) * 2.0;
  if (!(value >= kLow && value < kBehind)) return std::nullopt;
  return canonical_bits(static_cast<T>(value));
}

/// As the trace hashes it; nothing if the type has no such number.
std::optional<std::uint64_t> bits_of(trace_log::Dtype dtype, double value) {
  using trace_log::Dtype;
  switch (dtype) {
    case Dtype::float32:
      return canonical_bits(static_cast<float>(value));
    case Dtype::float64:
      return canonical_bits(value);
    case Dtype::int8:
      return whole_bits<std::int8_t>(value);
    case Dtype::int16:
      return whole_bits<std::int16_t>(value);
    case Dtype::int32:
      return whole_bits<std::int32_t>(value);
    case Dtype::int64:
      return whole_bits<std::int64_t>(value);
    case Dtype::uint8:
      return whole_bits<std::uint8_t>(value);
    case Dtype::uint16:
      return whole_bits<std::uint16_t>(value);
    case Dtype::uint32:
      return whole_bits<std::uint32_t>(value);
    case Dtype::uint64:
      return whole_bits<std::uint64_t>(value);
    case Dtype::boolean:
      break;
  }
  return value == 0.0 || value == 1.0 ? std::optional<std::uint64_t>(value != 0.0) : std::nullopt;
}

}  // namespace

class Recording::Destinations {
 public:
  std::string path;                   // of the file; empty: none
  std::vector<std::string> forwards;  // as they were written

  /// Opens all. Empty, or what is wrong.
  std::string open(const StreamFacts& facts, const Expected* expected) {
    facts_ = facts;
    channels_ = facts.channels;
    hash_ = facts.hash.value_or(0);
    has_scenes_ = facts.has_scenes;
    if (expected != nullptr) {
      channels_.clear();
      for (const ExpectedChannel& each : expected->channels) channels_.push_back(each.channel);
      hash_ = expected->hash;
      expected_ = expected;
      has_scenes_ = has_scenes_ || expected->has_scenes;
      facts_.graph = expected->graph;
      facts_.engine = expected->engine;
    }
    if (channels_.empty())
      return "error: the stream does not say what its messages are\nhelp: name the graph of the "
             "program, `--graph GRAPH.yaml`";
    if (is_trace(path) && facts.channels.empty())
      return fmt::format(
          "error: the stream leaves messages out, so `{}` would be the trace of no "
          "run\nhelp: record a file .mcap, or start the program with `--trace`",
          path);
    for (std::size_t i = 0; i < channels_.size(); ++i) places_.emplace(channels_[i].name, i);
    if (is_trace(path)) {
      sinks_.push_back(trace_file(path, facts_, channels_));
    } else if (!path.empty()) {
      sinks_.push_back(mcap_file(path, channels_));
    }
    // The file, if there is one, is the first.
    for (const std::string& to : forwards) sinks_.push_back(sink_to(to));
    std::string problem;
    for (const auto& sink : sinks_) {
      if (problem.empty()) problem = sink->open();
      if (problem.empty() && !sink->note().empty()) notes_ += sink->note() + "\n";
    }
    return problem;
  }
  /// Notes for the user, printed once.
  std::string take_notes() { return std::exchange(notes_, {}); }
  foxglove::Server* serve(foxglove::Site site, std::vector<foxglove::Topic> topics,
                          std::string& problem) {
    foxglove::Served served = what_is_served();
    served.site = std::move(site);
    served.topics = std::move(topics);
    auto server = foxglove::server({"127.0.0.1", "0", "--live"}, std::move(served));
    foxglove::Server* const opened = server.get();
    sinks_.push_back(std::move(server));
    has_clients_ = true;
    problem = opened->open();
    return problem.empty() ? opened : nullptr;
  }
  [[nodiscard]] bool is_open() const { return !channels_.empty(); }
  [[nodiscard]] bool has_some() const { return !path.empty() || !forwards.empty() || has_clients_; }
  [[nodiscard]] bool has_clients() const { return has_clients_; }
  [[nodiscard]] bool wants_scenes() const {
    return has_clients_ || ranges::any_of(forwards, [](const std::string& to) {
             return to.starts_with(kFoxgloveTo);
           });
  }
  void scene(const StreamScene& scene) {
    const std::int64_t time_ns = in_all_runs(scene.time_ns);
    for (const auto& sink : sinks_)
      sink->scene({scene.episode, time_ns, scene.rows.data(), scene.rows.size() / kSceneColumns});
  }

  /// Another run begins: its time continues after that of the previous run.
  void next_run() {
    if (has_begun_) base_ns_ = last_ns_ + static_cast<std::int64_t>(kNsInSecond);
    has_begun_ = true;
  }

  /// False: the message is none of these channels.
  bool message(const StreamMessage& message) {
    const auto place = places_.find(message.channel);
    if (place == places_.end()) return false;
    const trace_log::RecordedChannel& channel = channels_[place->second];
    if (message.elements != channel.size || !take_bits(message, channel)) return false;
    const publish::PublishedMessage out{static_cast<std::uint32_t>(place->second), message.episode,
                                        message.seq.value_or(0), in_all_runs(message.time_ns),
                                        bits_.data()};
    for (const auto& sink : sinks_) sink->message(out);
    return true;
  }
  void step(const StreamStep& step) {
    for (const auto& sink : sinks_)
      sink->step({step.episode, step.step.value_or(steps_), in_all_runs(step.time_ns)});
    ++steps_;
  }
  /// False: the file takes no more.
  bool idle() {
    for (const auto& sink : sinks_) sink->idle();
    return path.empty() || sinks_.empty() || sinks_.front()->dropped() == 0;
  }
  std::string close() {
    std::string problem;
    for (const auto& sink : std::exchange(sinks_, {})) {
      const std::string wrong = sink->close();
      if (problem.empty()) problem = wrong;
    }
    return problem;
  }

 private:
  std::unique_ptr<publish::PublishSink> sink_to(const std::string& to) {
    publish::Address address;
    const std::string_view all = to;
    if (all.starts_with(kFoxgloveTo)) {
      publish::parse_local_address(all.substr(kFoxgloveTo.size()), address);
      address.said = "--forward " + to;
      has_clients_ = true;
      return foxglove::server(address, what_is_served());
    }
    if (all.starts_with(kDdsTo)) {
      dds::Network network;
      dds::parse_network(all.substr(kDdsTo.size()), network);
      return dds::topic_sink(network, "--forward " + to, channels_, dds_graph(),
                             std::vector<bool>(channels_.size(), true));
    }
    const bool is_udp = all.starts_with(kUdpTo);
    publish::parse_address(all.substr((is_udp ? kUdpTo : kTeleplotTo).size()), address);
    address.said = "--forward " + to;
    return is_udp ? publish::udp_sink(address, channels_, hash_)
                  : publish::teleplot_sink(address, channels_);
  }
  /// A channel without a known type: its messages are arrays then.
  [[nodiscard]] dds::Graph dds_graph() const {
    dds::Graph graph{facts_.graph, {}};
    for (const trace_log::RecordedChannel& channel : channels_) {
      const auto* const known = expected_ != nullptr ? expected_->find(channel.name) : nullptr;
      dds::Port port{channel.name, channel.name, channel.dtype, {}, false};
      if (known != nullptr) {
        port.name = known->port;
        port.shape = known->shape;
        port.is_sensor = known->is_sensor;
      } else if (channel.size > 1) {
        port.shape = {static_cast<std::uint32_t>(channel.size)};
      }
      graph.ports.push_back(std::move(port));
    }
    return graph;
  }
  [[nodiscard]] foxglove::Served what_is_served() const {
    foxglove::Served served;
    served.graph = facts_.graph;
    served.engine = facts_.engine;
    served.graph_hash = hash_;
    served.channels = &channels_;
    served.chosen.assign(channels_.size(), true);
    served.has_scene = has_scenes_;
    return served;
  }
  bool take_bits(const StreamMessage& message, const trace_log::RecordedChannel& channel) {
    bits_.clear();
    if (message.bits != nullptr) {
      bits_.assign(message.bits, message.bits + message.elements);
      return true;
    }
    for (const double value : message.values) {
      const auto bits = bits_of(channel.dtype, value);
      if (!bits) return false;
      bits_.push_back(*bits);
    }
    return bits_.size() == channel.size;
  }
  std::int64_t in_all_runs(std::int64_t time_ns) {
    last_ns_ = std::max(last_ns_, base_ns_ + time_ns);
    return base_ns_ + time_ns;
  }

  StreamFacts facts_;
  publish::PublishedChannels channels_;
  std::map<std::string, std::size_t, std::less<>> places_;
  std::vector<std::unique_ptr<publish::PublishSink>> sinks_;
  std::vector<std::uint64_t> bits_;
  std::uint64_t hash_ = 0;  // of the graph
  const Expected* expected_ = nullptr;
  std::string notes_;
  bool has_scenes_ = false, has_clients_ = false, has_begun_ = false;
  std::int64_t base_ns_ = 0, last_ns_ = 0;
  std::uint64_t steps_ = 0;  // so far, where messages have no numbers
};

Recording::Recording(const Expected* expected)
    : destinations_(std::make_unique<Destinations>()), expected_(expected) {}
Recording::~Recording() = default;

void Recording::record(const std::string& path) {
  destinations_->path = path;
}
void Recording::forward(const std::string& destination) {
  destinations_->forwards.push_back(destination);
}

foxglove::Server* Recording::serve(foxglove::Site site, std::vector<foxglove::Topic> topics,
                                   std::string& problem) {
  problem = destinations_->open({}, expected_);
  return problem.empty() ? destinations_->serve(std::move(site), std::move(topics), problem)
                         : nullptr;
}

bool Recording::begin(const StreamFacts& facts) {
  if (!destinations_->has_some() || !problem_.empty()) return true;
  if (!destinations_->is_open()) {
    problem_ = destinations_->open(facts, expected_);
    destinations_->next_run();
  } else if (is_trace(destinations_->path)) {
    problem_ =
        fmt::format("error: another run begins, and `{}` is the trace of one", destinations_->path);
  } else {
    destinations_->next_run();
  }
  return true;
}

void Recording::message(const StreamMessage& message) {
  if (destinations_->is_open() && !destinations_->message(message)) ++left_out_;
}
void Recording::step(const StreamStep& step) {
  destinations_->step(step);
}
void Recording::idle() {
  if (!destinations_->idle() && problem_.empty()) problem_ = destinations_->close();
}
std::string Recording::take_notes() {
  return destinations_->take_notes();
}
bool Recording::has_clients() const {
  return destinations_->has_clients();
}
void Recording::scene(const StreamScene& scene) {
  if (destinations_->is_open()) destinations_->scene(scene);
}
bool Recording::wants_scenes() const {
  return destinations_->wants_scenes();
}
std::string Recording::finish() {
  const std::string wrong = destinations_->close();
  return problem_.empty() ? wrong : problem_;
}

bool is_recording(const std::string& path) {
  return path.ends_with(".mcap") || is_trace(path);
}

bool is_destination(const std::string& text) {
  publish::Address address;
  const std::string_view all = text;
  if (all.starts_with(kFoxgloveTo))
    return publish::parse_local_address(all.substr(kFoxgloveTo.size()), address);
  dds::Network network;
  if (all == kDdsTo || all.starts_with("dds:") || all.starts_with("dds@"))
    return dds::parse_network(all.substr(kDdsTo.size()), network);
  if (all.starts_with(kUdpTo)) return publish::parse_address(all.substr(kUdpTo.size()), address);
  return all.starts_with(kTeleplotTo) &&
         publish::parse_address(all.substr(kTeleplotTo.size()), address);
}

}  // namespace eagerx::gen
