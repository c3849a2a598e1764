#include "generator/tools/serve/serve.hpp"

#include <fmt/format.h>
#include <sys/random.h>

#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <thread>

#include "generator/support/command_line/command_line.hpp"
#include "generator/support/command_line/output.hpp"
#include "generator/tools/serve/http.hpp"
#include "generator/tools/serve/programs.hpp"
#include "generator/tools/serve/router.hpp"
#include "generator/tools/serve/session.hpp"

namespace eagerx::gen::serve {
namespace {

/// 128 bits of the system's generator; empty: it has none.
std::string new_token() {
  std::array<unsigned char, 16> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) return {};
  std::string token;
  for (const unsigned char byte : bytes) token += fmt::format("{:02x}", byte);
  return token;
}

/// While it lives, the signals that end a program wait, in all threads that begin meanwhile.
class EndingSignals {
 public:
  EndingSignals() {
    sigemptyset(&signals_);
    for (const int each : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&signals_, each);
    pthread_sigmask(SIG_BLOCK, &signals_, &before_);
  }
  ~EndingSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  EndingSignals(const EndingSignals&) = delete;
  EndingSignals& operator=(const EndingSignals&) = delete;

  /// True: one came, within `wait_ms`.
  bool come(int wait_ms) {
    constexpr long kNsPerMs = 1'000'000;
    const timespec wait{0, wait_ms * kNsPerMs};
    return sigtimedwait(&signals_, nullptr, &wait) > 0;
  }

 private:
  sigset_t signals_{}, before_{};
};

}  // namespace

int serve(Workshop& workshop, const ServeOptions& options) {
  constexpr int kLookEveryMs = 200;
  std::string problem;
  const auto http = load_http(workshop.http_module(), problem);
  if (http == nullptr) {
    complain("{}\n", problem);
    return kInputOutput;
  }
  Session session(workshop, options.graph);
  if (!session.problem().empty()) {
    complain("error: cannot read `{}`: {}\n", options.graph, session.problem());
    return kInputOutput;
  }
  EndingSignals signals;  // before there is a thread
  const std::string token = new_token();
  const int port = http->bind(options.port);
  if (token.empty() || port == 0) {
    complain_text(token.empty() ? "error: the system gives no random numbers\n"
                                : fmt::format("error: port {} of 127.0.0.1 cannot be had\nhelp: "
                                              "leave `--port` out to get one that is free\n",
                                              options.port));
    return kInputOutput;
  }
  Programs programs(workshop.self(), options.graph);
  Router router(session, programs, token, port);
  std::atomic<bool> has_ended = false;
  std::thread thread([&] {
    http->run(router);
    has_ended = true;
  });
  say("{}\n", router.address());
  static_cast<void>(flush_output());
  while (!has_ended && !signals.come(kLookEveryMs)) session.look();
  const bool failed = has_ended;
  session.end();
  programs.end();
  if (!failed) http->stop();
  thread.join();
  return failed ? kInputOutput : kDone;
}

}  // namespace eagerx::gen::serve
