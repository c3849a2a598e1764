#include <fmt/format.h>

#include "generator/graph/resolve/graph.hpp"
#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {

std::uint64_t Space::size() const {
  std::uint64_t product = 1;
  for (const std::uint64_t dimension : shape) product *= dimension;
  return product;
}

std::string Space::describe() const {
  return fmt::format("{} [{}]", to_string(dtype), join(shape, ", "));
}

std::vector<const Processor*> Processor::stages() const {
  std::vector<const Processor*> result;
  for (const Processor& stage : before) result.push_back(&stage);
  result.push_back(this);
  return result;
}

std::string Processor::names() const {
  std::vector<std::string> ids;
  for (const Processor* stage : stages()) ids.push_back(stage->entity->id.value);
  return fmt::format("{}", join(ids, ", "));
}

}  // namespace eagerx::gen
