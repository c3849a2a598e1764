// The host's half of a split graph: its link to the board.
#pragma once

#include <cstdint>
#include <eagerx/link/host.hpp>
#include <string>
#include <targets/common/partner.hpp>
#include <targets/linux-sim/link_port.hpp>
#include <targets/linux-sim/options.hpp>
#include <targets/linux-sim/summary.hpp>

namespace eagerx::linux_sim {

template <class Graph>
inline constexpr bool is_split = requires {
  typename Graph::Link;
};

/// The link of a split graph; of a whole one, nothing.
template <class Graph, bool = is_split<Graph>>
struct LinkOf {
  using Type = link::NoLink;
  static constexpr bool kBoardDecides = false;
};
template <class Graph>
struct LinkOf<Graph, true> {
  using Type = link::HostLink<LinkPort, Graph::Link::kToBoard, Graph::Link::kToHost>;
  static constexpr bool kBoardDecides = Graph::Link::kBoardDecides;
};

template <class Graph, class Trace, class Link = typename LinkOf<Graph>::Type,
          bool = is_split<Graph>>
struct ProgramOf {
  using Type = typename Graph::template Program<Trace>;
};
template <class Graph, class Trace, class Link>
struct ProgramOf<Graph, Trace, Link, true> {
  using Type = typename Graph::template Program<Trace, Link>;
};

/// False if the board decides and does not know this agent.
template <class Graph>
constexpr bool board_knows(target::Agent agent) {
  if (!LinkOf<Graph>::kBoardDecides) return true;
  if (agent == target::Agent::random) return target::board_knows_random<Graph>;
  return agent != target::Agent::csv;
}

/// Why a link is over, for people.
std::string problem_text(link::Problem problem, const link::Greeting& board,
                         link::Identity identity, const LinkPort& port,
                         const link::Statistics& statistics);

/// The lines of a summary about the link.
void describe_link(Summary& summary, const char* board, const link::Statistics& statistics,
                   const link::Report& report);

/// A number that no earlier session had.
std::uint32_t new_session();

template <class Graph>
constexpr link::Identity identity_of() {
  return {Graph::Link::kGraph, target::kRuntimeVersion};
}

/// Why `link` is over.
template <class Graph, class Link>
std::string problem_of(const Link& link) {
  return problem_text(link.problem(), link.board(), identity_of<Graph>(), link.port,
                      link.statistics());
}

/// Connects with the board. Returns what went wrong; empty: nothing.
template <class Graph, class Link>
std::string connect(Link& link, const Options& options) {
  constexpr double kNsPerSecond = 1e9;
  if (!link.port.open(options.link, options.baud))
    return "error: cannot open `" + options.link + "`: " + link.port.error();
  link.set_time_limit(static_cast<std::uint64_t>(options.link_timeout_s * kNsPerSecond));
  if (!link.open(identity_of<Graph>(), new_session())) return problem_of<Graph>(link);
  return {};
}

/// Gives a program its link. Real hardware is made safe when the board is silent.
template <class Graph, class Program, class Link>
void set_link(Program& program, Link& link) {
  program.connect(link);
  if constexpr (requires { program.make_safe(); }) {
    if (!program.is_real()) return;
    link.on_silence(
        static_cast<std::uint64_t>(Graph::kSafety.link_timeout_ns),
        [](void* context) { static_cast<Program*>(context)->make_safe(); }, &program);
  }
}

}  // namespace eagerx::linux_sim
