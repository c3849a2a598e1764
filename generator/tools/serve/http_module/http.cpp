// The server of `eagerx-gen serve`, by cpp-httplib.
#include "generator/tools/serve/http.hpp"

#include <httplib.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <thread>
#include <utility>

namespace eagerx::gen::serve {
namespace {

constexpr std::size_t kThreads = 64;
constexpr int kReadS = 5, kWriteS = 30;

Asked asked_of(const httplib::Request& request) {
  Asked asked{request.method,
              request.path,
              request.get_header_value("Host"),
              request.get_header_value("Origin"),
              request.get_header_value("Content-Type"),
              {},
              request.body};
  for (const auto& [name, value] : request.params) asked.query.emplace_back(name, value);
  return asked;
}

void put(httplib::Response& response, Answer answer) {
  response.status = answer.status;
  response.set_content(std::move(answer.body), answer.type.c_str());
}

/// A connection of which no more is read than a request has: the library itself takes lines, and as
/// many of them, as somebody sends. Functions of all of its versions.
class LimitedStream final : public httplib::Stream {
 public:
  explicit LimitedStream(int socket) : socket_(socket) {}

  bool is_readable() const { return at_ < size_ || wait(POLLIN, kReadS); }
  bool is_writable() const { return wait(POLLOUT, kWriteS); }
  bool wait_readable() const { return is_readable(); }
  bool wait_writable() const { return is_writable(); }
  time_t duration() const { return 0; }
  void get_remote_ip_and_port(std::string& ip, int& port) const { ip = "127.0.0.1", port = 0; }
  void get_local_ip_and_port(std::string& ip, int& port) const { ip = "127.0.0.1", port = 0; }
  socket_t socket() const { return socket_; }

  ssize_t read(char* to, std::size_t size) {
    if (at_ == size_ && !fill()) return is_over_ ? -1 : 0;
    const std::size_t count = std::min(size, size_ - at_);
    for (std::size_t i = 0; i < count; ++i) {
      to[i] = bytes_[at_++];
      if (!is_counted(to[i])) return -1;
    }
    return static_cast<ssize_t>(count);
  }
  ssize_t write(const char* from, std::size_t size) {
    if (!is_writable()) return -1;
    return send(socket_, from, size, MSG_NOSIGNAL);
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::size_t kMostHead = std::size_t{32} << 10U;  // bytes
  static constexpr std::chrono::seconds kHead{10};

  bool wait(short what, int most_s) const {
    constexpr int kMsPerS = 1000;
    pollfd item{socket_, what, 0};
    int count = -1;
    while ((count = poll(&item, 1, most_s * kMsPerS)) < 0 && errno == EINTR) {
    }
    return count > 0;
  }
  bool fill() {
    const bool is_late = in_head_ && Clock::now() - begun_ > kHead;
    is_over_ = is_over_ || is_late || !wait(POLLIN, kReadS);
    if (is_over_) return false;
    const ssize_t count = recv(socket_, bytes_.data(), bytes_.size(), 0);
    is_over_ = count < 0;
    at_ = 0;
    size_ = count > 0 ? static_cast<std::size_t>(count) : 0;
    return count > 0;
  }
  /// False: it is one too many. A head ends with an empty line.
  bool is_counted(char byte) {
    const std::size_t most = in_head_ ? kMostHead : HttpServer::kMostBody;
    is_over_ = is_over_ || ++count_ > most;
    if (!in_head_) return !is_over_;
    if (byte == '\n' && is_line_empty_) in_head_ = false, count_ = 0;
    if (byte != '\r') is_line_empty_ = byte == '\n';
    return !is_over_;
  }

  const int socket_;
  const Clock::time_point begun_ = Clock::now();
  std::array<char, 4096> bytes_{};
  std::size_t at_ = 0, size_ = 0;
  std::size_t count_ = 0;  // of head or body
  bool in_head_ = true, is_line_empty_ = false, is_over_ = false;
};

/// One request a connection, from such a stream.
class LimitedServer final : public httplib::Server {
 public:
  bool process_and_close_socket(socket_t socket) override {
    LimitedStream stream(static_cast<int>(socket));
    const bool good = process(*this, stream);
    shutdown(static_cast<int>(socket), SHUT_RDWR);
    ::close(static_cast<int>(socket));
    return good;
  }

 private:
  /// Newer versions of the library want addresses, too.
  template <class Server>
  static bool process(Server& server, httplib::Stream& stream) {
    bool closed = false;
    const std::string address = "127.0.0.1";
    if constexpr (requires { server.process_request(stream, true, closed, nullptr); }) {
      return server.process_request(stream, true, closed, nullptr);
    } else {
      return server.process_request(stream, address, 0, address, 0, true, closed, nullptr);
    }
  }
};

/// Why the body of a request is refused: if it is compressed or comes in pieces, its length is
/// unknown. 0: it is accepted.
int refused_body(const httplib::Request& request) {
  constexpr int kUnsupported = 415, kTooLarge = 413, kBad = 400;
  if (request.has_header("Content-Encoding")) return kUnsupported;
  if (request.has_header("Transfer-Encoding")) return kBad;
  const std::string length = request.get_header_value("Content-Length");
  if (length.find_first_not_of("0123456789") != std::string::npos) return kBad;
  constexpr std::size_t kMostDigits = 7;
  const bool is_long = length.size() > kMostDigits ||
                       (!length.empty() && std::stoul(length) > HttpServer::kMostBody);
  return is_long ? kTooLarge : 0;
}

class Httplib final : public HttpServer {
 public:
  Httplib() {
    server_.new_task_queue = [] { return new httplib::ThreadPool(kThreads); };
    server_.set_keep_alive_max_count(1);
    server_.set_read_timeout(kReadS);
    server_.set_write_timeout(kWriteS);
    server_.set_payload_max_length(kMostBody);
    server_.set_tcp_nodelay(true);
    server_.set_default_headers({{"Referrer-Policy", "no-referrer"},
                                 {"Cache-Control", "no-store"},
                                 {"X-Content-Type-Options", "nosniff"},
                                 {"X-Frame-Options", "DENY"},
                                 {"Cross-Origin-Resource-Policy", "same-origin"}});
    // The library's own way would share the port of another server that allows it.
    server_.set_socket_options([](auto socket) {
      const int yes = 1;
      setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
  }

  int bind(int port) override {
    if (port == 0) return std::max(server_.bind_to_any_port("127.0.0.1"), 0);
    return server_.bind_to_port("127.0.0.1", port) ? port : 0;
  }

  void run(HttpHandler& handler) override {
    using Response = httplib::Server::HandlerResponse;
    server_.set_pre_routing_handler(
        [&](const httplib::Request& request, httplib::Response& response) {
          auto refused = handler.refusal(asked_of(request));
          if (const int status = refused_body(request); !refused && status != 0)
            refused = handler.error(status);
          if (!refused) return Response::Unhandled;
          put(response, std::move(*refused));
          return Response::Handled;
        });
    const auto answer = [&](const httplib::Request& request, httplib::Response& response) {
      put(response, handler.answer(asked_of(request)));
    };
    server_.Get(".*", answer);
    server_.Post(".*", answer);
    // What the library refuses itself.
    server_.set_error_handler(
        [&](const httplib::Request& /*request*/, httplib::Response& response) {
          if (response.body.empty()) put(response, handler.error(response.status));
        });
    server_.listen_after_bind();
  }

  void stop() override {
    // Before it listens, the library has nothing to stop.
    while (!server_.is_running()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    server_.stop();
  }

 private:
  LimitedServer server_;
};

}  // namespace
}  // namespace eagerx::gen::serve

extern "C" __attribute__((visibility("default"))) eagerx::gen::serve::HttpServer*
eagerx_http_server() {
  return new eagerx::gen::serve::Httplib;
}
