// What is answered to which request: who may ask, addresses, methods. It knows no sockets.
#pragma once

#include <string>
#include <vector>

#include "generator/serve/programs.hpp"
#include "generator/serve/session.hpp"

namespace eagerx::gen::serve {

/// A request of HTTP. Header fields that are not there are empty.
struct Asked {
  std::string method, path;  // the path without the query, decoded
  std::string host, origin, type;
  std::vector<std::pair<std::string, std::string>> query = {};
  std::string body = {};
  [[nodiscard]] const std::string* parameter(const std::string& name) const;
};

struct Answer {
  int status = 200;
  std::string type = "application/json";
  std::string body = {};
};

class Router {
 public:
  static constexpr std::size_t kMostBody = 1U << 20U;  // bytes

  Router(Session& session, Programs& programs, std::string token, int port);

  /// Why a request is refused before its body is looked at; nothing: it is not.
  [[nodiscard]] std::optional<Answer> refusal(const Asked& asked) const;
  /// The answer to a request that is not refused.
  Answer answer(const Asked& asked);
  /// An error in the form that all have.
  static Answer error(int status, const std::string& problem, const std::string& help = {});
  /// `http://127.0.0.1:PORT/TOKEN/`
  [[nodiscard]] std::string address() const;

 private:
  Answer get(const std::string& what, const Asked& asked);
  Answer post(const std::string& what, const Json& request);

  Session& session_;
  Programs& programs_;
  std::string token_;
  std::vector<std::string> hosts_;  // our names
};

}  // namespace eagerx::gen::serve
