#include <fmt/format.h>
#include <fmt/ranges.h>

#include "generator/resolve/graph.hpp"

namespace eagerx::gen {

std::uint64_t Space::size() const {
  std::uint64_t product = 1;
  for (const std::uint64_t dimension : shape) product *= dimension;
  return product;
}

std::string Space::describe() const {
  return fmt::format("{} [{}]", to_string(dtype), fmt::join(shape, ", "));
}

}  // namespace eagerx::gen
