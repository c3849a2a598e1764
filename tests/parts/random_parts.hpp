// A graph in one program, and the same in parts whose lines are memory: ./random_parts makes
// programs that compare both. The hub continues as long as it can: a part runs only while the hub
// waits for it.
#pragma once

#include <cstdint>
#include <cstdio>
#include <deque>
#include <eagerx/link/pipeline.hpp>
#include <eagerx/trace.hpp>
#include <memory>
#include <semaphore>
#include <targets/common/partner.hpp>
#include <targets/common/run.hpp>
#include <thread>
#include <tuple>
#include <utility>
#include <vector>

namespace eagerx::random_parts {

/// Both ends of a line, and whose turn it is.
struct Line {
  std::deque<std::uint8_t> to_part, to_hub;
  std::binary_semaphore part_turn{0}, hub_turn{0};
  bool is_closed = false;
  std::size_t on_way = 0, most_on_way = 0;  // frames without an answer

  void run_part() {
    part_turn.release();
    hub_turn.acquire();
  }
};

inline int next_of(std::deque<std::uint8_t>& bytes) {
  const int byte = bytes.front();
  bytes.pop_front();
  return byte;
}

struct HubPort {
  Line* line = nullptr;
  std::uint64_t clock_ns = 0;

  void put(std::uint8_t byte) { line->to_part.push_back(byte); }
  void flush() {
    ++line->on_way;
    line->most_on_way = std::max(line->most_on_way, line->on_way);
  }
  int get(std::uint64_t until_ns) {
    if (line->to_hub.empty()) line->run_part();
    if (!line->to_hub.empty()) return next_of(line->to_hub);
    clock_ns = until_ns;
    return link::kNothing;
  }
  std::uint64_t now_ns() const { return clock_ns; }
};

struct PartPort {
  Line* line = nullptr;

  void put(std::uint8_t byte) { line->to_hub.push_back(byte); }
  void flush() { --line->on_way; }
  int get() {
    while (line->to_part.empty()) {
      if (line->is_closed) return link::kClosed;
      line->hub_turn.release();
      line->part_turn.acquire();
    }
    return next_of(line->to_part);
  }
};

/// Observations of an agent and applied actions, step by step.
using Seen = std::vector<std::uint64_t>;

/// Keeps all of it, or looks at nothing.
template <class Graph>
struct KeepingWatch : target::Watch<Graph> {
  using typename target::Watch<Graph>::Action;
  using typename target::Watch<Graph>::Observation;
  using typename target::Watch<Graph>::Outcome;

  bool keeps = false;
  target::Agent agent = target::Agent::random;
  Seen seen{};
  void (*begin_parts)(void* star, EpisodeKey key) = nullptr;
  void* star = nullptr;

  bool looks() const { return keeps; }
  void begin(EpisodeKey key) {
    if (begin_parts != nullptr) begin_parts(star, key);
  }
  void reset(std::uint32_t episode, const Observation& observation) {
    seen.push_back(episode);
    see(observation);
  }
  void step(std::uint32_t /*episode*/, Seq step, const Action& action,
            const Observation& observation, const Outcome& /*outcome*/) {
    seen.push_back(step);
    if (keeps) action.for_each([&](const char*, const auto& message) { add(message); });
    see(observation);
  }

 private:
  void see(const Observation& observation) {
    if (!keeps) return;
    observation.for_each([&](const char*, const auto& window) {
      for (std::uint32_t i = 0; i < window.size(); ++i) add(window[i]);
    });
  }
  template <class Message>
  void add(const Message& message) {
    for (std::size_t i = 0; i < size_of<Message>; ++i)
      seen.push_back(canonical_bits(element(message, i)));
  }
};

struct CountingHooks : HashTrace {
  std::uint64_t messages = 0;
  template <class Message>
  void on_message(std::uint32_t channel, Seq seq, const Message& message) {
    ++messages;
    HashTrace::on_message(channel, seq, message);
  }
};

struct Result {
  std::uint64_t hash = 0, messages = 0;
  Seen seen{};
  bool is_whole = true;
  std::size_t most_on_way = 0;
};

template <class Graph, class Program>
Result run(const target::RunPlan& plan, Program& program, KeepingWatch<Graph>& watch,
           bool decides) {
  const auto agent = [&](EpisodeKey key, Seq step, const typename Graph::Observation& observation) {
    return decides ? target::act<Graph>(watch.agent, key, step, observation, program)
                   : Graph::zero();
  };
  target::run_episodes<Graph>(plan, program, agent, watch);
  target::drain(program);
  return {program.hooks.hash(), program.hooks.messages, std::move(watch.seen),
          target::is_linked(program)};
}

template <class Graph>
Result run_whole(const target::RunPlan& plan) {
  auto program = std::make_unique<typename Graph::template Program<CountingHooks>>();
  KeepingWatch<Graph> watch;
  watch.keeps = true;
  return run<Graph>(plan, *program, watch, true);
}

/// The program of a part, on a thread of its own.
template <class Graph>
class PartRun {
 public:
  explicit PartRun(Line& line) : line_(line) {
    link_->port.line = &line;
    thread_ = std::thread([this] {
      line_.part_turn.acquire();
      target::serve<Graph, PartPort>(*program_, *link_, [] { return std::uint32_t{0}; });
      line_.hub_turn.release();
    });
  }
  ~PartRun() {
    line_.is_closed = true;
    line_.run_part();
    thread_.join();
  }
  PartRun(const PartRun&) = delete;
  PartRun& operator=(const PartRun&) = delete;

 private:
  Line& line_;
  std::unique_ptr<target::BoardLinkOf<Graph, PartPort>> link_ =
      std::make_unique<target::BoardLinkOf<Graph, PartPort>>();
  std::unique_ptr<target::BoardProgramOf<Graph, PartPort>> program_ =
      std::make_unique<target::BoardProgramOf<Graph, PartPort>>();
  std::thread thread_;
};

template <class Hub, class... Parts>
class SplitRun {
 public:
  /// `pipelined`: not in lockstep; `looks`: at what the agent sees and gives, after each step.
  static Result run(const target::RunPlan& plan, bool pipelined, bool looks) {
    return SplitRun().run_parts(plan, pipelined, looks, std::index_sequence_for<Parts...>());
  }

 private:
  using Star = typename Hub::Link::template Star<HubPort>;
  static_assert(Star::kParts == sizeof...(Parts));

  template <std::size_t... K>
  Result run_parts(const target::RunPlan& plan, bool pipelined, bool looks,
                   std::index_sequence<K...> /*parts*/) {
    const std::tuple<PartRun<Parts>...> parts(lines_[K]...);
    star_.set_pipelined(pipelined);
    ((star_.template link<K>().port.line = &lines_[K]), ...);
    const bool open =
        (star_.template link<K>().open({Parts::Link::kGraph, target::kRuntimeVersion}, K + 1) &&
         ...);
    if (!open) return {.is_whole = false};
    auto program = std::make_unique<typename Hub::template Program<CountingHooks, Star>>();
    program->connect(star_);
    KeepingWatch<Hub> watch;
    watch.keeps = looks;
    watch.begin_parts = begin;
    watch.star = &star_;
    Result result = random_parts::run<Hub>(plan, *program, watch, !Hub::Link::kPartDecides);
    const auto finish = [](auto& link) {
      link::Report report;
      return link.finish(report, [](const char*, std::uint64_t) {});
    };
    result.is_whole = (finish(star_.template link<K>()) && ...) && result.is_whole;
    for (const Line& line : lines_)
      result.most_on_way = std::max(result.most_on_way, line.most_on_way);
    return result;
  }
  static void begin(void* star, EpisodeKey key) {
    static_cast<Star*>(star)->begin_episode(
        {key, static_cast<std::uint8_t>(target::Agent::random)});
  }

  Line lines_[sizeof...(Parts)];
  Star star_{};
};

/// Prints a line about a graph; returns how many of its runs differ from the whole program's.
/// Without an engine, what is seen is what leaves, after the guard of the program with the agent.
template <class Whole, class Hub, class... Parts>
int compare(const char* name, const target::RunPlan& plan) {
  const Result whole = run_whole<Whole>(plan);
  constexpr bool kSeesTheSame = requires {
    &Hub::template Program<>::warm_up;
  }
  || !Hub::Link::kPartDecides;
  int different = 0;
  std::size_t most = 0;
  for (const auto& [what, pipelined, looks] :
       {std::tuple("in lockstep", false, true), std::tuple("pipelined", true, false),
        std::tuple("pipelined, looked at", true, true)}) {
    const Result split = SplitRun<Hub, Parts...>::run(plan, pipelined, looks);
    most = std::max(most, split.most_on_way);
    const char* const problem = !split.is_whole                    ? "a link is over"
                                : split.messages != whole.messages ? "other messages"
                                : split.hash != whole.hash         ? "another hash"
                                : looks && kSeesTheSame && split.seen != whole.seen
                                    ? "its agent sees otherwise"
                                    : nullptr;
    if (problem == nullptr) continue;
    ++different;
    std::printf("FAIL %s %s: %s (%llu messages of %llu)\n", name, what, problem,
                static_cast<unsigned long long>(split.messages),
                static_cast<unsigned long long>(whole.messages));
  }
  std::printf("%s: %llu messages, %zu parts, %zu on their way\n", name,
              static_cast<unsigned long long>(whole.messages), sizeof...(Parts), most);
  return different;
}

}  // namespace eagerx::random_parts
