#include "generator/graph/plan/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <map>

#include "generator/graph/plan/order.hpp"
#include "generator/graph/plan/receptions.hpp"
#include "generator/graph/plan/schedule.hpp"
#include "generator/graph/plan/split.hpp"
#include "generator/graph/plan/telemetry.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

std::string port_of(const GraphNode& node, const Output& output) {
  return fmt::format("{}", join(node.ports_of(output), ", "));
}

constexpr std::uint64_t kMaxRingBytes = std::uint64_t{1} << 30U;
// A power of two saves a division at every access; above this many wasted bytes the exact size is
// better.
constexpr std::uint64_t kMaxWastedBytes = 256;

class Planner {
 public:
  Planner(const Graph& graph, Diagnostics& diagnostics) : graph_(graph), diagnostics_(diagnostics) {
    plan_.graph = &graph;
  }

  std::optional<Plan> run() {
    const std::size_t errors_before = diagnostics_.error_count();
    auto rates = find_rates(graph_, diagnostics_);
    if (!rates) return std::nullopt;
    plan_.rates = std::move(*rates);
    assign_rates();
    order();
    add_channels();
    for (std::size_t n = 0; n < graph_.nodes.size(); ++n) receive(n);
    size_rings();
    plan_.schedule =
        make_schedule(plan_.rates, plan_.nodes[Graph::kEnvironment].rate, graph_.nodes.size(),
                      graph_.has_reset_nodes() || graph_.asynchronous);
    if (diagnostics_.error_count() != errors_before) return std::nullopt;
    if (graph_.placement) plan_.split = make_split(plan_);
    if (graph_.telemetry) plan_.telemetry = make_telemetry(plan_, diagnostics_);
    if (diagnostics_.error_count() != errors_before) return std::nullopt;
    return std::move(plan_);
  }

 private:
  void assign_rates() {
    for (const auto& node : graph_.nodes) {
      const auto rate = ranges::find(plan_.rates, node.rate_hz, &RateClass::rate_hz);
      PlannedNode planned;
      planned.rate = static_cast<std::size_t>(rate - plan_.rates.begin());
      plan_.nodes.push_back(std::move(planned));
    }
  }

  void order() {
    std::vector<std::size_t> rate_of;
    for (const auto& node : plan_.nodes) rate_of.push_back(node.rate);
    Order order = order_nodes(graph_, rate_of);
    place_.assign(graph_.nodes.size(), 0);
    std::size_t place = 0;
    for (const std::size_t n : order.before) place_[n] = place++;
    place_[Graph::kEnvironment] = place++;
    for (const std::size_t n : order.after) place_[n] = place++;
    plan_.before = std::move(order.before);
    plan_.after = std::move(order.after);
  }

  void add_channels() {
    for (std::size_t n = 0; n < graph_.nodes.size(); ++n) {
      for (std::size_t o = 0; o < graph_.nodes[n].outputs.size(); ++o) {
        const Output& output = graph_.nodes[n].outputs[o];
        // Traces omit channels that only pictures need, because programs without pictures lack
        // them.
        if (!graph_.nodes[n].drawn)
          plan_.channels.push_back({graph_.nodes[n].name + "/" + output.name, n, o,
                                    port_of(graph_.nodes[n], output),
                                    graph_.aliases_of(graph_.nodes[n], output)});
        plan_.nodes[n].rings.push_back(plan_.rings.size());
        Ring ring;
        ring.node = n;
        ring.output = o;
        ring.space = output.space;
        plan_.rings.push_back(std::move(ring));
      }
    }
    std::ranges::sort(plan_.channels, {}, &Channel::name);
  }

  void receive(std::size_t n) {
    const GraphNode& node = graph_.nodes[n];
    for (std::size_t i = 0; i < node.inputs.size(); ++i) {
      const Input& input = node.inputs[i];
      // A callback writes its output into the ring while it still reads: where it reads that ring
      // itself, the message it writes needs a place of its own.
      const bool writes_what_it_reads = input.source_node == n && !input.processor &&
                                        !node.outputs[input.source_output].processor;
      const ReceptionEnds ends{
          .source_rate_hz = graph_.nodes[input.source_node].rate_hz,
          .rate_hz = node.rate_hz,
          .source_first = place_[input.source_node] < place_[n] || writes_what_it_reads,
          .asynchronous = graph_.asynchronous};
      auto reception = plan_reception(input, ends, diagnostics_);
      if (!reception) reception.emplace();
      reception->ring = input.processor || input.original
                            ? add_own_ring(n, i)
                            : plan_.nodes[input.source_node].rings[input.source_output];
      keep(reception->ring, reception->keep, input);
      // The hub hands it on late, as it was sent.
      if (reception->ring != plan_.nodes[input.source_node].rings[input.source_output] &&
          goes_from_part_to_part(n, input))
        keep(plan_.nodes[input.source_node].rings[input.source_output], reception->keep, input);
      plan_.nodes[n].receptions.push_back(*reception);
    }
  }
  void keep(std::size_t place, std::uint64_t count, const Input& input) {
    Ring& ring = plan_.rings[place];
    if (count <= ring.needed && !ring.why.empty()) return;
    ring.needed = std::max(ring.needed, count);
    ring.why = input.written;
    why_.resize(std::max(why_.size(), place + 1));
    why_[place] = input.span;
  }
  [[nodiscard]] bool goes_from_part_to_part(std::size_t n, const Input& input) const {
    if (!graph_.placement) return false;
    const std::size_t from = graph_.placement->part_of[input.source_node];
    const std::size_t to = graph_.placement->part_of[n];
    return from != to && from != Placement::kHub && to != Placement::kHub;
  }

  /// Every receiver has its own processor, so a converted message needs a place of its own.
  std::size_t add_own_ring(std::size_t n, std::size_t i) {
    const Input& input = graph_.nodes[n].inputs[i];
    Ring ring;
    ring.node = input.source_node;
    ring.output = input.source_output;
    ring.reader_node = n;
    ring.reader_input = i;
    const Output& output = graph_.nodes[input.source_node].outputs[input.source_output];
    ring.space = input.processor ? input.processor->output : output.raw;
    plan_.rings.push_back(std::move(ring));
    return plan_.rings.size() - 1;
  }

  void size_rings() {
    for (auto& ring : plan_.rings) {
      // With a time for each message where inputs go by the clock.
      const std::uint64_t bytes = bytes_of(ring.space) + (graph_.asynchronous ? 8 : 0);
      const std::uint64_t power = std::bit_ceil(ring.needed);
      ring.capacity = (power - ring.needed) * bytes <= kMaxWastedBytes ? power : ring.needed;
      if (ring.capacity <= kMaxRingBytes / bytes && ring.capacity < (std::uint64_t{1} << 31U))
        continue;
      const GraphNode& node = graph_.nodes[ring.node];
      const std::string name = (ring.node == Graph::kEnvironment ? "actions" : node.name) + "." +
                               node.outputs[ring.output].name;
      if (ring.why.empty()) {  // nothing reads it
        diagnostics_
            .error("E0403", node.outputs[ring.output].span,
                   fmt::format("`{}` has messages of {} bytes", name, bytes))
            .help = "a ring may have at most 1 GiB";
        continue;
      }
      diagnostics_
          .error("E0403", why_[static_cast<std::size_t>(&ring - plan_.rings.data())],
                 fmt::format("`{}` needs {} messages of `{}` at once, of {} bytes each", ring.why,
                             ring.needed, name, bytes))
          .help = "shorten the delay or the window: a ring may have at most 1 GiB";
    }
  }

  const Graph& graph_;
  Diagnostics& diagnostics_;
  Plan plan_;
  std::vector<std::size_t> place_;
  std::vector<Span> why_;  // of rings: the connection that needs the most
};

}  // namespace

std::uint64_t bytes_of(const Space& space) {
  switch (space.dtype) {
    case Dtype::float64:
    case Dtype::int64:
    case Dtype::uint64:
      return 8 * space.size();
    case Dtype::float32:
    case Dtype::int32:
    case Dtype::uint32:
      return 4 * space.size();
    case Dtype::int16:
    case Dtype::uint16:
      return 2 * space.size();
    default:
      return space.size();
  }
}

std::optional<Plan> make_plan(const Graph& graph, Diagnostics& diagnostics) {
  return Planner(graph, diagnostics).run();
}

}  // namespace eagerx::gen
