#include "generator/tools/monitor/monitor.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "generator/support/command_line/command_line.hpp"
#include "generator/support/command_line/output.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/tools/monitor/expected.hpp"
#include "generator/tools/monitor/lines.hpp"
#include "generator/tools/monitor/numbers.hpp"
#include "generator/tools/monitor/recording.hpp"
#include "generator/tools/monitor/screen.hpp"
#include "generator/tools/monitor/source.hpp"
#include "generator/tools/monitor/watching.hpp"

namespace eagerx::gen {
namespace {

constexpr std::int64_t kNsPerMs = 1'000'000, kNsPerSec = 1'000'000'000;
// Polling interval of a growing file, and redraw interval of the screen.
constexpr std::int64_t kLookNs = 20 * kNsPerMs, kDrawNs = 100 * kNsPerMs;
constexpr std::int64_t kServeNs = 10 * kNsPerMs;  // of who is served

std::int64_t ns_of(double seconds) {
  constexpr double kMost = 1e9;
  return static_cast<std::int64_t>(std::min(seconds, kMost) * static_cast<double>(kNsPerSec));
}

/// How a program is started that sends to `source`; empty: it is another kind.
std::string help_to_publish(const std::string& source) {
  constexpr std::string_view kUdp = "udp:", kFoxglove = "foxglove:";
  const bool is_udp = source.starts_with(kUdp);
  if (!is_udp && !source.starts_with(kFoxglove)) return {};
  const bool has_host = source.find(':', (is_udp ? kUdp : kFoxglove).size()) != std::string::npos;
  return fmt::format("help: start a program with `--publish {}`\n",
                     is_udp && !has_host ? "udp:127.0.0.1:" + source.substr(kUdp.size()) : source);
}

class Watching {
 public:
  Watching(const MonitorOptions& options, const Expected* expected, std::unique_ptr<Source> source)
      : options_(options), source_(std::move(source)), model_(expected), recording_(expected) {
    if (!options.record.empty()) recording_.record(options.record);
    for (const std::string& to : options.forward) recording_.forward(to);
  }

  int run(Screen* screen) {
    int code = screen == nullptr ? lines() : this->screen(*screen);
    const std::string problem = recording_.finish();
    if (!problem.empty()) {
      last_words_ = problem;
      code = kInputOutput;
    } else if (screen != nullptr && is_refused()) {
      last_words_ = refusal_text(model_);
    } else if (screen != nullptr && has_failed()) {
      last_words_ = source_->problem();
      code = this->code();
    } else if (recording_.left_out() > 0) {
      last_words_ =
          fmt::format("note: {} not recorded, because of values that do not fit their types",
                      counted(recording_.left_out(), "message"));
    }
    return code;
  }
  /// Printed once the terminal is as it was; empty: nothing.
  [[nodiscard]] const std::string& last_words() const { return last_words_; }

 private:
  int lines();
  int screen(Screen& screen);

  using State = Source::State;

  void wait(std::int64_t until_ns, bool with_keys);
  void read();
  [[nodiscard]] bool is_over() const { return state_ == State::ended || has_failed(); }
  [[nodiscard]] bool has_failed() const {
    return state_ == State::failed || state_ == State::refused;
  }
  /// The exit code then.
  [[nodiscard]] int code() const { return state_ == State::refused ? kProblems : kInputOutput; }
  /// Before anything was shown: later ones change nothing.
  [[nodiscard]] bool is_refused() const {
    return !model_.has_messages() && !model_.refusal().empty();
  }
  /// Why there is nothing to show and never will be; nothing: there may be.
  [[nodiscard]] std::optional<int> gives_up(std::int64_t began_ns) const;
  bool print();

  const MonitorOptions& options_;
  std::unique_ptr<Source> source_;
  Model model_;
  Recording recording_;
  Both both_{model_, recording_};
  State state_ = State::open;
  std::string last_words_;
};

/// Until there is something to read, a key was pressed, or the time has come.
void Watching::wait(std::int64_t until_ns, bool with_keys) {
  if (state_ == State::more) return;
  pollfd waited[2] = {{-1, POLLIN, 0}, {with_keys ? STDIN_FILENO : -1, POLLIN, 0}};
  if (!is_over()) {
    waited[0].fd = source_->descriptor();
    if (waited[0].fd < 0) until_ns = std::min(until_ns, steady_ns() + kLookNs);
  }
  if (recording_.has_clients()) until_ns = std::min(until_ns, steady_ns() + kServeNs);
  const std::int64_t left_ns = std::max<std::int64_t>(until_ns - steady_ns(), 0);
  poll(waited, 2, static_cast<int>((left_ns + kNsPerMs - 1) / kNsPerMs));
}

void Watching::read() {
  if (is_over()) return recording_.idle();
  const std::int64_t now_ns = steady_ns();
  model_.now(now_ns);
  state_ = source_->read(now_ns, both_);
  recording_.idle();
  if (const std::string notes = recording_.take_notes(); !notes.empty()) complain("{}", notes);
}

std::optional<int> Watching::gives_up(std::int64_t began_ns) const {
  if (has_failed() && model_.refusal().empty()) {
    complain("{}\n", source_->problem());
    return code();
  }
  if (model_.has_messages()) return std::nullopt;
  if (is_refused()) {
    complain("{}\n", refusal_text(model_));
    return kProblems;
  }
  if (state_ == State::ended) {
    complain("error: `{}` has no messages\n", options_.source);
    return kProblems;
  }
  if (steady_ns() - began_ns < ns_of(options_.timeout_s)) return std::nullopt;
  complain("error: nothing came from `{}` in {}\n{}", options_.source,
           duration_text(options_.timeout_s), help_to_publish(options_.source));
  return kProblems;
}

/// False: the output is closed.
bool Watching::print() {
  model_.now(steady_ns());
  say_table(lines_text(model_));
  const auto why = flush_output();
  if (why) complain("error: cannot write the standard output: {}\n", *why);
  return !why;
}

int Watching::lines() {
  const std::int64_t began_ns = steady_ns();
  std::int64_t next_ns = 0, heard_ns = 0;  // next_ns: of a table; 0: nothing has come
  std::uint64_t heard = 0;
  say_table(lines_head());  // who reads it knows that the source is open
  static_cast<void>(flush_output());
  while (!is_interrupted()) {
    wait(next_ns != 0 ? next_ns : began_ns + ns_of(options_.timeout_s), false);
    read();
    if (const auto code = gives_up(began_ns)) return *code;
    if (!recording_.problem().empty()) return kInputOutput;
    if (!model_.has_messages()) continue;
    const std::int64_t now_ns = steady_ns();
    if (next_ns == 0) next_ns = now_ns + ns_of(options_.every_s);
    if (model_.messages() != heard) {
      heard = model_.messages();
      heard_ns = now_ns;
    }
    if (is_over()) return print() ? kDone : kInputOutput;
    if (now_ns < next_ns) continue;
    next_ns = std::max(next_ns + ns_of(options_.every_s), now_ns);
    if (!print()) return kInputOutput;
    if (options_.once || now_ns - heard_ns > ns_of(options_.timeout_s)) return kDone;
  }
  return kDone;
}

int Watching::screen(Screen& screen) {
  ScreenView view;
  std::optional<Model> paused;
  std::int64_t draw_ns = 0;
  while (!is_interrupted() && !view.ends && recording_.problem().empty()) {
    wait(draw_ns, true);
    read();
    if (is_refused()) return kProblems;
    const Model& shown = paused ? *paused : model_;
    while (const auto key = screen.key()) {
      press(*key, shown, view);
      draw_ns = 0;
    }
    if (view.paused && !paused) paused = model_;
    if (!view.paused) paused.reset();
    const std::int64_t now_ns = steady_ns();
    if (now_ns < draw_ns) continue;
    model_.now(now_ns);
    std::string note;
    if (state_ == State::ended) note = "the stream has ended";
    if (has_failed()) note = source_->problem();
    screen.draw(
        screen_lines(paused ? *paused : model_, view, screen.size(), options_.source, note));
    draw_ns = now_ns + kDrawNs;
  }
  return kDone;
}

}  // namespace

int watch(const MonitorOptions& options, const WatchedGraph* graph) {
  std::optional<Expected> expected;
  if (graph != nullptr) expected = expected_of(*graph->plan, graph->file, graph->hash);
  std::string problem;
  std::unique_ptr<Source> source = open_source(options.source, options.layout, problem);
  if (source == nullptr) {
    complain("{}\n", problem);
    return kInputOutput;
  }
  if (const std::string warning = source->warning(); !warning.empty())
    complain("note: {}\n", warning);
  const bool has_terminal = isatty(STDOUT_FILENO) == 1 && isatty(STDIN_FILENO) == 1;
  const bool in_lines = options.lines || options.once || !has_terminal;
  std::unique_ptr<Screen> screen;
  if (!in_lines) {
    screen = open_screen(problem);
    if (screen == nullptr) {
      complain("{}\n", problem);
      return kProblems;
    }
  }
  end_at_signals();
  Watching watching(options, expected ? &*expected : nullptr, std::move(source));
  const int code = watching.run(screen.get());
  screen.reset();
  if (!watching.last_words().empty()) complain("{}\n", watching.last_words());
  return code;
}

}  // namespace eagerx::gen
