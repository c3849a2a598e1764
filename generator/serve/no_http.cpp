// eagerx-gen that was built without cpp-httplib.
#include "generator/serve/http.hpp"

namespace eagerx::gen::serve {

std::string why_no_http() {
  return "error: this eagerx-gen was built without a server\nhelp: install libcpp-httplib-dev and "
         "build it again";
}

struct HttpServer::Library {};

HttpServer::HttpServer() = default;
HttpServer::~HttpServer() = default;

int HttpServer::bind(int /*port*/) {
  return 0;
}
void HttpServer::run(Router& /*router*/) {}
void HttpServer::stop() {}

}  // namespace eagerx::gen::serve
