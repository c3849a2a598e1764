#include "generator/backend/emit/types.hpp"

#include <fmt/format.h>

namespace eagerx::gen {

std::string window_type(const Plan& plan, std::size_t node, std::size_t input, Numbers numbers) {
  const Reception& reception = plan.nodes[node].receptions[input];
  const Ring& ring = plan.rings[reception.ring];
  const Input& port = plan.graph->nodes[node].inputs[input];
  const bool padded = node == Graph::kEnvironment && port.window > 0;
  const std::string arguments =
      fmt::format("<{}, {}, {}, {}, {}>", message_type(ring.space, numbers),
                  rate_type(plan.graph->nodes[port.source_node].rate_hz), ring.capacity,
                  reception.max_size, reception.always_full);
  if (numbers != Numbers::simd)
    return fmt::format("eagerx::{}{}", padded ? "PaddedWindow" : "Window", arguments);
  const bool scattered =
      reception.count == Reception::Count::delayed || reception.count == Reception::Count::skipped;
  const char* const kind = port.window == 0 ? "NewLane" : scattered ? "Scattered" : "Lane";
  const std::string window = fmt::format("eagerx::{}Window{}", kind, arguments);
  return padded ? "eagerx::PaddedLanes<" + window + ">" : window;
}

std::string window_argument(const Plan& plan, const ProgramNames& names, std::size_t node,
                            std::size_t input) {
  const Reception& reception = plan.nodes[node].receptions[input];
  const Input& port = plan.graph->nodes[node].inputs[input];
  const std::size_t rate = plan.nodes[port.source_node].rate;
  std::string total;
  switch (reception.count) {
    case Reception::Count::ticks:
      total = names.rates[rate].counter;
      break;
    case Reception::Count::ticks_but_one:
      total = names.rates[rate].counter + " - 1";
      break;
    case Reception::Count::ticks_before:
      total = fmt::format("{} - ((due & {}) != 0 ? 1U : 0U)", names.rates[rate].counter,
                          names.rates[rate].due);
      break;
    case Reception::Count::delayed:
    case Reception::Count::skipped:
      total = names.nodes[node].inputs[input].cursor + ".take()";
      if (names.numbers == Numbers::simd)
        total = fmt::format("{}.at({})", names.rates[rate].counter, total);
      break;
    case Reception::Count::arrived:
      return fmt::format(
          "{{{}, {}.{}({}, now_ns, arrivals_)}}", names.rings[reception.ring].expression(),
          names.nodes[node].inputs[input].cursor, port.window == 0 ? "take_new" : "take",
          names.nodes[port.source_node].sent);
  }
  // A hub whose agent is elsewhere only shows what that sees, once all is there.
  if (names.runs(node)) total = names.awaited(port.source_node, total);
  if (port.window == 0)
    total = fmt::format("{}.take({})", names.nodes[node].inputs[input].fresh, total);
  return fmt::format("{{{}, {}}}", names.rings[reception.ring].expression(), total);
}

bool asks_what_is_due(const Plan& plan, std::size_t node, std::size_t input) {
  return plan.nodes[node].receptions[input].count == Reception::Count::ticks_before;
}

std::string ring_place(const Plan& plan, const ProgramNames& names, std::size_t ring,
                       const std::string& seq) {
  const std::uint64_t capacity = plan.rings[ring].capacity;
  if (capacity == 1) return names.rings[ring].expression() + "[0]";
  return fmt::format("{}[eagerx::ring_position<{}>({})]", names.rings[ring].expression(), capacity,
                     seq);
}

}  // namespace eagerx::gen
