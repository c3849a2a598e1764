// The main program of a board without an operating system, with semihosting or a serial port, for
// any graph.
#pragma once

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <eagerx/float_environment.hpp>
#include <eagerx/trace_text.hpp>
#include <string_view>
#include <targets/common/bare-metal/clock.hpp>
#include <targets/common/bare-metal/console.hpp>
#include <targets/common/bare-metal/graph_note.hpp>
#include <targets/common/bare-metal/semihosting.hpp>
#include <targets/common/bare-metal/stack.hpp>
#include <targets/common/bare-metal/telemetry.hpp>
#include <targets/common/csv.hpp>
#include <targets/common/pace.hpp>
#include <targets/common/reward_check.hpp>
#include <targets/common/run.hpp>
#include <type_traits>

namespace eagerx::board {

/// The mode of a program; the words are those of linux-sim's options.
struct Options {
  target::RunPlan plan;
  target::Agent agent = target::Agent::zero;
  Output output = Output::semihosting;
  target::Pace pace = target::Pace::free;
  std::uint64_t late_limit = 10;  // late slots in a row that end a paced run
  bool csv = false;
  bool trace = false;
};

struct BoardClock {
  static std::uint64_t ticks() { return clock_ticks(); }
  static void wait_for(std::uint64_t ticks) { wait_for_clock(ticks); }
  static std::uint64_t hz() { return clock_hz(); }
};
template <class Graph>
using PacedHooks = target::PacedHooks<BoardClock, typename IdleWorkOf<Graph>::Type>;

#ifndef EAGERX_TRACE
#define EAGERX_TRACE 0
#endif
/// Whether the program knows --trace: 5 kB of flash. CMake's EAGERX_TRACE decides.
inline constexpr bool kTraces = EAGERX_TRACE != 0;

#ifndef EAGERX_STARTS_ALONE
#define EAGERX_STARTS_ALONE 0
#endif
/// Whether the options are in the image: then all text goes to the serial port.
inline constexpr bool kStartsAlone = EAGERX_STARTS_ALONE != 0;

/// Paces, makes the hash and, with --trace, prints every message.
template <class Graph>
class PrintingHooks : public PacedHooks<Graph> {
  using Base = PacedHooks<Graph>;

 public:
  using Text = TraceText<Console>;

  void print(bool prints) { prints_ = prints; }
  void on_episode(std::uint32_t index) {
    episode_ = index;
    Base::on_episode(index);
  }
  template <class Message>
  void on_message(std::uint32_t channel, Seq seq, const Message& message) {
    Base::on_message(channel, seq, message);
    if (prints_) print_message(channel, seq, message);
  }
  void print_end() const {
    if (prints_) Text::end(console, messages_, this->hash());
  }

 private:
  template <class Message>
  [[gnu::noinline]] void print_message(std::uint32_t channel, Seq seq, const Message& message) {
    ++messages_;
    Text::begin_message(console, episode_, Graph::kChannels[channel], seq);
    Text::values(console, message);
  }

  std::uint64_t messages_ = 0;  // that were printed
  std::uint32_t episode_ = 0;
  bool prints_ = false;
};

template <class Graph>
using PlainHooks = std::conditional_t<kTraces, PrintingHooks<Graph>, PacedHooks<Graph>>;
template <class Graph>
using Hooks =
    std::conditional_t<HasTelemetry<Graph>, TelemetryHooks<PlainHooks<Graph>>, PlainHooks<Graph>>;

/// Reads the words of the command line after the program's name.
class OptionParser {
 public:
  explicit OptionParser(std::string_view line) {
    // The name of the image comes first and may have spaces in it.
    line.remove_prefix(std::min(line.find(" --"), line.size()));
    rest_ = line;
  }

  /// False if a word is wrong; wrong() is that word.
  bool read(Options& options) {
    while (next()) {
      if (word_ == "--csv") {
        options.csv = true;
      } else if (kTraces && word_ == "--trace") {
        options.trace = true;
      } else if (word_ == "--timing") {
        options.pace = target::Pace::measured;
      } else if (word_ == "--pace") {
        options.pace = target::Pace::paced;
      } else if (!read_value(options)) {
        return false;
      }
    }
    return true;
  }
  std::string_view wrong() const { return word_; }

 private:
  bool read_value(Options& options) {
    using Setter = bool (OptionParser::*)(Options&) const;
    const Setter set = word_ == "--episodes"     ? &OptionParser::set_episodes
                       : word_ == "--steps"      ? &OptionParser::set_steps
                       : word_ == "--seed"       ? &OptionParser::set_seed
                       : word_ == "--agent"      ? &OptionParser::set_agent
                       : word_ == "--output"     ? &OptionParser::set_output
                       : word_ == "--late-limit" ? &OptionParser::set_late_limit
                                                 : nullptr;
    return set != nullptr && next() && (this->*set)(options);
  }

  bool set_episodes(Options& options) const {
    return number(options.plan.episodes) && options.plan.episodes > 0;
  }
  bool set_steps(Options& options) const {
    return number(options.plan.steps) && options.plan.steps > 0;
  }
  bool set_seed(Options& options) const { return number(options.plan.seed); }
  bool set_agent(Options& options) const {
    return target::agent_of(word_, options.agent) && options.agent != target::Agent::csv;
  }
  bool set_output(Options& options) const {
    options.output = word_ == "uart" ? Output::uart : Output::semihosting;
    return word_ == "uart" || word_ == "semihosting";
  }

  bool set_late_limit(Options& options) const {
    return number(options.late_limit) && options.late_limit > 0;
  }

  template <class T>
  bool number(T& value) const {
    const char* const end = word_.data() + word_.size();
    const std::from_chars_result result = std::from_chars(word_.data(), end, value);
    return result.ec == std::errc() && result.ptr == end;
  }

  bool next() {
    const std::size_t begin = rest_.find_first_not_of(' ');
    if (begin == std::string_view::npos) return false;
    rest_.remove_prefix(begin);
    // Not substr: it can throw, which the link forbids.
    word_ = {rest_.data(), std::min(rest_.find(' '), rest_.size())};
    rest_.remove_prefix(word_.size());
    return true;
  }

  std::string_view rest_;
  std::string_view word_;
};

/// Counts steps and prints the CSV.
template <class Graph>
class Watch : public target::Watch<Graph> {
 public:
  using typename target::Watch<Graph>::Action;
  using typename target::Watch<Graph>::Observation;
  using typename target::Watch<Graph>::Outcome;
  using Table = target::CsvTable<Graph, Console>;

  Watch(const Options& options, const PacedHooks<Graph>& hooks)
      : hooks_(hooks), late_limit_(options.late_limit), csv_(options.csv) {}

  bool go_on() const { return !too_late(); }
  /// Only slots with deadlines are ever late.
  std::uint64_t late_in_a_row() const { return hooks_.too_late_in_a_row(typename Graph::Rate{}); }
  bool too_late() const { return hooks_.timing().late_in_a_row >= late_limit_; }
  void reset(std::uint32_t episode, const Observation& observation) const {
    if (!csv_) return;
    if (episode == 0) Table::header(console, observation);
    Table::row(console, episode, 0, observation, nullptr, nullptr);
  }
  void step(std::uint32_t episode, Seq step, const Action& action, const Observation& observation,
            const Outcome& outcome) {
    ++steps_;
    rewards_.step(outcome);
    if (csv_) Table::row(console, episode, step, observation, &action, &outcome);
  }
  std::uint64_t steps() const { return steps_; }
  const target::RewardCheck<Outcome>& rewards() const { return rewards_; }

 private:
  const PacedHooks<Graph>& hooks_;
  target::RewardCheck<Outcome> rewards_;
  std::uint64_t steps_ = 0;
  std::uint64_t late_limit_;
  bool csv_;
};

inline int wrong_usage(std::string_view about, std::string_view word) {
  console.text("error: ");
  console.text(about);
  console.text(word);
  console.text(
      "\nhelp: [--episodes N] [--steps N] [--seed N] [--agent policy|zero|random] [--csv] "
      "[--output semihosting|uart] [--timing] [--pace] [--late-limit N]");
  console.text(kTraces ? " [--trace]\n" : "\n");
  return kBadUsage;
}

/// Fills `options` from the command line. Returns the exit code of a wrong one, otherwise kDone.
inline int read_options(Options& options, bool has_policy) {
  constexpr std::size_t kLongestCommandLine = 512;
  char line[kLongestCommandLine];
  const int length = semihosting_command_line(line, sizeof line);
  if (length < 0) return wrong_usage("the command line is longer than 511 characters", "");
  OptionParser parser({line, static_cast<std::size_t>(length)});
  if (!parser.read(options)) return wrong_usage("wrong option or value at ", parser.wrong());
  if (options.agent == target::Agent::policy && !has_policy) {
    return wrong_usage("this program has no ", "policy");
  }
  return kDone;
}

/// The line `name value`.
template <class T>
void print(std::string_view name, T value, std::string_view unit = "") {
  console.text(name);
  console.text(" ");
  if constexpr (std::is_convertible_v<T, std::string_view>) {
    console.text(value);
  } else {
    console.number(value);
  }
  console.text(unit);
  console.text("\n");
}

/// Ticks of the clock as nanoseconds, rounded down.
inline std::uint64_t ns(std::uint64_t ticks) {
  constexpr std::uint64_t kNsPerSecond = 1'000'000'000;
  const std::uint64_t hz = clock_hz();
  return ticks / hz * kNsPerSecond + ticks % hz * kNsPerSecond / hz;
}

/// Whether text and telemetry go over the same line.
inline bool shares_serial_port(const Options& options) {
  return options.pace == target::Pace::paced && (kStartsAlone || options.output == Output::uart);
}
/// Telemetry has that line for itself during the run: text would wait for it, and fall into frames.
inline int check_serial_port(const Options& options) {
  if (!shares_serial_port(options) || !(options.csv || options.trace)) return kDone;
  return wrong_usage("the serial port is taken by telemetry, so no table can be printed to it", "");
}

template <class Work>
void print_telemetry(const Work& work) {
  print("telemetry records", work.telemetry.records());
  print("telemetry dropped", work.telemetry.dropped());
}

inline void print_timing(const target::Timing& timing, target::Pace pace) {
  print("clock", clock_hz(), " Hz");
  print("slots", timing.slots);
  print("busy least", timing.busy.least, " ticks");
  print("busy most", timing.busy.most, " ticks");
  print("busy sum", timing.busy.sum, " ticks");
  if (pace != target::Pace::paced) return;
  print("period least", ns(timing.period.least), " ns");
  print("period most", ns(timing.period.most), " ns");
  print("late slots", timing.late);
  print("largest lateness", ns(timing.worst), " ns");
}

/// The main function: runs the episodes of the command line on this board, and prints the results.
template <class Graph>
int run(const char* board) {
  static_assert(note_graph<Graph> != nullptr);
  static_assert(
      target::default_agent<Graph>() != target::Agent::csv,
      "this graph has `agent: {csv: FILE}`, but a board has no files: generate it for boards "
      "with `agent: zero`, `random` or `{policy: FILE}`");
  Options options;
  options.plan = target::default_plan<Graph>();
  options.agent = target::default_agent<Graph>();
  int usage = read_options(options, Graph::kHasPolicy);
  if constexpr (HasTelemetry<Graph>) {
    if (usage == kDone) usage = check_serial_port(options);
  }
  console.send_to(options.output);
  if (usage != kDone) return console.flush(), usage;
  if (!calculates_as_everywhere()) {
    console.text("error: this board flushes denormal numbers, or does not round to nearest\n");
    return console.flush(), kSelfTestFailed;
  }
  if (!Graph::policies_answer()) {
    console.text("error: this board's answers of the policy differ from the generator's\n");
    return console.flush(), kSelfTestFailed;
  }

  using BoardHooks = Hooks<Graph>;
  constinit static typename Graph::template Program<BoardHooks> program{};
  if constexpr (kTraces) {
    program.hooks.print(options.trace);
    if (options.trace)
      BoardHooks::Text::head(console, traced_graph<Graph>(), options.plan.seed,
                             options.plan.environment, target::name_of(options.agent), false);
  }
  program.hooks.set_pace(options.pace, Graph::kSafety.max_lateness_ns);
  if (options.pace != target::Pace::free) start_clock();
  if constexpr (HasTelemetry<Graph>) {
    if (options.pace != target::Pace::free) program.hooks.idle_work.telemetry.start();
  }
  Watch<Graph> watch(options, program.hooks);
  const auto agent = [&](EpisodeKey key, Seq step, const typename Graph::Observation& observation) {
    return target::act<Graph>(options.agent, key, step, observation, program);
  };
  target::run_episodes<Graph>(options.plan, program, agent, watch);
  const bool too_late = watch.too_late();
  if (too_late) target::step_safely<Graph>(program);
  if constexpr (kTraces) program.hooks.print_end();
  target::stop(program);
  if constexpr (HasTelemetry<Graph>) {
    if (options.pace == target::Pace::paced) program.hooks.idle_work.finish();
  }

  print("graph", Graph::kName);
  print("engine", Graph::kEngine);
  print("board", board);
  print("agent", target::name_of(options.agent));
  print("seed", options.plan.seed);
  print("episodes", options.plan.episodes);
  print("steps", watch.steps());
  print("program", sizeof program, " bytes");
  print("stack", stack_used_bytes(), " bytes");
  const auto print_count = [](const char* name, std::uint64_t count) {
    if (count > 0) print(name, count);
  };
  target::for_each_fault(program, print_count);
  watch.rewards().for_each_count(print_count);
  if (options.pace != target::Pace::free) print_timing(program.hooks.timing(), options.pace);
  if constexpr (HasTelemetry<Graph>) {
    if (options.pace != target::Pace::free) print_telemetry(program.hooks.idle_work);
  }
  if (too_late)
    print("error: stopped with the safe action, late slots in a row:", options.late_limit);
  console.text("trace hash 0x");
  console.hex(program.hooks.hash());
  console.text("\n");
  console.flush();
  if constexpr (HasTelemetry<Graph>) {
    if (shares_serial_port(options)) uart_write('\0');  // ends the text for who reads frames
  }
  return too_late ? kTooLate : kDone;
}

}  // namespace eagerx::board
