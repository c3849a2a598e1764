// The links of a hub to the parts of its graph, in addition to app.hpp.
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

template <class Graph, std::size_t K>
class LinkOfRun final : public SplitLink {
 public:
  explicit LinkOfRun(StarOf<Graph>& star) : star_(star) {}
  LinkPort& port() override { return link().port; }
  const link::PartFacts& part() const override { return Graph::Link::kParts[K]; }
  const link::PartProgress& progress() const override { return star_.progress(K); }
  void set_time_limit(std::uint64_t ns) override { link().set_time_limit(ns); }
  bool open(std::uint32_t session) override {
    return link().open({part().graph, target::kRuntimeVersion}, session);
  }
  bool ok() const override { return link().ok(); }
  link::Problem problem() const override { return link().problem(); }
  const link::Greeting& greeting() const override { return link().board(); }
  const link::Statistics& statistics() const override { return link().statistics(); }
  void set_pipelined(bool is_pipelined) override { star_.set_pipelined(is_pipelined); }
  void forget_silence() override { link().on_silence(0, nullptr, nullptr); }
  bool finish(link::Report& report, CountListener& counts) override {
    return link().finish(report,
                         [&](const char* name, std::uint64_t count) { counts.count(name, count); });
  }

 private:
  auto& link() const { return star_.template link<K>(); }

  StarOf<Graph>& star_;
};

template <class Graph, class Parts>
struct LinksOfRun;
template <class Graph, std::size_t... K>
struct LinksOfRun<Graph, std::index_sequence<K...>> {
  explicit LinksOfRun(StarOf<Graph>& star) : links(LinkOfRun<Graph, K>(star)...) {}

  SplitLink* find(std::size_t part) {
    SplitLink* found = nullptr;
    ((K == part ? void(found = &std::get<K>(links)) : void()), ...);
    return found;
  }

  std::tuple<LinkOfRun<Graph, K>...> links;
};

template <class Graph>
requires requires {
  typename Graph::Link;
}
class LinkOf<Graph> {
 public:
  static constexpr bool kIsSplit = true;
  static constexpr bool kPartDecides = Graph::Link::kPartDecides;
  template <class Hooks>
  using Program = typename Graph::template Program<Hooks, StarOf<Graph>>;

  static void tell(GraphFacts& facts) {
    facts.parts = Graph::Link::kParts;
    facts.part_count = StarOf<Graph>::kParts;
    facts.part_decides = kPartDecides;
    facts.part_knows_random = target::board_knows_random<Graph>;
  }
  SplitLink* link(std::size_t part) { return links_.find(part); }
  /// Real hardware is made safe when a part is silent.
  template <class Program>
  void connect(Program& program) {
    program.connect(star_);
    if constexpr (requires { program.make_safe(); }) {
      if (!program.is_real()) return;
      star_.for_each([&](auto& link) {
        link.on_silence(
            static_cast<std::uint64_t>(Graph::kSafety.link_timeout_ns),
            [](void* context) { static_cast<Program*>(context)->make_safe(); }, &program);
      });
    }
  }
  void begin(EpisodeKey key, target::Agent agent) {
    star_.begin_episode({key, static_cast<std::uint8_t>(agent)});
  }
  template <class Program>
  static void make_safe(Program& program) {
    if constexpr (kPartDecides) program.link().make_safe();
  }

 private:
  StarOf<Graph> star_{};
  LinksOfRun<Graph, std::make_index_sequence<StarOf<Graph>::kParts>> links_{star_};
};

}  // namespace eagerx::linux_sim
