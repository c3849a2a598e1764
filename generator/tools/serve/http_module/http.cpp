// The server of `eagerx-gen serve`, by cpp-httplib.
#include "generator/tools/serve/http.hpp"

#include <httplib.h>

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
  httplib::Server server_;
};

}  // namespace
}  // namespace eagerx::gen::serve

extern "C" __attribute__((visibility("default"))) eagerx::gen::serve::HttpServer*
eagerx_http_server() {
  return new eagerx::gen::serve::Httplib;
}
