#include "generator/tools/monitor/live.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/random.h>

#include <array>
#include <utility>

#include "generator/support/command_line/command_line.hpp"
#include "generator/support/command_line/output.hpp"
#include "generator/tools/monitor/expected.hpp"
#include "generator/tools/monitor/live_text.hpp"
#include "generator/tools/monitor/source.hpp"
#include "generator/tools/monitor/watching.hpp"

namespace eagerx::gen {
namespace {

constexpr int kServeMs = 10;                     // readers are served at this interval
constexpr std::int64_t kUpdateNs = 200'000'000;  // /monitor is updated at this interval

/// 128 bits of the system's generator; empty: it has none.
std::string new_key() {
  std::array<unsigned char, 16> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) return {};
  std::string key;
  for (const unsigned char byte : bytes) key += fmt::format("{:02x}", byte);
  return key;
}

class Live final : public Both {
 public:
  Live(Model& model, Recording& recording, Source& source)
      : Both(model, recording), model_(model), recording_(recording), source_(source) {}

  int run(foxglove::Server& server);

  bool begin(const StreamFacts& facts) override {
    arrivals_.clear();
    return Both::begin(facts);
  }
  void message(const StreamMessage& message) override {
    Both::message(message);
    arrivals_.add(message, model_.late_ns());
  }
  void step(const StreamStep& step) override {
    Both::step(step);
    time_ns_ = step.time_ns;
  }

 private:
  using State = Source::State;

  [[nodiscard]] bool is_over() const { return state_ != State::open && state_ != State::more; }
  [[nodiscard]] std::string note() const {
    if (state_ == State::ended) return "the stream has ended";
    return model_.has_messages() ? "" : "nothing has come yet";
  }
  /// Why nothing of this stream can be shown; empty: it can.
  [[nodiscard]] std::string failure() const {
    if (!model_.has_messages() && !model_.refusal().empty()) return refusal_text(model_);
    return state_ == State::failed || state_ == State::refused ? source_.problem() : "";
  }
  void read();

  Model& model_;
  Recording& recording_;
  Source& source_;
  Arrivals arrivals_;
  State state_ = State::open;
  std::int64_t time_ns_ = 0;
};

void Live::read() {
  pollfd waited{is_over() ? -1 : source_.descriptor(), POLLIN, 0};
  if (state_ != State::more) poll(&waited, 1, kServeMs);
  const std::int64_t now_ns = steady_ns();
  model_.now(now_ns);
  if (!is_over()) state_ = source_.read(now_ns, *this);
  recording_.idle();
}

int Live::run(foxglove::Server& server) {
  std::int64_t updated_ns = 0;
  while (!is_interrupted()) {
    read();
    if (const std::string why = failure(); !why.empty()) {
      complain("{}\n", why);
      return model_.refusal().empty() ? kInputOutput : kProblems;
    }
    if (!recording_.problem().empty()) return kInputOutput;
    if (steady_ns() - updated_ns < kUpdateNs) continue;
    updated_ns = steady_ns();
    server.say(0, time_ns_, monitor_text(model_, arrivals_, note()));
  }
  return kDone;
}

}  // namespace

int serve_live(LiveOptions options, const WatchedGraph& graph) {
  const Expected expected = expected_of(*graph.plan, graph.file, graph.hash);
  std::string problem;
  const std::unique_ptr<Source> source = open_source(options.source, options.layout, problem);
  if (source == nullptr) {
    complain("{}\n", problem);
    return kInputOutput;
  }
  if (const std::string warning = source->warning(); !warning.empty())
    complain("note: {}\n", warning);
  const std::string key = new_key();
  if (key.empty()) {
    complain("error: the system gives no random numbers\n");
    return kInputOutput;
  }
  Model model(&expected);
  Recording recording(&expected);
  foxglove::Server* const server =
      recording.serve({std::move(options.page), key}, {monitor_topic()}, problem);
  if (server == nullptr) {
    complain("{}\n", problem);
    return kInputOutput;
  }
  end_at_signals();
  say("{}/?key={}\n", server->address(), key);
  static_cast<void>(flush_output());
  Live live(model, recording, *source);
  const int code = live.run(*server);
  problem = recording.finish();
  if (!problem.empty()) complain("{}\n", problem);
  return problem.empty() ? code : kInputOutput;
}

}  // namespace eagerx::gen
