#include "generator/serve/http.hpp"

#include <httplib.h>

#include <chrono>
#include <thread>

#include "generator/serve/status.hpp"

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

}  // namespace

std::string why_no_http() {
  return {};
}

struct HttpServer::Library {
  httplib::Server server;
};

HttpServer::HttpServer() : library_(std::make_unique<Library>()) {
  httplib::Server& server = library_->server;
  server.new_task_queue = [] { return new httplib::ThreadPool(kThreads); };
  server.set_keep_alive_max_count(1);
  server.set_read_timeout(kReadS);
  server.set_write_timeout(kWriteS);
  server.set_payload_max_length(Router::kMostBody);
  server.set_tcp_nodelay(true);
  server.set_default_headers({{"Referrer-Policy", "no-referrer"},
                              {"Cache-Control", "no-store"},
                              {"X-Content-Type-Options", "nosniff"},
                              {"X-Frame-Options", "DENY"},
                              {"Cross-Origin-Resource-Policy", "same-origin"}});
  // Another server's port is not taken over.
  server.set_socket_options([](auto socket) {
    const int yes = 1;
    setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  });
}

HttpServer::~HttpServer() = default;

int HttpServer::bind(int port) {
  httplib::Server& server = library_->server;
  if (port == 0) return std::max(server.bind_to_any_port("127.0.0.1"), 0);
  return server.bind_to_port("127.0.0.1", port) ? port : 0;
}

void HttpServer::run(Router& router) {
  httplib::Server& server = library_->server;
  server.set_pre_routing_handler([&](const httplib::Request& request, httplib::Response& response) {
    auto refused = router.refusal(asked_of(request));
    if (!refused) return httplib::Server::HandlerResponse::Unhandled;
    put(response, std::move(*refused));
    return httplib::Server::HandlerResponse::Handled;
  });
  const auto answer = [&](const httplib::Request& request, httplib::Response& response) {
    put(response, router.answer(asked_of(request)));
  };
  server.Get(".*", answer);
  server.Post(".*", answer);
  // What the library refuses itself: a body that is too large, a request that is none.
  server.set_error_handler([](const httplib::Request& /*request*/, httplib::Response& response) {
    if (!response.body.empty()) return;
    put(response, Router::error(response.status, response.status == kTooLarge
                                                     ? "the body is too large"
                                                     : "the request is none that is known"));
  });
  server.listen_after_bind();
}

void HttpServer::stop() {
  // Before it listens, the library has nothing to stop.
  while (!library_->server.is_running()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  library_->server.stop();
}

}  // namespace eagerx::gen::serve
