// Answers to requests: permissions, addresses, methods. It knows no sockets.
#pragma once

#include <string>
#include <vector>

#include "generator/tools/serve/http.hpp"
#include "generator/tools/serve/programs.hpp"
#include "generator/tools/serve/session.hpp"

namespace eagerx::gen::serve {

class Router final : public HttpHandler {
 public:
  Router(Session& session, Programs& programs, std::string token, int port);

  [[nodiscard]] std::optional<Answer> refusal(const Asked& asked) const override;
  Answer answer(const Asked& asked) override;
  [[nodiscard]] Answer error(int status) const override;
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
