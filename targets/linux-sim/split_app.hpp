// The links of a hub to the parts of its graph, beside app.hpp.
#pragma once

#include <cstddef>
#include <targets/common/partner.hpp>
#include <targets/linux-sim/app.hpp>
#include <targets/linux-sim/link_port.hpp>
#include <targets/linux-sim/split.hpp>
#include <tuple>
#include <utility>

namespace eagerx::linux_sim {

template <class Graph>
using StarOf = typename Graph::Link::template Star<LinkPort>;
template <class Graph>
inline StarOf<Graph> star_of_run{};

template <class Graph, std::size_t K>
class LinkOfRun final : public SplitLink {
 public:
  LinkPort& port() override { return link().port; }
  const link::PartFacts& part() const override { return Graph::Link::kParts[K]; }
  const link::PartProgress& progress() const override { return star_of_run<Graph>.progress(K); }
  void set_time_limit(std::uint64_t ns) override { link().set_time_limit(ns); }
  bool open(std::uint32_t session) override {
    return link().open({part().graph, target::kRuntimeVersion}, session);
  }
  bool ok() const override { return link().ok(); }
  link::Problem problem() const override { return link().problem(); }
  const link::Greeting& greeting() const override { return link().board(); }
  const link::Statistics& statistics() const override { return link().statistics(); }
  void set_runs_ahead(bool runs_ahead) override { star_of_run<Graph>.set_runs_ahead(runs_ahead); }
  void forget_silence() override { link().on_silence(0, nullptr, nullptr); }
  bool finish(link::Report& report, CountListener& counts) override {
    return link().finish(report,
                         [&](const char* name, std::uint64_t count) { counts.count(name, count); });
  }

 private:
  static auto& link() { return star_of_run<Graph>.template link<K>(); }
};

template <class Graph, std::size_t... K>
SplitLink* link_of(std::size_t part, std::index_sequence<K...> /*parts*/) {
  static std::tuple<LinkOfRun<Graph, K>...> links;
  SplitLink* found = nullptr;
  ((K == part ? void(found = &std::get<K>(links)) : void()), ...);
  return found;
}

template <class Graph>
requires requires {
  typename Graph::Link;
}
struct LinkOf<Graph> {
  static constexpr bool kIsSplit = true;
  static constexpr bool kPartDecides = Graph::Link::kPartDecides;
  template <class Trace>
  using Program = typename Graph::template Program<Trace, StarOf<Graph>>;

  static void tell(GraphFacts& facts) {
    facts.parts = Graph::Link::kParts;
    facts.part_count = StarOf<Graph>::kParts;
    facts.part_decides = kPartDecides;
    facts.part_knows_random = target::board_knows_random<Graph>;
  }
  static SplitLink* link(std::size_t part) {
    return link_of<Graph>(part, std::make_index_sequence<StarOf<Graph>::kParts>());
  }
  /// Real hardware is made safe when a part is silent.
  template <class Program>
  static void connect(Program& program) {
    program.connect(star_of_run<Graph>);
    if constexpr (requires { program.make_safe(); }) {
      if (!program.is_real()) return;
      star_of_run<Graph>.for_each([&](auto& link) {
        link.on_silence(
            static_cast<std::uint64_t>(Graph::kSafety.link_timeout_ns),
            [](void* context) { static_cast<Program*>(context)->make_safe(); }, &program);
      });
    }
  }
  static void begin(EpisodeKey key, target::Agent agent) {
    star_of_run<Graph>.begin_episode({key, static_cast<std::uint8_t>(agent)});
  }
  template <class Program>
  static void make_safe(Program& program) {
    if constexpr (kPartDecides) program.link().make_safe();
  }
};

}  // namespace eagerx::linux_sim
