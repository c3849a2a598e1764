// HTTP, as serve/ sees it. The server is cpp-httplib's, in a module of its own (http_module/) that
// is loaded when it is needed: the library brings others whose loading would take longer than most
// commands, and eagerx-gen works without it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace eagerx::gen::serve {

/// A request. Header fields that are not there are empty.
struct Asked {
  std::string method, path;  // the path without the query, decoded
  std::string host, origin, type;
  std::vector<std::pair<std::string, std::string>> query = {};
  std::string body = {};
};

struct Answer {
  int status = 200;
  std::string type = "application/json";
  std::string body = {};
};

/// The handler of requests. Its functions are called from several threads.
class HttpHandler {
 public:
  HttpHandler() = default;
  HttpHandler(const HttpHandler&) = delete;
  HttpHandler& operator=(const HttpHandler&) = delete;
  virtual ~HttpHandler() = default;

  /// Why a request is refused before its body is looked at; nothing: it is not.
  [[nodiscard]] virtual std::optional<Answer> refusal(const Asked& asked) const = 0;
  /// The answer to a request that is not refused.
  virtual Answer answer(const Asked& asked) = 0;
  /// To what is no request, or one that is too large.
  [[nodiscard]] virtual Answer error(int status) const = 0;
};

/// A server on 127.0.0.1. A connection has one request, and a thread of its own, of which there are
/// a fixed number: a slow one does not block others.
class HttpServer {
 public:
  static constexpr std::size_t kMostBody = 1U << 20U;  // bytes

  HttpServer() = default;
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;
  virtual ~HttpServer() = default;

  /// Returns the port; 0: it cannot be had.
  virtual int bind(int port) = 0;
  /// Answers until stop(); the calling thread waits.
  virtual void run(HttpHandler& handler) = 0;
  virtual void stop() = 0;
};

/// The interface of the module, under the name `eagerx_http_server`.
using MakeHttpServer = HttpServer* (*)();

/// The server of the module in this file, which stays loaded; nothing: `problem` says why, in lines
/// for the user.
std::unique_ptr<HttpServer> load_http(const std::string& module, std::string& problem);

}  // namespace eagerx::gen::serve
