// The graph in time and memory: when and in what order nodes run, and where messages are stored.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "generator/graph/resolve/graph.hpp"

namespace eagerx::gen {

/// All nodes of one rate share a counter and a bit of the due mask.
struct RateClass {
  Rational rate_hz;
  std::uint64_t period = 1;  // in quanta of the grid
};

/// Storage of one channel, or of one channel as an input has it alone: converted by its processor,
/// or not converted by that of the output.
struct Ring {
  std::size_t node = 0;
  std::size_t output = 0;
  std::optional<std::size_t> reader_node, reader_input;  // of such an input
  Space space;
  std::uint64_t needed = 1;  // messages that must be kept
  std::uint64_t capacity =
      1;            // messages that are kept: a power of two, or exact where messages are large
  std::string why;  // the input that needs the most
};

/// How an input knows the number of messages it has received. With source rate / own rate = a/b in
/// lowest terms and x = ceil(b · source rate · delay) (SEMANTICS §3):
struct Reception {
  enum class Count : std::uint8_t {
    ticks,          // all that were sent: the source's counter
    ticks_but_one,  // all but the one of this slot (skip, the source is due whenever the node is)
    ticks_before,   // all that were sent before this slot, in which the source may be due (skip)
    delayed,        // max(1, floor((a n - x) / b) + 1) at tick n
    skipped,        // the sum of max(0, min(cum(n + off) - cum(n + off - 1), cum(n) + 1))
    arrived,        // all that were sent at least the delay ago, by the engine's clock
  };
  Count count = Count::ticks;
  std::size_t ring = 0;
  std::int64_t a = 1, b = 1, x = 0, off = 0;
  /// A delay that a reset may change: x = ceil(delay in ns · num / den), with the delay of the
  /// graph to begin with and never more than the longest.
  struct Changing {
    std::int64_t num = 0, den = 1, first_ns = 0, longest_ns = 0;
  };
  std::optional<Changing> changing;
  std::int64_t delay_ns = 0;   // of `arrived`; num = den = 1 there
  std::uint64_t max_size = 1;  // most messages in the window
  bool always_full = true;
  std::uint64_t keep = 1;  // messages that the ring must have room for
};

/// A node in the plan; receptions match the node's inputs.
struct PlannedNode {
  std::size_t rate = 0;  // index of its RateClass
  std::vector<Reception> receptions;
  std::vector<std::size_t> rings;  // of its outputs
};

/// A published output; its index is its number in the trace.
struct Channel {
  std::string name;
  std::size_t node = 0, output = 0;
  // Its names in graphs: "smooth.filtered", "pendulum.theta", "actions.u", "arm.x, arm.same".
  // Sensors with their own processors have other messages; the name is then
  // "arm/state.observation".
  std::string port = {};
  std::vector<std::string> aliases = {};  // ports of composites that it is: "robot.speed"
};

enum class ScheduleForm : std::uint8_t {
  constants,  // a step is the hyperperiod: its slots one after the other, masks known to the
              // compiler
  kinds,      // a table of kinds of slots; their masks are known to the compiler
  table,      // a table of masks
  countdown,  // hyperperiod too long for a table: one countdown a rate
};
/// In words for reports, such as "a table of masks".
const char* text_of(ScheduleForm form);

struct Schedule {
  /// Consecutive equal slots.
  struct Run {
    std::uint64_t mask = 0;
    std::size_t slots = 0;
  };
  ScheduleForm form = ScheduleForm::countdown;
  std::optional<std::uint64_t> slots;  // of the hyperperiod, if it can be counted
  // Empty for countdown:
  std::vector<std::uint64_t> masks;  // one a slot
  std::vector<std::uint64_t> kinds;  // each mask once; the first is that of an episode's beginning
  std::vector<Run> runs;             // all slots
};

/// The messages between the hub and a part of a placed graph.
struct PartLink {
  std::vector<bool> to_part, to_hub;  // by channel
  std::size_t part_payload = 0;       // most bytes of a frame to the part, and back; what is
  std::size_t hub_payload = 0;        // longer takes several frames
  double exchanges = 0.0;             // a step: a frame there and one back
  double part_bytes = 0.0;            // a step, to the part, without frames
  double hub_bytes = 0.0;
  bool several_frames = false;  // whether messages do not fit into one
  bool is_pipelined = false;    // the hub asks for messages where they are sent, and takes them
                                // where they are read
  std::size_t depth = 1;        // exchanges in flight at most
  std::string why_no_more;      // what keeps the hub from going further
  /// By node: the number of its ticks after sending a message at which the hub forwards it to this
  /// part, and the part expects it; message 0 is forwarded immediately.
  std::vector<std::uint64_t> lags;
};
struct Split {
  std::vector<PartLink> links;     // of each part
  std::size_t most_in_flight = 0;  // ticks of a part's nodes in flight, if any link is pipelined
  std::size_t trace_bytes = 0;     // of messages that wait for them in the hub
};

/// The telemetry of a board: the channels of one rate together, as many as a record takes.
struct TelemetryGroup {
  struct Place {
    std::size_t channel = 0;   // of Plan::channels
    std::string port;          // as the graph calls it
    std::uint64_t offset = 0;  // in the record
  };
  std::size_t rate = 0;     // index of its RateClass
  std::uint32_t every = 1;  // one of this many messages is sent
  std::uint64_t bytes = 0;  // of a record, its header among them
  std::vector<Place> channels;
};
struct TelemetryPlan {
  std::vector<TelemetryGroup> groups;  // fastest first
  Rational share;                      // of the line that it may take
  std::uint32_t baud = 0;
  std::uint32_t greet_every = 1;             // records between greetings, one greeting a second
  std::size_t cells = 0;                     // records that the ring has room for
  double bytes_per_s = 0.0;                  // on the line
  std::optional<double> wanted_bytes_per_s;  // if that was too much: before it was made less
  [[nodiscard]] double baud_needed() const { return 10.0 * bytes_per_s; }
};

struct Plan {
  const Graph* graph = nullptr;
  std::vector<RateClass> rates;  // fastest first; bit i of a mask is rates[i]
  std::vector<PlannedNode> nodes;
  std::vector<std::size_t> before,
      after;  // nodes in data-flow order, up to and from the environment
  std::vector<Ring> rings;
  std::vector<Channel> channels;
  Schedule schedule;
  std::optional<Split> split;  // of a placed graph
  std::optional<TelemetryPlan> telemetry;
};

/// Bytes of a message in memory and on a link.
std::uint64_t bytes_of(const Space& space);

/// Plans a resolved graph. Problems, E04xx: E0401 an input that would stay empty for ever, E0402 a
/// number that does not fit, E0403 a limit that is passed, E0426 telemetry that is too much for its
/// line.
std::optional<Plan> make_plan(const Graph& graph, Diagnostics& diagnostics);

}  // namespace eagerx::gen
