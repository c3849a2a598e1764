#include <algorithm>
#include <chrono>
#include <deque>
#include <map>
#include <optional>
#include <random>
#include <runtime/host/base/counted.hpp>
#include <runtime/host/base/hash.hpp>
#include <runtime/host/base/json.hpp>
#include <runtime/host/foxglove/access.hpp>
#include <runtime/host/foxglove/client_message.hpp>
#include <runtime/host/foxglove/scene_update.hpp>
#include <runtime/host/foxglove/server.hpp>
#include <runtime/host/foxglove/server_text.hpp>
#include <runtime/host/trace/json_text.hpp>
#include <runtime/host/web_socket/listener.hpp>
#include <runtime/host/web_socket/web_socket.hpp>
#include <set>
#include <thread>

namespace eagerx::foxglove {
namespace {

using publish::PublishedMessage;
using publish::PublishedScene;
using publish::PublishedStep;
using trace_log::append_json_message;
using web_socket::ClientId;
using web_socket::Handshake;
using web_socket::Page;
using web_socket::WebSocketOwner;
using web_socket::WebSocketServer;

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;
using Asked = ClientMessage::Kind;

enum ServerOp : std::uint8_t { kMessageData = 1, kTime = 2, kCallResponse = 3 };

/// Little-endian.
template <class T>
void append(std::string& to, T value) {
  for (std::size_t i = 0; i < sizeof(T); ++i)
    to += static_cast<char>(static_cast<std::uint8_t>(value >> (8 * i)));
}

class FoxgloveServer final : public Server, private WebSocketOwner {
 public:
  FoxgloveServer(publish::Address to, Served served)
      : to_(std::move(to)), served_(std::move(served)), steering_(served_.steering) {
    if (served_.has_scene) topics_ = {scene_topic(), drawing_topic()};
    topics_.insert(topics_.end(), served_.topics.begin(), served_.topics.end());
    subscribers_.resize(channels().size() + topics_.size());
  }

  std::string open() override;
  void message(const PublishedMessage& message) override;
  void scene(const PublishedScene& scene) override;
  void step(const PublishedStep& step) override {
    step_ = step;
    time_ns_ = step.time_ns;
  }
  void idle() override;
  std::string close() override;
  const char* unit() const override { return "messages"; }
  std::string more() const override;
  std::string address() const override { return "http://" + host_; }
  std::string note() const override { return note_; }
  void say(std::size_t topic, std::int64_t time_ns, const std::string& json) override {
    tell(topics_.size() - served_.topics.size() + topic, time_ns, [&] { return json; });
  }

 private:
  struct Client {
    bool may_change = false;
    int wrong = 0;  // messages
    bool wants_all_parameters = false;
    std::set<std::string> parameters;  // whose values it wants to know
  };
  struct Subscriber {
    ClientId client;
    std::uint32_t id;
  };
  struct Call {
    ClientId client;
    std::uint32_t service, id;
    std::uint64_t number;  // of the request
  };

  bool admit(const Handshake& handshake) override { return access_.may_read(handshake); }
  void opened(ClientId id, const Handshake& handshake) override;
  bool received(ClientId id, std::string_view message, bool is_text) override;
  void closed(ClientId id) override;

  const Page* page(std::string_view path, const Handshake& handshake) override;

  const publish::PublishedChannels& channels() const { return *served_.channels; }
  bool has_services() const { return steering_ != nullptr && steering_->has_services(); }
  void answer(ClientId client, const std::string& text);
  void say_wrong(ClientId client, const std::string& problem) {
    answer(client, status_text(StatusLevel::error, problem));
  }
  /// A message of a topic, which `text` makes if somebody wants it.
  template <class Text>
  void tell(std::size_t topic, std::int64_t time_ns, Text text) {
    auto& subscribers = subscribers_[channels().size() + topic];
    if (subscribers.empty()) return;
    begin_frame(time_ns);
    frame_ += text();
    send_to(subscribers);
  }
  /// `frame_` has the beginning of a message, and what comes behind the subscription's number.
  void send_to(std::vector<Subscriber>& subscribers);
  void begin_frame(std::int64_t time_ns);
  void subscribe(ClientId client, const ClientMessage& message);
  void set_parameters(ClientId client, const ClientMessage& message);
  void tell_parameters(const std::vector<std::string>& names);
  void call(ClientId client, const ClientMessage& message);
  void answer_calls();
  void send_time();

  const publish::Address to_;
  const Served served_;
  Steering* const steering_;
  std::vector<Topic> topics_;  // behind the channels
  Access access_;
  std::string host_, note_;
  Page page_;
  std::string session_;
  std::map<ClientId, Client> clients_;
  std::vector<std::vector<Subscriber>> subscribers_;  // by channel, then by topic
  std::string frame_;
  std::deque<Call> calls_;
  std::uint64_t done_ = 0, sent_version_ = 0;
  PublishedStep step_{};
  std::int64_t time_ns_ = 0, sent_time_ns_ = -1;
  Clock::time_point sent_time_, sent_parameters_;
  std::uint64_t clients_in_all_ = 0;
  std::unique_ptr<WebSocketServer> server_;  // the last, for it still tells who is gone
};

std::string FoxgloveServer::open() {
  const std::string about = "error: `" + to_.said + "`: ";
  access_.key = served_.site.key;
  if (!served_.key_file.empty()) {
    std::string problem = read_key(served_.key_file, access_.key);
    if (!problem.empty()) return problem;
  }
  web_socket::Listener listener;
  std::string problem = web_socket::listen_on(to_.host, to_.port, listener);
  if (!problem.empty()) return about + problem;
  server_ = web_socket_server(*this, listener.socket, kFoxgloveProtocol, {}, problem);
  if (!server_) return about + problem;
  host_ = to_.host + ":" + listener.port;
  access_.is_loopback = listener.is_loopback;
  access_.is_real = served_.is_real;
  if (!served_.site.key.empty()) access_.only_host = host_;
  page_ = {served_.site.page, "text/html; charset=utf-8"};
  std::random_device random;
  session_ = std::to_string(random()) + std::to_string(random());
  if (!listener.is_loopback)
    note_ = "note: `" + to_.said + "` listens beyond this machine: every client may read it, " +
            (access_.key.empty() ? "and no client may change the run"
                                 : "and clients with the key may change the run");
  return {};
}

const Page* FoxgloveServer::page(std::string_view path, const Handshake& handshake) {
  return path == "/" && !page_.text.empty() && access_.may_see(handshake) ? &page_ : nullptr;
}

void FoxgloveServer::opened(ClientId id, const Handshake& handshake) {
  ++clients_in_all_;
  Client& client = clients_[id];
  client.may_change = steering_ != nullptr && access_.may_change(handshake);
  const bool has_services = client.may_change && this->has_services();
  answer(id, server_info_text("eagerx " + served_.graph, has_services, session_,
                              {{"graph", served_.graph},
                               {"graph_hash", host::hex_text(served_.graph_hash)},
                               {"engine", served_.engine},
                               {"may_change", client.may_change ? "true" : "false"}}));
  answer(id, advertise_text(channels(), served_.chosen, topics_));
  if (has_services) answer(id, advertise_services_text());
}

void FoxgloveServer::closed(ClientId id) {
  clients_.erase(id);
  for (auto& list : subscribers_)
    std::erase_if(list, [&](const Subscriber& each) { return each.client == id; });
  std::erase_if(calls_, [&](const Call& each) { return each.client == id; });
  if (steering_ != nullptr && steering_->release(id)) tell_parameters({});
}

/// A client that does not take answers is soon dropped.
void FoxgloveServer::answer(ClientId client, const std::string& text) {
  if (!server_->send(client, true, true, text)) server_->disconnect(client);
}

void FoxgloveServer::begin_frame(std::int64_t time_ns) {
  frame_.clear();
  frame_ += static_cast<char>(kMessageData);
  append(frame_, std::uint32_t{0});  // of the subscription
  append(frame_, static_cast<std::uint64_t>(time_ns));
}

void FoxgloveServer::send_to(std::vector<Subscriber>& subscribers) {
  for (const Subscriber& each : subscribers) {
    for (std::size_t i = 0; i < sizeof(each.id); ++i)
      frame_[1 + i] = static_cast<char>(static_cast<std::uint8_t>(each.id >> (8 * i)));
    ++(server_->send(each.client, false, false, frame_) ? sent_ : dropped_);
  }
}

void FoxgloveServer::message(const PublishedMessage& message) {
  time_ns_ = message.time_ns;
  auto& subscribers = subscribers_[message.channel];
  if (subscribers.empty()) return;
  begin_frame(message.time_ns);
  append_json_message(frame_, channels()[message.channel], message.episode, message.seq,
                      message.values);
  send_to(subscribers);
}

void FoxgloveServer::scene(const PublishedScene& scene) {
  if (!served_.has_scene) return;
  tell(0, scene.time_ns, [&] { return scene_update(scene.rows, scene.count, scene.time_ns); });
  tell(1, scene.time_ns, [&] { return drawing_text(scene.rows, scene.count, scene.episode); });
}

bool FoxgloveServer::received(ClientId id, std::string_view bytes, bool is_text) {
  constexpr int kMostWrong = 16;
  const ClientMessage message = is_text ? read_client_text(bytes) : read_client_bytes(bytes);
  Client& client = clients_[id];
  switch (message.kind) {
    case Asked::wrong:
      say_wrong(id, message.problem);
      return ++client.wrong < kMostWrong;
    case Asked::unsupported:
      answer(id, status_text(StatusLevel::warning, message.problem));
      break;
    case Asked::subscribe:
      subscribe(id, message);
      break;
    case Asked::unsubscribe:
      for (auto& list : subscribers_)
        std::erase_if(list, [&](const Subscriber& each) {
          return each.client == id &&
                 std::find(message.ids.begin(), message.ids.end(), each.id) != message.ids.end();
        });
      break;
    case Asked::get_parameters:
      answer(id, parameter_values_text(steering_ != nullptr ? steering_->values(message.names)
                                                            : std::vector<ParameterValue>(),
                                       message.id));
      break;
    case Asked::set_parameters:
      set_parameters(id, message);
      break;
    case Asked::subscribe_parameters:
      client.wants_all_parameters = client.wants_all_parameters || message.names.empty();
      for (const std::string& name : message.names)
        if (steering_ != nullptr && steering_->has(name)) client.parameters.insert(name);
      break;
    case Asked::unsubscribe_parameters:
      if (message.names.empty()) client.parameters.clear();
      client.wants_all_parameters = client.wants_all_parameters && !message.names.empty();
      for (const std::string& name : message.names) client.parameters.erase(name);
      break;
    case Asked::call:
      call(id, message);
      break;
  }
  return true;
}

void FoxgloveServer::subscribe(ClientId id, const ClientMessage& message) {
  for (const auto& [subscription, channel] : message.subscriptions) {
    const std::size_t index = std::size_t{channel} - 1;
    const auto& chosen = served_.chosen;
    if (channel == 0 || index >= subscribers_.size() || (index < chosen.size() && !chosen[index])) {
      say_wrong(id, "there is no channel " + std::to_string(channel));
      continue;
    }
    auto& list = subscribers_[index];
    // One a channel, so that a client costs no more than that.
    const bool has = std::any_of(list.begin(), list.end(),
                                 [&](const Subscriber& each) { return each.client == id; });
    has ? say_wrong(id, "channel " + std::to_string(channel) + " is subscribed to already")
        : list.push_back({id, subscription});
  }
}

void FoxgloveServer::set_parameters(ClientId id, const ClientMessage& message) {
  std::vector<std::string> names;
  for (const ClientMessage::Parameter& each : message.parameters) {
    names.push_back(each.name);
    const std::string problem = !clients_[id].may_change || steering_ == nullptr
                                    ? "this client may read and change nothing"
                                    : steering_->set(id, each);
    if (!problem.empty()) say_wrong(id, problem);
  }
  if (steering_ == nullptr || names.empty()) return;
  if (!message.id.empty()) answer(id, parameter_values_text(steering_->values(names), message.id));
  tell_parameters(names);
}

/// Those who want to know; without names all parameters may have changed.
void FoxgloveServer::tell_parameters(const std::vector<std::string>& names) {
  for (const auto& each : clients_) {
    const Client& client = each.second;
    if (!client.wants_all_parameters && client.parameters.empty()) continue;
    auto values = steering_->values(names);
    if (!client.wants_all_parameters)
      std::erase_if(values,
                    [&](const auto& value) { return !client.parameters.contains(value.name); });
    // A client that is behind receives the next change.
    if (!values.empty() && server_->has_room(each.first))
      answer(each.first, parameter_values_text(values, ""));
  }
}

void FoxgloveServer::call(ClientId id, const ClientMessage& message) {
  constexpr std::size_t kMostCalls = 64;
  const auto refuse = [&](const std::string& why) {
    answer(id, call_failure_text(message.service, message.call_id, why));
  };
  if (!clients_[id].may_change || !has_services()) return refuse("this client may not do that");
  if (message.service == 0 || message.service > kServices)
    return refuse("there is no such service");
  if (message.encoding != "json") return refuse("the encoding is not `json`");
  const auto service = static_cast<Service>(message.service);
  std::uint32_t steps = 0;
  if (service == Service::step) {
    steps = steps_of_request(message.request);
    if (steps == 0) return refuse("it takes `{\"steps\":N}`, from 1 on");
  }
  const std::uint64_t number = calls_.size() < kMostCalls ? steering_->ask(service, steps) : 0;
  if (number == 0) return refuse("the run is busy");
  calls_.push_back({id, message.service, message.call_id, number});
}

/// The work before the latest idle(): its messages are sent by now.
void FoxgloveServer::answer_calls() {
  while (!calls_.empty() && calls_.front().number <= done_) {
    const Call& call = calls_.front();
    constexpr std::string_view kEncoding = "json";
    std::string text;
    text += static_cast<char>(kCallResponse);
    append(text, call.service);
    append(text, call.id);
    append(text, static_cast<std::uint32_t>(kEncoding.size()));
    text += kEncoding;
    host::Json place(host::Json::Style::compact);
    place.begin_object().key("episode").whole(step_.episode).key("step").whole(step_.step);
    text += place.end_object().str();
    if (!server_->send(call.client, false, true, text)) server_->disconnect(call.client);
    calls_.pop_front();
  }
  if (steering_ != nullptr) done_ = steering_->done();
}

void FoxgloveServer::send_time() {
  const Clock::time_point now = Clock::now();
  if (time_ns_ == sent_time_ns_ || now - sent_time_ < 20ms) return;
  sent_time_ = now;
  sent_time_ns_ = time_ns_;
  std::string text;
  text += static_cast<char>(kTime);
  append(text, static_cast<std::uint64_t>(time_ns_));
  for (const auto& each : clients_) server_->send(each.first, false, false, text);
}

void FoxgloveServer::idle() {
  answer_calls();
  send_time();
  if (steering_ != nullptr) {
    if (steering_->release(Steering::kNoClient)) tell_parameters({});
    const std::uint64_t version = steering_->version();
    const Clock::time_point now = Clock::now();
    if (version != sent_version_ && version % 2 == 0 && now - sent_parameters_ > 50ms) {
      sent_version_ = version;
      sent_parameters_ = now;
      tell_parameters({});
    }
  }
  server_->service();
}

/// Clients that read get the rest; no wait is long.
std::string FoxgloveServer::close() {
  const Clock::time_point end = Clock::now() + 500ms;
  if (steering_ != nullptr) done_ = steering_->done();
  answer_calls();
  for (const Call& call : calls_)
    answer(call.client, call_failure_text(call.service, call.id, "the run is over"));
  calls_.clear();
  do {
    server_->service();
    if (server_->is_empty()) break;
    std::this_thread::sleep_for(1ms);
  } while (Clock::now() < end);
  return {};
}

std::string FoxgloveServer::more() const {
  std::string text = ", " + host::counted(clients_in_all_, "client");
  if (server_->refused() > 0) text += ", " + std::to_string(server_->refused()) + " refused";
  if (server_->disconnected() > 0)
    text += ", " + std::to_string(server_->disconnected()) + " disconnected";
  return text;
}

}  // namespace

std::unique_ptr<Server> server(const publish::Address& to, Served served) {
  return std::make_unique<FoxgloveServer>(to, std::move(served));
}

}  // namespace eagerx::foxglove
