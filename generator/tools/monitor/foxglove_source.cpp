#include <fmt/format.h>

#include <map>
#include <optional>
#include <runtime/host/foxglove/server_message.hpp>
#include <runtime/host/foxglove/server_text.hpp>
#include <runtime/host/publish/address.hpp>
#include <runtime/host/trace/channel_name.hpp>
#include <runtime/host/web_socket/web_socket.hpp>
#include <utility>

#include "generator/tools/monitor/datagram.hpp"
#include "generator/tools/monitor/source.hpp"

namespace eagerx::gen {
namespace {

// Bounds of what a server can make it keep.
constexpr std::size_t kMostBytes = 8 << 20;       // of a message: a list of channels with schemas
constexpr std::size_t kMostValueBytes = 1 << 18;  // of one of a channel
constexpr std::size_t kMostDrawingBytes = 1 << 20;
constexpr std::int64_t kAgainNs = 500'000'000;  // between attempts to connect

/// A program that was started with `--publish foxglove:PORT`, or `monitor --forward` to such a
/// port.
class FoxgloveSource final : public Source, private web_socket::WebSocketListener {
 public:
  explicit FoxgloveSource(std::string name) : name_(std::move(name)) {}

  /// Empty, or the problem.
  std::string open(const publish::Address& at) {
    std::string problem;
    client_ = web_socket::web_socket_client(
        *this, {at.host, at.port, std::string(foxglove::kFoxgloveProtocol)}, kMostBytes, problem);
    return problem;
  }

  [[nodiscard]] int descriptor() const override { return client_->descriptor(); }
  [[nodiscard]] std::string problem() const override { return problem_; }

  State read(std::int64_t now_ns, StreamListener& listener) override {
    using Is = web_socket::WebSocketClient::State;
    listener_ = &listener;
    now_ns_ = now_ns;
    taken_ = 0;
    // A program may begin after who watches it.
    if (client_->state() == Is::absent && now_ns >= again_ns_) {
      again_ns_ = now_ns + kAgainNs;
      client_->connect();
    }
    const bool has_more = client_->service();
    const std::uint64_t too_large = client_->too_large();
    if (too_large > reported_too_large_)
      listener.fault(StreamFault::crowded_out, too_large - reported_too_large_);
    reported_too_large_ = too_large;
    if (is_refused_) return State::failed;
    if (client_->state() == Is::closed) return State::ended;
    if (client_->state() == Is::refused) {
      problem_ = fmt::format("error: who listens at `{}` speaks something else, or refuses", name_);
      return State::failed;
    }
    return has_more ? State::more : State::open;
  }

 private:
  struct Channel {
    std::string name;
    bool is_drawing = false;
  };

  void opened() override {}
  bool received(std::string_view bytes, bool is_text) override;
  void advertise(const foxglove::ServerMessage& message);
  void begin();
  void data(const foxglove::ServerMessage& message);
  void value(const Channel& channel, const foxglove::ServerMessage& message);

  using MessageKind = foxglove::ServerMessage::Kind;

  const std::string name_;
  std::unique_ptr<web_socket::WebSocketClient> client_;
  std::string problem_;
  StreamListener* listener_ = nullptr;
  std::int64_t now_ns_ = 0, again_ns_ = 0;
  int taken_ = 0;  // messages of this read()
  std::uint64_t reported_too_large_ = 0;
  StreamFacts facts_;
  bool has_begun_ = false, is_refused_ = false;
  std::map<std::uint32_t, Channel> channels_;  // by their numbers, which subscriptions have, too
  std::optional<std::uint32_t> steps_;         // the channel that counts them
  foxglove::ChannelValue value_;
  std::vector<float> rows_;
};

bool FoxgloveSource::received(std::string_view bytes, bool is_text) {
  constexpr int kMostAtOnce = 512;
  if (is_refused_) return false;
  const auto message =
      is_text ? foxglove::read_server_text(bytes) : foxglove::read_server_bytes(bytes);
  switch (message.kind) {
    case MessageKind::wrong:
      listener_->fault(StreamFault::damaged, 1);
      break;
    case MessageKind::info:
      facts_.graph = message.about("graph");
      facts_.engine = message.about("engine");
      facts_.hash = read_hash(message.about("graph_hash"));
      break;
    case MessageKind::advertise:
      advertise(message);
      break;
    case MessageKind::unadvertise:
      for (const std::uint32_t id : message.ids) channels_.erase(id);
      break;
    case MessageKind::data:
      data(message);
      break;
    case MessageKind::other:
      break;
  }
  return ++taken_ < kMostAtOnce;
}

/// Subscribes to the channels of the graph, and to the drawing if somebody wants it.
void FoxgloveSource::advertise(const foxglove::ServerMessage& message) {
  const std::string drawing = foxglove::drawing_topic().name, scene = foxglove::scene_topic().name;
  std::string list;
  for (const auto& each : message.channels) {
    const bool is_drawing = each.topic == drawing;
    facts_.has_scenes = facts_.has_scenes || is_drawing;
    if (!each.topic.starts_with('/') || each.encoding != "json" || each.topic == scene) continue;
    const std::string name = each.topic.substr(1);
    if (is_drawing ? !listener_->wants_scenes()
                   : name.find('/') == std::string::npos ||
                         !trace_log::problem_with_channel_name(name).empty())
      continue;
    if (channels_.size() >= kMostStreamChannels) {
      listener_->fault(StreamFault::crowded_out, 1);
      continue;
    }
    channels_[each.id] = {name, is_drawing};
    list +=
        fmt::format("{}{{\"id\":{},\"channelId\":{}}}", list.empty() ? "" : ",", each.id, each.id);
  }
  begin();
  if (!is_refused_ && !list.empty())
    client_->send("{\"op\":\"subscribe\",\"subscriptions\":[" + list + "]}");
}

void FoxgloveSource::begin() {
  if (!std::exchange(has_begun_, true)) is_refused_ = !listener_->begin(facts_);
}

void FoxgloveSource::data(const foxglove::ServerMessage& message) {
  const auto found = channels_.find(message.subscription);
  if (found == channels_.end() || !has_begun_) return listener_->fault(StreamFault::damaged, 1);
  if (!found->second.is_drawing) return value(found->second, message);
  std::uint32_t episode = 0;
  if (message.payload.size() > kMostDrawingBytes)
    return listener_->fault(StreamFault::crowded_out, 1);
  if (!foxglove::read_drawing(message.payload, episode, rows_))
    return listener_->fault(StreamFault::damaged, 1);
  listener_->scene({episode, message.time_ns, rows_});
}

void FoxgloveSource::value(const Channel& channel, const foxglove::ServerMessage& message) {
  if (message.payload.size() > kMostValueBytes)
    return listener_->fault(StreamFault::crowded_out, 1);
  if (!foxglove::read_channel_value(message.payload, kMostStreamElements, value_))
    return listener_->fault(StreamFault::damaged, 1);
  if (value_.elements > value_.values.size())
    listener_->fault(StreamFault::crowded_out, value_.elements - value_.values.size());
  listener_->message({.channel = channel.name,
                      .values = value_.values,
                      .elements = value_.elements,
                      .episode = value_.episode,
                      .seq = value_.tick,
                      .time_ns = message.time_ns,
                      .real_ns = now_ns_});
  // Every step has one action.
  if (!steps_ && channel.name.starts_with("environment/")) steps_ = message.subscription;
  if (steps_ == message.subscription)
    listener_->step({value_.episode, value_.tick + 1, message.time_ns, now_ns_});
}

}  // namespace

std::unique_ptr<Source> open_foxglove_source(const std::string& name, std::string_view address,
                                             std::string& problem) {
  publish::Address at;
  if (!publish::parse_local_address(address, at)) {
    problem = fmt::format(
        "error: `{}` is not a source\nhelp: `foxglove:PORT` or `foxglove:HOST:PORT`", name);
    return nullptr;
  }
  auto source = std::make_unique<FoxgloveSource>(name);
  const std::string why = source->open(at);
  if (why.empty()) return source;
  problem = fmt::format("error: `{}`: {}", name, why);
  return nullptr;
}

}  // namespace eagerx::gen
