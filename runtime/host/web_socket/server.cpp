#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <runtime/host/web_socket/library.hpp>
#include <runtime/host/web_socket/relay.hpp>
#include <runtime/host/web_socket/web_socket.hpp>
#include <utility>
#include <vector>

namespace eagerx::web_socket {
namespace {

using Clock = std::chrono::steady_clock;

class LwsServer final : public WebSocketServer {
 public:
  LwsServer(WebSocketOwner& owner, int listening, std::string_view protocol,
            const WebSocketLimits& limits)
      : owner_(owner), listening_(listening), protocol_(protocol), limits_(limits) {}
  LwsServer(const LwsServer&) = delete;
  LwsServer& operator=(const LwsServer&) = delete;
  ~LwsServer() override {
    if (context_ != nullptr) lws.context_destroy(context_);
    while (carry_all()) continue;
    ::close(listening_);
  }

  bool open();
  void service() override;
  bool send(ClientId client, bool is_text, bool is_answer, std::string_view message) override;
  bool has_room(ClientId client) const override;
  void disconnect(ClientId client) override;
  bool is_empty() const override;
  std::uint64_t refused() const override { return refused_; }
  std::uint64_t disconnected() const override { return disconnected_; }

 private:
  struct Message {
    bool is_text;
    std::string bytes;  // behind LWS_PRE of the library's own
  };
  struct Connection {
    ClientId client = 0;  // 0: it is none yet
    Handshake handshake;
    Clock::time_point since;  // the last good thing that it did
    std::string received;
    bool is_admitted = false, is_binary = false, is_ended = false;
    std::deque<Message> queue;
    std::size_t queued = 0;   // bytes
    std::string_view unsent;  // of the page that it is shown
    bool is_shown = false;
    std::shared_ptr<Relay> relay;
  };

  static int on_event(::lws* wsi, lws_callback_reasons reason, void* /*user*/, void* in,
                      std::size_t size) {
    auto* const server = static_cast<LwsServer*>(lws.context_user(lws.get_context(wsi)));
    return server != nullptr ? server->event(wsi, reason, in, size) : 0;
  }
  int event(::lws* wsi, lws_callback_reasons reason, const void* in, std::size_t size);
  int admit(::lws* wsi);
  int receive(::lws* wsi, Connection& from, const void* in, std::size_t size);
  int write(::lws* wsi, Connection& to);
  int show(::lws* wsi, Connection& to, std::string_view path);
  int write_page(::lws* wsi, Connection& to);
  int close_with(::lws* wsi, lws_close_status status);
  void forget(::lws* wsi);
  void accept_all();
  bool carry_all();
  int begin(::lws* wsi);
  int establish(::lws* wsi, Connection& connection);
  void look_at_clocks();
  void end(::lws* wsi, Connection& connection);
  std::optional<std::string> header(::lws* wsi, lws_token_indexes which) const;
  std::string key_of(::lws* wsi) const;
  std::optional<Handshake> handshake_of(::lws* wsi) const;

  WebSocketOwner& owner_;
  int listening_;
  const std::string protocol_;
  const WebSocketLimits limits_;
  std::array<lws_protocols, 3> protocols_{};
  lws_context* context_ = nullptr;
  lws_vhost* vhost_ = nullptr;
  std::map<::lws*, Connection> connections_;
  std::vector<std::shared_ptr<Relay>> relays_;  // the oldest first
  std::map<ClientId, ::lws*> clients_;
  ClientId last_client_ = 0;
  std::uint64_t written_ = 0, refused_ = 0, disconnected_ = 0;
};

bool LwsServer::open() {
  // Who asks for no protocol, or another one, gets the first.
  protocols_[0].name = "none";
  protocols_[1].name = protocol_.c_str();
  for (std::size_t i = 0; i < 2; ++i) {
    protocols_[i].callback = on_event;
    protocols_[i].rx_buffer_size = 4096;
    protocols_[i].tx_packet_size = 1 << 20;  // a message in one piece, if the socket takes it
  }
  lws_context_creation_info info{};
  info.port = CONTEXT_PORT_NO_LISTEN_SERVER;
  info.protocols = protocols_.data();
  info.user = this;
  info.options = LWS_SERVER_OPTION_EXPLICIT_VHOSTS | LWS_SERVER_OPTION_VALIDATE_UTF8;
  info.fd_limit_per_thread = static_cast<unsigned>(limits_.connections) + 16;
  info.max_http_header_pool = static_cast<unsigned short>(limits_.connections);
  info.retry_and_idle_policy = &kAliveness;
  info.server_string = "eagerx";
  lws.set_log_level(0, nullptr);
  context_ = lws.create_context(&info);
  if (context_ != nullptr) vhost_ = lws.create_vhost(context_, &info);
  return vhost_ != nullptr;
}

void LwsServer::service() {
  constexpr int kAtOnce = 16;
  accept_all();
  look_at_clocks();
  // Each time there is a call for every socket that takes something.
  for (int i = 0; i < kAtOnce; ++i) {
    const std::uint64_t before = written_;
    const bool did_carry = carry_all();
    for (auto& [wsi, connection] : connections_)
      if (!connection.queue.empty()) lws.callback_on_writable(wsi);
    lws.service(context_, -1);  // below 0: it does not wait
    if (written_ == before && !did_carry) break;
  }
}

void LwsServer::accept_all() {
  constexpr int kAtOnce = 16;
  for (int i = 0; i < kAtOnce; ++i) {
    const int fd = ::accept4(listening_, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK);
    if (fd < 0) return;
    const auto relay = std::make_shared<Relay>(fd);
    if (relays_.size() >= limits_.connections || relay->inner() < 0) {
      ++refused_;
      continue;
    }
    relays_.push_back(relay);
    // It may be gone before this returns: event() knows.
    static_cast<void>(lws.adopt_socket_vhost(vhost_, relay->inner()));
  }
}

/// Whether there was anything.
bool LwsServer::carry_all() {
  bool did_something = false;
  for (const auto& relay : relays_) {
    const bool was_unmasked = relay->is_unmasked();
    if (relay->carry()) did_something = true;
    if (relay->is_unmasked() && !was_unmasked) ++disconnected_;
    if (relay->is_no_request()) ++refused_;
  }
  std::erase_if(relays_, [](const auto& relay) { return relay->is_over(); });
  return did_something;
}

void LwsServer::look_at_clocks() {
  const Clock::time_point now = Clock::now();
  for (auto& [wsi, connection] : connections_) {
    const double s = std::chrono::duration<double>(now - connection.since).count();
    const bool is_new = connection.client == 0 && !connection.is_shown;
    const bool waits = !connection.queue.empty() || connection.is_shown;
    if (is_new ? s > limits_.handshake_s : waits && s > limits_.silence_s) end(wsi, connection);
  }
}

/// At the next service(), whatever the client does.
void LwsServer::end(::lws* wsi, Connection& connection) {
  if (connection.is_ended) return;
  connection.is_ended = true;
  ++disconnected_;
  lws.set_timeout(wsi, PENDING_TIMEOUT_KILLED_BY_PARENT, LWS_TO_KILL_ASYNC);
}

int LwsServer::event(::lws* wsi, lws_callback_reasons reason, const void* in, std::size_t size) {
  if (reason == LWS_CALLBACK_FILTER_PROTOCOL_CONNECTION) return admit(wsi);
  if (reason == LWS_CALLBACK_SERVER_NEW_CLIENT_INSTANTIATED) return begin(wsi);
  if (reason == LWS_CALLBACK_CLOSED || reason == LWS_CALLBACK_WSI_DESTROY) return forget(wsi), 0;
  const auto found = connections_.find(wsi);
  if (found == connections_.end()) return 0;
  Connection& connection = found->second;
  switch (reason) {
    case LWS_CALLBACK_HTTP:
      return show(wsi, connection, {static_cast<const char*>(in), size});
    case LWS_CALLBACK_HTTP_WRITEABLE:
      return write_page(wsi, connection);
    case LWS_CALLBACK_ESTABLISHED:
      return establish(wsi, connection);
    case LWS_CALLBACK_RECEIVE:
      return receive(wsi, connection, in, size);
    case LWS_CALLBACK_SERVER_WRITEABLE:
      return write(wsi, connection);
    default:
      return 0;
  }
}

int LwsServer::admit(::lws* wsi) {
  const auto found = connections_.find(wsi);
  if (found == connections_.end()) return -1;
  Connection& connection = found->second;
  const std::optional<Handshake> handshake = handshake_of(wsi);
  const std::string protocols = header(wsi, WSI_TOKEN_PROTOCOL).value_or("");
  connection.handshake = handshake.value_or(Handshake());
  connection.is_admitted = handshake && protocols.find(protocol_) != std::string::npos &&
                           owner_.admit(connection.handshake);
  if (connection.is_admitted) return 0;
  ++refused_;
  return -1;
}

int LwsServer::begin(::lws* wsi) {
  const int inner = lws.get_socket_fd(wsi);
  // One that has ended may have had the same number.
  const auto found = std::find_if(relays_.rbegin(), relays_.rend(),
                                  [&](const auto& relay) { return relay->inner() == inner; });
  if (found == relays_.rend()) return -1;
  Connection& connection = connections_[wsi];
  connection.since = Clock::now();
  connection.relay = *found;
  return 0;
}

int LwsServer::establish(::lws* wsi, Connection& connection) {
  if (!connection.is_admitted) return -1;
  connection.relay->answered(ClientBytes::Answer::web_socket);
  connection.client = ++last_client_;
  connection.since = Clock::now();
  clients_[connection.client] = wsi;
  owner_.opened(connection.client, connection.handshake);
  return 0;
}

int LwsServer::receive(::lws* wsi, Connection& from, const void* in, std::size_t size) {
  if (from.received.empty()) from.is_binary = lws.frame_is_binary(wsi) != 0;
  const std::size_t rest = lws.remaining_packet_payload(wsi);
  if (from.received.size() + size + rest > limits_.message_bytes)
    return close_with(wsi, LWS_CLOSE_STATUS_MESSAGE_TOO_LARGE);
  from.received.append(static_cast<const char*>(in), size);
  if (rest > 0 || lws.is_final_fragment(wsi) == 0) return 0;
  const std::string message = std::exchange(from.received, {});
  if (owner_.received(from.client, message, !from.is_binary)) return 0;
  return close_with(wsi, LWS_CLOSE_STATUS_POLICY_VIOLATION);
}

int LwsServer::close_with(::lws* wsi, lws_close_status status) {
  ++disconnected_;
  lws.close_reason(wsi, status, nullptr, 0);
  return -1;
}

int LwsServer::write(::lws* wsi, Connection& to) {
  while (!to.queue.empty() && lws.send_pipe_choked(wsi) == 0) {
    Message& message = to.queue.front();
    const std::size_t size = message.bytes.size() - LWS_PRE;
    auto* const begin = reinterpret_cast<unsigned char*>(message.bytes.data()) + LWS_PRE;
    if (lws.write(wsi, begin, size, message.is_text ? LWS_WRITE_TEXT : LWS_WRITE_BINARY) < 0)
      return -1;
    to.queued -= message.bytes.size();
    to.queue.pop_front();
    ++written_;
    to.since = Clock::now();
  }
  return 0;
}

/// A forbidden page is refused with a status and nothing else. One page a connection.
int LwsServer::show(::lws* wsi, Connection& to, std::string_view path) {
  constexpr unsigned kFound = 200, kRefused = 403;
  // A foreign page cannot have this one in a frame, and no other page learns its address.
  constexpr std::array<std::array<const char*, 2>, 4> kHeaders = {
      {{"cache-control:", "no-store"},
       {"referrer-policy:", "no-referrer"},
       {"x-frame-options:", "DENY"},
       {"x-content-type-options:", "nosniff"}}};
  if (to.is_shown) return -1;
  static const Page refused{"refused: the address is not the one that was printed\n",
                            "text/plain; charset=utf-8"};
  const std::optional<Handshake> handshake = handshake_of(wsi);
  const Page* page = handshake ? owner_.page(path, *handshake) : nullptr;
  if (page == nullptr) ++refused_;
  const unsigned status = page != nullptr ? kFound : kRefused;
  if (page == nullptr) page = &refused;
  std::array<unsigned char, LWS_PRE + 1024> head{};
  unsigned char* const begin = head.data() + LWS_PRE;
  unsigned char *at = begin, *const end = head.data() + head.size() - 1;
  if (lws.add_http_common_headers(wsi, status, page->type, page->text.size(), &at, end) != 0)
    return -1;
  for (const auto& [name, value] : kHeaders) {
    if (lws.add_http_header_by_name(wsi, reinterpret_cast<const unsigned char*>(name),
                                    reinterpret_cast<const unsigned char*>(value),
                                    static_cast<int>(std::string_view(value).size()), &at,
                                    end) != 0)
      return -1;
  }
  if (lws.finalize_write_http_header(wsi, begin, &at, end) != 0) return -1;
  to.unsent = page->text;
  to.is_shown = true;
  to.relay->answered(ClientBytes::Answer::page);
  to.since = Clock::now();
  lws.callback_on_writable(wsi);
  return 0;
}

int LwsServer::write_page(::lws* wsi, Connection& to) {
  constexpr std::size_t kAtOnce = 1 << 16;
  if (!to.is_shown || to.unsent.empty()) return -1;
  const std::string_view part = to.unsent.substr(0, kAtOnce);
  to.unsent.remove_prefix(part.size());
  std::string bytes(LWS_PRE, '\0');
  bytes += part;
  to.since = Clock::now();
  if (lws.write(wsi, reinterpret_cast<unsigned char*>(bytes.data()) + LWS_PRE, part.size(),
                to.unsent.empty() ? LWS_WRITE_HTTP_FINAL : LWS_WRITE_HTTP) < 0)
    return -1;
  ++written_;
  lws.callback_on_writable(wsi);
  return 0;
}

void LwsServer::forget(::lws* wsi) {
  const auto found = connections_.find(wsi);
  if (found == connections_.end()) return;
  const ClientId client = found->second.client;
  connections_.erase(found);
  if (client == 0) return;
  clients_.erase(client);
  owner_.closed(client);
}

bool LwsServer::has_room(ClientId client) const {
  const auto found = clients_.find(client);
  return found != clients_.end() &&
         connections_.find(found->second)->second.queued < limits_.queue_bytes;
}

bool LwsServer::send(ClientId client, bool is_text, bool is_answer, std::string_view message) {
  const auto found = clients_.find(client);
  if (found == clients_.end()) return false;
  Connection& to = connections_.find(found->second)->second;
  const std::size_t bytes = LWS_PRE + message.size();
  const std::size_t most = limits_.queue_bytes + (is_answer ? limits_.queue_bytes / 4 : 0);
  // A message that is larger than everything there is room for goes alone.
  if (to.queued + bytes > most && (!to.queue.empty() || !is_answer)) return false;
  if (to.queue.empty()) to.since = Clock::now();
  to.queue.push_back({is_text, std::string(LWS_PRE, '\0')});
  to.queue.back().bytes += message;
  to.queued += bytes;
  return true;
}

void LwsServer::disconnect(ClientId client) {
  const auto found = clients_.find(client);
  if (found != clients_.end()) end(found->second, connections_.find(found->second)->second);
}

bool LwsServer::is_empty() const {
  return std::all_of(connections_.begin(), connections_.end(),
                     [](const auto& each) { return each.second.queue.empty(); }) &&
         std::all_of(relays_.begin(), relays_.end(),
                     [](const auto& relay) { return relay->is_empty(); });
}

/// Empty without one; nothing if there is more of it than is good.
std::optional<std::string> LwsServer::header(::lws* wsi, lws_token_indexes which) const {
  std::array<char, 1024> text{};
  const int size = lws.hdr_copy(wsi, text.data(), static_cast<int>(text.size()), which);
  if (size < 0) return std::nullopt;
  return std::string(text.data(), static_cast<std::size_t>(size));
}

/// Nothing if a header does not fit: a long origin is not the same as none.
std::optional<Handshake> LwsServer::handshake_of(::lws* wsi) const {
  const auto origin = header(wsi, WSI_TOKEN_ORIGIN), host = header(wsi, WSI_TOKEN_HOST);
  if (!origin || !host) return std::nullopt;
  return Handshake{key_of(wsi), *origin, *host};
}

std::string LwsServer::key_of(::lws* wsi) const {
  constexpr int kMostArguments = 16;
  constexpr std::string_view kName = "key=", kBearer = "Bearer ";
  std::array<char, 1024> text{};
  for (int i = 0; i < kMostArguments; ++i) {
    const int size = lws.hdr_copy_fragment(wsi, text.data(), static_cast<int>(text.size()),
                                           WSI_TOKEN_HTTP_URI_ARGS, i);
    if (size < 0) break;
    const std::string_view argument(text.data(), static_cast<std::size_t>(size));
    if (argument.starts_with(kName)) return std::string(argument.substr(kName.size()));
  }
  const std::string authorization = header(wsi, WSI_TOKEN_HTTP_AUTHORIZATION).value_or("");
  return authorization.starts_with(kBearer) ? authorization.substr(kBearer.size()) : std::string();
}

}  // namespace

std::unique_ptr<WebSocketServer> web_socket_server(WebSocketOwner& owner, int listening,
                                                   std::string_view protocol,
                                                   const WebSocketLimits& limits,
                                                   std::string& problem) {
  auto server = std::make_unique<LwsServer>(owner, listening, protocol, limits);
  problem = load();
  if (problem.empty() && !server->open()) problem = "libwebsockets does not start";
  if (!problem.empty()) return nullptr;
  return server;
}

}  // namespace eagerx::web_socket
