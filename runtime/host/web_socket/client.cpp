#include <array>
#include <deque>
#include <runtime/host/web_socket/library.hpp>
#include <runtime/host/web_socket/web_socket.hpp>
#include <utility>

namespace eagerx::web_socket {
namespace {

class LwsClient final : public WebSocketClient {
 public:
  LwsClient(WebSocketListener& listener, WebSocketAddress to, std::size_t message_bytes)
      : listener_(listener), to_(std::move(to)), message_bytes_(message_bytes) {}
  LwsClient(const LwsClient&) = delete;
  LwsClient& operator=(const LwsClient&) = delete;
  ~LwsClient() override {
    if (context_ != nullptr) lws.context_destroy(std::exchange(context_, nullptr));
  }

  bool open();
  void connect() override;
  bool service() override;
  State state() const override { return state_; }
  void send(std::string_view text) override {
    queue_.push_back(std::string(LWS_PRE, '\0') += text);
  }
  int descriptor() const override { return state_ == State::open ? lws.get_socket_fd(wsi_) : -1; }
  std::uint64_t too_large() const override { return too_large_; }

 private:
  static int on_event(::lws* wsi, lws_callback_reasons reason, void* /*user*/, void* in,
                      std::size_t size) {
    auto* const client = static_cast<LwsClient*>(lws.context_user(lws.get_context(wsi)));
    const bool is_own = client != nullptr && client->context_ != nullptr;
    return is_own ? client->event(wsi, reason, {static_cast<const char*>(in), in ? size : 0}) : 0;
  }
  int event(::lws* wsi, lws_callback_reasons reason, std::string_view in);
  int receive(::lws* wsi, std::string_view part);
  int write(::lws* wsi);
  void end(State why) {
    state_ = why;
    wsi_ = nullptr;
    received_.clear();
    queue_.clear();
  }

  WebSocketListener& listener_;
  const WebSocketAddress to_;
  const std::size_t message_bytes_;
  std::array<lws_protocols, 2> protocols_{};
  lws_context* context_ = nullptr;
  ::lws* wsi_ = nullptr;
  State state_ = State::absent;
  std::string received_;
  std::deque<std::string> queue_;  // behind LWS_PRE of the library's own
  bool is_binary_ = false, is_skipped_ = false, has_read_ = false, has_enough_ = false;
  std::uint64_t too_large_ = 0;
};

bool LwsClient::open() {
  constexpr std::size_t kAtOnce = 1 << 16;  // bytes
  protocols_[0].name = to_.protocol.c_str();
  protocols_[0].callback = on_event;
  protocols_[0].rx_buffer_size = kAtOnce;
  lws_context_creation_info info{};
  info.port = CONTEXT_PORT_NO_LISTEN;
  info.protocols = protocols_.data();
  info.user = this;
  info.options = LWS_SERVER_OPTION_VALIDATE_UTF8;
  info.fd_limit_per_thread = 8;
  info.pt_serv_buf_size = kAtOnce;
  info.retry_and_idle_policy = &kAliveness;
  lws.set_log_level(0, nullptr);
  context_ = lws.create_context(&info);
  return context_ != nullptr;
}

void LwsClient::connect() {
  if (state_ == State::connecting || state_ == State::open) return;
  const std::string host = to_.host + ":" + to_.port;
  lws_client_connect_info info{};
  info.context = context_;
  info.address = to_.host.c_str();
  info.port = std::atoi(to_.port.c_str());
  info.path = "/";
  info.host = host.c_str();
  info.protocol = to_.protocol.c_str();
  info.pwsi = &wsi_;
  state_ = State::connecting;
  // An immediate failure may have caused an event already.
  if (lws.client_connect_via_info(&info) == nullptr && state_ == State::connecting)
    end(State::absent);
}

bool LwsClient::service() {
  constexpr int kAtOnce = 64;  // reads
  has_enough_ = false;
  for (int i = 0; i < kAtOnce; ++i) {
    has_read_ = false;
    if (state_ == State::open && !queue_.empty()) lws.callback_on_writable(wsi_);
    lws.service(context_, -1);  // below 0: it does not wait
    if (!has_read_ && queue_.empty()) return false;
    if (has_enough_) return true;
  }
  return true;
}

int LwsClient::event(::lws* wsi, lws_callback_reasons reason, std::string_view in) {
  switch (reason) {
    case LWS_CALLBACK_CLIENT_CONNECTION_ERROR:
      // Who answers, and not as it should, is there.
      end(in.substr(0, 2) == "HS" ? State::refused : State::absent);
      return 0;
    case LWS_CALLBACK_CLIENT_ESTABLISHED:
      state_ = State::open;
      has_read_ = true;
      listener_.opened();
      return 0;
    case LWS_CALLBACK_CLIENT_RECEIVE:
      return receive(wsi, in);
    case LWS_CALLBACK_CLIENT_WRITEABLE:
      return write(wsi);
    case LWS_CALLBACK_CLIENT_CLOSED:
      end(State::closed);
      return 0;
    default:
      return 0;
  }
}

int LwsClient::receive(::lws* wsi, std::string_view part) {
  has_read_ = true;
  if (received_.empty() && !is_skipped_) is_binary_ = lws.frame_is_binary(wsi) != 0;
  const std::size_t rest = lws.remaining_packet_payload(wsi);
  if (received_.size() + part.size() + rest > message_bytes_) {
    too_large_ += is_skipped_ ? 0 : 1;
    is_skipped_ = true;
    received_.clear();
  }
  if (!is_skipped_) received_ += part;
  if (rest > 0 || lws.is_final_fragment(wsi) == 0) return 0;
  if (std::exchange(is_skipped_, false)) return 0;
  const std::string message = std::exchange(received_, {});
  if (!listener_.received(message, !is_binary_)) has_enough_ = true;
  return 0;
}

int LwsClient::write(::lws* wsi) {
  if (queue_.empty()) return 0;
  std::string& bytes = queue_.front();
  const std::size_t size = bytes.size() - LWS_PRE;
  auto* const begin = reinterpret_cast<unsigned char*>(bytes.data()) + LWS_PRE;
  if (lws.write(wsi, begin, size, LWS_WRITE_TEXT) < 0) return -1;
  queue_.pop_front();
  return 0;
}

}  // namespace

std::unique_ptr<WebSocketClient> web_socket_client(WebSocketListener& listener,
                                                   const WebSocketAddress& to,
                                                   std::size_t message_bytes,
                                                   std::string& problem) {
  auto client = std::make_unique<LwsClient>(listener, to, message_bytes);
  problem = load();
  if (problem.empty() && !client->open()) problem = "libwebsockets does not start";
  if (!problem.empty()) return nullptr;
  return client;
}

}  // namespace eagerx::web_socket
