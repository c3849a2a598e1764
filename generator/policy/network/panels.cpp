#include "generator/policy/network/panels.hpp"

#include <algorithm>
#include <bit>
#include <eagerx/policy/panel_size.hpp>

namespace eagerx::gen {

using eagerx::policy::kPanel;

std::size_t padded_outputs(std::size_t outputs) {
  const std::size_t tail = outputs % kPanel;
  return outputs - tail + (tail == 0 ? 0 : std::bit_ceil(tail));
}

std::vector<Panel> panels_of(std::size_t outputs) {
  const std::size_t stored = padded_outputs(outputs);
  std::vector<Panel> panels;
  for (std::size_t first = 0; first < outputs; first += kPanel) {
    const std::size_t end = std::min(first + kPanel, stored);
    panels.push_back({first, std::min(end, outputs) - 1, end});
  }
  return panels;
}

}  // namespace eagerx::gen
