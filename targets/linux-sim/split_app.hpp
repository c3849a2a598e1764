// The link of a split graph's program to its board, beside app.hpp.
#pragma once

#include <targets/common/partner.hpp>
#include <targets/linux-sim/app.hpp>
#include <targets/linux-sim/link_port.hpp>
#include <targets/linux-sim/split.hpp>

namespace eagerx::linux_sim {

template <class Graph>
using HostLinkOf = link::HostLink<LinkPort, Graph::Link::kToBoard, Graph::Link::kToHost>;
template <class Graph>
inline HostLinkOf<Graph> link_of_run{};

template <class Graph>
class LinkOfRun final : public SplitLink {
 public:
  LinkPort& port() override { return link().port; }
  link::Identity identity() const override {
    return {Graph::Link::kGraph, target::kRuntimeVersion};
  }
  void set_time_limit(std::uint64_t ns) override { link().set_time_limit(ns); }
  bool open(std::uint32_t session) override { return link().open(identity(), session); }
  bool ok() const override { return link().ok(); }
  link::Problem problem() const override { return link().problem(); }
  const link::Greeting& board() const override { return link().board(); }
  const link::Statistics& statistics() const override { return link().statistics(); }
  void forget_silence() override { link().on_silence(0, nullptr, nullptr); }
  bool finish(link::Report& report, CountListener& counts) override {
    return link().finish(report,
                         [&](const char* name, std::uint64_t count) { counts.count(name, count); });
  }

 private:
  static HostLinkOf<Graph>& link() { return link_of_run<Graph>; }
};

template <class Graph>
requires requires {
  typename Graph::Link;
}
struct LinkOf<Graph> {
  static constexpr bool kIsSplit = true;
  static constexpr bool kBoardDecides = Graph::Link::kBoardDecides;
  template <class Trace>
  using Program = typename Graph::template Program<Trace, HostLinkOf<Graph>>;

  static void tell(GraphFacts& facts) {
    facts.board = Graph::Link::kBoard;
    facts.board_decides = kBoardDecides;
    facts.board_knows_random = target::board_knows_random<Graph>;
  }
  static SplitLink* link() {
    static LinkOfRun<Graph> link;
    return &link;
  }
  /// Real hardware is made safe when the board is silent.
  template <class Program>
  static void connect(Program& program) {
    program.connect(link_of_run<Graph>);
    if constexpr (requires { program.make_safe(); }) {
      if (!program.is_real()) return;
      link_of_run<Graph>.on_silence(
          static_cast<std::uint64_t>(Graph::kSafety.link_timeout_ns),
          [](void* context) { static_cast<Program*>(context)->make_safe(); }, &program);
    }
  }
  static void begin(EpisodeKey key, target::Agent agent) {
    link_of_run<Graph>.begin_episode({key, static_cast<std::uint8_t>(agent)});
  }
  template <class Program>
  static void make_safe(Program& program) {
    if constexpr (kBoardDecides) program.link().make_safe();
  }
};

}  // namespace eagerx::linux_sim
