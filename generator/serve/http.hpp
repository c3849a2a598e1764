// HTTP, by cpp-httplib. Inside serve/ only; without that library there is no_http.cpp.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "generator/serve/router.hpp"

namespace eagerx::gen::serve {

/// Why there is no server in this eagerx-gen; "": there is one.
std::string why_no_http();

/// A server on 127.0.0.1. A connection has one request, and a thread of its own, of which there are
/// a fixed number: one that is slow lets others go on.
class HttpServer {
 public:
  HttpServer();
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  /// Returns the port; 0: it cannot be had.
  int bind(int port);
  /// Answers until stop(); the calling thread waits.
  void run(Router& router);
  void stop();

 private:
  struct Library;
  std::unique_ptr<Library> library_;
};

}  // namespace eagerx::gen::serve
